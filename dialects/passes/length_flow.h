// Whether the length of a tool is in effect before each statement, on all ways that lead there: by G43 and G49, by the
// offset of T0101, or by D where that is an edge of the tool.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "dialects/ir/control.h"
#include "dialects/ir/program.h"

namespace dripfeed::passes {

// unknown: by a caller, by a program that was called, or by the way.
enum class ToolLength : std::uint8_t { off, on, unknown };

class LengthFlow {
 public:
  // Must outlive it.
  LengthFlow(const ir::Program& program, const ir::Control& control);

  // As the statement's own motion finds it: its block's words and codes have taken effect.
  [[nodiscard]] ToolLength at(std::uint32_t statement) const;

 private:
  [[nodiscard]] ToolLength after(std::uint32_t statement, ToolLength length) const;
  [[nodiscard]] ToolLength after_block(const ir::Block& block, ToolLength length) const;

  const ir::Program& program_;
  const ir::Control& control_;
  std::vector<std::optional<ToolLength>> before_;
};

// Whether the block goes to a place of the machine (G53, SUPA) along an axis that has the tool's length: of mills Z,
// and all of them where the program leaves the plane XY.
bool moves_length_to_machine(const ir::Program& program, const ir::Block& block, const ir::Control& control);

}  // namespace dripfeed::passes
