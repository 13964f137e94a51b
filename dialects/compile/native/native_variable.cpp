// Names are compared as SINUMERIK does it, without their case; numbers of a bank are taken as they are written.
#include "dialects/compile/native/native_variable.h"

#include <algorithm>
#include <string>

#include "dialects/compile/native/native_flow.h"
#include "dialects/facts/calls.h"
#include "dialects/facts/flow_graph.h"
#include "dialects/passes/walk.h"
#include "dialects/text/number.h"
#include "dialects/text/upper_case.h"

namespace dripfeed::compile {

namespace {

using ir::StatementKind;

std::optional<std::uint32_t> number_after(std::string_view name, char letter) {
  if (name.size() < 2 || name.front() != letter) return std::nullopt;
  const std::optional<std::int64_t> number = text::parse_integer(name.substr(1));
  if (!number || *number < 0 || *number > 99'999'999) return std::nullopt;
  return static_cast<std::uint32_t>(*number);
}

// The first statement of the program that declares the symbol; the end of the text where no line does.
std::uint32_t owner_of(const ir::Program& program, std::uint32_t symbol) {
  for (std::uint32_t i = 0; i < program.statements.size(); ++i) {
    const ir::Statement& s = program.statements[i];
    if (s.kind != StatementKind::define || s.payload == ir::kNoIndex) continue;
    const ir::Structure& all = program.structures[s.payload];
    if (symbol - all.first_symbol < all.symbol_count) return facts::section_of(program, i).first;
  }
  return static_cast<std::uint32_t>(program.statements.size());
}

// Those that are one variable: the main program's own; else the control's; else that of another program of the text,
// and all where several have one.
std::vector<ir::SymbolId> symbols_named(const ir::Program& program, std::string_view name) {
  std::vector<ir::SymbolId> own;
  std::vector<ir::SymbolId> global;
  std::vector<ir::SymbolId> others;
  const std::uint32_t main = main_section(program).first;
  for (std::uint32_t i = 0; i < program.symbols.size(); ++i) {
    const ir::Symbol& symbol = program.symbols[i];
    if (symbol.is_parameter || text::upper_case(program.strings.at(symbol.name)) != name) continue;
    std::vector<ir::SymbolId>& kind = symbol.is_global ? global : owner_of(program, i) == main ? own : others;
    kind.push_back(static_cast<ir::SymbolId>(i));
  }
  return !own.empty() ? own : !global.empty() ? global : others;
}

}  // namespace

const ir::Structure* procedure_named(const ir::Program& program, ir::StringId name) {
  for (std::uint32_t i = 0; i < program.statements.size(); ++i) {
    if (program.statements[i].kind != StatementKind::procedure) continue;
    const facts::StatementRange own = facts::section_of(program, i);
    const auto section = std::ranges::find(program.sections, own.first, &ir::Section::first);
    if (section != program.sections.end() && section->name == name)
      return &program.structures[program.statements[i].payload];
  }
  return nullptr;
}

std::optional<NativeVariable> NativeVariable::named(const ir::Program& program, const ir::Control& control,
                                                    std::string_view name) {
  NativeVariable out;
  const bool numbered = ir::has_numbered_variables(control);
  if (const auto number = number_after(name, '#')) {
    out.bank_ = ir::Bank::hash;
    out.number_ = *number;
    return numbered && *number != 0 ? std::optional(out) : std::nullopt;
  }
  if (numbered) return std::nullopt;
  if (const auto number = number_after(name, 'R')) {
    out.bank_ = ir::Bank::r;
    out.number_ = *number;
    return out;
  }
  out.symbols_ = symbols_named(program, name);
  return out;
}

NativeVariable NativeVariable::of_symbol(ir::SymbolId symbol) {
  NativeVariable out;
  out.symbols_ = {symbol};
  return out;
}

std::vector<ir::Variable> NativeVariable::uses() const {
  ir::Variable one;
  one.bank = bank_;
  one.number = number_;
  if (bank_ != ir::Bank::named) return {one};
  std::vector<ir::Variable> out;
  for (const ir::SymbolId symbol : symbols_) {
    one.symbol = symbol;
    out.push_back(one);
  }
  return out;
}

bool NativeVariable::is(const ir::Program& program, ir::VariableId variable) const {
  const ir::Variable& v = program.at(variable);
  if (v.bank != bank_) return false;
  if (bank_ == ir::Bank::named)
    return v.index == ir::ExpressionId::none && std::ranges::find(symbols_, v.symbol) != symbols_.end();
  if (v.index == ir::ExpressionId::none) return v.number == number_;
  const ir::Expression& index = program.at(v.index);  // R[10] is R10
  return index.op == ir::Operator::constant && index.value == number_;
}

// VAR parameters of a program of the text, which give back what the called program leaves in them.
bool NativeVariable::is_passed_back(const ir::Program& program, const ir::Statement& call) const {
  const ir::Call& c = program.calls[call.payload];
  const ir::Structure* head = procedure_named(program, c.name);
  for (std::uint32_t i = 0; head != nullptr && i < std::min(c.argument_count, head->symbol_count); ++i) {
    const ir::ExpressionId value = program.arguments[c.first_argument + i].value;
    if (!program.symbols[head->first_symbol + i].by_reference || value == ir::ExpressionId::none) continue;
    if (program.at(value).op == ir::Operator::variable && is(program, program.at(value).variable)) return true;
  }
  return false;
}

std::vector<NativeVariable::Setting> NativeVariable::settings(const ir::Program& program) const {
  std::vector<Setting> out;
  const auto type_of = [&program](ir::SymbolId id) { return program.at(id).type; };
  for (std::uint32_t i = 0; i < program.statements.size(); ++i) {
    const ir::Statement& s = program.statements[i];
    if (s.kind == StatementKind::define && s.payload != ir::kNoIndex) {
      const ir::Structure& all = program.structures[s.payload];
      for (std::uint32_t k = all.first_symbol; k < all.first_symbol + all.symbol_count; ++k) {
        const bool mine = std::ranges::find(symbols_, static_cast<ir::SymbolId>(k)) != symbols_.end();
        const ir::Symbol& symbol = program.symbols[k];
        if (mine && symbol.initial != ir::ExpressionId::none)
          out.push_back({i, symbol.initial, symbol.type == ir::ValueType::integer});
      }
      continue;
    }
    if (facts::is_call(s.kind) && is_passed_back(program, s)) out.push_back({.statement = i});
    for (const passes::VariableUseAt& use : passes::variables_of(program, s)) {
      if (!use.set || !is(program, use.variable)) continue;
      const bool assigns = s.kind == StatementKind::assign;
      const bool integer =
          bank_ == ir::Bank::named && type_of(program.at(use.variable).symbol) == ir::ValueType::integer;
      out.push_back({i, assigns ? program.assigns[s.payload].value : ir::ExpressionId::none, integer});
    }
  }
  return out;
}

bool NativeVariable::is_read_by(const ir::Program& program, std::uint32_t statement) const {
  return std::ranges::any_of(passes::variables_of(program, program.statements[statement]),
                             [&](const passes::VariableUseAt& use) { return !use.set && is(program, use.variable); });
}

}  // namespace dripfeed::compile
