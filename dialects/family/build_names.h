// What becomes of a family's names when its program is built: which are numbers in the text, which are variables at
// all, and which of those change.
#pragma once

#include <cstddef>
#include <cstdint>
#include <set>
#include <span>
#include <vector>

#include "dialects/family/bind.h"

namespace dripfeed::family {

// From an `if` or `else` whose branch is not taken: to its `else`, or to the step before its `end`.
std::size_t skip_branch(const std::vector<Step>& steps, std::size_t at);

class BuildNames {
 public:
  explicit BuildNames(const BoundFamily& bound);

  // Decided now, and a number in the text: constants, choices, tools, the counts of lists.
  [[nodiscard]] bool is_fixed(ir::SymbolId symbol) const { return fixed_[static_cast<std::size_t>(symbol)] != 0; }
  // Named by a step, or by what a step names.
  [[nodiscard]] bool is_needed(ir::SymbolId symbol) const { return needed_[static_cast<std::size_t>(symbol)] != 0; }
  // The target of a `set`.
  [[nodiscard]] bool is_set(ir::SymbolId symbol) const { return set_.contains(symbol); }
  [[nodiscard]] std::span<const double> values() const { return bound_.values; }
  [[nodiscard]] double value_of(ir::SymbolId symbol) const { return bound_.values[static_cast<std::size_t>(symbol)]; }

  // Whether what the expression says is decided now.
  [[nodiscard]] bool is_decided(ir::ExpressionId id) const;
  // Whether it is a whole number whatever the parameters are.
  [[nodiscard]] bool is_always_whole(ir::ExpressionId id) const;
  // Whether a loop goes from a whole number to a whole number by one.
  [[nodiscard]] bool counts_whole(const Step& loop) const;

 private:
  void find_whole_counters();
  void find_fixed();
  void find_needed();
  void need(ir::ExpressionId id);
  void need(ir::SymbolId symbol) { needed_[static_cast<std::size_t>(symbol)] = 1; }
  void need(const Step& step);
  void need_numbers(const List& list);
  void need_steps();

  const BoundFamily& bound_;
  const Family& family_;
  std::vector<std::uint8_t> fixed_;   // by symbol
  std::vector<std::uint8_t> needed_;  // by symbol
  std::set<ir::SymbolId> set_;
  std::set<ir::SymbolId> whole_counters_;  // names of such loops alone
};

}  // namespace dripfeed::family
