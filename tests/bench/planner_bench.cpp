// How fast the look-ahead plans, against a planner of the kind that small controls have, in the same run: blocks a
// second at gentle and low acceleration, by one thread and by more; and the figures 5 to 7 of A. Keinert, A. Verl. By
// hand: cmake --build build/release --target planner_bench && build/release/planner_bench [blocks] [figures]
#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <string_view>
#include <thread>
#include <vector>

#include <fmt/format.h>

#include "checks/timing/limited_look_ahead.h"
#include "checks/timing/look_ahead.h"
#include "checks/timing/sweep.h"
#include "dialects/text/number.h"
#include "tests/bench/ring_planner.h"

namespace {

using namespace dripfeed::timing;
using Clock = std::chrono::steady_clock;

double seconds(Clock::time_point from) { return std::chrono::duration<double>(Clock::now() - from).count(); }

// A finishing raster, 0.1 mm a block, on a wavy surface.
LinePath raster(std::size_t count) {
  LinePath path;
  const auto add = [&](std::size_t i) {
    const std::size_t row = i / 2000;
    const std::size_t column = row % 2 != 0 ? 1999 - i % 2000 : i % 2000;
    const double x = 0.1 * static_cast<double>(column);
    const double y = 0.25 * static_cast<double>(row);
    path.points[0].push_back(x);
    path.points[1].push_back(y);
    path.points[2].push_back(10 * std::sin(x * 0.05) * std::cos(y * 0.08) + 0.3 * std::sin(x * 0.9 + y * 0.7) - 12);
  };
  for (std::size_t i = 0; i <= count; ++i) add(i);
  for (std::size_t i = 0; i < count; ++i)
    path.feed.push_back((2500 + 500 * std::sin(static_cast<double>(i) * 0.003)) / 60);
  return path;
}

AxisRates rates_with(double acceleration) {
  AxisRates rates;
  rates.rapid.fill(500);
  rates.feed.fill(500);
  rates.acceleration.fill(acceleration);
  rates.sample_s = 0.004;
  return rates;
}

struct Best {
  double s = 1e300;
  template <class Work>
  void measure(Work&& work) {
    const auto from = Clock::now();
    work();
    s = std::min(s, seconds(from));
  }
};

void throughput(std::size_t count, unsigned most_threads) {
  constexpr int kRounds = 9;
  const LinePath path = raster(count);
  fmt::print("{} blocks of 0.1 mm, best of {} interleaved rounds, million blocks/s\n", count, kRounds);
  fmt::print("{:>10} {:>12} {:>12} {:>10} {:>10} {:>8} {:>8} {:>9}\n", "mm/s2", "ring of 16", "ring of 250", "1 thread",
             fmt::format("{} threads", most_threads), "ratio", "speed-up", "settled");
  for (const double acceleration : {3000.0, 500.0, 50.0, 5.0}) {
    const AxisRates rates = rates_with(acceleration);
    Best small, large, one, more;
    PieceArrays pieces, other_pieces;
    SpeedPlan plan, other;
    for (int round = 0; round < kRounds; ++round) {
      small.measure([&] { dripfeed::bench::plan_in_ring(path, acceleration, 16); });
      if (round < 3) large.measure([&] { dripfeed::bench::plan_in_ring(path, acceleration, 250); });
      one.measure([&] { plan_lines(path, rates, {0, 1}, pieces, plan); });
      more.measure([&] { plan_lines(path, rates, {0, most_threads}, other_pieces, other); });
    }
    if (plan.speed2 != other.speed2 || plan.duration_s != other.duration_s) fmt::print("DIFFERENT BITS\n");
    const auto rate = [&](const Best& best) { return static_cast<double>(count) / best.s * 1e-6; };
    const auto text = [](double value) { return dripfeed::text::format_fixed(value, 2); };
    fmt::print("{:>10} {:>12} {:>12} {:>10} {:>10} {:>8} {:>8} {:>9}\n", acceleration, text(rate(small)),
               text(rate(large)), text(rate(one)), text(rate(more)), text(rate(one) / rate(small)),
               text(one.s / more.s), other.reswept);
  }
}

// Figure 5: from how many blocks on a second thread pays; and figures 6 and 7 with buffers of 300 elements: how far the
// profile drops with too small an overlap, and how much overlap the path needs.
void figures(const LinePath& path, unsigned most_threads) {
  const auto text = [](double value) { return dripfeed::text::format_fixed(value, 2); };
  fmt::print("\nfigure 5: best of 15, microseconds\n{:>9} {:>11} {:>11} {:>9} {:>13} {:>13} {:>9}\n", "blocks",
             "exact, 1", fmt::format("exact, {}", most_threads), "speed-up", "buffers, 1",
             fmt::format("buffers, {}", most_threads), "speed-up");
  const AxisRates rates = rates_with(500);
  for (const std::size_t count : {100U, 1000U, 3000U, 10'000U, 30'000U, 100'000U, 300'000U, 1'000'000U}) {
    if (count > path.size()) break;
    LinePath part = path;
    part.feed.resize(count);
    for (auto& axis : part.points) axis.resize(count + 1);
    Best one, more, limited, limited_more;
    PieceArrays pieces;
    SpeedPlan plan;
    LimitedPlan buffers;
    for (int round = 0; round < 15; ++round) {
      one.measure([&] { plan_lines(part, rates, {0, 1}, pieces, plan); });
      more.measure([&] { plan_lines(part, rates, {0, most_threads, 1}, pieces, plan); });
      limited.measure([&] { plan_limited(pieces, {300, 5, 50, 1}, buffers); });
      limited_more.measure([&] { plan_limited(pieces, {300, 5, 50, most_threads}, buffers); });
    }
    fmt::print("{:>9} {:>11} {:>11} {:>9} {:>13} {:>13} {:>9}\n", count, text(one.s * 1e6), text(more.s * 1e6),
               text(one.s / more.s), text(limited.s * 1e6), text(limited_more.s * 1e6),
               text(limited.s / limited_more.s));
  }
  for (const double acceleration : {3000.0, 500.0, 50.0}) {
    PieceArrays pieces;
    SpeedPlan plan;
    plan_lines(path, rates_with(acceleration), {0, 1}, pieces, plan);
    std::vector<double> exact(pieces.size() + 1, 0.0);
    junction_limits(pieces, {0, pieces.size()}, exact.data());
    sweep_back(pieces, {0, pieces.size()}, 0.0, exact.data());
    fmt::print(
        "\nfigures 6 and 7, {} mm/s2, buffers of 300: overlap at most, junctions that drop, deepest drop mm/s, overlap "
        "used on average, buffers cut\n",
        acceleration);
    for (const std::size_t most : {5U, 10U, 20U, 50U, 100U, 1000U}) {
      LimitedPlan limited;
      plan_limited(pieces, {300, 5, most, 1}, limited);
      std::size_t dropped = 0;
      double deepest = 0;
      for (std::size_t i = 0; i < exact.size(); ++i) {
        dropped += limited.limit2[i] != exact[i] ? 1U : 0U;
        deepest = std::max(deepest, std::sqrt(exact[i]) - std::sqrt(limited.limit2[i]));
      }
      double sum = 0;
      for (const std::size_t one : limited.overlap) sum += static_cast<double>(one);
      fmt::print("{:>8} {:>9} {:>9} {:>9} {:>9}\n", most, dropped, text(deepest),
                 text(sum / static_cast<double>(limited.overlap.size())), limited.cut);
    }
  }
}

}  // namespace

int main(int argc, char** argv) {
  std::size_t count = 1'000'000;
  if (argc > 1) {
    if (const auto number = dripfeed::text::parse_number(argv[1]); number && *number >= 1.0)
      count = static_cast<std::size_t>(*number);
  }
  const unsigned threads = std::max(2U, std::thread::hardware_concurrency());
  throughput(count, threads);
  if (argc > 2 && std::string_view(argv[2]) == "figures") figures(raster(count), threads);
  return 0;
}
