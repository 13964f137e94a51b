// The order of the steps, and the variables: a main program that sits in the control's memory takes R parameters, not
// DEF names. They cost half the time to read (paper figures in control.cpp), the operator sees and edits them on their
// own screen, and they survive a reset; their names stay next to their first assignment as comments.
#include "dialects/sinumerik/writer/raise.h"

#include <algorithm>
#include <map>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "dialects/passes/allocation.h"
#include "dialects/passes/outside_values.h"
#include "dialects/passes/refusal.h"
#include "dialects/sinumerik/sinumerik.h"

namespace dripfeed::sinumerik {

text::Diagnostic& Raising::report(text::DiagnosticId id, text::Span span, std::vector<std::string> arguments) const {
  diagnostics.push_back(ir::diagnose(to, id, span, std::move(arguments)));
  return diagnostics.back();
}

void Raising::cannot(passes::Refusal what, text::Span span) const {
  report(what.id, span, {std::move(what.what), to.title});
}

namespace {

constexpr std::uint32_t kFirstCommon = 100;

// #500 of the program that is called is R500 or another number, as that translation found room.
void warn_of_shared_value(const Raising& raising, const passes::AllocatedVariable& v) {
  if (v.from_bank != ir::Bank::hash || v.from_number < kFirstCommon || v.number == v.from_number) return;
  const auto& statements = raising.program.statements;
  const bool shares = std::ranges::any_of(statements, [](const ir::Statement& s) {
    return s.kind == ir::StatementKind::call || s.kind == ir::StatementKind::subprogram_return;
  });
  if (!shares) return;
  const auto use = std::ranges::find_if(raising.program.variables, [&](const ir::Variable& u) {
    return u.bank == ir::Bank::r && u.number == v.number && !u.span.empty();
  });
  const text::Span span = use == raising.program.variables.end() ? text::Span{} : use->span;
  raising.cannot("the number of #" + std::to_string(v.from_number) + ", here R" + std::to_string(v.number) +
                     " and in called programs and callers perhaps another,",
                 span);
  raising.diagnostics.back().severity = text::Severity::warning;
}

// #101 is empty at power-on; an R parameter holds what was left in it.
void warn_of_outside_values(const Raising& raising, const passes::OutsideValue& value) {
  raising.cannot(passes::not_known(fmt::format(
                     "the value of #{}, which nothing here sets before it is read (an R parameter keeps what "
                     "was set last),",
                     value.number)),
                 value.span);
  raising.diagnostics.back().severity = text::Severity::warning;
}

}  // namespace

std::vector<ir::PlacedName> raise_variables(const Raising& raising, std::set<ir::SymbolId> kept) {
  ir::Program& program = raising.program;
  const std::vector<passes::OutsideValue> outside = passes::outside_values(program, raising.from, ir::Bank::hash);
  passes::AllocationReport report = passes::allocate_variables(program, raising.from, raising.to, ir::Bank::r,
                                                               {.fixed = {}, .kept = std::move(kept)});
  for (text::Diagnostic& d : report.diagnostics) raising.diagnostics.push_back(std::move(d));
  // A number that one name has to itself keeps the name for the printer's comment.
  for (const passes::AllocatedVariable& v : report.variables) warn_of_shared_value(raising, v);
  for (const passes::OutsideValue& value : outside) warn_of_outside_values(raising, value);
  std::map<std::uint32_t, ir::SymbolId> names;
  for (const passes::AllocatedVariable& v : report.variables) {
    if (v.symbol == ir::SymbolId::none || v.count != 1) continue;
    const auto [entry, is_new] = names.emplace(v.number, v.symbol);
    if (!is_new) entry->second = ir::SymbolId::none;
  }
  for (ir::Variable& v : program.variables) {
    if (v.bank != ir::Bank::r || v.index != ir::ExpressionId::none) continue;
    if (const auto name = names.find(v.number); name != names.end()) v.symbol = name->second;
  }
  return passes::placed_names(report, ir::Bank::r);
}

namespace {

// A native that is not the first of its line comes after something that was read (DEF A[30000]=REP(1)): what it adds
// cannot be printed by itself.
void check_natives(const Raising& raising) {
  for (const ir::Statement& s : raising.program.statements) {
    if (s.kind != ir::StatementKind::native || s.tokens.first < s.tokens.last) continue;
    raising.cannot(std::string(raising.program.strings.at(raising.program.natives[s.payload].name)), s.span);
  }
}

}  // namespace

ir::RaiseResult raise(const ir::Program& program, const ir::Control& from, const ir::Control& to) {
  ir::RaiseResult result{program, {}};
  const Raising raising{result.program, from, to, result.diagnostics};
  std::set<ir::SymbolId> kept;
  if (raising.is_own()) {
    check_natives(raising);
  } else {
    raise_skipped_words(raising);
    kept = raise_arguments(raising);
    raise_macro_calls(raising);
    raise_vacant(raising);
    raise_expressions(raising);
    raise_flow(raising);
    raise_cycles(raising);
    raise_frames(raising);
  }
  raise_reference(raising);
  raise_machine_moves(raising);
  raise_blocks(raising);
  if (!raising.is_own()) {
    raise_modes(raising);
    result.placed = raise_variables(raising, std::move(kept));
  }
  return result;
}

}  // namespace dripfeed::sinumerik
