// The ranges of the controls say what is there; below kFirstOwn they were laid down together (0i-F B-64604EN, Mazak and
// M800 user macro chapters), above it each builder went on for itself.
#include "dialects/passes/foreign_variables.h"

#include <algorithm>
#include <optional>
#include <set>
#include <string>

#include "dialects/passes/refusal.h"
#include "dialects/passes/walk.h"

namespace dripfeed::passes {

namespace {

constexpr std::uint32_t kFirstOwn = 8000;
constexpr std::uint32_t kAxes = 20;  // numbers of one work offset

// The number of the same axis of the same offset of G54.1, where the two controls have it under other numbers.
std::optional<std::uint32_t> equal_offset(std::uint32_t number, const ir::Control& from, const ir::Control& to) {
  for (const ir::SystemVariableRow& row : from.system_variables) {
    if (row.extended_offset == 0 || number < row.first || number > row.last) continue;
    const std::uint32_t offset = row.extended_offset + (number - row.first) / kAxes;
    for (const ir::SystemVariableRow& there : to.system_variables) {
      if (there.extended_offset == 0 || offset < there.extended_offset) continue;
      const std::uint32_t equal = there.first + (offset - there.extended_offset) * kAxes + (number - row.first) % kAxes;
      if (equal <= there.last) return equal;
    }
  }
  return std::nullopt;
}

const ir::SystemVariableRow* row_of(const ir::Control& control, std::uint32_t number) {
  const auto row = std::ranges::find_if(control.system_variables, [&](const ir::SystemVariableRow& one) {
    return one.name.empty() && number >= one.first && number <= one.last;
  });
  return row == control.system_variables.end() ? nullptr : &*row;
}

// A control that has a range of its own means something else by its numbers than who has the common one.
bool is_the_same(std::uint32_t number, const ir::Control& from, const ir::Control& to) {
  const ir::VariableRange* here = ir::find_variable(from, ir::Bank::hash, number);
  const ir::VariableRange* there = ir::find_variable(to, ir::Bank::hash, number);
  if (number >= kFirstOwn || here == nullptr || there == nullptr) return false;
  if (here->first != there->first || here->last != there->last || here->use != there->use) return false;
  const ir::SystemVariableRow* a = row_of(from, number);
  const ir::SystemVariableRow* b = row_of(to, number);
  return a == nullptr || b == nullptr || a->kind == b->kind;
}

bool is_system(const ir::VariableRange* range) { return range == nullptr || range->use == ir::VariableUse::system; }

}  // namespace

bool is_foreign_variable(const ir::Variable& v, const ir::Control& from) {
  if (v.bank != ir::Bank::hash || v.index != ir::ExpressionId::none || v.number == 0) return false;
  return is_system(ir::find_variable(from, ir::Bank::hash, v.number));
}

std::vector<text::Diagnostic> translate_variables(ir::Program& program, const ir::Control& from,
                                                  const ir::Control& to) {
  std::vector<text::Diagnostic> out;
  std::set<ir::VariableId> seen;
  for (const ir::Statement& s : program.statements) {
    for (const VariableUseAt& use : variables_of(program, s)) {
      if (!seen.insert(use.variable).second) continue;
      ir::Variable& v = program.variables[static_cast<std::uint32_t>(use.variable)];
      if (v.bank != ir::Bank::hash || v.index != ir::ExpressionId::none) continue;
      const ir::VariableRange* there = ir::find_variable(to, ir::Bank::hash, v.number);
      if (!is_foreign_variable(v, from) && there != nullptr && there->use != ir::VariableUse::system) continue;
      if (v.number == 0 || is_the_same(v.number, from, to)) continue;
      if (const auto equal = equal_offset(v.number, from, to)) {
        v.number = *equal;
        continue;
      }
      const text::Span span = v.span.empty() ? s.span : v.span;
      out.push_back(passes::diagnose(passes::of_value("the variable #" + std::to_string(v.number)), span, to.title));
    }
  }
  return out;
}

}  // namespace dripfeed::passes
