// Look-ups in a handful of words.
#include "dialects/facts/block_values.h"

#include <algorithm>
#include <cmath>

namespace dripfeed::facts {

ToolPair tool_of_pair(double word) {
  constexpr double kLongest = 9999.0;
  const double number = std::trunc(std::abs(word));
  const double base = number > kLongest ? 1000.0 : 100.0;
  return {.tool = std::floor(number / base), .offset = std::fmod(number, base)};
}

// Of an inch the increment is a tenth: 0.0001 inch for 0.001 mm.
double of_increments(double count, const ir::Semantics& semantics, bool inch) {
  const double per_unit = std::nearbyint(1.0 / semantics.least_increment_mm);
  return count / (inch ? per_unit * 10.0 : per_unit);
}

BlockValues::BlockValues(const ir::Program& of, const ir::Block& block, bool with_rest)
    : program(of), codes(of.codes_of(block)), words(of.words_of(block)) {
  if (!with_rest && block.rest_level != 0) leave_out_rest(block);
  for (const ir::Word& word : words) addresses_.set(static_cast<std::size_t>(word.address));
}

void BlockValues::leave_out_rest(const ir::Block& block) {
  const auto stands_in_rest = [&block](const auto& item) { return ir::in_rest(block, item.span); };
  codes = codes.first(static_cast<std::size_t>(std::ranges::find_if(codes, stands_in_rest) - codes.begin()));
  words = words.first(static_cast<std::size_t>(std::ranges::find_if(words, stands_in_rest) - words.begin()));
}

bool BlockValues::has_code(ir::Function function) const {
  return std::ranges::find(codes, function, &ir::Code::function) != codes.end();
}

bool BlockValues::has_computed_code(char letter) const {
  return std::ranges::any_of(
      codes, [letter](const ir::Code& code) { return code.number != ir::ExpressionId::none && code.letter == letter; });
}

const ir::Word* BlockValues::word(ir::Address address) const {
  if (!addresses_.test(static_cast<std::size_t>(address))) return nullptr;
  const ir::Word* found = nullptr;
  for (const ir::Word& word : words)
    if (word.address == address) found = &word;
  return found;
}

std::optional<double> BlockValues::constant(const ir::Word& word) const {
  if (word.value == ir::ExpressionId::none) return std::nullopt;
  const ir::Expression& e = program.at(word.value);
  return e.op == ir::Operator::constant ? std::optional(e.value) : std::nullopt;
}

std::optional<double> BlockValues::constant_or(ir::Address address, double without) const {
  const ir::Word* found = word(address);
  return found == nullptr ? std::optional(without) : constant(*found);
}

bool BlockValues::is_text(const ir::Word& word) const {
  return word.value != ir::ExpressionId::none && program.at(word.value).op == ir::Operator::string;
}

bool BlockValues::has_point(const ir::Word& word) const {
  return word.value != ir::ExpressionId::none && program.at(word.value).has_point;
}

}  // namespace dripfeed::facts
