// What the variables of a program measure, as far as the program shows it: an axis word takes a length, a sine an
// angle, F the feed of the mode in effect, an index a count. From there through sums, comparisons and assignments.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "dialects/facts/resolved.h"
#include "dialects/family/unit.h"
#include "dialects/ir/control.h"
#include "dialects/ir/program.h"

namespace dripfeed::compile {

struct VariableQuantity {
  family::Dimension dimension = {};
  bool is_count = false;  // whole numbers
  bool is_ms = false;     // a time in milliseconds, not in seconds
  friend bool operator==(const VariableQuantity&, const VariableQuantity&) = default;
};

// A word that takes a variable, or what is computed from it without a change of its unit.
struct WordUse {
  std::uint32_t statement = 0;
  family::Dimension dimension = {};
  bool mode_known = true;  // of F: feed per minute or per revolution
  friend bool operator==(const WordUse&, const WordUse&) = default;
};

class VariableQuantities {
 public:
  // All three must outlive it.
  VariableQuantities(const ir::Program& program, const ir::Control& control, const facts::Resolved& resolved);

  // Nothing where no use shows it, or two uses disagree.
  [[nodiscard]] std::optional<VariableQuantity> of(const ir::Variable& variable) const;
  [[nodiscard]] std::optional<VariableQuantity> of(ir::SymbolId symbol) const;
  // In the order of the text; of statements in `scope` alone, which has one bit a statement.
  [[nodiscard]] std::vector<WordUse> uses_of(const std::vector<ir::Variable>& variables,
                                             const std::vector<bool>& scope) const;

 private:
  using Key = std::pair<ir::Bank, std::uint32_t>;
  struct Known {
    VariableQuantity quantity;
    bool is_contradicted = false;
  };
  static std::optional<Key> key_of(const ir::Variable& variable);

  void learn();
  void block(std::uint32_t statement);
  void dwell(const ir::Block& block);
  void word(const ir::Word& word, std::uint32_t statement);
  void use(const WordUse& use, ir::ExpressionId value);
  void expressions(const ir::Statement& statement);
  void node(ir::ExpressionId id);
  void assignment(const ir::Assign& assign);
  void call(const ir::Call& call);
  void counters();
  void counted_by(ir::ExpressionId one, ir::ExpressionId other);
  void take(ir::ExpressionId id, VariableQuantity quantity);
  void pass_on(ir::ExpressionId id, VariableQuantity quantity, const Key& to);
  void note(const Key& key, VariableQuantity quantity);
  [[nodiscard]] std::optional<VariableQuantity> quantity_of(ir::ExpressionId id) const;
  [[nodiscard]] bool is_ratio(ir::ExpressionId id) const;
  [[nodiscard]] std::optional<Key> counter_in(ir::ExpressionId id) const;

  const ir::Program& program_;
  const ir::Control& control_;
  const facts::Resolved& resolved_;
  std::map<Key, Known> known_;
  std::map<Key, std::vector<WordUse>> uses_;
  std::map<Key, std::set<Key>> passed_on_;  // to those that are computed from it
  const WordUse* using_ = nullptr;          // by whom take() was called
  const Key* passing_to_ = nullptr;
  bool changed_ = false;
};

}  // namespace dripfeed::compile
