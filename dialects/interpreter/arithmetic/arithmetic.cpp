// The operators, by what the manuals of the controls say of them; where they differ, ir::Semantics decides.
#include "dialects/interpreter/arithmetic/arithmetic.h"

#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <utility>

namespace dripfeed::interpreter {

namespace {

using ir::Operator;

// Largest magnitude on controls that calculate with eight digits.
constexpr double kEightDigitLimit = 1e47;
constexpr double kRadian = std::numbers::pi / 180.0;
constexpr double kDegree = 180.0 / std::numbers::pi;

constexpr Outcome fault(Fault f) { return {0.0, f}; }
constexpr std::size_t kOperatorCount = static_cast<std::size_t>(Operator::count_);
constexpr double truth(bool value) { return value ? 1.0 : 0.0; }

// An angle as quarter turns (0 to 3) and a rest of at most 45 degrees, both exact.
struct Quarters {
  unsigned quarter;
  double rest_deg;
};
Quarters split_angle(double angle_deg) {
  // Adding and taking away 1.5·2^52 rounds to the nearest integer; beyond 2^45 the product below is no longer exact.
  constexpr double kRounder = 6755399441055744.0;
  if (std::abs(angle_deg) > 3e13) angle_deg = std::remainder(angle_deg, 360.0);
  const double quarters = (angle_deg / 90.0 + kRounder) - kRounder;
  return {static_cast<unsigned>(static_cast<std::int64_t>(quarters) & 3), angle_deg - quarters * 90.0};
}

double sine_of(Quarters a) {
  const double rest = a.rest_deg * kRadian;
  switch (a.quarter) {
    case 0: return std::sin(rest);
    case 1: return std::cos(rest);
    case 2: return -std::sin(rest);
    default: return -std::cos(rest);
  }
}

// Bits of a value that bit operators see: a whole number that 32 bits hold, with or without sign.
constexpr double kLowestBits = -2147483648.0;
constexpr double kHighestBits = 4294967295.0;
bool fits_bits(double value) { return value >= kLowestBits && value <= kHighestBits; }
std::uint32_t bits_of(double value) { return static_cast<std::uint32_t>(static_cast<std::int64_t>(value)); }

// 25 -> 0x25 and back. Only whole numbers of decimal digits have a counterpart.
Outcome to_bcd(double value) {
  if (value < 0 || value > 99999999.0) return fault(Fault::argument_out_of_domain);
  std::uint32_t rest = static_cast<std::uint32_t>(value);
  std::uint32_t result = 0;
  for (unsigned shift = 0; rest != 0; shift += 4, rest /= 10) result |= (rest % 10) << shift;
  return {static_cast<double>(result)};
}
Outcome from_bcd(double value) {
  if (value < 0 || value > kHighestBits) return fault(Fault::argument_out_of_domain);
  double result = 0.0;
  double place = 1.0;
  for (std::uint32_t rest = static_cast<std::uint32_t>(value); rest != 0; rest >>= 4, place *= 10.0) {
    if ((rest & 15U) > 9) return fault(Fault::argument_out_of_domain);
    result += place * static_cast<double>(rest & 15U);
  }
  return {result};
}

}  // namespace

double sine_deg(double angle_deg) { return sine_of(split_angle(angle_deg)); }

double cosine_deg(double angle_deg) {
  const Quarters a = split_angle(angle_deg);
  return sine_of({(a.quarter + 1) & 3U, a.rest_deg});
}

double round_to_integer(double value, ir::RoundHalf half) {
  if (half == ir::RoundHalf::away_from_zero) return std::round(value);
  const double below = std::floor(value);
  return value - below >= 0.5 ? below + 1.0 : below;
}

double round_to_eight_digits(double value) {
  if (value == 0.0 || !std::isfinite(value)) return value;
  const int exponent = static_cast<int>(std::floor(std::log10(std::abs(value))));
  // A power of ten up to 22 is exact, so that 0.1 stays the double nearest to 0.1.
  const int shift = 7 - exponent;
  const double scale = std::pow(10.0, std::abs(shift));
  if (!std::isfinite(scale)) return value;
  return shift >= 0 ? std::round(value * scale) / scale : std::round(value / scale) * scale;
}

std::string_view describe(Operator op) {
  struct Row {
    Operator op;
    std::string_view name;
  };
  constexpr Row kRows[] = {
      {Operator::asin, "the arc sine"},
      {Operator::acos, "the arc cosine"},
      {Operator::sqrt, "the square root"},
      {Operator::ln, "the logarithm"},
      {Operator::bcd, "BCD"},
      {Operator::bin, "BIN"},
      {Operator::power, "the power"},
  };
  for (const Row& row : kRows)
    if (row.op == op) return row.name;
  return "the function";
}

Arithmetic::Arithmetic(const ir::Semantics& semantics)
    : semantics_(semantics),
      relative_(semantics.comparison == ir::ComparisonMode::relative),
      tolerance_(semantics.relative_tolerance),
      limit_(semantics.number_format == ir::NumberFormat::eight_digit ? kEightDigitLimit
                                                                      : std::numeric_limits<double>::max()) {}

Outcome Arithmetic::finish(double value) const {
  if (!(std::abs(value) <= limit_)) return fault(Fault::result_overflow);
  if (semantics_.number_format == ir::NumberFormat::eight_digit) value = round_to_eight_digits(value);
  return {value + 0.0};
}

// One row an operator. Operands come without vacant, but for equality, which distinguishes vacant from 0.
struct Arithmetic::Rules {
  using Unary = Outcome (*)(const Arithmetic&, double);
  using Binary = Outcome (*)(const Arithmetic&, double, double);
  template <class F>
  struct Row {
    Operator op;
    F apply;
  };
  template <class F, std::size_t n>
  static constexpr std::array<F, kOperatorCount> table(const Row<F> (&rows)[n]) {
    std::array<F, kOperatorCount> result{};
    for (const Row<F>& row : rows) result[static_cast<std::size_t>(row.op)] = row.apply;
    return result;
  }

