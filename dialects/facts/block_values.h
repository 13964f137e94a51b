// The codes and words of one block, with or without what stands after "/n" inside it, and the numbers that its words
// give.
#pragma once

#include <bitset>
#include <optional>
#include <span>

#include "dialects/ir/program.h"
#include "dialects/ir/semantics.h"

namespace dripfeed::facts {

// T0606: the last two digits are the offset; with more than four digits the last three.
struct ToolPair {
  double tool = 0.0;
  double offset = 0.0;
};
ToolPair tool_of_pair(double word);

// A length that counts increments, in mm or inch.
double of_increments(double count, const ir::Semantics& semantics, bool inch);

struct BlockValues {
  BlockValues(const ir::Program& program, const ir::Block& block, bool with_rest);

  [[nodiscard]] bool has_code(ir::Function function) const;
  // A code whose number is computed (G#130, M=…).
  [[nodiscard]] bool has_computed_code(char letter) const;
  // The last one of the address; nullptr without one.
  [[nodiscard]] const ir::Word* word(ir::Address address) const;
  // Nothing where the value is computed, or a text.
  [[nodiscard]] std::optional<double> constant(const ir::Word& word) const;
  // `without`: where the block has no such word.
  [[nodiscard]] std::optional<double> constant_or(ir::Address address, double without) const;
  [[nodiscard]] bool is_text(const ir::Word& word) const;
  [[nodiscard]] bool has_point(const ir::Word& word) const;

  const ir::Program& program;
  std::span<const ir::Code> codes;
  std::span<const ir::Word> words;

 private:
  void leave_out_rest(const ir::Block& block);

  std::bitset<static_cast<std::size_t>(ir::Address::count_)> addresses_;  // of `words`: most are not there
};

}  // namespace dripfeed::facts
