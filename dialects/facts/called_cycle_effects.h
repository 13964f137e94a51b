// What a call of a cycle of the control leaves: where its holes end, feed, speed and spindle.
#pragma once

#include <cstdint>
#include <optional>

#include "dialects/facts/modal_facts.h"
#include "dialects/ir/called_cycle.h"
#include "dialects/ir/control.h"
#include "dialects/ir/program.h"

namespace dripfeed::facts {

// All must outlive it.
struct CalledCycleEffects {
  const ir::Program& program;
  const ir::Control& control;
  std::uint32_t statement;  // the call, modal or not
  Facts& facts;

  // Where it stands.
  void run();
  // A modal call, after a statement that moves, or may.
  void at_position(bool moves);

 private:
  [[nodiscard]] const ir::Call& call() const { return program.calls[program.statements[statement].payload]; }
  [[nodiscard]] bool has(ir::CycleValue which) const;
  // Of a value that is left out: 0; nothing where it is computed.
  [[nodiscard]] std::optional<double> number(ir::CycleValue which) const;
  void make_hole();
  void leave_tool();
  void take_spindle();
  void take_feed(ir::CycleValue which);
  void make_pattern();
};

}  // namespace dripfeed::facts
