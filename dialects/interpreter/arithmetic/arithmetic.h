// What each operator gives, defined once for the machine and for everybody who folds constants. Values are doubles;
// vacant is one NaN and a value that is not known another, and no operator ever gives a third: what is not defined is a
// fault.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string_view>

#include "dialects/ir/expression.h"
#include "dialects/ir/semantics.h"

namespace dripfeed::interpreter {

// The vacant value (#0, a variable that was never set). Where nothing is vacant it is a value that is not known, too.
inline constexpr double kVacant = std::bit_cast<double>(std::uint64_t{0x7FF8'0000'0000'0D1FULL});
// A value that is not known (Semantics::unset_is_unknown): what is computed from one is not known either.
inline constexpr double kUnknown = std::bit_cast<double>(std::uint64_t{0x7FF8'0000'0000'0D20ULL});
// Vacant, or not known: no number to calculate with.
inline bool is_vacant(double value) { return value != value; }
inline bool is_unknown(double value, const ir::Semantics& semantics) {
  if (!is_vacant(value) || !semantics.unset_is_unknown) return false;
  return !semantics.has_vacant || std::bit_cast<std::uint64_t>(value) == std::bit_cast<std::uint64_t>(kUnknown);
}
inline double value_or_zero(double value) { return is_vacant(value) ? 0.0 : value; }
// What a condition takes a value for: not zero; vacant is false, and one that is not known as well.
inline bool is_true(double value) { return value != 0.0 && !is_vacant(value); }

enum class Fault : std::uint8_t { none, division_by_zero, argument_out_of_domain, result_overflow, integer_overflow };

struct Outcome {
  double value = 0.0;
  Fault fault = Fault::none;
};

// Angles in degrees. Multiples of 90 are exact, so that TAN[90] is a division by zero.
double sine_deg(double angle_deg);
double cosine_deg(double angle_deg);

// Half goes away from zero or up; works for any finite value.
double round_to_integer(double value, ir::RoundHalf half);
// To eight significant decimal digits, half away from zero.
double round_to_eight_digits(double value);

// The function as messages call it: "the square root".
std::string_view describe(ir::Operator op);

class Arithmetic {
 public:
  explicit Arithmetic(const ir::Semantics& semantics);

  // Any operator of one or two operands that gives a number, on operands that may be vacant. Comparisons and logic give
  // 1 or 0. Rounding to eight digits and the overflow limit are applied.
  [[nodiscard]] Outcome unary(ir::Operator op, double a) const;
  [[nodiscard]] Outcome binary(ir::Operator op, double a, double b) const;
  // BOUND(low, high, x)
  [[nodiscard]] Outcome bound(double low, double high, double value) const;
  // a / b of two whole numbers on a control that divides them as such.
  [[nodiscard]] Outcome integer_quotient(double a, double b) const;

  // Largest magnitude of a result.
  [[nodiscard]] double limit() const { return limit_; }
  [[nodiscard]] double round(double value) const { return round_to_integer(value, semantics_.round_half); }
  // A value that is stored in a variable of that type, or fault: INT rounds, BOOL is 1 or 0, CHAR is 0 to 255.
  [[nodiscard]] Outcome convert(ir::ValueType type, double value) const;

  [[nodiscard]] bool equal(double a, double b) const { return relative_ ? near(a, b) : equal_exact(a, b); }
  // Vacant equals vacant only: vacant EQ 0 is false.
  static bool equal_exact(double a, double b) { return a == b || (is_vacant(a) && is_vacant(b)); }
  // Within the tolerance of the larger.
  [[nodiscard]] bool near(double a, double b) const {
    return std::abs(a - b) <= tolerance_ * std::fmax(std::abs(a), std::abs(b)) || equal_exact(a, b);
  }

  // a < b; with a tolerance near values are not less. Operands are not vacant.
  [[nodiscard]] bool less(double a, double b) const { return a < b && !(relative_ && near(a, b)); }

 private:
  struct Rules;  // the tables
  // Overflow is a fault, -0 becomes 0 (a trace would show it), eight-digit controls round.
  [[nodiscard]] Outcome finish(double value) const;

  ir::Semantics semantics_;
  // A value that is not known makes the result not known, whatever the operator does with vacant.
  [[nodiscard]] bool unknown(double a) const { return is_unknown(a, semantics_); }

  bool relative_;
  double tolerance_;
  double limit_;
};

}  // namespace dripfeed::interpreter