  static Outcome tangent(const Arithmetic& m, double a) {
    const double cosine = cosine_deg(a);
    return cosine == 0.0 ? fault(Fault::division_by_zero) : m.finish(sine_deg(a) / cosine);
  }
  static Outcome arc_sine(const Arithmetic& m, double a) {
    if (std::abs(a) > 1.0) return fault(Fault::argument_out_of_domain);
    const double angle = std::asin(a) * kDegree;
    return m.finish(m.semantics_.asin_from_90_to_270 && angle < 0.0 ? angle + 360.0 : angle);
  }
  static Outcome arc_cosine(const Arithmetic& m, double a) {
    return std::abs(a) > 1.0 ? fault(Fault::argument_out_of_domain) : m.finish(std::acos(a) * kDegree);
  }
  static Outcome arc_tangent2(const Arithmetic& m, double a, double b) {
    const double angle = std::atan2(a, b) * kDegree;
    return m.finish(m.semantics_.atan_full_circle && angle < 0.0 ? angle + 360.0 : angle);
  }
  static Outcome square_root(const Arithmetic& m, double a) {
    return a < 0.0 ? fault(Fault::argument_out_of_domain) : m.finish(std::sqrt(a));
  }
  static Outcome logarithm(const Arithmetic& m, double a) {
    return a <= 0.0 ? fault(Fault::argument_out_of_domain) : m.finish(std::log(a));
  }
  static Outcome round_up(const Arithmetic& m, double a) {
    const bool away = m.semantics_.round_up == ir::RoundUpMode::away_from_zero;
    return m.finish(away && a < 0.0 ? std::floor(a) : std::ceil(a));
  }
  static Outcome bit_not(const Arithmetic& m, double a) {
    const double whole = m.round(a);
    if (!fits_bits(whole)) return fault(Fault::integer_overflow);
    return {static_cast<double>(static_cast<std::int32_t>(~bits_of(whole)))};
  }
  // A sign in, a sign out: a control without negative operands has 32 bits without sign.
  template <class Combine>
  static Outcome bits(const Arithmetic& m, double a, double b, Combine combine) {
    const double x = m.round(a);
    const double y = m.round(b);
    if (!fits_bits(x) || !fits_bits(y)) return fault(Fault::integer_overflow);
    const std::uint32_t result = combine(bits_of(x), bits_of(y));
    return {x < 0.0 || y < 0.0 ? static_cast<double>(static_cast<std::int32_t>(result)) : static_cast<double>(result)};
  }
  static Outcome power(const Arithmetic& m, double base, double exponent) {
    if (base == 0.0 && exponent < 0.0) return fault(Fault::division_by_zero);
    if (base < 0.0 && exponent != std::trunc(exponent)) return fault(Fault::argument_out_of_domain);
    return m.finish(std::pow(base, exponent));
  }
  template <double (*Divide)(double, double)>
  static Outcome quotient(const Arithmetic& m, double a, double b) {
    return b == 0.0 ? fault(Fault::division_by_zero) : m.finish(Divide(a, b));
  }
  static double divide(double a, double b) { return a / b; }
  static double whole_quotient(double a, double b) { return std::trunc(a / b); }
  static double remainder(double a, double b) { return std::fmod(a, b); }

