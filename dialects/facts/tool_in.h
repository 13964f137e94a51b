// The tool in the spindle, for whoever must name it.
#pragma once

#include <cstdint>
#include <optional>

#include "dialects/facts/modal_facts.h"
#include "dialects/ir/program.h"

namespace dripfeed::facts {

struct ToolIn {
  enum class State : std::uint8_t { none, tool, differs };  // none: none is stated; differs: or is not known here
  State state = State::none;
  ir::ExpressionId value = ir::ExpressionId::none;  // of T: its number, or a text
  std::optional<double> number = {};                // where it is one
  // What may have changed it since, outside of the text: a call or the like. kNoIndex: nothing.
  std::uint32_t changer = ir::kNoIndex;
};

// `tool`: one of Kept::tool and Kept::next_tool.
ToolIn tool_in(const ir::Program& program, const Known<Written>& tool);

}  // namespace dripfeed::facts
