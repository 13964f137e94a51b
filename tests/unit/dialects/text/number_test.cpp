// Numbers against known values and against exact whole-number arithmetic: a dyadic fraction k / 2^n has the finite
// decimal expansion k·5^n / 10^n, which the test writes digit by digit.
#include "dialects/text/number.h"

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <string>

#include <gtest/gtest.h>

namespace dripfeed::text {
namespace {

std::string digits_of(std::uint64_t value) {
  std::string text;
  do {
    text.insert(text.begin(), static_cast<char>('0' + value % 10));
    value /= 10;
  } while (value != 0);
  return text;
}

// value / 10^fraction, every digit.
std::string decimal_text(std::uint64_t value, std::size_t fraction) {
  std::string text = digits_of(value);
  if (text.size() <= fraction) text.insert(0, fraction + 1 - text.size(), '0');
  if (fraction > 0) text.insert(text.size() - fraction, ".");
  return text;
}

double value_of(std::string_view text) {
  const auto decimal = read_decimal(text);
  EXPECT_TRUE(decimal) << text;
  return decimal ? decimal->value : std::numeric_limits<double>::quiet_NaN();
}

TEST(ReadDecimal, ReadsTheForms) {
  struct Case {
    std::string_view text;
    double value;
    int digits, fraction;
    bool has_point;
    std::size_t length;
  };
  const std::array cases = {
      Case{"10", 10, 2, 0, false, 2},     Case{"10.", 10, 2, 0, true, 3}, Case{".5", 0.5, 1, 1, true, 2},
      Case{"0.25X", 0.25, 2, 2, true, 4}, Case{"007", 7, 1, 0, false, 3}, Case{"0", 0, 0, 0, false, 1},
      Case{"1.2.3", 1.2, 2, 1, true, 3},  Case{"1e5", 1, 1, 0, false, 1}, Case{"12 3", 12, 2, 0, false, 2},
      Case{"0.050", 0.05, 2, 3, true, 5}, Case{"1,5", 1, 1, 0, false, 1},
  };
  for (const Case& c : cases) {
    const auto decimal = read_decimal(c.text);
    ASSERT_TRUE(decimal) << c.text;
    EXPECT_EQ(decimal->value, c.value) << c.text;
    EXPECT_EQ(decimal->digits, c.digits) << c.text;
    EXPECT_EQ(decimal->fraction, c.fraction) << c.text;
    EXPECT_EQ(decimal->has_point, c.has_point) << c.text;
    EXPECT_EQ(decimal->length, c.length) << c.text;
  }
}

TEST(ReadDecimal, RefusesWhatHasNoDigit) {
  for (const std::string_view text : {"", ".", "-1", "+1", "X", "..1", " 1"}) EXPECT_FALSE(read_decimal(text)) << text;
}

TEST(ReadDecimal, IsExactForDyadicFractionsOfAnyLength) {
  std::mt19937_64 random(1);
  for (int i = 0; i < 100000; ++i) {
    const std::uint64_t k = random() % (1U << 17U);
    const auto n = static_cast<int>(random() % 18);
    std::uint64_t power = 1;
    for (int j = 0; j < n; ++j) power *= 5;
    const std::string text = decimal_text(k * power, static_cast<std::size_t>(n));
    ASSERT_EQ(value_of(text), std::ldexp(static_cast<double>(k), -n)) << text;
  }
}

TEST(ReadDecimal, RoundsToNearestAtFifteenSixteenAndSeventeenDigits) {
  EXPECT_EQ(value_of("0.1"), 0.1);
  EXPECT_EQ(value_of("123456789012345"), 123456789012345.0);
  EXPECT_EQ(value_of("9007199254740993"), 9007199254740992.0);  // a tie, to even
  EXPECT_EQ(value_of("9007199254740995"), 9007199254740996.0);  // a tie, to even
  EXPECT_EQ(value_of("0.30000000000000004"), 0.30000000000000004);
  EXPECT_EQ(value_of("0.29999999999999999"), 0.3);
  EXPECT_EQ(value_of("9007199254740993.0000000000000000000000001"), 9007199254740994.0);
}

TEST(ReadDecimal, TakesManyZerosAndHugeNumbers) {
  EXPECT_EQ(value_of(std::string(400, '0') + "7"), 7.0);
  EXPECT_EQ(value_of("0." + std::string(30, '0') + "1"), 1e-31);
  EXPECT_EQ(value_of("0." + std::string(400, '0') + "1"), 0.0);
  EXPECT_EQ(value_of(std::string(400, '9')), std::numeric_limits<double>::infinity());
  EXPECT_EQ(read_decimal(std::string(400, '9'))->digits, 255);
}

TEST(ParseNumber, TakesSignPointAndExponentAndAllOfTheText) {
  EXPECT_EQ(parse_number("-1.5e3"), -1500.0);
  EXPECT_EQ(parse_number("+.5"), 0.5);
  EXPECT_EQ(parse_number("1E-2"), 0.01);
  EXPECT_TRUE(std::signbit(*parse_number("-0")));
  for (const std::string_view text :
       {"", "-", "--1", "+-1", "1 ", " 1", "inf", "-inf", "nan", "1e", "1e999", "0x1", "1,5"}) {
    EXPECT_FALSE(parse_number(text)) << text;
  }
}

TEST(ParseInteger, TakesTheWholeRangeAndNothingElse) {
  EXPECT_EQ(parse_integer("-9223372036854775808"), std::numeric_limits<std::int64_t>::min());
  EXPECT_EQ(parse_integer("+7"), 7);
  for (const std::string_view text : {"", "+", "+-7", "9223372036854775808", "7.", "7 ", "a"}) {
    EXPECT_FALSE(parse_integer(text)) << text;
  }
}

TEST(FormatShortest, ReadsBackAsTheSameDouble) {
  std::mt19937_64 random(2);
  for (int i = 0; i < 100000; ++i) {
    const double value = std::bit_cast<double>(random());
    if (!std::isfinite(value)) continue;
    const std::string text = format_shortest(value);
    const auto back = parse_number(text);
    ASSERT_TRUE(back) << text;
    ASSERT_EQ(std::bit_cast<std::uint64_t>(*back), std::bit_cast<std::uint64_t>(value)) << text;
  }
  EXPECT_EQ(format_shortest(0.1), "0.1");
  EXPECT_EQ(format_shortest(1e300), "1e+300");
  EXPECT_EQ(format_shortest(100000.0), "100000");
}

TEST(FormatFixed, GivesBackTheDigitsItWasMadeOf) {
  std::mt19937_64 random(3);
  std::uint64_t power = 1;
  for (int decimals = 0; decimals <= 9; ++decimals, power *= 10) {
    for (int i = 0; i < 20000; ++i) {
      const std::uint64_t n = random() % 1000000000000000U >> random() % 40;
      const double value = static_cast<double>(n) / static_cast<double>(power);
      ASSERT_EQ(format_fixed(value, decimals), decimal_text(n, static_cast<std::size_t>(decimals)));
    }
  }
}

TEST(FormatFixed, RoundsHalfAwayFromZeroOnTheDecimalThatIsSeen) {
  EXPECT_EQ(format_fixed(0.5, 0), "1");
  EXPECT_EQ(format_fixed(1.5, 0), "2");
  EXPECT_EQ(format_fixed(2.5, 0), "3");
  EXPECT_EQ(format_fixed(0.125, 2), "0.13");
  EXPECT_EQ(format_fixed(1.005, 2), "1.01");  // the double lies below 1.005
  EXPECT_EQ(format_fixed(0.0625, 3), "0.063");
  EXPECT_EQ(format_fixed(-0.0005, 3), "-0.001");
  EXPECT_EQ(format_fixed(-1.00049999, 3), "-1.000");
  EXPECT_EQ(format_fixed(9.9995, 3), "10.000");
  EXPECT_EQ(format_fixed(0.99996, 4), "1.0000");
  EXPECT_EQ(format_fixed(0.05, 0), "0");
  EXPECT_EQ(format_fixed(0.0000000005, 9), "0.000000001");
}

TEST(FormatFixed, NeverWritesAMinusZero) {
  EXPECT_EQ(format_fixed(-0.0, 3), "0.000");
  EXPECT_EQ(format_fixed(-0.0004, 3), "0.000");
  EXPECT_EQ(format_fixed(-1e-300, 9), "0.000000000");
  EXPECT_EQ(format_fixed(-0.4, 0), "0");
}

TEST(FormatFixed, WritesLargeNumbersInFull) {
  EXPECT_EQ(format_fixed(1e15, 2), "1000000000000000.00");
  EXPECT_EQ(format_fixed(1.5e20, 1), "150000000000000000000.0");
  EXPECT_EQ(format_fixed(123456789012345680.0, 0), "123456789012345680");
}

TEST(AppendWordNumber, DropsZerosAndKeepsThePoint) {
  const auto word = [](double value, int decimals, bool bare) {
    std::string out = "X";
    append_word_number(out, value, decimals, bare);
    return out;
  };
  EXPECT_EQ(word(10.0, 3, false), "X10.");
  EXPECT_EQ(word(10.0, 3, true), "X10");
  EXPECT_EQ(word(0.25, 3, false), "X0.25");
  EXPECT_EQ(word(-3.5004, 3, false), "X-3.5");
  EXPECT_EQ(word(-0.0001, 3, false), "X0.");
  EXPECT_EQ(word(-0.0001, 3, true), "X0");
  EXPECT_EQ(word(100.0, 0, false), "X100.");
  EXPECT_EQ(word(100.0, 0, true), "X100");
}

}  // namespace
}  // namespace dripfeed::text
