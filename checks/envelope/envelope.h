// checks/envelope: does the program stay inside the machine: travel in machine coordinates, feeds, spindle speeds,
// tools, arcs that close, and signs of a confused unit. Works on what the interpreter emits, in one pass, with flat
// memory. Collisions and surfaces are left to gouge and accuracy.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <span>

#include "checks/finding.h"
#include "checks/machine.h"
#include "dialects/ir/motion.h"

namespace dripfeed::envelope {

struct Settings {
  checks::Machine machine = {};
  double arc_tolerance_mm = 0.02;  // start and end of an arc may differ by this (ir::Semantics)
  std::int32_t work_offset = 1;    // in effect before the program names one: 1 is G54; 0 none
  double part_size_mm = 0.0;       // longest side of stock or nominal, for the suspicion of units; 0: not known
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
};

struct Report {
  std::uint64_t moves = 0;
  std::array<Reach, ir::kAxisCount> work;     // in the work offsets
  std::array<Reach, ir::kAxisCount> machine;  // in machine coordinates, where the offset is known
  double feed_max_mm_min = 0.0;
  double spindle_max_rpm = 0.0;
  checks::FindingList findings;
  checks::NotCheckedList not_checked;
};

class Envelope final : public ir::MotionSink {
 public:
  explicit Envelope(Settings settings);
  void consume(std::span<const ir::Motion> motions) override;
  // After the last motion; once.
  [[nodiscard]] Report finish();

 private:
  using Point = std::array<double, ir::kAxisCount>;

  void check_move(const ir::Motion& motion);
  void check_place(const ir::Motion& motion, ir::Axis axis, double value);
  void check_arc(const ir::Motion& motion);
  void check_speeds(const ir::Motion& motion);
  void check_spindle(const ir::Motion& motion, double diameter_mm);
  void check_units();
  // Radius where the axis is programmed in diameters.
  [[nodiscard]] double slide(ir::Axis axis, double programmed) const;

  Settings settings_;
  Report report_;
  std::array<const checks::MachineAxis*, ir::kAxisCount> axes_{};
  const checks::WorkOffset* offset_ = nullptr;
  std::int32_t offset_number_ = 1;
  std::uint16_t said_ = 0;  // bit per axis: that the offset in effect is not known for it
  Reach cut_;               // of all linear axes in cutting moves, from the work zero
  double cut_feed_ = 0.0;   // highest of moves with a feed per minute
  ir::Place cut_place_;
};

}  // namespace dripfeed::envelope
