// Everything random is drawn before anything is tried, and results are kept by their index, so that neither the number
// of threads nor their order shows.
#include "checks/sweep/sweep.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <random>
#include <thread>
#include <utility>

namespace dripfeed::sweep {

namespace {

using Values = std::vector<double>;

// Calls work(i) for 0..count-1 on some threads.
template <class Work>
void spread(std::size_t count, unsigned threads, Work&& work) {
  std::atomic<std::size_t> next{0};
  const auto run = [&] {
    for (std::size_t i = next++; i < count; i = next++) work(i);
  };
  std::vector<std::jthread> others;
  for (unsigned i = 1; i < std::min<std::size_t>(threads, count); ++i) others.emplace_back(run);
  run();
}

class Sweeper {
 public:
  Sweeper(const std::vector<Parameter>& parameters, const Try& attempt, const Settings& settings)
      : parameters_(parameters), attempt_(attempt), settings_(settings), random_(settings.seed) {
    for (const Parameter& one : parameters) standard_.push_back(one.standard);
    report_.parameters = parameters;
  }

  Report run() {
    report_.standard = tried(standard_);
    if (report_.standard.passes) {
      find_ranges();
      try_all(corners(), report_.corners);
      try_all(samples(), report_.samples);
      find_smallest();
    } else {
      report_.smallest_failure = Example{standard_, {}, 0.0, report_.standard};
    }
    report_.trials = trials_;
    return std::move(report_);
  }

 private:
  Trial tried(const Values& values) {
    if (settings_.stop.stop_requested()) return {false, "stopped", "the sweep was stopped"};
    ++trials_;
    return attempt_(values);
  }
  [[nodiscard]] double rounded(std::size_t i, double value) const {
    const Parameter& one = parameters_[i];
    if (one.step == 0.0) return value;
    const double highest = std::floor((one.high - one.low) / one.step);
    return one.low + one.step * std::min(std::round((value - one.low) / one.step), highest);
  }

  // The end first: where it passes, the side is taken as free all along.
  Side find_side(std::size_t i, double end) {
    Side side{end, false, 0.0, {}, {}};
    if (end == standard_[i]) return side;
    Values values = standard_;
    values[i] = end;
    Trial trial = tried(values);
    if (trial.passes) return side;
    double passes = standard_[i];
    double fails = end;
    for (int step = 0; step < kBisections; ++step) {
      const double middle = rounded(i, 0.5 * (passes + fails));
      if (middle == passes || middle == fails) break;
      values[i] = middle;
      Trial here = tried(values);
      (here.passes ? passes : fails) = middle;
      if (!here.passes) trial = std::move(here);
    }
    return {passes, true, fails, std::move(trial.check), std::move(trial.text)};
  }

  void find_ranges() {
    report_.ranges.resize(parameters_.size());
    spread(2 * parameters_.size(), settings_.threads, [&](std::size_t k) {
      const std::size_t i = k / 2;
      Side& side = k % 2 == 0 ? report_.ranges[i].low : report_.ranges[i].high;
      side = find_side(i, k % 2 == 0 ? parameters_[i].low : parameters_[i].high);
    });
    for (std::size_t i = 0; i < parameters_.size(); ++i) {
      for (const Side& side : {report_.ranges[i].low, report_.ranges[i].high}) {
        if (!side.is_bounded) continue;
        Values values = standard_;
        values[i] = side.fails_at;
        consider({values, {false, side.check, side.text}});
      }
    }
  }

  std::vector<Values> corners() {
    std::vector<Values> all;
    const std::size_t n = parameters_.size();
    const bool every = n < 20 && (std::size_t{1} << n) <= settings_.most_corners;
    const std::size_t count = n == 0 ? 0 : (every ? std::size_t{1} << n : settings_.most_corners);
    for (std::size_t corner = 0; corner < count; ++corner) {
      Values values;
      for (std::size_t i = 0; i < n; ++i) {
        const bool high = every ? (corner >> i & 1U) != 0 : (random_() & 1U) != 0;
        values.push_back(high ? parameters_[i].high : parameters_[i].low);
      }
      all.push_back(std::move(values));
    }
    return all;
  }

  // std::uniform_real_distribution differs between libraries; this does not.
  double uniform() { return static_cast<double>(random_()) * 0x1p-32; }

  std::vector<Values> samples() {
    std::vector<Values> all;
    for (std::size_t k = 0; k < settings_.samples && !parameters_.empty(); ++k) {
      Values values;
      for (std::size_t i = 0; i < parameters_.size(); ++i) {
        const Parameter& one = parameters_[i];
        values.push_back(rounded(i, one.low + uniform() * (one.high - one.low)));
      }
      all.push_back(std::move(values));
    }
    return all;
  }

