// R parameters in range and set, system variables that may be written, strings where numbers belong.
#include <algorithm>
#include <map>
#include <vector>

#include "dialects/sinumerik/tables/system_variables.h"
#include "dialects/sinumerik/validator/validate.h"

namespace dripfeed::sinumerik {

namespace {

using ir::StatementKind;
using text::DiagnosticId;

void check_r_range(const Check& check) {
  const auto has_r = [](const ir::VariableRange& r) { return r.bank == ir::Bank::r; };
  if (std::ranges::none_of(check.control.variables, has_r)) return;
  for (const ir::Variable& v : check.program.variables) {
    if (v.bank != ir::Bank::r) continue;
    double number = v.number;
    const bool indexed = v.index != ir::ExpressionId::none;
    if (indexed) {
      const ir::Expression& e = check.program.at(v.index);
      if (e.op != ir::Operator::constant) continue;
      number = e.value;
    }
    const bool whole = number >= 0.0 && number < 4e9;
    if (whole && ir::find_variable(check.control, ir::Bank::r, static_cast<std::uint32_t>(number)) != nullptr) continue;
    // How many there are is a machine datum (MD28050): without the machine it is a guess.
    text::Diagnostic& d =
        check.report(DiagnosticId::variable_out_of_range, v.span, {std::string(check.text_of(v.span))});
    if (indexed) d.alarm = "17020";
    if (!check.control.from_profile && number >= 0.0) d.severity = text::Severity::warning;
  }
}

// A main program that calls nothing and reads an R that it never sets depends on what another program left there.
void check_r_set(const Check& check) {
  const ir::Program& program = check.program;
  if (may_have_caller(program)) return;
  const bool others = std::ranges::any_of(program.statements, [&](const ir::Statement& s) {
    return s.kind == StatementKind::call || s.kind == StatementKind::modal_call ||
           (s.kind == StatementKind::native && !program.natives[s.payload].effects_known);
  });
  if (others) return;
  std::map<std::uint32_t, bool> set;
  bool any_computed = false;
  const auto mark = [&](ir::VariableId id) {
    if (id == ir::VariableId::none || program.at(id).bank != ir::Bank::r) return;
    any_computed = any_computed || program.at(id).index != ir::ExpressionId::none;
    set[program.at(id).number] = true;
  };
  for (const ir::Assign& a : program.assigns) mark(a.target);
  for (const ir::Structure& s : program.structures) mark(s.counter);
  if (any_computed) return;
  for (const ir::Expression& e : program.expressions) {
    if (e.op != ir::Operator::variable) continue;
    const ir::Variable& v = program.at(e.variable);
    if (v.bank != ir::Bank::r || v.index != ir::ExpressionId::none || set[v.number]) continue;
    set[v.number] = true;  // said once
    check.report(DiagnosticId::variable_never_set, v.span, {"R" + std::to_string(v.number)});
  }
}

void check_system_writes(const Check& check) {
  for (const ir::Statement& s : check.program.statements) {
    if (s.kind != StatementKind::assign) continue;
    const ir::VariableId target = check.program.assigns[s.payload].target;
    if (target == ir::VariableId::none || check.program.at(target).bank != ir::Bank::system) continue;
    const ir::Variable& v = check.program.at(target);
    if (v.number != 0 && !check.control.system_variables[v.number].writable)
      check.report(DiagnosticId::variable_write_protected, s.span,
                   {std::string(check.control.system_variables[v.number].name)});
  }
}

bool is_text(const ir::Program& program, ir::ExpressionId value) {
  const ir::Operator op = program.at(value).op;
  return op == ir::Operator::string || op == ir::Operator::concatenate;
}

void check_types(const Check& check) {
  const ir::Program& program = check.program;
  for (const ir::Assign& a : program.assigns) {
    if (a.target == ir::VariableId::none || a.value == ir::ExpressionId::none) continue;
    const ir::Variable& target = program.at(a.target);
    if (target.bank == ir::Bank::system || !is_text(program, a.value)) continue;
    if (target.bank == ir::Bank::named) {
      const ir::Symbol& symbol = program.at(target.symbol);
      const bool numeric = symbol.type == ir::ValueType::integer || symbol.type == ir::ValueType::real;
      if (symbol.span.empty() || !numeric) continue;
    }
    check.report(DiagnosticId::wrong_type, program.at(a.value).span,
                 {std::string(check.text_of(program.at(a.value).span)), "STRING", "a number"});
  }
}

}  // namespace

void check_values(const Check& check) {
  check_r_range(check);
  check_r_set(check);
  check_system_writes(check);
  check_types(check);
}

}  // namespace dripfeed::sinumerik
