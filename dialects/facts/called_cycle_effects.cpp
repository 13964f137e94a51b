// The cycles save the modal codes and bring them back. A hole leaves the tool over its position at the return level; a
// tap leaves the spindle as its value states.
#include "dialects/facts/called_cycle_effects.h"

#include <utility>

#include "dialects/facts/drill_effects.h"
#include "dialects/ir/called_pattern.h"

namespace dripfeed::facts {

namespace {

using ir::CalledSort;
using ir::CycleValue;
using ir::Function;

constexpr double kMostHoles = 10'000.0;

std::optional<Function> spindle_of(double m_code) {
  if (m_code == 3.0) return Function::spindle_cw;
  if (m_code == 4.0) return Function::spindle_ccw;
  return m_code == 5.0 ? std::optional(Function::spindle_stop) : std::nullopt;
}

// First and second; nothing where the plane is not known.
std::optional<std::pair<Number, Number>> axes_of(const Known<Setting>& plane) {
  if (!plane.agrees()) return std::nullopt;
  if (plane.value.function == Function::plane_zx) return std::pair(Number::z, Number::x);
  if (plane.value.function == Function::plane_yz) return std::pair(Number::y, Number::z);
  return std::pair(Number::x, Number::y);
}

}  // namespace

bool CalledCycleEffects::has(CycleValue which) const { return ir::place_of(*call().cycle, which) != ir::kNoPlace; }

std::optional<double> CalledCycleEffects::number(CycleValue which) const {
  if (ir::value_of(program, call(), which) == ir::ExpressionId::none) return 0.0;
  return ir::number_of(program, call(), which);
}

void CalledCycleEffects::run() {
  switch (call().cycle->sort) {
    case CalledSort::hole: return make_hole();
    case CalledSort::holes_in_row:
    case CalledSort::holes_on_circle: return make_pattern();
    case CalledSort::holes_anywhere: return facts.forget_positions(statement);
    case CalledSort::milling: return facts.forget_positions(statement);
    case CalledSort::removal: facts[Kept::feed].forget(statement); [[fallthrough]];  // its contour is cut by its own
    case CalledSort::thread: facts.forget_positions(statement); facts[Mode::spindle].forget(statement);
  }
}

void CalledCycleEffects::at_position(bool moves) {
  const std::optional<Facts> without = moves ? std::nullopt : std::optional(facts);
  run();
  if (without) facts.join(*without);
}

void CalledCycleEffects::make_hole() {
  leave_tool();
  take_spindle();
  for (const CycleValue feed : {CycleValue::feed_in, CycleValue::feed_out}) take_feed(feed);
  // A tap turns at a speed of its own and brings back the one before, where there was one.
  const Written* speed = facts[Kept::speed].certain();
  const bool is_back = speed != nullptr && speed->is_stated && speed->is_number && speed->number > 0.0;
  if (has(CycleValue::speed) && !is_back) facts[Kept::speed].forget(statement);
}

// The X of a lathe may be a diameter, and a level is none.
void CalledCycleEffects::leave_tool() {
  const std::optional<double> axis = number(CycleValue::axis);
  const bool on_plane = axis && (*axis == 0.0 || *axis == 3.0);
  const std::optional<Number> along = on_plane ? drilling_axis(facts[Mode::plane]) : std::nullopt;
  if (!along) return facts.forget_positions(statement);
  facts[*along].forget(statement);
  facts[*name_of(*along)].forget(statement);
  const std::optional<double> level = ir::number_of(program, call(), CycleValue::return_level);
  if (level && !(control.kind != ir::MachineKind::mill && along == Number::x)) facts[*along].set(*level, statement);
}

void CalledCycleEffects::take_spindle() {
  if (has(CycleValue::spindle)) facts[Mode::spindle].forget(statement);
  if (!has(CycleValue::spindle_after)) return;
  const std::optional<double> after = number(CycleValue::spindle_after);
  const std::optional<Function> stated = after ? spindle_of(*after) : std::nullopt;
  // A tap by the spindle's position ends with the spindle stopped where nothing else is stated.
  const bool stops = after && !stated && has(CycleValue::speed);
  if (stated || stops)
    facts[Mode::spindle].set({.function = stated.value_or(Function::spindle_stop)}, statement);
  else
    facts[Mode::spindle].forget(statement);
}

// It stays in effect.
void CalledCycleEffects::take_feed(CycleValue which) {
  if (!has(which)) return;
  const std::optional<double> feed = number(which);
  if (!feed) return facts[Kept::feed].forget(statement);
  if (*feed > 0.0)
    facts[Kept::feed].set({.number = *feed,
                           .value = ir::value_of(program, call(), which),
                           .is_number = true,
                           .has_point = true,
                           .is_stated = true},
                          statement);
}

void CalledCycleEffects::make_pattern() {
  const auto axes = axes_of(facts[Mode::plane]);
  if (!axes) return facts.forget_positions(statement);
  const double* first = facts[axes->first].certain();
  const double* second = facts[axes->second].certain();
  const auto from =
      first != nullptr && second != nullptr ? std::optional(ir::PlanePoint{*first, *second}) : std::nullopt;
  const std::optional<ir::CalledPattern> pattern = ir::called_pattern(program, call());
  const bool is_plain =
      control.kind == ir::MachineKind::mill && pattern && pattern->count >= 1.0 && pattern->count <= kMostHoles;
  const auto holes = is_plain ? ir::holes_of(*pattern, from) : std::nullopt;
  for (const Number axis : {axes->first, axes->second}) {
    facts[axis].forget(statement);
    facts[*name_of(axis)].forget(statement);
  }
  if (!holes) return;
  facts[axes->first].set(holes->back().first, statement);
  facts[axes->second].set(holes->back().second, statement);
}

}  // namespace dripfeed::facts
