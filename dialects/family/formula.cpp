// Nodes in evaluation order; each is one call through a pointer.
#include "dialects/family/formula.h"

#include <algorithm>
#include <limits>

namespace dripfeed::family {

namespace {

constexpr std::size_t kShort = 32;  // nodes that fit the stack
constexpr double kNoNumber = std::numeric_limits<double>::quiet_NaN();

}  // namespace

Formula::Formula(const ir::Program& arena, ir::ExpressionId expression, std::span<const double> values,
                 ir::SymbolId first, ir::SymbolId second)
    : free_{first, second}, nodes_(2) {
  root_ = add(arena, expression, values);
}

// An index that depends on what stays free names no single number of a list.
bool Formula::is_free_of(const ir::Program& arena, ir::ExpressionId id) const {
  return std::ranges::none_of(free_,
                              [&](ir::SymbolId free) { return free != ir::SymbolId::none && names(arena, id, free); });
}

bool Formula::is_constant(std::uint32_t node) const {
  return node > kSecond && nodes_[node].unary == nullptr && nodes_[node].binary == nullptr;
}

std::uint32_t Formula::add(const ir::Program& arena, ir::ExpressionId id, std::span<const double> values) {
  const ir::Expression& e = arena.at(id);
  Node node;
  const int operands = ir::operand_count(e.op);
  if (operands == 0) {
    if (e.op == ir::Operator::variable) {
      const ir::SymbolId symbol = arena.at(e.variable).symbol;
      if (symbol == free_[0] && symbol != ir::SymbolId::none) return kFirst;
      if (symbol == free_[1] && symbol != ir::SymbolId::none) return kSecond;
      node.constant = is_free_of(arena, id) ? evaluate(arena, id, values) : Dual{kNoNumber};
      nodes_.push_back(node);
      return static_cast<std::uint32_t>(nodes_.size() - 1);
    }
    node.constant = evaluate(arena, id, values);
  } else if (e.op == kAlong) {
    node.constant = is_free_of(arena, id) ? evaluate(arena, id, values) : Dual{kNoNumber};
  } else {
    node.a = add(arena, e.a, values);
    node.b = operands > 1 ? add(arena, e.b, values) : node.a;
    node.unary = operands > 1 ? nullptr : unary_rule(e.op);
    node.binary = operands > 1 ? binary_rule(e.op) : nullptr;
    if (node.unary == nullptr && node.binary == nullptr) {
      node.constant = {kNoNumber};
    } else if (is_constant(node.a) && is_constant(node.b)) {
      const Dual a = nodes_[node.a].constant;
      node.constant = node.unary != nullptr ? node.unary(a) : node.binary(a, nodes_[node.b].constant);
      node.unary = nullptr;
      node.binary = nullptr;
    }
  }
  nodes_.push_back(node);
  return static_cast<std::uint32_t>(nodes_.size() - 1);
}

Dual Formula::at(double first, double second) const {
  std::array<Dual, kShort> few;
  std::vector<Dual> many;
  Dual* values = few.data();
  if (nodes_.size() > kShort) {
    many.resize(nodes_.size());
    values = many.data();
  }
  values[kFirst] = {first, 1.0};
  values[kSecond] = {second, 0.0};
  for (std::size_t i = 2; i < nodes_.size(); ++i) {
    const Node& node = nodes_[i];
    if (node.unary != nullptr) {
      values[i] = node.unary(values[node.a]);
    } else if (node.binary != nullptr) {
      values[i] = node.binary(values[node.a], values[node.b]);
    } else {
      values[i] = node.constant;
    }
  }
  return values[root_];
}

}  // namespace dripfeed::family
