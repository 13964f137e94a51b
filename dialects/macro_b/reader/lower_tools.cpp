// A tool change that names the tool of the next one.
#include <algorithm>

#include "dialects/macro_b/reader/lower.h"

namespace dripfeed::macro_b {

bool BlockLowering::changes_tool(std::uint32_t first_code) const {
  return std::ranges::any_of(std::span(program_.codes).subspan(first_code),
                             [](const ir::Code& c) { return c.function == ir::Function::tool_change; });
}

// T2 T3 M6: T2 is put in, then T3 is made ready, as by a block of its own. T2 T0 M6: none is. (Mazak, "Tool command of
// machining centers"; the order is from memory, and programs for Mazak have T0 second.)
void BlockLowering::emit_tool_change(std::uint32_t first_code, std::uint32_t first_word, const BlockPlace& place) {
  const auto is_tool = [](const ir::Word& w) { return w.address == ir::Address::t; };
  const auto first = std::ranges::find_if(program_.words.begin() + static_cast<std::ptrdiff_t>(first_word),
                                          program_.words.end(), is_tool);
  const auto second = first == program_.words.end() ? first : std::find_if(first + 1, program_.words.end(), is_tool);
  if (second == program_.words.end()) return emit_block(first_code, first_word, place);
  const ir::Word next = *second;
  program_.words.erase(second);
  emit_block(first_code, first_word, place);
  const ir::Expression& e = program_.at(next.value);
  if (e.op == ir::Operator::constant && e.value == 0.0) return;
  const auto word = static_cast<std::uint32_t>(program_.words.size());
  program_.words.push_back(next);
  emit_block(static_cast<std::uint32_t>(program_.codes.size()), word, place);
}

}  // namespace dripfeed::macro_b
