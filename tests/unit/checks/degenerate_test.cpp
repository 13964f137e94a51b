// Programs and machines that make no sense, through every check: moves without a length, numbers that are none, radii
// of nothing, places beyond all measure, machines at the ends of what a profile may say. Every check ends, in bounded
// time and memory, and its figures are numbers. Seeded: a failure can be played again.
#include <array>
#include <chrono>
#include <cmath>
#include <limits>
#include <memory>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "checks/accuracy/accuracy.h"
#include "checks/accuracy/plane_accuracy.h"
#include "checks/envelope/envelope.h"
#include "checks/gouge/gouge.h"
#include "checks/gouge/milling.h"
#include "checks/timing/timing.h"

namespace dripfeed::checks {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

// What a calculation may come to: places that there are, if odd ones, and far ones.
constexpr std::array<double, 16> kOdd = {0.0,  -0.0,  1e-308, 1e-12, -1e-9, 0.001,     1.0,        -1.0,
                                         25.4, 100.0, -99.9,  360.0, 1e6,   999999999, -999999999, 1e9};
constexpr std::array<double, 6> kFar = {1.1e9, 1e15, 1e30, 1e154, 1e308, -1e308};
constexpr std::array<double, 3> kNone = {kNaN, kInfinity, -kInfinity};

class Any {
 public:
  Any(unsigned seed, bool finite) : random_(seed), finite_(finite) {}

  std::size_t below(std::size_t n) { return std::uniform_int_distribution<std::size_t>(0, n - 1)(random_); }
  bool one_in(std::size_t n) { return below(n) == 0; }
  double between(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }
  // Of a range that a profile may have, its ends above all.
  double in(double low, double high) {
    const std::size_t what = below(4);
    return what == 0 ? low : what == 1 ? high : between(low, std::min(high, low + 1e4));
  }
  double value() {
    if (!finite_ && one_in(50)) return kNone[below(kNone.size())];
    if (one_in(100)) return kFar[below(kFar.size())];
    return one_in(3) ? kOdd[below(kOdd.size())] : between(-150, 150);
  }

  ir::Motion motion(std::uint32_t line, const ir::Motion& before) {
    ir::Motion m;
    m.kind = static_cast<ir::MotionKind>(below(static_cast<std::size_t>(ir::MotionKind::end)));
    m.place = {0, line, line};
    m.plane = static_cast<ir::Plane>(below(3));
    m.feed_mode = static_cast<ir::FeedMode>(below(3));
    m.axes_commanded = static_cast<std::uint16_t>(below(512));
    m.axes_unknown = one_in(6) ? static_cast<std::uint16_t>(below(512)) : std::uint16_t{0};
    m.gaps = one_in(8) ? static_cast<std::uint8_t>(below(8)) : std::uint8_t{0};
    m.length_offset = static_cast<ir::LengthOffset>(below(3));
    m.length_offset_number = static_cast<std::uint16_t>(below(4));
    m.machine_coordinates = one_in(12);
    m.exact_stop = one_in(6);
    if (has_places(before)) m.start = m.end = before.end;
    if (one_in(10)) m.start = {value(), value(), value()};
    for (double& axis : m.end)
      if (one_in(3)) axis = value();
    if (one_in(8)) m.end = m.start;
    for (double& axis : m.center) axis = one_in(4) ? 0.0 : value();
    m.feed = one_in(5) ? value() : between(0, 2000);
    m.spindle_rpm = one_in(5) ? value() : between(0, 5000);
    m.surface_speed_m_min = one_in(6) ? value() : 0.0;
    m.spindle = static_cast<ir::SpindleState>(below(3));
    m.comp = static_cast<ir::CompSide>(below(3));
    m.number = static_cast<std::int32_t>(below(4));
    m.compute.blocks = 1;
    return m;
  }

  std::vector<ir::Motion> program(std::size_t length) {
    std::vector<ir::Motion> motions(1);
    motions.front().kind = ir::MotionKind::tool;
    motions.front().number = 1;
    while (motions.size() < length)
      motions.push_back(motion(static_cast<std::uint32_t>(motions.size()), motions.back()));
    return motions;
  }

