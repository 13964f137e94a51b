// checks/sweep: for which values of its parameters does a part pass: from the usual values along each parameter to
// where a check begins to fail (bisection), the corners of the box of all ranges, and seeded samples of it; and the
// smallest example that fails. What a trial is, rendering and checking for one machine, is the caller's.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

#include "checks/plot/plot.h"

namespace dripfeed::sweep {

struct Parameter {
  std::string name;
  std::string unit;  // may be empty
  double low = 0.0;
  double high = 0.0;
  double standard = 0.0;
  double step = 0.0;  // values are `low` and a whole number of steps; 0: any
};

struct Trial {
  bool passes = false;
  std::string check;  // that fails: "constraint", "travel", …
  std::string text;   // what it says
};
// One value a parameter. Called from several threads at once; must give the same for the same values.
using Try = std::function<Trial(std::span<const double> values)>;

struct Settings {
  std::uint32_t seed = 1;
  std::size_t samples = 100;
  std::size_t most_corners = 64;  // all of them where there are no more; else a seeded choice
  unsigned threads = 1;           // the result is the same for any
  std::stop_token stop = {};      // once asked to stop nothing more is tried: the report is of no use then
};

// From the standard value towards one end of the range, all others as usual.
struct Side {
  double reach = 0.0;       // farthest value that passes, as far as bisection goes
  bool is_bounded = false;  // a check fails beyond; otherwise the range ends there
  double fails_at = 0.0;    // nearest value that fails, when bounded
  std::string check;        // what bounds it
  std::string text;
};

struct ParameterRange {
  Side low;
  Side high;
};

struct Example {
  std::vector<double> values;
  std::vector<std::size_t> changed;  // indices of parameters that are not as usual
  double change = 0.0;               // sum over them of |value - standard| by the range's width
  Trial trial;
};

struct Share {
  std::size_t tried = 0;
  std::size_t passed = 0;
};

struct Report {
  std::vector<Parameter> parameters;
  Trial standard;
  std::vector<ParameterRange> ranges;  // a parameter each; empty where the standard values fail
  Share corners;
  Share samples;
  // The failing example with the fewest changed parameters, then the smallest change; nothing when none failed.
  std::optional<Example> smallest_failure;
  std::size_t trials = 0;
};

// Bounded: 1 + 2·(1 + kBisections) trials a parameter, corners, samples, and the shrinking of kShrunk failing ones.
Report sweep(const std::vector<Parameter>& parameters, const Try& attempt, const Settings& settings);

// The stretch of each parameter that passes, in its range, and what ends it.
plot::Plot region_plot(const Report& report);

inline constexpr int kBisections = 20;
inline constexpr std::size_t kShrunk = 4;

}  // namespace dripfeed::sweep
