// The part of a program that a REPEAT or REPEATB runs again: found alike by whoever runs, checks or translates
// it. (SINUMERIK Programming Manual Job Planning, "Program section repetition".)
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "dialects/ir/program.h"

namespace dripfeed::ir {

struct RepeatedPart {
  std::uint32_t repeat = 0;        // the statement with REPEAT
  std::uint32_t first = kNoIndex;  // first statement of the first block
  std::uint32_t last = kNoIndex;   // last statement of the last block; none: up to the REPEAT itself
  bool is_open = false;            // no last label is named

  [[nodiscard]] bool is_found() const { return first != kNoIndex && (is_open || last != kNoIndex); }
};

// One for each repeat_section, in the order of the text. A label is looked for above the REPEAT first, then below it.
std::vector<RepeatedPart> repeated_parts(const Program& program);

// The first block of a part of the text that has a label, as labels are kept, or N and its number.
struct LabelledBlock {
  std::uint32_t first = kNoIndex;  // its statements
  std::uint32_t last = kNoIndex;
  bool is_bare = false;  // nothing but the label
};
std::optional<LabelledBlock> labelled_block(const Program& program, Section range, std::string_view name);

// Whether the statement is the first of its block: the first one holds the block's tokens. Programs that were built
// have none: there each statement is a block, but for those that follow on the same line of the same block.
bool begins_block(const Program& program, std::uint32_t statement);

}  // namespace dripfeed::ir
