// Whether a text that was laid out again is still the same program: word for word, whatever stands between the words.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "dialects/ir/stage.h"

namespace dripfeed::app {

// The tokens of a block that are no blanks, [first, last) of `indexes`.
struct BlockTokens {
  std::uint32_t first = 0;
  std::uint32_t last = 0;
  std::uint32_t begin = 0;  // offset of the block in the text
};
struct TokenBlocks {
  std::vector<std::uint32_t> indexes;  // of Program::tokens
  std::vector<BlockTokens> blocks;     // each up to its EOB
};
TokenBlocks blocks_of(const ir::Program& program);

// Blocks, by their number from 0, whose words are others, the case of letters aside; nothing: there are more or fewer
// blocks.
std::optional<std::vector<std::uint32_t>> changed_blocks(const ir::Program& before, const ir::Program& after);

// Both do the same, where all their words are the same: what the reader made of them is. False also where only the
// name of a program or of a called one is another.
bool is_same_program(const ir::Program& before, const ir::Program& after);

}  // namespace dripfeed::app