  // Within what a profile's reader takes.
  Machine machine() {
    Machine machine;
    machine.kind = static_cast<ir::MachineKind>(below(3));
    for (std::size_t i = 0; i < 3; ++i) {
      MachineAxis axis{.axis = static_cast<ir::Axis>(i), .is_diameter = one_in(4)};
      if (!one_in(4)) axis.min = between(-1e6, 0);
      if (!one_in(4)) axis.max = between(0, 1e6);
      axis.rapid_mm_min = in(0.001, 1e9);
      axis.acceleration_mm_s2 = in(0.001, 1e9);
      axis.jerk_mm_s3 = in(0.0, 1e12);
      if (one_in(2)) axis.feed_limit_mm_min = in(0.001, 1e9);
      if (!one_in(8)) machine.axes.push_back(axis);
    }
    if (one_in(2)) machine.feed_limit_mm_min = in(0.001, 1e9);
    if (one_in(2)) machine.spindle_max_rpm = in(0.001, 1e6);
    for (std::int32_t number = 1; number < 4; ++number)
      machine.tools.push_back({.number = number,
                               .offset = number,
                               .nose_radius_mm = in(0.0, 1000.0),
                               .tip = static_cast<std::int32_t>(below(10)),
                               .diameter_mm = in(0.0, 10'000.0),
                               .length_mm = in(0.0, 10'000.0)});
    machine.buffer = {.bytes = static_cast<std::uint32_t>(in(0, 1e9)),
                      .blocks = static_cast<std::uint32_t>(in(0, 1e6))};
    machine.timing.sample_time_ms = in(0.0, 1000.0);
    machine.timing.look_ahead_blocks = static_cast<std::uint32_t>(in(0, 1e6));
    machine.timing.tool_change_s = in(0.0, 3600.0);
    return machine;
  }

 private:
  std::mt19937 random_;
  bool finite_;
};

curves::Profile straight_profile() {
  return {
      {{{{-50, 0}, [](double) { return curves::ExplicitPoint{20, 0}; }, [](double, double) { return curves::Range{}; }},
        0.01}}};
}

void envelope_ends(Any& any, const std::vector<ir::Motion>& motions) {
  envelope::Envelope check({.machine = any.machine(), .part_size_mm = any.one_in(2) ? 0.0 : 100.0});
  check.consume(motions);
  const envelope::Report report = check.finish();
  EXPECT_FALSE(std::isnan(report.feed_max_mm_min));
  for (const auto& reach : report.machine) EXPECT_FALSE(std::isnan(reach.low) || std::isnan(reach.high));
}

void timing_ends(Any& any, const std::vector<ir::Motion>& motions) {
  timing::Settings settings{.machine = any.machine()};
  settings.keep_whole = any.one_in(2);
  settings.wants_curve = any.one_in(4);
  if (any.one_in(2)) {
    settings.line = timing::Line{.baud = any.in(50, 4e6)};
    settings.line_bytes.assign(motions.size(), static_cast<std::uint32_t>(any.in(0, 200)));
  }
  timing::Timing check(std::move(settings));
  check.consume(motions);
  const timing::Report report = check.finish();
  EXPECT_FALSE(std::isnan(report.cycle_s));
  EXPECT_GE(report.cycle_s, 0.0);
}

void gouge_ends(Any& any, const std::vector<ir::Motion>& motions) {
  const Machine machine = any.machine();
  gouge::Settings turning{.stock = gouge::Cylinder{60, -60, 2}, .nominal = straight_profile()};
  turning.tools = machine.tools;
  if (any.one_in(2)) turning.rapid_x_mm_min = turning.rapid_z_mm_min = 1e4;
  gouge::Gouge lathe(turning);
  lathe.consume(motions);
  EXPECT_FALSE(std::isnan(lathe.finish().deepest_cut_mm));
  gouge::MillingSettings milling{.stock = gouge::Blank{{-50, 50}, {-40, 40}, {-20, 0}}};
  milling.tools = machine.tools;
  milling.step_mm = 2.0;
  if (any.one_in(2)) milling.rapid_mm_min = {1e4, 2e4, 1e4};
  gouge::Milling mill(milling);
  mill.consume(motions);
  EXPECT_FALSE(std::isnan(mill.finish().deepest_rapid_mm));
}

void accuracy_ends(Any& any, const std::vector<ir::Motion>& motions) {
  accuracy::Settings turning{.nominal = straight_profile()};
  turning.tools = any.machine().tools;
  accuracy::Accuracy lathe(turning);
  lathe.consume(motions);
  EXPECT_FALSE(std::isnan(lathe.finish().path.max_mm));
  const curves::ParametricCurve line{{0, 1},
                                     [](double t) { return curves::ParametricPoint{{100 * t, 0}, {100, 0}, {0, 0}}; },
                                     [](double, double) { return curves::Box{{0, 100}, {0, 0}}; },
                                     {}};
  accuracy::PlaneSettings plane;
  plane.nominal = {{line, 0.01, false}};
  plane.tools = turning.tools;
  accuracy::PlaneAccuracy mill(plane);
  mill.consume(motions);
  EXPECT_FALSE(std::isnan(mill.finish().path.max_mm));
}

using Check = void (*)(Any& any, const std::vector<ir::Motion>& motions);

void every_seed_ends(Check check, bool finite) {
  constexpr unsigned kSeeds = 60;
  constexpr std::size_t kLength = 60;
  using Clock = std::chrono::steady_clock;
  for (unsigned seed = 1; seed <= kSeeds; ++seed) {
    SCOPED_TRACE(seed);
    Any any(seed, finite);
    const std::vector<ir::Motion> motions = any.program(kLength);
    const auto began = Clock::now();
    check(any, motions);
    EXPECT_LT(Clock::now() - began, std::chrono::seconds(20)) << "60 moves";
  }
}

TEST(Degenerate, EnvelopeOfNumbers) { every_seed_ends(envelope_ends, true); }
TEST(Degenerate, EnvelopeOfNoNumbers) { every_seed_ends(envelope_ends, false); }
TEST(Degenerate, TimingOfNumbers) { every_seed_ends(timing_ends, true); }
TEST(Degenerate, TimingOfNoNumbers) { every_seed_ends(timing_ends, false); }
TEST(Degenerate, GougeOfNumbers) { every_seed_ends(gouge_ends, true); }
TEST(Degenerate, GougeOfNoNumbers) { every_seed_ends(gouge_ends, false); }
TEST(Degenerate, AccuracyOfNumbers) { every_seed_ends(accuracy_ends, true); }
TEST(Degenerate, AccuracyOfNoNumbers) { every_seed_ends(accuracy_ends, false); }

}  // namespace
}  // namespace dripfeed::checks
