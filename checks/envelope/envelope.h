// checks/envelope: does the program stay inside the machine: travel in machine coordinates, feeds, spindle speeds,
// tools, arcs that close, and signs of a confused unit. Works on what the interpreter emits, in one pass, with flat
// memory. Collisions and surfaces are left to gouge and accuracy.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "checks/envelope/report.h"
#include "checks/envelope/speeds.h"
#include "checks/envelope/travel.h"
#include "dialects/ir/motion.h"

namespace dripfeed::envelope {

class Envelope final : public ir::MotionSink {
 public:
  explicit Envelope(Settings settings);
  void consume(std::span<const ir::Motion> motions) override;
  // After the last motion; once.
  [[nodiscard]] Report finish();

 private:
  void report_unknowns();
  void take_tool(const ir::Motion& motion);
  void check_move(const ir::Motion& motion);
  void check_cut(const ir::Motion& motion);
  void check_arc(const ir::Motion& motion);
  void check_units();
  void include_cut(const ir::Motion& motion, double value);

  Settings settings_;
  Report report_;
  Travel travel_;
  Speeds speeds_;
  bool has_tool_ = false;
  bool has_reported_no_tool_ = false;
  bool spindle_ran_ = false;
  bool has_reported_standing_ = false;
  Reach cut_;                   // of all linear axes in cutting moves, from the work zero
  ir::Place cut_place_;         // where it is farthest from there
  std::array<Reach, 3> spans_;  // X Y Z of all moves in work coordinates
};

}  // namespace dripfeed::envelope
