// Assignments to outputs by their variables: numbers of the controls with #, names of SINUMERIK, whose H words go to
// the PLC as well.
#include "server/app/checks/outputs_written.h"

#include <algorithm>
#include <cstdint>
#include <set>
#include <string>
#include <string_view>

#include <fmt/format.h>

namespace dripfeed::app {

namespace {

struct NumberRange {
  std::uint32_t first;
  std::uint32_t last;
};
// Signals to the PMC, and the relays of a Haas under their old and new numbers. A control that lacks some of them says
// so in its own table of variables.
constexpr NumberRange kNumbers[] = {{1100, 1155}, {12000, 12255}};

// Empty when the variable is no output.
std::string output_name(const ir::Program& program, const ir::Control& control, const ir::Variable& v) {
  if (v.bank == ir::Bank::hash && v.index == ir::ExpressionId::none) {
    const bool known = ir::find_variable(control, ir::Bank::hash, v.number) != nullptr;
    const bool is_output =
        std::ranges::any_of(kNumbers, [&](const NumberRange& r) { return v.number >= r.first && v.number <= r.last; });
    return known && is_output ? fmt::format("#{}", v.number) : std::string();
  }
  if (v.bank != ir::Bank::system || v.name == ir::StringId::none) return {};
  const bool is_output = ir::use_of_system(control, v.number) == ir::SystemUse::output;
  return is_output ? std::string(program.strings.at(v.name)) : std::string();
}

// H of a control without numbered variables; elsewhere it is a length or an increment.
bool has_auxiliary_word(const ir::Program& program, const ir::Control& control, const ir::Statement& statement) {
  if (statement.kind != ir::StatementKind::block || ir::has_numbered_variables(control)) return false;
  const auto words = program.words_of(program.blocks[statement.payload]);
  return std::ranges::find(words, ir::Address::h, &ir::Word::address) != words.end();
}

// Empty when the statement writes none.
std::string written_output(const ir::Program& program, const ir::Control& control, const ir::Statement& statement) {
  if (has_auxiliary_word(program, control, statement)) return "H";
  if (statement.kind != ir::StatementKind::assign) return {};
  const ir::VariableId target = program.assigns[statement.payload].target;
  return target == ir::VariableId::none ? std::string() : output_name(program, control, program.at(target));
}

}  // namespace

bool list_outputs(const ir::Program& program, const ir::Control& control, checks::NotCheckedList& not_checked) {
  std::set<std::string> listed;
  for (const ir::Statement& statement : program.statements) {
    const std::string name = written_output(program, control, statement);
    if (name.empty() || !listed.insert(name).second) continue;
    not_checked.add(fmt::format("{}: what this output does is not known", name), statement.line);
  }
  return !listed.empty();
}

}  // namespace dripfeed::app
