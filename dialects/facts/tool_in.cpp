// Paths that disagree, and variables with another value by now, make it unknown; a called program only may have changed
// it.
#include "dialects/facts/tool_in.h"

#include "dialects/facts/calls.h"

namespace dripfeed::facts {

namespace {

bool goes_elsewhere(const ir::Program& program, std::uint32_t changer) {
  if (changer >= program.statements.size()) return false;
  const ir::StatementKind kind = program.statements[changer].kind;
  return is_call(kind) || kind == ir::StatementKind::native || kind == ir::StatementKind::repeat_section ||
         kind == ir::StatementKind::execute_text;
}

}  // namespace

ToolIn tool_in(const ir::Program& program, const Known<Written>& tool) {
  if (tool.origin == kNoStatement) return {};
  const bool elsewhere = goes_elsewhere(program, tool.changer);
  const bool is_known = tool.value.is_number || tool.value.value != ir::ExpressionId::none;
  if (!tool.agrees() || (tool.changer != kNoStatement && !elsewhere) || (tool.value.is_stated && !is_known))
    return {.state = ToolIn::State::differs};
  if (!tool.value.is_stated) return {};
  return {.state = ToolIn::State::tool,
          .value = tool.value.value,
          .number = tool.value.is_number ? std::optional(tool.value.number) : std::nullopt,
          .changer = elsewhere ? tool.changer : ir::kNoIndex};
}

}  // namespace dripfeed::facts
