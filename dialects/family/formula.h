// An expression that is computed very often, with all names but one or two given once: constants are folded and the
// operators found beforehand. What it computes is what `evaluate` does.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "dialects/family/evaluate.h"
#include "dialects/ir/program.h"

namespace dripfeed::family {

class Formula {
 public:
  // `values` has one number a symbol; `first` and `second` stay free (none: it has no such variable).
  Formula(const ir::Program& arena, ir::ExpressionId expression, std::span<const double> values, ir::SymbolId first,
          ir::SymbolId second = ir::SymbolId::none);

  // The slope is by the first variable.
  [[nodiscard]] Dual at(double first, double second = 0.0) const;

 private:
  struct Node {
    UnaryRule unary = nullptr;
    BinaryRule binary = nullptr;
    std::uint32_t a = 0;
    std::uint32_t b = 0;
    Dual constant = {};
  };
  static constexpr std::uint32_t kFirst = 0;  // the first two nodes are the variables
  static constexpr std::uint32_t kSecond = 1;

  std::uint32_t add(const ir::Program& arena, ir::ExpressionId id, std::span<const double> values);
  [[nodiscard]] bool is_free_of(const ir::Program& arena, ir::ExpressionId id) const;
  [[nodiscard]] bool is_constant(std::uint32_t node) const;

  std::array<ir::SymbolId, 2> free_;
  std::vector<Node> nodes_;  // operands before operators
  std::uint32_t root_ = 0;
};

}  // namespace dripfeed::family
