// Whatever is not plainly a move to a number makes the position unknown.
#include "dialects/facts/position_effects.h"

#include <algorithm>

#include "dialects/facts/axis_words.h"
#include "dialects/facts/drill_effects.h"
#include "dialects/ir/axis_letters.h"
#include "dialects/ir/cycle.h"

namespace dripfeed::facts {

namespace {

using ir::Address;
using ir::Function;

// The block ends where its axis words say.
bool ends_at_its_words(const Setting& motion) {
  switch (motion.function) {
    case Function::rapid:
    case Function::linear:
    case Function::arc_cw:
    case Function::arc_ccw:
    case Function::thread:
    case Function::thread_changing: return true;
    default: return false;
  }
}

// Words that place the end elsewhere than at the axis words.
bool bends_the_end(Address a) {
  return a == Address::polar_angle || a == Address::polar_radius || a == Address::named_axis ||
         a == Address::direct_angle || a == Address::chamfer || a == Address::chamfer_length ||
         a == Address::rounding || a == Address::modal_rounding || a == Address::measuring || a == Address::other ||
         (a >= Address::poly_x2 && a <= Address::poly_z5);
}

// What a caller outside of the text or a called program there left on is not looked for.
bool may_be_on(const Known<Setting>& fact, Function off) {
  return fact.more || (fact.origin != kNoStatement && fact.value.function != off) ||
         (fact.other_origin != kNoStatement && fact.other.function != off);
}

}  // namespace

bool PositionEffects::turns(const ir::Word& word) const {
  const std::optional<AxisTarget> target = target_of(word);
  return target && (target->axis == Number::x || target->axis == Number::z);
}
void PositionEffects::run() {
  const bool other_letters = may_be_on(facts[Mode::transformation], Function::none) ||
                             may_be_on(facts[Mode::letters], Function::polar_words_off);
  if (other_letters) return facts.forget_positions(statement);
  if (std::ranges::any_of(values.codes, [](const ir::Code& code) { return has_own_words(code); })) return;
  const auto names_axis = [this](const ir::Word& word) { return target_of(word).has_value(); };
  if (std::ranges::any_of(values.words, [](const ir::Word& word) { return bends_the_end(word.address); }))
    return facts.forget_positions(statement);
  const Setting* cycle = facts[Mode::cycle].certain();
  if (cycle != nullptr && cycle->function == Function::drill) return take_drilling();
  if (cycle != nullptr && cycle->function == Function::turning_cycle) return take_turning_words(cycle->argument);
  if (std::ranges::none_of(values.words, names_axis)) return;
  const Known<Setting>& motion = facts[Mode::motion];
  const bool plain = facts[Mode::cycle].is({.function = Function::cycle_off}) && !motion.is_open() &&
                     ends_at_its_words(motion.value) &&
                     (motion.other_origin == kNoStatement || ends_at_its_words(motion.other));
  if (!plain) return facts.forget_positions(statement);
  for (const ir::Word& word : values.words) take_axis(word);
}

// Holes at plain positions are followed; those that are repeated, or of a lathe, are not.
void PositionEffects::take_drilling() {
  if (std::ranges::none_of(values.words, makes_hole, &ir::Word::address)) return;
  const std::optional<Number> along = drilling_axis(facts[Mode::plane]);
  const bool repeats = values.word(Address::k) != nullptr || values.word(Address::l) != nullptr;
  if (control.kind != ir::MachineKind::mill || !along || repeats) return facts.forget_positions(statement);
  for (const ir::Word& word : values.words) {
    const std::optional<AxisTarget> target = target_of(word);
    if (target && target->axis != *along) take_axis(word);
  }
  DrillEffects{control, statement, values, facts}.leave_hole(*along);
}

// A turning cycle ends where it began.
void PositionEffects::take_turning_words(std::int32_t cycle) {
  const Address old_taper = cycle == ir::argument_of(ir::TurningCycle::along_x) ? Address::k : Address::i;
  for (const ir::Word& word : values.words) {
    if (word.address == Address::r || word.address == old_taper)
      keep(Kept::turn_taper, coordinate(word, Number::x), word);
    if (!turns(word)) continue;
    const AxisTarget target = *target_of(word);
    const double* from = facts[target.axis].certain();
    const std::optional<bool> increment = is_increment(word, target);
    std::optional<double> end = coordinate(word, target.axis);
    if (!increment || (*increment && (from == nullptr || halves(target.axis))))
      end.reset();
    else if (end && *increment)
      *end += *from;
    keep(target.axis == Number::x ? Kept::turn_x : Kept::turn_z, end, word);
  }
}
void PositionEffects::keep(Kept which, std::optional<double> number, const ir::Word& word) {
  facts[which].set({.number = number.value_or(0.0),
                    .value = word.value,
                    .is_number = number.has_value(),
                    .has_point = number.has_value(),
                    .is_stated = true},
                   statement);
}
// Under DIAM90 an increment is a radius where X is a diameter.
bool PositionEffects::halves(Number axis) const {
  const Setting* diameter = facts[Mode::diameter].certain();
  return axis == Number::x && (diameter == nullptr || diameter->function == Function::diameter_absolute_only);
}

std::optional<PositionEffects::AxisTarget> PositionEffects::target_of(const ir::Word& word) const {
  const std::optional<char> letter =
      word.address <= Address::z ? ir::incremented_axis(control, ir::letter_of(word.address)) : std::nullopt;
  if (letter) return AxisTarget{*axis_of(static_cast<Address>(*letter - 'A')), true};
  const std::optional<Number> axis = axis_of(word.address);
  return axis ? std::optional(AxisTarget{*axis, false}) : std::nullopt;
}

// What a variable alone says, absolutely.
void PositionEffects::take_name(const ir::Word& word, Number axis) {
  const std::optional<Kept> name = name_of(axis);
  if (!name) return;
  const bool absolute = is_increment(word, {axis, false}) == false && word.value != ir::ExpressionId::none;
  const bool is_name = absolute && is_plain_name(values.program, word.value);
  facts[*name].set(is_name ? Written{.value = word.value, .is_stated = true} : Written(), statement);
}

void PositionEffects::take_axis(const ir::Word& word) {
  const std::optional<AxisTarget> target = target_of(word);
  if (!target) return;
  Known<double>& position = facts[target->axis];
  take_name(word, target->axis);
  const std::optional<double> value = coordinate(word, target->axis);
  const std::optional<bool> increment = is_increment(word, *target);
  if (!value || !increment) return position.forget(statement);
  if (!*increment) return position.set(*value, statement);
  const double* from = position.certain();
  if (from == nullptr || halves(target->axis)) return position.forget(statement);
  position.set(*from + *value, statement);
}

std::optional<bool> PositionEffects::is_increment(const ir::Word& word, const AxisTarget& target) const {
  if (target.by_letter) return true;
  if (word.mode != ir::WordMode::as_modal) return word.mode == ir::WordMode::incremental;
  if (control.semantics.incremental_letters_uvw) return false;
  const Setting* distance = facts[Mode::distance].certain();
  return distance == nullptr ? std::nullopt : std::optional(distance->function == Function::incremental);
}

// In the program's unit; nothing where it is computed, or counts increments of an unknown unit.
std::optional<double> PositionEffects::coordinate(const ir::Word& word, Number axis) const {
  const std::optional<double> value = values.constant(word);
  const ir::Semantics& semantics = control.semantics;
  if (!value || *value == 0.0 || values.has_point(word) || semantics.decimal_mode == ir::DecimalMode::calculator)
    return value;
  if (axis >= Number::a && axis <= Number::c) return std::nullopt;
  const Setting* unit = facts[Mode::unit].certain();
  return unit == nullptr ? std::nullopt
                         : std::optional(of_increments(*value, semantics, unit->function == Function::unit_inch));
}

}  // namespace dripfeed::facts