  static constexpr Row<Unary> kUnary[] = {
      {Operator::negate, [](const Arithmetic& m, double a) { return m.finish(-a); }},
      {Operator::logic_not, [](const Arithmetic&, double a) { return Outcome{truth(a == 0.0)}; }},
      {Operator::bit_not, bit_not},
      {Operator::sin, [](const Arithmetic& m, double a) { return m.finish(sine_deg(a)); }},
      {Operator::cos, [](const Arithmetic& m, double a) { return m.finish(cosine_deg(a)); }},
      {Operator::tan, tangent},
      {Operator::asin, arc_sine},
      {Operator::acos, arc_cosine},
      {Operator::atan, [](const Arithmetic& m, double a) { return m.finish(std::atan(a) * kDegree); }},
      {Operator::sqrt, square_root},
      {Operator::square, [](const Arithmetic& m, double a) { return m.finish(a * a); }},
      {Operator::abs, [](const Arithmetic& m, double a) { return m.finish(std::abs(a)); }},
      {Operator::ln, logarithm},
      {Operator::exp, [](const Arithmetic& m, double a) { return m.finish(std::exp(a)); }},
      {Operator::round, [](const Arithmetic& m, double a) { return m.finish(m.round(a)); }},
      {Operator::truncate, [](const Arithmetic& m, double a) { return m.finish(std::trunc(a)); }},
      {Operator::round_up, round_up},
      {Operator::bcd, [](const Arithmetic& m, double a) { return to_bcd(m.round(a)); }},
      {Operator::bin, [](const Arithmetic& m, double a) { return from_bcd(m.round(a)); }},
  };
  static constexpr Row<Binary> kBinary[] = {
      {Operator::add, [](const Arithmetic& m, double a, double b) { return m.finish(a + b); }},
      {Operator::subtract, [](const Arithmetic& m, double a, double b) { return m.finish(a - b); }},
      {Operator::multiply, [](const Arithmetic& m, double a, double b) { return m.finish(a * b); }},
      {Operator::divide, quotient<divide>},
      {Operator::integer_divide, quotient<whole_quotient>},
      {Operator::modulo, quotient<remainder>},
      {Operator::bit_and,
       [](const Arithmetic& m, double a, double b) { return bits(m, a, b, std::bit_and<std::uint32_t>()); }},
      {Operator::bit_or,
       [](const Arithmetic& m, double a, double b) { return bits(m, a, b, std::bit_or<std::uint32_t>()); }},
      {Operator::bit_xor,
       [](const Arithmetic& m, double a, double b) { return bits(m, a, b, std::bit_xor<std::uint32_t>()); }},
      {Operator::logic_and, [](const Arithmetic&, double a, double b) { return Outcome{truth(a != 0.0 && b != 0.0)}; }},
      {Operator::logic_or, [](const Arithmetic&, double a, double b) { return Outcome{truth(a != 0.0 || b != 0.0)}; }},
      {Operator::logic_xor,
       [](const Arithmetic&, double a, double b) { return Outcome{truth((a != 0.0) != (b != 0.0))}; }},
      {Operator::less, [](const Arithmetic& m, double a, double b) { return Outcome{truth(m.less(a, b))}; }},
      {Operator::less_equal, [](const Arithmetic& m, double a, double b) { return Outcome{truth(!m.less(b, a))}; }},
      {Operator::greater, [](const Arithmetic& m, double a, double b) { return Outcome{truth(m.less(b, a))}; }},
      {Operator::greater_equal, [](const Arithmetic& m, double a, double b) { return Outcome{truth(!m.less(a, b))}; }},
      {Operator::atan2, arc_tangent2},
      {Operator::power, power},
      {Operator::minimum, [](const Arithmetic& m, double a, double b) { return m.finish(std::fmin(a, b)); }},
      {Operator::maximum, [](const Arithmetic& m, double a, double b) { return m.finish(std::fmax(a, b)); }},
  };
  static const std::array<Unary, kOperatorCount> kUnaryTable;
  static const std::array<Binary, kOperatorCount> kBinaryTable;
};
constexpr std::array<Arithmetic::Rules::Unary, kOperatorCount> Arithmetic::Rules::kUnaryTable = table(kUnary);
constexpr std::array<Arithmetic::Rules::Binary, kOperatorCount> Arithmetic::Rules::kBinaryTable = table(kBinary);

Outcome Arithmetic::unary(Operator op, double a) const {
  if (unknown(a)) return {kUnknown};
  return Rules::kUnaryTable[static_cast<std::size_t>(op)](*this, value_or_zero(a));
}

Outcome Arithmetic::binary(Operator op, double a, double b) const {
  if (unknown(a) || unknown(b)) {
    // One side alone may decide: FALSE AND …, TRUE OR …
    if (op == Operator::logic_and && (a == 0.0 || b == 0.0)) return {0.0};
    if (op == Operator::logic_or && (is_true(a) || is_true(b))) return {1.0};
    return {kUnknown};
  }
  if (op == Operator::equal) return {truth(equal(a, b))};
  if (op == Operator::not_equal) return {truth(!equal(a, b))};
  return Rules::kBinaryTable[static_cast<std::size_t>(op)](*this, value_or_zero(a), value_or_zero(b));
}

Outcome Arithmetic::integer_quotient(double a, double b) const {
  if (unknown(a) || unknown(b)) return {kUnknown};
  return Rules::quotient<Rules::whole_quotient>(*this, value_or_zero(a), value_or_zero(b));
}

Outcome Arithmetic::bound(double low, double high, double value) const {
  if (unknown(low) || unknown(high) || unknown(value)) return {kUnknown};
  return finish(std::fmax(value_or_zero(low), std::fmin(value_or_zero(high), value_or_zero(value))));
}

Outcome Arithmetic::convert(ir::ValueType type, double value) const {
  if (unknown(value)) return {kUnknown};
  switch (type) {
    case ir::ValueType::integer: {
      const double whole = round(value_or_zero(value));
      const bool fits = whole >= -2147483648.0 && whole <= 2147483647.0;
      return fits ? Outcome{whole + 0.0} : fault(Fault::result_overflow);
    }
    case ir::ValueType::boolean: return {truth(is_true(value))};
    case ir::ValueType::character: {
      const double code = round(value_or_zero(value));
      return code >= 0.0 && code <= 255.0 ? Outcome{code + 0.0} : fault(Fault::result_overflow);
    }
    case ir::ValueType::real:
    case ir::ValueType::axis:
    case ir::ValueType::frame:
    case ir::ValueType::string: break;
  }
  return {value};
}

}  // namespace dripfeed::interpreter
