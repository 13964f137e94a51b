// A place for each variable that the text mentions.
#include "dialects/optimize/places.h"

#include <algorithm>

#include "dialects/facts/calls.h"
#include "dialects/facts/flow_graph.h"
#include "dialects/ir/sections.h"

namespace dripfeed::optimize {

namespace {

std::pair<ir::Bank, std::uint32_t> key_of(const ir::Variable& v) {
  return {v.bank, v.bank == ir::Bank::named ? static_cast<std::uint32_t>(v.symbol) : v.number};
}

bool is_scalar(const ir::Program& program, const ir::Variable& v) {
  if (v.index != ir::ExpressionId::none || v.bank == ir::Bank::system) return false;
  if (v.bank != ir::Bank::named) return true;
  return v.symbol != ir::SymbolId::none && program.at(v.symbol).dimension1 == 0;
}

// A called program may know names of its caller (a SINUMERIK with LUD_EXTENDED_SCOPE) and shares its local variables
// (M98).
bool calls_others(const ir::Program& program) {
  return std::ranges::any_of(program.statements, [&](const ir::Statement& s) {
    return facts::is_call(s.kind) && !facts::is_standard_cycle(program, s);
  });
}

// Where it returns to, its local variables may be those of the caller, too.
bool returns(const ir::Program& program) {
  return std::ranges::any_of(program.statements, [](const ir::Statement& s) { return ir::returns(s.kind); });
}

bool has_computed_number(const ir::Program& program, ir::Bank bank) {
  return std::ranges::any_of(
      program.variables, [bank](const ir::Variable& v) { return v.bank == bank && v.index != ir::ExpressionId::none; });
}

PlaceFacts named_facts(const ir::Symbol& symbol, bool calls) {
  PlaceFacts facts{.bank = ir::Bank::named, .type = symbol.type};
  facts.is_own = !symbol.is_global && !symbol.by_reference && !calls;
  facts.is_plain = facts.is_own && (symbol.type == ir::ValueType::real || symbol.type == ir::ValueType::integer);
  return facts;
}

// A number 0 is vacant for ever; what the control defines changes by itself.
PlaceFacts numbered_facts(const ir::Variable& v, const ir::Control& control) {
  PlaceFacts facts{.bank = v.bank, .number = v.number};
  const ir::VariableRange* range = ir::find_variable(control, v.bank, v.number);
  facts.is_plain = range != nullptr && range->writable && range->use != ir::VariableUse::system &&
                   !(v.bank == ir::Bank::hash && v.number == 0);
  return facts;
}

}  // namespace

Places::Places(const ir::Program& program, const ir::Control& control, std::span<const NumberRange> own) {
  const bool calls = calls_others(program);
  const bool has_own_locals = !calls && !returns(program) && !has_computed_number(program, ir::Bank::hash);
  for (const ir::Variable& v : program.variables) {
    if (!is_scalar(program, v) || by_key_.contains(key_of(v))) continue;
    PlaceFacts facts =
        v.bank == ir::Bank::named ? named_facts(program.at(v.symbol), calls) : numbered_facts(v, control);
    facts.symbol = v.symbol;
    if (v.bank != ir::Bank::named && facts.is_plain) {
      const ir::VariableRange* range = ir::find_variable(control, v.bank, v.number);
      const bool is_local = range->use == ir::VariableUse::local && has_own_locals;
      facts.is_own =
          is_local || std::ranges::any_of(own, [&](const NumberRange& r) { return r.has(v.bank, v.number); });
    }
    by_key_.emplace(key_of(v), static_cast<Place>(facts_.size()));
    facts_.push_back(facts);
  }
}

Place Places::of(const ir::Variable& variable) const {
  if (variable.index != ir::ExpressionId::none) return kNoPlace;
  const auto found = by_key_.find(key_of(variable));
  return found == by_key_.end() ? kNoPlace : found->second;
}

}  // namespace dripfeed::optimize
