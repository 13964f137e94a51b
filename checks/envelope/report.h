// What the envelope check gets and what it reports.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <string_view>

#include "checks/finding.h"
#include "checks/machine.h"
#include "dialects/ir/axis_letters.h"
#include "dialects/ir/motion.h"

namespace dripfeed::envelope {

constexpr bool is_rotary(std::size_t axis) { return axis >= 3 && axis <= 5; }

struct Settings {
  checks::Machine machine = {};
  double arc_tolerance_mm = 0.02;     // start and end of an arc may differ by this (ir::Semantics)
  double arc_tolerance_factor = 0.0;  // … or by this part of its radius, where that is more
  std::int32_t work_offset = 1;       // in effect before the program names one: 1 is G54; 0 none
  double part_size_mm = 0.0;          // longest side of stock or nominal, for the suspicion of units; 0: not known
  bool d_selects_edge = false;  // lengths are those of the tool's edge D (SINUMERIK), otherwise of an offset number
};

// What was reached. `low` > `high` where an axis did not move. mm and degrees; diameter axes as radii.
struct Reach {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();

  void include(double value) {
    if (value < low) low = value;
    if (value > high) high = value;
  }
  [[nodiscard]] bool empty() const { return low > high; }
  [[nodiscard]] double span() const { return empty() ? 0.0 : high - low; }
};

struct Report {
  std::uint64_t moves = 0;
  std::array<Reach, ir::kAxisCount> work;     // in the work offsets
  std::array<Reach, ir::kAxisCount> machine;  // in machine coordinates, where offset and tool length are known
  double feed_max_mm_min = 0.0;
  double spindle_max_rpm = 0.0;
  // A move whose place in the machine the program itself made unknown: it changed a zero or a
  // tool length by what only the control knows.
  bool lost_place = false;
  checks::FindingList findings;
  checks::NotCheckedList not_checked;
};

// Figures in sentences: four decimals at most.
std::string figure(double value);

}  // namespace dripfeed::envelope
