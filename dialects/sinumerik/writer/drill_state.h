// What facts know of modal drilling (G81 to G89) at a statement of a program of another control, as what makes calls of
// it asks: which cycle is on, with which words, and the modes that its words depend on.
#pragma once

#include <cstdint>
#include <optional>

#include "dialects/facts/resolved.h"
#include "dialects/ir/control.h"
#include "dialects/ir/program.h"

namespace dripfeed::sinumerik {

// A value that is the same on all paths, or not known.
template <class T>
struct Fact {
  T value{};
  bool known = false;

  [[nodiscard]] bool is(T wanted) const { return known && value == wanted; }
};

struct DrillState {
  static constexpr std::int16_t kNone = -1;
  Fact<std::int16_t> cycle;                          // argument of Function::drill
  Fact<ir::ExpressionId> depth, level, peck, dwell;  // Z, R, Q, P as they were written
  Fact<ir::ExpressionId> shift_i, shift_j;           // I, J of boring cycles
  Fact<bool> depth_by_distance, level_by_distance;   // written under G91
  Fact<ir::ExpressionId> feed, speed;
  Fact<bool> to_level;     // G99
  Fact<bool> incremental;  // G91
  Fact<bool> inch;
  Fact<bool> at_initial;  // the tool stands at the level where the cycle began
  // Where the cycle began, in units of the program: a number, or a name that still has its value.
  struct Level {
    Fact<double> number;
    Fact<ir::SymbolId> name;
  };
  Level initial;
  Fact<ir::Function> motion, plane, spindle, feed_mode;
};

DrillState drill_state(const ir::Program& program, const facts::Facts& facts);

// Address of the axis that stands on the plane.
ir::Address drilling_axis(ir::Function plane);

}  // namespace dripfeed::sinumerik
