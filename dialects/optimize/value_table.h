// Numbers for values: two expressions with the same number are worth the same wherever both are computed.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <tuple>
#include <vector>

#include "dialects/ir/expression.h"

namespace dripfeed::optimize {

using Value = std::uint32_t;
inline constexpr Value kNoValue = 0xFFFFFFFFU;

class ValueTable {
 public:
  // Of which nothing is known but that it is one value.
  Value fresh() { return add(std::nullopt); }
  Value constant(double value);
  Value computed(ir::Operator op, Value a, Value b, Value c);
  [[nodiscard]] std::optional<double> constant_of(Value value) const { return constants_[value]; }

 private:
  Value add(std::optional<double> constant) {
    constants_.push_back(constant);
    return static_cast<Value>(constants_.size() - 1);
  }

  std::vector<std::optional<double>> constants_;
  std::map<double, Value> by_constant_;
  std::map<std::tuple<ir::Operator, Value, Value, Value>, Value> by_operands_;
};

inline Value ValueTable::constant(double value) {
  const auto [at, is_new] = by_constant_.try_emplace(value, kNoValue);
  if (is_new) at->second = add(value);
  return at->second;
}

inline Value ValueTable::computed(ir::Operator op, Value a, Value b, Value c) {
  const auto [at, is_new] = by_operands_.try_emplace({op, a, b, c}, kNoValue);
  if (is_new) at->second = add(std::nullopt);
  return at->second;
}

}  // namespace dripfeed::optimize
