// Motions to rows and pieces: what each asks of the line, of the control's computing and of the machine. What is
// missing or no number is reported once and left out.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "checks/timing/kinematics.h"
#include "checks/timing/rows.h"
#include "checks/timing/timing.h"

namespace dripfeed::timing {

struct Intaken {
  Row row;
  std::optional<Piece> piece;
  double feed_mm_s = 0.0;   // of a cutting piece, as programmed
  double limit_mm_s = 0.0;  // what the axes allow
};

class Intake {
 public:
  // `settings` must outlive it; `report` gets what is counted and what is not checked.
  Intake(const Settings& settings, Report& report);
  Intaken take(const ir::Motion& motion);

  // Bytes of all lines, on the wire.
  [[nodiscard]] std::uint64_t all_bytes() const { return bytes_through_.back(); }

 private:
  void report_missing_settings();
  void take_line(const ir::Place& place, Row& row);
  void take_move(const ir::Motion& motion, Intaken& taken);
  double event_seconds(const ir::Motion& motion);

  const Settings& settings_;
  Report& report_;
  AxisRates rates_;
  ir::CostModel cost_;
  std::vector<std::uint64_t> bytes_through_;  // of the lines 1 .. index
  std::uint32_t line_sent_ = 0;
  std::uint64_t last_ordinal_ = 0;
  std::uint32_t last_program_ = 0;
  bool first_ = true;
  AxisVector direction_{};  // at the end of the last move
  double length_ = 0.0;     // of it
  bool rests_ = true;       // the next move starts from rest
  bool was_rapid_ = false;
  std::int32_t tool_ = -1;
};

}  // namespace dripfeed::timing
