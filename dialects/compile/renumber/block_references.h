// Where a program names its own blocks by their numbers.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "dialects/ir/program.h"

namespace dripfeed::compile {

struct BlockReference {
  std::uint32_t number = 0;
  std::uint32_t statement = 0;
  text::Span span;  // of the digits
};

// What may name a block, and cannot be followed.
struct UnclearReference {
  std::uint32_t statement = 0;
  std::string why;
};

struct BlockReferences {
  std::vector<BlockReference> known;
  std::vector<UnclearReference> unclear;
  bool calls_others = false;  // programs that are not in this text
};

// Of "N10", ":10", "P0010": what follows the letter.
text::Span digits_of(std::string_view text, text::Span span);

BlockReferences block_references(const ir::Program& program);

}  // namespace dripfeed::compile
