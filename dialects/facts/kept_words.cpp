// A variable whose index is computed may be any of its kind.
#include "dialects/facts/kept_words.h"

namespace dripfeed::facts {

namespace {

using ir::ExpressionId;

bool may_be_same(const ir::Variable& a, const ir::Variable& b) {
  if (a.bank != b.bank) return false;
  if (a.index != ExpressionId::none || b.index != ExpressionId::none) return true;
  return a.bank == ir::Bank::named ? a.symbol == b.symbol : a.number == b.number;
}

bool reads(const ir::Program& program, ExpressionId id, const ir::Variable& variable) {
  if (id == ExpressionId::none) return false;
  const ir::Expression& e = program.at(id);
  if (e.op != ir::Operator::variable)
    return reads(program, e.a, variable) || reads(program, e.b, variable) || reads(program, e.c, variable);
  const ir::Variable& read = program.at(e.variable);
  return may_be_same(read, variable) || reads(program, read.index, variable) || reads(program, read.index2, variable) ||
         reads(program, read.index3, variable);
}

bool is_computed(const Written& word) { return !word.is_number && word.value != ExpressionId::none; }

template <class Which>
void forget_where(Facts& facts, Which&& which) {
  for (Known<Written>& word : facts.kept) {
    if (word.origin != kNoStatement && is_computed(word.value) && which(word.value))
      word.value.value = ExpressionId::none;
    if (word.other_origin != kNoStatement && is_computed(word.other) && which(word.other))
      word.other.value = ExpressionId::none;
  }
}

}  // namespace

Written written(const ir::Word& word, const BlockValues& values) {
  const std::optional<double> number = values.constant(word);
  return {.number = number.value_or(0.0),
          .value = word.value,
          .is_number = number.has_value(),
          .has_point = number.has_value() && values.has_point(word),
          .is_stated = true};
}

void forget_computed(const ir::Program& program, ir::VariableId variable, Facts& facts) {
  const ir::Variable& changed = program.at(variable);
  forget_where(facts, [&](const Written& word) { return reads(program, word.value, changed); });
}

void forget_computed(Facts& facts) {
  forget_where(facts, [](const Written&) { return true; });
}

}  // namespace dripfeed::facts
