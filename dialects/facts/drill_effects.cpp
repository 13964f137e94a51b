// A cycle takes words that stay until it ends; one that replaces another keeps them.
#include "dialects/facts/drill_effects.h"

#include <algorithm>
#include <array>

#include "dialects/facts/kept_words.h"

namespace dripfeed::facts {

namespace {

using ir::Address;
using ir::Function;

constexpr std::array kWords = {Kept::drill_depth, Kept::drill_level, Kept::drill_peck,
                               Kept::drill_dwell, Kept::drill_i,     Kept::drill_j};

struct WordRow {
  Address address;
  Kept word;
};
constexpr WordRow kPlain[] = {{Address::q, Kept::drill_peck},
                              {Address::p, Kept::drill_dwell},
                              {Address::i, Kept::drill_i},
                              {Address::j, Kept::drill_j}};

Address letter_of(Number axis) {
  if (axis == Number::x) return Address::x;
  return axis == Number::y ? Address::y : Address::z;
}

}  // namespace

bool makes_hole(Address a) { return a == Address::x || a == Address::y || a == Address::z || a == Address::r; }

std::optional<Number> drilling_axis(const Known<Setting>& plane) {
  if (!plane.agrees()) return std::nullopt;
  switch (plane.value.function) {
    case Function::plane_zx: return Number::y;
    case Function::plane_yz: return Number::x;
    default: return Number::z;
  }
}

std::optional<Kept> name_of(Number axis) {
  switch (axis) {
    case Number::x: return Kept::at_x;
    case Number::y: return Kept::at_y;
    case Number::z: return Kept::at_z;
    default: return std::nullopt;
  }
}

bool is_plain_name(const ir::Program& program, ir::ExpressionId value) {
  const ir::Expression& e = program.at(value);
  if (e.op != ir::Operator::variable) return false;
  const ir::Variable& variable = program.at(e.variable);
  return variable.bank == ir::Bank::named && variable.index == ir::ExpressionId::none;
}

void DrillEffects::begin() {
  const Setting* before = facts[Mode::cycle].certain();
  const bool enters = before != nullptr && before->function == Function::cycle_off;
  if (before != nullptr && !enters) return;
  for (const Kept word : kWords) facts[word].set({}, statement);
  if (enters) facts[Mode::hole_end].set({.function = Function::return_to_initial}, statement);
  if (enters) return keep_initial();
  facts[Mode::hole_end].forget(statement);
  facts[Kept::initial].forget(statement);
}

void DrillEffects::keep_initial() {
  const std::optional<Number> along = drilling_axis(facts[Mode::plane]);
  const double* number = along ? facts[*along].certain() : nullptr;
  const Written* name = along ? facts[*name_of(*along)].certain() : nullptr;
  Known<Written>& initial = facts[Kept::initial];
  if (number != nullptr)
    return initial.set({.number = *number, .is_number = true, .has_point = true, .is_stated = true}, statement);
  if (name != nullptr && name->is_stated && name->value != ir::ExpressionId::none) return initial.set(*name, statement);
  initial.forget(statement);
}

std::optional<bool> DrillEffects::is_incremental() const {
  const Known<Setting>& distance = facts[Mode::distance];
  return distance.agrees() ? std::optional(distance.value.function == Function::incremental) : std::nullopt;
}

void DrillEffects::take(Kept which, const ir::Word& word, std::optional<bool> by_distance) {
  if (!by_distance) return facts[which].forget(statement);
  Written value = written(word, values);
  value.by_distance = *by_distance;
  facts[which].set(value, statement);
}

void DrillEffects::take_words() {
  // I and J say the shift of a boring cycle together, Q says it without them.
  const auto says = [this](Address a) { return values.word(a) != nullptr; };
  if (says(Address::i) || says(Address::j) || says(Address::q))
    for (const Kept shift : {Kept::drill_i, Kept::drill_j}) facts[shift].set({}, statement);
  const std::optional<Number> along = drilling_axis(facts[Mode::plane]);
  const Address depth = letter_of(along.value_or(Number::z));
  for (const ir::Word& word : values.words) {
    if (word.address == depth) take(Kept::drill_depth, word, is_incremental());
    const bool from_initial = control.semantics.drill_r_from_initial;
    if (word.address == Address::r)
      take(Kept::drill_level, word, from_initial ? std::optional(true) : is_incremental());
    const auto* const row = std::ranges::find(kPlain, word.address, &WordRow::address);
    if (row != std::end(kPlain)) take(row->word, word, false);
  }
  if (std::ranges::none_of(values.words, makes_hole, &ir::Word::address)) return;
  const Known<Setting>& level = facts[Mode::return_level];
  const Setting* certain = level.certain();
  if (certain == nullptr) return facts[Mode::hole_end].forget(statement);
  const Setting* stands = facts[Mode::hole_end].certain();
  const bool stays = stands != nullptr && *stands == *certain;
  if (!stays) facts[Mode::hole_end].set({.function = certain->function}, statement);
}

void DrillEffects::leave_hole(Number along) {
  Known<double>& position = facts[along];
  Known<Written>& name = facts[*name_of(along)];
  position.forget(statement);
  name.forget(statement);
  const Setting* end = facts[Mode::hole_end].certain();
  if (end == nullptr) return;
  const bool at_level = end->function == Function::return_to_r;
  const Written* level = facts[at_level ? Kept::drill_level : Kept::initial].certain();
  if (level == nullptr || level->by_distance || !level->is_stated) return;
  const bool counts = !level->has_point && control.semantics.decimal_mode == ir::DecimalMode::least_increment;
  if (level->is_number && !counts) position.set(level->number, statement);
  if (!level->is_number && is_plain_name(values.program, level->value)) name.set(*level, statement);
}

}  // namespace dripfeed::facts
