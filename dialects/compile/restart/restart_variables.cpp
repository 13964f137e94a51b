// Values come from the run, what is read from the text.
#include "dialects/compile/restart/restart_variables.h"

#include <algorithm>
#include <map>

#include <fmt/format.h>

#include "dialects/interpreter/bytecode/variable_map.h"
#include "dialects/ir/control.h"
#include "dialects/passes/walk.h"
#include "dialects/text/number.h"

namespace dripfeed::compile {

namespace {

using text::DiagnosticId;

// What the rest, or any program that the run has called, reads.
struct Reads {
  std::set<std::string> names;  // of arrays without their indices
  bool anywhere = false;        // by a number that is computed
  [[nodiscard]] bool has(std::string_view name) const {
    return anywhere || names.contains(std::string(name.substr(0, name.find('['))));
  }
};

void add_reads(const ir::Program& program, const ir::Statement& statement, Reads& out) {
  for (const passes::VariableUseAt& use : passes::variables_of(program, statement)) {
    const ir::Variable& variable = program.at(use.variable);
    const bool numbered = variable.bank == ir::Bank::hash || variable.bank == ir::Bank::r;
    if (numbered && variable.index != ir::ExpressionId::none) out.anywhere |= !use.set;
    if (use.set && variable.index == ir::ExpressionId::none) continue;
    if (numbered && variable.index == ir::ExpressionId::none)
      out.names.insert(interpreter::variable_name(variable.bank, variable.number));
    else if (variable.bank == ir::Bank::named)
      out.names.insert(std::string(program.strings.at(program.at(variable.symbol).name)));
    else if (variable.bank == ir::Bank::system)
      out.names.insert(std::string(program.strings.at(variable.name)));
  }
}

Reads reads_of_rest(const RestartDraft& draft) {
  Reads out;
  for (const ir::Statement& s : draft.program.statements)
    if (s.line >= draft.line) add_reads(draft.program, s, out);
  if (draft.library == nullptr) return out;
  for (const auto& loaded : draft.library->loaded())
    for (const ir::Statement& s : loaded->read.program.statements) add_reads(loaded->read.program, s, out);
  return out;
}

const ir::Symbol* symbol_of(const RestartDraft& draft, std::string_view name) {
  const std::string_view base = name.substr(0, name.find('['));
  const auto found = std::ranges::find_if(
      draft.program.symbols, [&](const ir::Symbol& symbol) { return draft.program.strings.at(symbol.name) == base; });
  return found == draft.program.symbols.end() ? nullptr : &*found;
}

// #5221, $P_UIFR, data of the control: what was written there outlives the run that is not finished, or does not.
bool is_of_control(const RestartDraft& draft, const std::string& name) {
  if (name.starts_with('#')) {
    const auto number = static_cast<std::uint32_t>(text::parse_integer(name.substr(1)).value_or(0));
    const ir::VariableRange* range = ir::find_variable(draft.control, ir::Bank::hash, number);
    return number >= 1000 && (range == nullptr || range->use == ir::VariableUse::system);
  }
  if (name.starts_with('R') && name.size() > 1 && name.find_first_not_of("0123456789", 1) == std::string::npos)
    return false;
  const ir::Symbol* symbol = symbol_of(draft, name);
  return symbol == nullptr || symbol->is_global;
}

std::optional<RestartRefusal> write_value(RestartDraft& draft, const interpreter::VariableValue& value) {
  const ir::Symbol* symbol = symbol_of(draft, value.name);
  if (value.text) {
    draft.add({fmt::format("{}=\"{}\"", value.name, *value.text)});
  } else if (symbol != nullptr && (symbol->type == ir::ValueType::axis || symbol->type == ir::ValueType::frame)) {
    return RestartRefusal{DiagnosticId::restart_unknown, "how the value of " + value.name + " is written is"};
  } else if (value.value) {
    draft.add({draft.words.assignment(value.name, *value.value)});
  } else if (value.name.starts_with('#')) {
    draft.add({value.name + "=#0"});
  }
  return std::nullopt;
}

// Of the program's own codes that the run does not carry out; "" for those that it does.
std::string not_repeated(const ir::Program& program, const ir::Code& code) {
  if (code.function == ir::Function::machine_function) return ir::name_of_machine_function(code.argument);
  const bool idle = code.function == ir::Function::no_effect || code.function == ir::Function::not_modelled;
  return idle ? std::string(program.strings.at(code.name)) : std::string();
}

}  // namespace

std::optional<RestartRefusal> write_variables(RestartDraft& draft) {
  const RestartPoint& point = draft.point;
  const Reads reads = reads_of_rest(draft);
  for (const std::string& name : point.changed)
    if (is_of_control(draft, name) && reads.has(name))
      return RestartRefusal{DiagnosticId::restart_unknown,
                            name + ", which the program has written and reads again, is"};
  for (const std::string& name : point.unknown)
    if (reads.has(name)) return RestartRefusal{DiagnosticId::restart_unknown, "the value of " + name + " is"};
  for (const interpreter::VariableValue& value : point.variables) {
    const bool text = value.text.has_value() && symbol_of(draft, value.name) != nullptr;
    if ((!text && !point.changed.contains(value.name)) || !reads.has(value.name)) continue;
    if (is_of_control(draft, value.name)) continue;
    if (auto refused = write_value(draft, value)) return refused;
  }
  std::vector<std::string> from_outside;
  for (const std::string& name : reads.names) {
    const bool numbered = name.starts_with('#') || (name.starts_with('R') && symbol_of(draft, name) == nullptr);
    if (numbered && !point.changed.contains(name) && name != "#0") from_outside.push_back(name);
  }
  if (!from_outside.empty())
    draft.assumptions.push_back(
        fmt::format("The rest reads {}, which the program does not set before: the values are those of the first run.",
                    fmt::join(from_outside, ", ")));
  return std::nullopt;
}

std::optional<RestartRefusal> look_at_what_is_left_out(RestartDraft& draft) {
  for (const interpreter::NotInterpreted& one : draft.run.result.not_interpreted) {
    const bool before = one.program != 0 || one.first_line < draft.line;
    // Where a reference point lies is not known, which the positions say themselves.
    const bool has_own_report =
        one.function == ir::Function::machine_function || one.function == ir::Function::reference_return;
    const bool is_other_spindle =
        one.function == ir::Function::other_spindle || one.function == ir::Function::main_spindle;
    if (!before || (one.effects_known && !is_other_spindle) || one.is_input || has_own_report) continue;
    return RestartRefusal{DiagnosticId::restart_unknown,
                          fmt::format("what {} in line {}{} has changed is", one.name, one.first_line,
                                      one.program == 0 ? "" : " of a called program")};
  }
  std::map<std::string, std::uint32_t> last_lines;
  for (std::uint32_t i = draft.places.main().first; i < draft.places.main().last; ++i) {
    const ir::Statement& s = draft.program.statements[i];
    if (s.line >= draft.line) break;
    if (s.kind != ir::StatementKind::block || draft.run.seen(s.line).visits == 0) continue;
    for (const ir::Code& code : draft.program.codes_of(draft.program.blocks[s.payload]))
      if (std::string name = not_repeated(draft.program, code); !name.empty()) last_lines[std::move(name)] = s.line;
  }
  std::vector<std::string> named;
  named.reserve(last_lines.size());
  for (const auto& [name, line] : last_lines) named.push_back(fmt::format("{} (line {})", name, line));
  if (!named.empty())
    draft.assumptions.push_back(
        fmt::format("What these codes did is still so and is not repeated: {}.", fmt::join(named, ", ")));
  return std::nullopt;
}

}  // namespace dripfeed::compile