  void try_all(const std::vector<Values>& all, Share& share) {
    std::vector<Trial> trials(all.size());
    spread(all.size(), settings_.threads, [&](std::size_t i) { trials[i] = tried(all[i]); });
    share.tried = all.size();
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (trials[i].passes) {
        ++share.passed;
      } else {
        failures_.emplace_back(all[i], std::move(trials[i]));
      }
    }
  }

  // Fewest changed parameters, then the smallest change.
  void consider(std::pair<Values, Trial> failure) {
    Example example{std::move(failure.first), {}, 0.0, std::move(failure.second)};
    for (std::size_t i = 0; i < parameters_.size(); ++i) {
      if (example.values[i] == standard_[i]) continue;
      example.changed.push_back(i);
      const double width = parameters_[i].high - parameters_[i].low;
      example.change += width > 0.0 ? std::fabs(example.values[i] - standard_[i]) / width : 0.0;
    }
    const std::optional<Example>& best = report_.smallest_failure;
    const bool smaller = !best || example.changed.size() < best->changed.size() ||
                         (example.changed.size() == best->changed.size() && example.change < best->change);
    if (smaller) report_.smallest_failure = std::move(example);
  }

  // One parameter after the other is put back as usual where it still fails; what must stay is halved towards usual.
  std::pair<Values, Trial> shrunk(std::pair<Values, Trial> failure) {
    for (std::size_t i = 0; i < parameters_.size(); ++i) {
      if (failure.first[i] == standard_[i]) continue;
      Values values = failure.first;
      values[i] = standard_[i];
      Trial trial = tried(values);
      if (!trial.passes) failure = {std::move(values), std::move(trial)};
    }
    for (std::size_t i = 0; i < parameters_.size(); ++i) {
      double passes = standard_[i];
      for (int step = 0; step < kBisections && failure.first[i] != standard_[i]; ++step) {
        Values values = failure.first;
        values[i] = rounded(i, 0.5 * (passes + failure.first[i]));
        if (values[i] == passes || values[i] == failure.first[i]) break;
        Trial trial = tried(values);
        if (trial.passes) {
          passes = values[i];
        } else {
          failure = {std::move(values), std::move(trial)};
        }
      }
    }
    return failure;
  }

  // A single parameter that fails alone needs nothing more; otherwise some of the failing places are shrunk.
  void find_smallest() {
    if (report_.smallest_failure) return;
    std::vector<std::pair<Values, Trial>> all(std::min(kShrunk, failures_.size()));
    spread(all.size(), settings_.threads,
           [&](std::size_t i) { all[i] = shrunk(failures_[i * failures_.size() / all.size()]); });
    for (auto& one : all) consider(std::move(one));
  }

  const std::vector<Parameter>& parameters_;
  const Try& attempt_;
  const Settings& settings_;
  std::mt19937 random_;
  Values standard_;
  std::vector<std::pair<Values, Trial>> failures_;
  std::atomic<std::size_t> trials_{0};
  Report report_;
};

}  // namespace

Report sweep(const std::vector<Parameter>& parameters, const Try& attempt, const Settings& settings) {
  return Sweeper(parameters, attempt, settings).run();
}

plot::Plot region_plot(const Report& report) {
  plot::Plot figure{.title = "values that pass, each parameter alone",
                    .x = {"share of the parameter's range", -0.1, 1.1},
                    .y = {"parameter", -0.6, static_cast<double>(report.parameters.size()) - 0.4}};
  for (std::size_t i = 0; i < report.ranges.size(); ++i) {
    const Parameter& one = report.parameters[i];
    const double width = one.high - one.low;
    const auto share = [&](double value) { return width > 0.0 ? (value - one.low) / width : 0.0; };
    const auto y = static_cast<double>(report.ranges.size() - 1 - i);
    const auto& [low, high] = report.ranges[i];
    figure.areas.push_back({"passes", share(low.reach), share(high.reach), y - 0.25, y + 0.25});
    figure.areas.push_back({"", 0.0, 1.0, y - 0.01, y + 0.01});
    figure.notes.push_back({{share(one.standard), y}, one.name});
    for (const Side& side : {low, high}) {
      if (side.is_bounded) figure.notes.push_back({{share(side.fails_at), y - 0.3}, side.check});
    }
  }
  return figure;
}

}  // namespace dripfeed::sweep
