// Blocks of the program that only retract are found by their codes and words.
#include "dialects/compile/restart/restart_retract.h"

#include <algorithm>

#include <fmt/format.h>

namespace dripfeed::compile {

namespace {

using ir::Address;
using ir::Function;

bool is_constant(const ir::Program& program, const ir::Word& word) {
  if (word.value == ir::ExpressionId::none) return false;
  const ir::Expression& value = program.at(word.value);
  return value.op == ir::Operator::constant ||
         (value.op == ir::Operator::negate && program.at(value.a).op == ir::Operator::constant);
}

// SUPA Z500 D0, G75 Z1=0: the tool axis alone (of a lathe both) to a machine position, and nothing else.
bool is_retract(const RestartDraft& draft, const ir::Block& block) {
  const ir::Program& program = draft.program;
  bool to_machine = false;
  for (const ir::Code& code : program.codes_of(block)) {
    const bool here = code.function == Function::machine_coordinates || code.function == Function::reference_return;
    const bool is_allowed_with_it =
        code.function == Function::rapid || code.function == Function::absolute || code.function == Function::comp_off;
    if ((!here && !is_allowed_with_it) || code.number != ir::ExpressionId::none) return false;
    to_machine |= here;
  }
  bool tool_axis = false;
  for (const ir::Word& word : program.words_of(block)) {
    const bool axis = word.address == Address::z || (draft.turns() && word.address == Address::x);
    if ((!axis && word.address != Address::d) || !is_constant(program, word)) return false;
    if (word.mode == ir::WordMode::incremental) return false;
    tool_axis |= axis;
  }
  return to_machine && tool_axis;
}

// The nearest before the line, otherwise the first after it; 0: there is none.
std::uint32_t retract_line(const RestartDraft& draft) {
  std::uint32_t found = 0;
  for (std::uint32_t i = draft.places.main().first; i < draft.places.main().last; ++i) {
    const ir::Statement& s = draft.program.statements[i];
    if (s.line >= draft.line && found != 0) break;
    if (s.kind != ir::StatementKind::block || s.skip_level != 0 || draft.run.seen(s.line).visits == 0) continue;
    const ir::Block& block = draft.program.blocks[s.payload];
    if (block.rest_level == 0 && is_retract(draft, block)) found = s.line;
  }
  return found;
}

void by_reference_point(RestartDraft& draft) {
  const RestartWords& words = draft.words;
  const std::string back = words.code(Function::reference_return, 1);
  const std::string zero = draft.turns() ? "X and then Z" : "Z";
  if (draft.turns() && draft.control.semantics.incremental_letters_uvw) {
    draft.add({back, "U0."});
    draft.add({back, "W0."});
  } else {
    draft.add({words.code(Function::incremental)});
    if (draft.turns()) draft.add({back, "X0."});
    draft.add({back, "Z0."});
    draft.add({words.code(Function::absolute)});
  }
  draft.assumptions.push_back(
      fmt::format("{} can go to the reference point from where the tool stands, and the tool is changed there.", zero));
}

}  // namespace

std::string bare_line(const RestartDraft& draft, std::uint32_t line) {
  std::string_view text = draft.program.source.line(line);
  text = text.substr(0, text.find_first_of(";("));
  const auto skip = [&](std::string_view set) {
    text.remove_prefix(std::min(text.find_first_not_of(set), text.size()));
  };
  skip(" \t");
  if (text.starts_with('N') || text.starts_with('n')) {
    text.remove_prefix(1);
    skip("0123456789");
    skip(" \t");
  }
  text = text.substr(0, text.find_last_not_of(" \t\r") + 1);
  return std::string(text);
}

void write_retract(RestartDraft& draft) {
  if (draft.words.by_number()) return by_reference_point(draft);
  if (const std::uint32_t line = retract_line(draft); line != 0) {
    draft.add({bare_line(draft, line)});
    draft.assumptions.push_back(
        fmt::format("The tool can retract as line {} does from where it stands, and is changed there.", line));
    return;
  }
  draft.add({draft.words.code(Function::program_stop), "; IS THE TOOL CLEAR OF WORK AND FIXTURE?"});
  draft.assumptions.emplace_back(
      "The program has no block that takes the tool clear: a person does it by hand before the stop is ended.");
}

}  // namespace dripfeed::compile
