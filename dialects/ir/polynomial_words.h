// The words of a polynomial (POLY): the axis word is its end, and each power above the first has an address of its own.
#pragma once

#include <cstddef>

#include "dialects/ir/statement.h"

namespace dripfeed::ir {

inline constexpr std::size_t kPolynomialAxes = 3;  // X Y Z
inline constexpr std::size_t kFirstPower = 2;
inline constexpr std::size_t kLastPower = 5;

// What stands before a power of the parameter; axis 0 is X.
constexpr Address coefficient_of(std::size_t axis, std::size_t power) {
  constexpr std::size_t kOfEach = kLastPower - kFirstPower + 1;
  return static_cast<Address>(static_cast<std::size_t>(Address::poly_x2) + axis * kOfEach + power - kFirstPower);
}
static_assert(coefficient_of(0, kLastPower) == Address::poly_x5);
static_assert(coefficient_of(2, kLastPower) == Address::poly_z5);

constexpr bool is_coefficient(Address address) { return address >= Address::poly_x2 && address <= Address::poly_z5; }

}  // namespace dripfeed::ir
