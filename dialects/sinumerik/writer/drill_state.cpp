// Plane, unit and distance are taken where paths agree, whatever a called program may have made of them:
// passes::make_modes_explicit() has looked through the calls for these, and has said them where the text would mislead.
#include "dialects/sinumerik/writer/drill_state.h"

#include "dialects/facts/spindle.h"

namespace dripfeed::sinumerik {

namespace {

using facts::Kept;
using facts::Mode;
using ir::Address;
using ir::Function;

Fact<Function> certain(const facts::Known<facts::Setting>& fact) {
  const facts::Setting* setting = fact.certain();
  return setting == nullptr ? Fact<Function>() : Fact<Function>{setting->function, true};
}
Fact<Function> agreed(const facts::Known<facts::Setting>& fact) { return {fact.value.function, fact.agrees()}; }
Fact<bool> is(const Fact<Function>& fact, Function wanted) { return {fact.value == wanted, fact.known}; }

Fact<ir::ExpressionId> word(const facts::Known<facts::Written>& fact) {
  const facts::Written* written = fact.certain();
  if (written == nullptr || (written->is_stated && written->value == ir::ExpressionId::none)) return {};
  return {written->value, true};
}
Fact<bool> by_distance(const facts::Known<facts::Written>& fact) {
  const facts::Written* written = fact.certain();
  return written == nullptr ? Fact<bool>() : Fact<bool>{written->by_distance, true};
}

Fact<std::int16_t> cycle_of(const facts::Known<facts::Setting>& fact) {
  const facts::Setting* cycle = fact.certain();
  if (cycle == nullptr) return {};
  const bool drills = cycle->function == Function::drill;
  return {drills ? static_cast<std::int16_t>(cycle->argument) : DrillState::kNone, true};
}

DrillState::Level level_of(const ir::Program& program, const facts::Known<facts::Written>& fact) {
  const facts::Written* level = fact.certain();
  DrillState::Level out;
  if (level == nullptr || !level->is_stated) return out;
  if (level->is_number) out.number = {level->number, true};
  if (level->is_number || level->value == ir::ExpressionId::none) return out;
  out.name = {program.at(program.at(level->value).variable).symbol, true};
  return out;
}

}  // namespace

ir::Address drilling_axis(Function plane) {
  if (plane == Function::plane_zx) return Address::y;
  return plane == Function::plane_yz ? Address::x : Address::z;
}

DrillState drill_state(const ir::Program& program, const facts::Facts& facts) {
  DrillState state;
  state.cycle = cycle_of(facts[Mode::cycle]);
  state.depth = word(facts[Kept::drill_depth]);
  state.level = word(facts[Kept::drill_level]);
  state.peck = word(facts[Kept::drill_peck]);
  state.dwell = word(facts[Kept::drill_dwell]);
  state.shift_i = word(facts[Kept::drill_i]);
  state.shift_j = word(facts[Kept::drill_j]);
  state.depth_by_distance = by_distance(facts[Kept::drill_depth]);
  state.level_by_distance = by_distance(facts[Kept::drill_level]);
  state.feed = word(facts[Kept::feed]);
  state.speed = word(facts[Kept::speed]);
  state.to_level = is(certain(facts[Mode::return_level]), Function::return_to_r);
  state.incremental = is(agreed(facts[Mode::distance]), Function::incremental);
  state.inch = is(agreed(facts[Mode::unit]), Function::unit_inch);
  state.at_initial = is(certain(facts[Mode::hole_end]), Function::return_to_initial);
  state.initial = level_of(program, facts[Kept::initial]);
  state.motion = certain(facts[Mode::motion]);
  state.plane = agreed(facts[Mode::plane]);
  const std::optional<Function> spindle = facts::stated_spindle(program, facts);
  state.spindle = {spindle.value_or(Function::none), spindle.has_value()};
  state.feed_mode = certain(facts[Mode::feed]);
  return state;
}

}  // namespace dripfeed::sinumerik
