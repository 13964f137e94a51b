// Which tool is in the spindle at each statement, on all ways that lead there: where M6 changes it, T only names the
// next one. For controls whose D is an edge of the tool that is in.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "dialects/ir/program.h"

namespace dripfeed::passes {

struct ToolState {
  enum class Known : std::uint8_t { none, tool, differs };  // differs: by the way, or by a variable that changes
  struct Tool {
    Known known = Known::none;
    ir::ExpressionId value = ir::ExpressionId::none;  // of T: its number, or a text
  };
  Tool in;                                              // in the spindle
  Tool next;                                            // named by T, to come in by M6
  bool has_edge = false;                                // D was said for the tool that is in
  ir::ExpressionId next_edge = ir::ExpressionId::none;  // D beside T
  std::uint32_t caller = ir::kNoIndex;                  // a call since the last change, which may have made another
};

class ToolFlow {
 public:
  // Must outlive it.
  explicit ToolFlow(const ir::Program& program);

  // Before the statement; nullptr where no way leads.
  [[nodiscard]] const ToolState* before(std::uint32_t statement) const;
  // Behind the block's own T, M6 and D.
  [[nodiscard]] ToolState after(std::uint32_t statement, ToolState state) const;
  // Whether T alone brings a tool in: the program has no M6.
  [[nodiscard]] bool changes_at_once() const { return at_once_; }
  [[nodiscard]] bool same_value(ir::ExpressionId a, ir::ExpressionId b) const;

 private:
  [[nodiscard]] bool has_change() const;
  [[nodiscard]] bool uses(ir::ExpressionId value, const ir::Variable& variable) const;
  void forget(const ir::Variable& variable, ToolState& state) const;
  [[nodiscard]] bool meet(ToolState& state, const ToolState& with) const;
  [[nodiscard]] bool meet(ToolState::Tool& tool, const ToolState::Tool& with) const;
  void take_block(const ir::Block& block, ToolState& state) const;

  const ir::Program& program_;
  bool at_once_;
  std::vector<std::optional<ToolState>> before_;
};

}  // namespace dripfeed::passes
