// Operators against their definitions, under the semantics of both families of controls.
#include "dialects/interpreter/arithmetic/arithmetic.h"

#include <numbers>

#include <gtest/gtest.h>

namespace dripfeed::interpreter {
namespace {

using ir::Operator;

ir::Semantics fanuc() { return {}; }
ir::Semantics siemens() {
  ir::Semantics s;
  s.comparison = ir::ComparisonMode::relative;
  s.relative_tolerance = 1e-12;
  s.round_half = ir::RoundHalf::up;
  s.round_up = ir::RoundUpMode::next_larger;
  s.atan_full_circle = s.asin_from_90_to_270 = false;
  return s;
}
double one(const ir::Semantics& s, Operator op, double a) {
  const Outcome outcome = Arithmetic(s).unary(op, a);
  EXPECT_EQ(outcome.fault, Fault::none);
  return outcome.value;
}
double two(const ir::Semantics& s, Operator op, double a, double b) {
  const Outcome outcome = Arithmetic(s).binary(op, a, b);
  EXPECT_EQ(outcome.fault, Fault::none);
  return outcome.value;
}
Fault fault_of(Operator op, double a) { return Arithmetic(fanuc()).unary(op, a).fault; }
Fault fault_of(Operator op, double a, double b) { return Arithmetic(fanuc()).binary(op, a, b).fault; }

TEST(Arithmetic, AnglesAreDegreesAndQuartersExact) {
  for (int turn = -8; turn <= 8; ++turn) {
    const double base = 360.0 * turn;
    EXPECT_EQ(sine_deg(base), 0.0);
    EXPECT_EQ(sine_deg(base + 90.0), 1.0);
    EXPECT_EQ(sine_deg(base + 180.0), 0.0);
    EXPECT_EQ(sine_deg(base + 270.0), -1.0);
    EXPECT_EQ(cosine_deg(base), 1.0);
    EXPECT_EQ(cosine_deg(base + 90.0), 0.0);
    EXPECT_EQ(cosine_deg(base - 180.0), -1.0);
  }
  for (double angle = -1000.0; angle < 1000.0; angle += 0.73) {
    EXPECT_NEAR(sine_deg(angle), std::sin(angle * std::numbers::pi / 180.0), 1e-14) << angle;
    EXPECT_NEAR(cosine_deg(angle), std::cos(angle * std::numbers::pi / 180.0), 1e-14) << angle;
  }
  EXPECT_EQ(sine_deg(3.6e15 + 90.0), 1.0);
  EXPECT_NEAR(one(fanuc(), Operator::tan, 45.0), 1.0, 1e-15);
  EXPECT_EQ(fault_of(Operator::tan, 90.0), Fault::division_by_zero);
  EXPECT_EQ(fault_of(Operator::tan, -270.0), Fault::division_by_zero);
}

TEST(Arithmetic, InverseAnglesHaveTheControlsRange) {
  EXPECT_NEAR(one(fanuc(), Operator::asin, -0.5), 330.0, 1e-12);
  EXPECT_NEAR(one(siemens(), Operator::asin, -0.5), -30.0, 1e-12);
  EXPECT_NEAR(one(fanuc(), Operator::asin, 0.5), 30.0, 1e-12);
  EXPECT_EQ(one(fanuc(), Operator::acos, -1.0), 180.0);
  EXPECT_EQ(two(fanuc(), Operator::atan2, -1.0, 0.0), 270.0);
  EXPECT_EQ(two(siemens(), Operator::atan2, -1.0, 0.0), -90.0);
  EXPECT_EQ(two(siemens(), Operator::atan2, 30.0, -30.0), 135.0);
  EXPECT_EQ(one(fanuc(), Operator::atan, -1.0), -45.0);
}

TEST(Arithmetic, RoundingHalves) {
  EXPECT_EQ(one(fanuc(), Operator::round, -2.5), -3.0);
  EXPECT_EQ(one(siemens(), Operator::round, -2.5), -2.0);
  EXPECT_EQ(one(siemens(), Operator::round, 2.5), 3.0);
  // The double just below one half is no half.
  EXPECT_EQ(one(siemens(), Operator::round, 0.49999999999999994), 0.0);
  EXPECT_EQ(one(fanuc(), Operator::truncate, -2.9), -2.0);
  EXPECT_EQ(one(fanuc(), Operator::round_up, -2.1), -3.0);
  EXPECT_EQ(one(siemens(), Operator::round_up, -2.1), -2.0);
  EXPECT_EQ(one(siemens(), Operator::round_up, 2.1), 3.0);
}

TEST(Arithmetic, DivisionAndItsRest) {
  EXPECT_EQ(two(siemens(), Operator::integer_divide, 24.75, 2.5), 9.0);
  EXPECT_EQ(two(siemens(), Operator::integer_divide, -7.0, 2.0), -3.0);
  EXPECT_EQ(two(siemens(), Operator::modulo, 24.75, 2.5), 2.25);
  EXPECT_EQ(two(fanuc(), Operator::divide, 7.0, 4.0), 1.75);
  EXPECT_EQ(Arithmetic(fanuc()).integer_quotient(7.0, 4.0).value, 1.0);
  EXPECT_EQ(fault_of(Operator::divide, 1.0, 0.0), Fault::division_by_zero);
  EXPECT_EQ(fault_of(Operator::divide, 0.0, 0.0), Fault::division_by_zero);
  EXPECT_EQ(fault_of(Operator::modulo, 1.0, kVacant), Fault::division_by_zero);
  EXPECT_EQ(fault_of(Operator::integer_divide, 1.0, 0.0), Fault::division_by_zero);
}

TEST(Arithmetic, Domains) {
  EXPECT_EQ(fault_of(Operator::sqrt, -1e-300), Fault::argument_out_of_domain);
  EXPECT_EQ(fault_of(Operator::asin, 1.0000001), Fault::argument_out_of_domain);
  EXPECT_EQ(fault_of(Operator::acos, -1.0000001), Fault::argument_out_of_domain);
  EXPECT_EQ(fault_of(Operator::ln, 0.0), Fault::argument_out_of_domain);
  EXPECT_EQ(fault_of(Operator::exp, 1000.0), Fault::result_overflow);
  EXPECT_EQ(fault_of(Operator::multiply, 1e200, 1e200), Fault::result_overflow);
  EXPECT_EQ(fault_of(Operator::power, -8.0, 0.5), Fault::argument_out_of_domain);
  EXPECT_EQ(fault_of(Operator::power, 0.0, -1.0), Fault::division_by_zero);
  EXPECT_EQ(two(fanuc(), Operator::power, -2.0, 3.0), -8.0);
  EXPECT_EQ(one(fanuc(), Operator::square, -3.0), 9.0);
  EXPECT_EQ(one(fanuc(), Operator::abs, -3.5), 3.5);
  EXPECT_EQ(one(fanuc(), Operator::exp, 0.0), 1.0);
  EXPECT_EQ(one(fanuc(), Operator::ln, 1.0), 0.0);
}

TEST(Arithmetic, BitsAndLogic) {
  EXPECT_EQ(two(fanuc(), Operator::bit_and, 12.0, 10.0), 8.0);
  EXPECT_EQ(two(fanuc(), Operator::bit_or, 12.4, 10.0), 14.0);
  EXPECT_EQ(two(fanuc(), Operator::bit_xor, 12.0, 10.0), 6.0);
  EXPECT_EQ(two(fanuc(), Operator::bit_and, 4294967295.0, 4294967295.0), 4294967295.0);
  EXPECT_EQ(two(siemens(), Operator::bit_and, -1.0, 255.0), 255.0);
  EXPECT_EQ(one(siemens(), Operator::bit_not, 0.0), -1.0);
  EXPECT_EQ(fault_of(Operator::bit_and, 4294967296.0, 1.0), Fault::integer_overflow);
  EXPECT_EQ(two(fanuc(), Operator::logic_and, 2.0, -1.0), 1.0);
  EXPECT_EQ(two(fanuc(), Operator::logic_and, 2.0, 0.0), 0.0);
  EXPECT_EQ(two(fanuc(), Operator::logic_xor, 2.0, 1.0), 0.0);
  EXPECT_EQ(one(fanuc(), Operator::logic_not, 0.5), 0.0);
  EXPECT_EQ(one(fanuc(), Operator::bcd, 25.0), 37.0);
  EXPECT_EQ(one(fanuc(), Operator::bin, 37.0), 25.0);
  EXPECT_EQ(fault_of(Operator::bin, 10.0), Fault::argument_out_of_domain);
  EXPECT_EQ(fault_of(Operator::bcd, -1.0), Fault::argument_out_of_domain);
}

TEST(Arithmetic, ComparisonModes) {
  const double sum = 0.1 + 0.2;
  EXPECT_EQ(two(fanuc(), Operator::equal, sum, 0.3), 0.0);
  EXPECT_EQ(two(siemens(), Operator::equal, sum, 0.3), 1.0);
  EXPECT_EQ(two(fanuc(), Operator::greater, sum, 0.3), 1.0);
  EXPECT_EQ(two(siemens(), Operator::greater, sum, 0.3), 0.0);
  EXPECT_EQ(two(siemens(), Operator::less_equal, sum, 0.3), 1.0);
  // Relative, not absolute: small numbers that differ are not equal.
  EXPECT_EQ(two(siemens(), Operator::equal, 1e-15, 2e-15), 0.0);
  EXPECT_EQ(two(siemens(), Operator::less, 1e-15, 2e-15), 1.0);
  EXPECT_EQ(two(siemens(), Operator::equal, 0.0, 0.0), 1.0);
  EXPECT_EQ(two(siemens(), Operator::equal, 1e15, 1e15 + 100.0), 1.0);
}

TEST(Arithmetic, EightDigits) {
  ir::Semantics s = fanuc();
  s.number_format = ir::NumberFormat::eight_digit;
  EXPECT_EQ(two(s, Operator::divide, 1.0, 3.0), 0.33333333);
  EXPECT_EQ(two(s, Operator::divide, 2.0, 3.0), 0.66666667);
  EXPECT_EQ(two(s, Operator::add, 12345678.0, 0.4), 12345678.0);
  EXPECT_EQ(two(s, Operator::multiply, 0.1, 3.0), 0.3);
  EXPECT_EQ(two(s, Operator::add, 0.1, 0.2), 0.3);
  EXPECT_EQ(Arithmetic(s).binary(Operator::multiply, 1e30, 1e30).fault, Fault::result_overflow);
  EXPECT_EQ(round_to_eight_digits(-1234567.891), -1234567.9);
  EXPECT_EQ(round_to_eight_digits(0.0), 0.0);
}

TEST(Arithmetic, BoundsAndConversions) {
  const Arithmetic a(siemens());
  EXPECT_EQ(a.bound(1.0, 5.0, 7.0).value, 5.0);
  EXPECT_EQ(a.bound(1.0, 5.0, -7.0).value, 1.0);
  EXPECT_EQ(two(siemens(), Operator::minimum, 2.0, -3.0), -3.0);
  EXPECT_EQ(two(siemens(), Operator::maximum, 2.0, -3.0), 2.0);
  EXPECT_EQ(a.convert(ir::ValueType::integer, 2.5).value, 3.0);
  EXPECT_EQ(a.convert(ir::ValueType::integer, -2.5).value, -2.0);
  EXPECT_EQ(a.convert(ir::ValueType::integer, 2147483648.0).fault, Fault::result_overflow);
  EXPECT_EQ(a.convert(ir::ValueType::boolean, -0.1).value, 1.0);
  EXPECT_EQ(a.convert(ir::ValueType::character, 256.0).fault, Fault::result_overflow);
  EXPECT_EQ(a.convert(ir::ValueType::real, 0.1).value, 0.1);
}

}  // namespace
}  // namespace dripfeed::interpreter
