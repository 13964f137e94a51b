// The program's own block of the change is written again where there is one; otherwise the words are made.
#include "dialects/compile/restart/restart_tool.h"

#include <algorithm>

#include <fmt/format.h>

#include "dialects/compile/restart/restart_retract.h"

namespace dripfeed::compile {

namespace {

using interpreter::ModalState;
using interpreter::Tool;
using ir::Address;
using ir::Function;

// Nothing but the change of a tool, said by constants: written again as the programmer wrote it.
bool is_tool_block(const ir::Program& program, const ir::Statement& s) {
  if (s.kind != ir::StatementKind::block || s.skip_level != 0) return false;
  const ir::Block& block = program.blocks[s.payload];
  bool has_tool = false;
  for (const ir::Code& code : program.codes_of(block))
    if (code.function != Function::tool_change || code.number != ir::ExpressionId::none) return false;
  for (const ir::Word& word : program.words_of(block)) {
    if (word.address != Address::t && word.address != Address::d) return false;
    const ir::Operator op = program.at(word.value).op;
    if (op != ir::Operator::constant && op != ir::Operator::string) return false;
    has_tool |= word.address == Address::t;
  }
  return has_tool && block.rest_level == 0;
}

// The line of the main program that brought the tool in with the offset that it has; 0: no line of that kind.
std::uint32_t tool_line(const RestartDraft& draft) {
  const auto& motions = draft.run.motions;
  for (std::size_t i = draft.run.first_motion(draft.point.ordinal); i-- > 0;) {
    if (motions[i].kind != ir::MotionKind::tool) continue;
    const std::uint32_t line = motions[i].place.line;
    const std::uint32_t at = motions[i].place.program == 0 ? draft.places.statement_at(line) : ir::kNoIndex;
    if (at == ir::kNoIndex || !is_tool_block(draft.program, draft.program.statements[at])) return 0;
    const bool alone = at + 1 >= draft.places.main().last || draft.program.statements[at + 1].line != line;
    return alone ? line : 0;
  }
  return 0;
}

std::string name_or_number(const RestartDraft& draft, const Tool& tool) {
  if (tool.name != interpreter::kNoText) return fmt::format("T=\"{}\"", draft.run.names.strings[tool.name]);
  if (draft.control.semantics.tool_word == ir::ToolWord::number_and_offset)
    return fmt::format("T{:02}{:02}", tool.number, tool.offset);
  return draft.words.count('T', tool.number);
}

// T1.2 and T1.3 are two tools: of the number the run keeps what stands before the point.
RestartRefusal cannot_write_number() {
  return {text::DiagnosticId::restart_unknown, "how the number of the tool is written is"};
}

std::string edge(const RestartDraft& draft, const ModalState& state) {
  if (!draft.control.semantics.d_selects_edge) return {};
  if (state.tool.offset != 0) return draft.words.count('D', state.tool.offset);
  return state.length_offset == ir::LengthOffset::off ? "D0" : "";
}

}  // namespace

std::optional<RestartRefusal> write_tool(RestartDraft& draft) {
  const ModalState& state = draft.point.state;
  const bool at_once = draft.words.rules().tool_at_once;
  const bool pairs = draft.control.semantics.tool_word == ir::ToolWord::number_and_offset;
  if (state.tool == Tool{}) {
    if (state.selected != Tool{} && !pairs) draft.add({name_or_number(draft, state.selected)});
    draft.assumptions.emplace_back(
        "The program names no tool before this line: the one in the spindle is the right one.");
    if (std::string word = edge(draft, state); word != "D0") draft.add({word});
    return std::nullopt;
  }
  if (const std::uint32_t line = tool_line(draft); line != 0) {
    draft.add({bare_line(draft, line)});
  } else if (draft.control.semantics.tool_number_has_suffix) {
    return cannot_write_number();
  } else if (draft.words.by_number()) {
    draft.add({name_or_number(draft, state.tool), at_once ? "" : draft.words.code(Function::tool_change)});
  } else {
    draft.add({name_or_number(draft, state.tool)});
    if (!at_once) draft.add({draft.words.code(Function::tool_change)});
  }
  draft.add({edge(draft, state)});
  if (auto refused = write_prepared_tool(draft)) return refused;
  // The number of the compensation, which a later G41 takes.
  if (!draft.control.semantics.d_selects_edge && !draft.turns() && state.comp_number > 0.0)
    draft.add({draft.words.count('D', state.comp_number)});
  return std::nullopt;
}

std::optional<RestartRefusal> write_prepared_tool(RestartDraft& draft) {
  const ModalState& state = draft.point.state;
  const bool same = state.selected.number == state.tool.number && state.selected.name == state.tool.name;
  if (same || draft.words.rules().tool_at_once) return std::nullopt;
  if (draft.control.semantics.tool_number_has_suffix) return cannot_write_number();
  draft.add({name_or_number(draft, state.selected)});
  return std::nullopt;
}

}  // namespace dripfeed::compile
