// What one block does to a modal drilling cycle: its words, and the levels where it begins and ends.
#pragma once

#include <cstdint>
#include <optional>

#include "dialects/facts/block_values.h"
#include "dialects/facts/modal_facts.h"
#include "dialects/ir/control.h"

namespace dripfeed::facts {

// X, Y, Z and R; the others only say how.
bool makes_hole(ir::Address address);
// The axis that stands on the plane, where that is known.
std::optional<Number> drilling_axis(const Known<Setting>& plane);
// Where the name of an axis' position stands.
std::optional<Kept> name_of(Number axis);
// A variable that has a name and no index.
bool is_plain_name(const ir::Program& program, ir::ExpressionId value);

// All must outlive it.
struct DrillEffects {
  const ir::Control& control;
  std::uint32_t statement;
  const BlockValues& values;
  Facts& facts;

  // At the cycle's code, before it takes effect.
  void begin();
  // The words of a block that may drill.
  void take_words();
  // Where the last hole left the tool along the axis.
  void leave_hole(Number along);

 private:
  void keep_initial();
  void take(Kept which, const ir::Word& word, std::optional<bool> by_distance);
  [[nodiscard]] std::optional<bool> is_incremental() const;
};

}  // namespace dripfeed::facts
