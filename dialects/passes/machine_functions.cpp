// Numbers only: whether the builder of the other machine took the same ones is not known to any table here.
#include "dialects/passes/machine_functions.h"

#include <algorithm>
#include <set>
#include <string>

#include "dialects/passes/refusal.h"

namespace dripfeed::passes {

namespace {

using ir::Function;
using ir::StatementKind;

// Of a control's own, whatever its table of codes says: calls and returns are no codes of blocks.
struct OwnRow {
  bool of_hash_controls;
  std::int16_t number;
};
constexpr OwnRow kOwn[] = {
    {true, 98},
    {true, 99},
    {true, 198},  // calls and their ends (0i-F B-64604EN)
    {false, 70},  // the spindle as an axis (SINUMERIK PG, M functions)
};

bool is_own(std::int16_t number, const ir::Control& control) {
  const bool hash = std::ranges::any_of(control.variables,
                                        [](const ir::VariableRange& range) { return range.bank == ir::Bank::hash; });
  if (std::ranges::any_of(kOwn, [&](const OwnRow& r) { return r.of_hash_controls == hash && r.number == number; }))
    return true;
  const ir::CodeRow* row = ir::find_code(control.m_codes, number * 10);
  return row != nullptr && row->function != Function::machine_function;
}

}  // namespace

std::vector<text::Diagnostic> foreign_machine_functions(const ir::Program& program, const ir::Control& from,
                                                        const ir::Control& to) {
  std::vector<text::Diagnostic> out;
  if (from.dialect == to.dialect) return out;
  std::set<std::int16_t> stated;
  for (const ir::Statement& s : program.statements) {
    if (s.kind != StatementKind::block) continue;
    for (const ir::Code& code : program.codes_of(program.blocks[s.payload])) {
      if (code.function != Function::machine_function || !stated.insert(code.argument).second) continue;
      const std::string name = "M" + std::to_string(code.argument);
      const text::Span span = code.span.empty() ? s.span : code.span;
      if (is_own(code.argument, to)) {
        out.push_back(passes::diagnose(name + ", which that control takes for a function of its own,", span, to.title));
        continue;
      }
      out.push_back(text::make_diagnostic(text::DiagnosticId::not_interpreted, span,
                                          {name + ", to which the builder of each machine gives its meaning,"}));
    }
  }
  return out;
}

}  // namespace dripfeed::passes
