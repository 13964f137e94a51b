// Reading families: expressions and their values, structure, faults that must not cascade, hostile input.
#include "dialects/family/read.h"

#include <algorithm>
#include <ctime>
#include <limits>
#include <memory>
#include <random>
#include <string>

#include <gtest/gtest.h>

#include "dialects/family/bind.h"

namespace dripfeed::family {
namespace {

ReadFamilyResult read(const std::string& text) { return read_family(text::Source("t", text)); }

std::string with_let(const std::string& expression) {
  return "family f\nmachine mill\nparam len length 30 mm in 1..100\nparam ang angle 60 deg in 0..90\n"
         "param f feed 120 mm/min in 1..999\nlet val = " +
         expression + "\nprogram p\nend\n";
}

// Value of `let val = expression`; a failure when it is refused.
double value_of(const std::string& expression) {
  ReadFamilyResult result = read(with_let(expression));
  EXPECT_TRUE(result.diagnostics.empty()) << expression << ": " << text::message_of(result.diagnostics.front());
  if (!result.diagnostics.empty()) return 0.0;
  const auto family = std::make_shared<const Family>(std::move(result.family));
  const BindResult bound = bind_family(family, {});
  return bound.bound.values[static_cast<std::size_t>(family->definitions.back().symbol)];
}

// Name of the first diagnostic of `let val = expression`, "" for none.
std::string fault_of(const std::string& expression) {
  const ReadFamilyResult result = read(with_let(expression));
  return result.diagnostics.empty() ? "" : std::string(text::row_of(result.diagnostics.front().id).name);
}

TEST(FamilyRead, ExpressionsHaveTheirPriorities) {
  EXPECT_DOUBLE_EQ(value_of("2 + 3*4"), 14.0);
  EXPECT_DOUBLE_EQ(value_of("(2 + 3)*4"), 20.0);
  EXPECT_DOUBLE_EQ(value_of("8/4/2"), 1.0);
  EXPECT_DOUBLE_EQ(value_of("8 - 4 - 2"), 2.0);
  EXPECT_DOUBLE_EQ(value_of("-2^2"), -4.0);
  EXPECT_DOUBLE_EQ(value_of("2^-2"), 0.25);
  EXPECT_DOUBLE_EQ(value_of("- -2"), 2.0);
  EXPECT_DOUBLE_EQ(value_of("2*-3"), -6.0);
  EXPECT_DOUBLE_EQ(value_of("len/2 - 5 mm"), 10.0);
  EXPECT_DOUBLE_EQ(value_of("1 in + 1 mm"), 26.4);
}

TEST(FamilyRead, FunctionsCalculateInDegrees) {
  EXPECT_DOUBLE_EQ(value_of("cos(ang)"), 0.5);
  EXPECT_DOUBLE_EQ(value_of("cos(90 deg)"), 0.0);
  EXPECT_DOUBLE_EQ(value_of("atan(1)"), 45.0);
  EXPECT_DOUBLE_EQ(value_of("atan2(-1 mm, 0 mm)"), -90.0);
  EXPECT_DOUBLE_EQ(value_of("sqrt(len^2 + 40 mm*40 mm)"), 50.0);
  EXPECT_DOUBLE_EQ(value_of("max(len, 31 mm)"), 31.0);
  EXPECT_DOUBLE_EQ(value_of("radians(180 deg)"), 3.14159265358979323846);
  EXPECT_DOUBLE_EQ(value_of("trunc(-2.7) + round(2.5)"), 1.0);
}

// Seconds alone, minutes in company: 120 mm/min for 30 s is 60 mm.
TEST(FamilyRead, TimesMeetFeedsInMinutes) {
  EXPECT_DOUBLE_EQ(value_of("f*30 s"), 60.0);
  EXPECT_DOUBLE_EQ(value_of("len/f"), 15.0);
  EXPECT_DOUBLE_EQ(value_of("len/30 s"), 60.0);
  EXPECT_DOUBLE_EQ(value_of("1 min + 1 s"), 61.0);
  EXPECT_DOUBLE_EQ(value_of("(30 s)/(2 min)"), 0.25);
  EXPECT_DOUBLE_EQ(value_of("0.2 mm/rev*500 rpm + f"), 220.0);
  EXPECT_DOUBLE_EQ(value_of("1/(30 s)"), 2.0);
}

TEST(FamilyRead, DimensionsMustFit) {
  EXPECT_EQ(fault_of("len + 5"), "family-missing-unit");
  EXPECT_EQ(fault_of("5 + len"), "family-missing-unit");
  EXPECT_EQ(fault_of("len + 2*3"), "family-missing-unit");
  EXPECT_EQ(fault_of("len + ang"), "family-wrong-unit");
  EXPECT_EQ(fault_of("len + 2*ang/ang"), "family-wrong-unit");
  EXPECT_EQ(fault_of("sin(len)"), "family-wrong-unit");
  EXPECT_EQ(fault_of("sin(30)"), "family-missing-unit");
  EXPECT_EQ(fault_of("atan(ang)"), "family-wrong-unit");
  EXPECT_EQ(fault_of("atan2(len, ang)"), "family-wrong-unit");
  EXPECT_EQ(fault_of("sqrt(len^3)"), "");
  EXPECT_EQ(fault_of("f + 100 m/min"), "family-wrong-unit");
  EXPECT_EQ(fault_of("len*len + len"), "family-wrong-unit");
  EXPECT_EQ(fault_of("min(len, 3)"), "family-missing-unit");
  EXPECT_EQ(fault_of("len < 3 mm"), "family-syntax");
}

TEST(FamilyRead, MissingUnitsComeWithTheCure) {
  const ReadFamilyResult result = read(with_let("len + 5"));
  ASSERT_EQ(result.diagnostics.size(), 1U);
  ASSERT_TRUE(result.diagnostics[0].fix.has_value());
  EXPECT_EQ(result.diagnostics[0].fix->text, " mm");
  EXPECT_EQ(result.diagnostics[0].fix->replaced.begin, with_let("len + 5").find("5\nprogram") + 1);
}

TEST(FamilyRead, InchesAndRangesAreDistinguished) {
  ReadFamilyResult result = read(
      "family f\nmachine mill\nparam a1 length 2 in in 1..3\nparam b1 count 3 in 1..9\n"
      "param c1 length 2 in in 1 mm..80 mm\nparam d1 length -2 in in -3 .. -1\nprogram p\nend\n");
  ASSERT_TRUE(result.diagnostics.empty()) << text::message_of(result.diagnostics[0]);
  EXPECT_DOUBLE_EQ(result.family.find_parameter("a1")->high, 76.2);
  EXPECT_DOUBLE_EQ(result.family.find_parameter("b1")->high, 9.0);
  EXPECT_DOUBLE_EQ(result.family.find_parameter("c1")->high, 80.0);
  EXPECT_DOUBLE_EQ(result.family.find_parameter("d1")->low, -76.2);
  EXPECT_EQ(format_value(*result.family.find_parameter("a1"), 50.8), "2 in");
}

TEST(FamilyRead, LinesGoOnAfterAnOperator) {
  EXPECT_DOUBLE_EQ(value_of("1 +\n  2 *   # two\n  3"), 7.0);
  EXPECT_EQ(fault_of("1\n + 2"), "family-syntax");
}

TEST(FamilyRead, OneFaultIsOneDiagnostic) {
  const ReadFamilyResult result = read(
      "family f\nmachine lathe, x is diameter\nparam len length 5 in 1..100\nlet broken = \nprogram p\n"
      "  feed 0.1 mm/rev\n  for t from len down to 1 mm step ?\n    cut x t\n  end\n  if t\n  end\nend\n");
  // The default without unit, the empty let, the '?', and t, which is gone after its loop.
  std::vector<std::uint32_t> lines;
  lines.reserve(result.diagnostics.size());
  for (const text::Diagnostic& d : result.diagnostics)
    lines.push_back(result.family.source.position(d.span.begin).line);
  EXPECT_EQ(lines, (std::vector<std::uint32_t>{3, 4, 7, 10}));
}

TEST(FamilyRead, StepsKeepTheirLines) {
  const ReadFamilyResult result = read(
      "family f\nmachine lathe, x is diameter\nprogram p\n  feed 0.1 mm/rev\n\n  profile\n    cut x 1 mm\n"
      "    cut x 2 mm\n  end\n  retract x 3 mm then z 4 mm\nend\n");
  ASSERT_TRUE(result.diagnostics.empty());
  ASSERT_EQ(result.family.profiles.size(), 1U);
  EXPECT_EQ(result.family.profiles[0].first, 7U);
  EXPECT_EQ(result.family.profiles[0].last, 8U);
  ASSERT_EQ(result.family.steps.size(), 7U);
  EXPECT_EQ(result.family.steps[5].line, 10U);
  EXPECT_EQ(result.family.steps[6].kind, StepKind::rapid);
}

TEST(FamilyRead, DeepAndLongExpressionsAreRefused) {
  EXPECT_EQ(fault_of(std::string(100'000, '(') + "1"), "family-syntax");
  EXPECT_EQ(fault_of(std::string(100'000, '-') + "1"), "family-syntax");
  EXPECT_EQ(fault_of("((((1.5^6)^6)^6)^6)^6"), "family-syntax");
  std::string sum = "1";
  for (int i = 0; i < 5000; ++i) sum += "+1";
  EXPECT_EQ(fault_of(sum), "family-syntax");
  std::string fine = "1";
  for (int i = 0; i < 500; ++i) fine += "+1";
  EXPECT_DOUBLE_EQ(value_of(fine), 501.0);
}

// Any bytes are read without a crash, and every span lies in the text.
TEST(FamilyRead, AnyBytesAreRead) {
  const std::string seed = with_let("sqrt(len^2 + 2 mm*max(len, 3 mm)) # c");
  std::mt19937 random(7);
  for (int round = 0; round < 3000; ++round) {
    std::string text = seed;
    for (int i = 0; i < 6; ++i) {
      const std::size_t at = random() % text.size();
      if (random() % 3 == 0) {
        text.erase(at, random() % 9);
        if (text.empty()) text = " ";
      } else {
        text[at] = static_cast<char>(random() % 256);
      }
    }
    const ReadFamilyResult result = read(text);
    for (const text::Diagnostic& d : result.diagnostics) {
      ASSERT_LE(d.span.begin, d.span.end);
      ASSERT_LE(d.span.end, text.size());
    }
  }
}

// A family that says `line` with 1, 2, 3, … for '#', so often.
std::string repeated(std::string_view before, std::string_view line, int times, std::string_view after) {
  std::string text(before);
  for (int i = 1; i <= times; ++i) {
    for (const char c : line) c == '#' ? text += std::to_string(i) : text += c;
  }
  return text + std::string(after);
}

// Processor time; of several readings the quickest, since what else the machine does only makes one slower.
double seconds_to_read(const std::string& text) {
  const text::Source source("t", text);
  double best = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 5; ++i) {
    const std::clock_t begin = std::clock();
    const auto family = std::make_shared<const Family>(read_family(source).family);
    bind_family(family, {});
    best = std::min(best, static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC);
  }
  return best;
}

// Reading that looked at all names for each name would take 70 to 160 times as long; 10 to 20 were measured, because
// the longer text no longer fits into the processor's caches.
TEST(FamilyRead, TenTimesTheTextTakesAboutTenTimesAsLong) {
  constexpr std::string_view kHead = "family f\nmachine mill\n";
  constexpr double kLargest = 30.0;
  constexpr std::string_view kEnd = "program p\nend\n";
  const struct {
    const char* what;
    std::string_view before, line, after;
  } kinds[] = {
      {"parameters", kHead, "param p# length 10 mm in 1..20\n", kEnd},
      {"names", kHead, "let q# = 1 mm + 2 mm\n", kEnd},
      {"a name and its use", kHead, "let q# = 1 mm\nlet r# = q# + q1\n", kEnd},
      {"names that are not known", kHead, "let q# = 1 mm\nlet r# = unknown_#\n", kEnd},
      {"names that are given twice", kHead, "let q = #\n", kEnd},
      {"blocks", "family f\nmachine mill\nprogram p\n", "for t# from 1 to 2 step 1\nprofile\nend\nend\n", "end\n"},
      {"open blocks", "family f\nmachine mill\nprogram p\n", "if 1 < #\nprofile\n", ""},
  };
  for (const auto& kind : kinds) {
    double ratio = std::numeric_limits<double>::infinity();
    for (int attempt = 0; attempt < 3 && ratio > kLargest; ++attempt) {
      ratio = seconds_to_read(repeated(kind.before, kind.line, 10'000, kind.after)) /
              seconds_to_read(repeated(kind.before, kind.line, 1'000, kind.after));
    }
    EXPECT_LE(ratio, kLargest) << kind.what;
  }
}

}  // namespace
}  // namespace dripfeed::family
