// What the variables of a program measure, as far as the program shows it: an axis word takes a length, a sine an
// angle, F the feed of the mode in effect, an index a count. From there through sums, comparisons and assignments.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <utility>

#include "dialects/facts/resolved.h"
#include "dialects/family/unit.h"
#include "dialects/ir/control.h"
#include "dialects/ir/program.h"

namespace dripfeed::compile {

struct VariableQuantity {
  family::Dimension dimension = {};
  bool is_count = false;  // whole numbers
  friend bool operator==(const VariableQuantity&, const VariableQuantity&) = default;
};

class VariableQuantities {
 public:
  // All three must outlive it.
  VariableQuantities(const ir::Program& program, const ir::Control& control, const facts::Resolved& resolved);

  // Nothing where no use shows it, or two uses disagree.
  [[nodiscard]] std::optional<VariableQuantity> of(const ir::Variable& variable) const;
  [[nodiscard]] std::optional<VariableQuantity> of(ir::SymbolId symbol) const;

 private:
  using Key = std::pair<ir::Bank, std::uint32_t>;
  struct Known {
    VariableQuantity quantity;
    bool is_contradicted = false;
  };
  static std::optional<Key> key_of(const ir::Variable& variable);

  void learn();
  void block(std::uint32_t statement);
  void word(const ir::Word& word, std::uint32_t statement);
  void expressions(const ir::Statement& statement);
  void node(ir::ExpressionId id);
  void assignment(const ir::Assign& assign);
  void call(const ir::Call& call);
  void counters();
  void counted_by(ir::ExpressionId one, ir::ExpressionId other);
  void take(ir::ExpressionId id, VariableQuantity quantity);
  void note(const Key& key, VariableQuantity quantity);
  [[nodiscard]] std::optional<VariableQuantity> quantity_of(ir::ExpressionId id) const;
  [[nodiscard]] bool is_ratio(ir::ExpressionId id) const;
  [[nodiscard]] std::optional<Key> counter_in(ir::ExpressionId id) const;

  const ir::Program& program_;
  const ir::Control& control_;
  const facts::Resolved& resolved_;
  std::map<Key, Known> known_;
  bool changed_ = false;
};

}  // namespace dripfeed::compile
