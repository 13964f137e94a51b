// What one statement does to the facts, calls of programs of the same text left out: those are followed by whoever
// walks the program.
#pragma once

#include <bitset>
#include <cstdint>
#include <vector>

#include "dialects/facts/modal_facts.h"
#include "dialects/ir/control.h"
#include "dialects/ir/program.h"

namespace dripfeed::facts {

// A bit for each mode, then one for each number.
using FactSet = std::bitset<kModes + kNumbers>;
FactSet differing(const Facts& a, const Facts& b);

class Effects {
 public:
  // Both must outlive it.
  Effects(const ir::Program& program, const ir::Control& control);

  // The facts after the statement. A call counts as one of a program that is not in the text, or of a cycle.
  void apply(std::uint32_t statement, Facts& facts) const;
  // Everything that the statement may set or change, whatever holds before it.
  [[nodiscard]] FactSet touched(std::uint32_t statement) const;
  // Whether the block may move, by its words, in a way that a modal call follows.
  [[nodiscard]] bool may_move(const ir::Statement& statement) const;

 private:
  struct Walk;  // one block
  void block(std::uint32_t statement, Facts& facts) const;

  const ir::Program& program_;
  const ir::Control& control_;
  bool tool_at_once_;        // T brings a tool in, without M6
  std::vector<bool> shape_;  // by statement: run for a cycle alone
};

}  // namespace dripfeed::facts
