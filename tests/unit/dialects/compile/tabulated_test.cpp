// A table in place of a formula: what it is made of, how far it is off, and where there is none.
#include <cmath>
#include <numbers>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include "dialects/compile/dialect/dialect.h"
#include "dialects/compile/dialect/execute.h"
#include "dialects/compile/render/optimized.h"

namespace dripfeed::compile {
namespace {

using optimize::Rule;

constexpr optimize::NumberRange kFreeR{ir::Bank::r, 100, 299};
constexpr optimize::NumberRange kOwnR{ir::Bank::r, 0, 99};
constexpr optimize::NumberRange kFreeHash{ir::Bank::hash, 500, 599};
constexpr optimize::NumberRange kOwnHash{ir::Bank::hash, 100, 149};

struct Given {
  std::string_view dialect = "sinumerik-840d";
  double tolerance_mm = 0.01;
  std::vector<optimize::NumberRange> free = {kFreeR};
  std::vector<optimize::NumberRange> own = {kOwnR};
};

ir::Control control_of(std::string_view dialect) {
  ir::Control control = find_dialect(dialect)->control(ir::MachineKind::mill, ir::GSystem::a);
  control.cost = find_dialect("sinumerik-840d")->control(ir::MachineKind::mill, ir::GSystem::a).cost;
  for (ir::VariableRange& range : control.variables)
    if (range.bank == ir::Bank::r) range.last = std::max(range.last, 499U);
  return control;
}

OptimizeResult tabulated(const std::string& text, const Given& given = {}) {
  OptimizeRequest request{.source = text::Source("program", text), .control = control_of(given.dialect), .cost = {}};
  request.cost = request.control.cost;
  request.settings.rules = optimize::Rules::none();
  request.settings.rules.set(Rule::table, true);
  request.settings.own = given.own;
  request.settings.free = given.free;
  request.settings.tolerance_mm = given.tolerance_mm;
  OptimizeResult result = optimize_text(request);
  EXPECT_FALSE(text::has_error(result.diagnostics)) << text;
  return result;
}

class Collect final : public ir::MotionSink {
 public:
  void consume(std::span<const ir::Motion> motions) override { all.insert(all.end(), motions.begin(), motions.end()); }
  std::vector<ir::Motion> all;
};

std::vector<ir::Motion> cuts_of(const std::string& text, std::string_view dialect) {
  const ir::Control control = control_of(dialect);
  const auto read = find_dialect(dialect)->read(text::Source("program", text), control);
  Collect collect;
  execute(read.program, control, nullptr, collect, {});
  std::erase_if(collect.all, [](const ir::Motion& m) { return m.kind != ir::MotionKind::linear; });
  return collect.all;
}

// The greatest distance between the ends of the cuts, measured here and not by the optimizer.
double measured(const std::string& before, const std::string& after, std::string_view dialect) {
  const auto a = cuts_of(before, dialect), b = cuts_of(after, dialect);
  EXPECT_EQ(a.size(), b.size());
  double most = 0.0;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i)
    most = std::max(most, std::hypot(a[i].end[0] - b[i].end[0], a[i].end[1] - b[i].end[1], a[i].end[2] - b[i].end[2]));
  return most;
}

// Eleven levels of a saddle, in 36 points each.
const std::string kNest =
    "G0 X0 Y0 Z5\nR1=0\nWHILE R1<11\nR2=0\nWHILE R2<36\nR3=COS(10*R2)\nR4=SIN(10*R2)\nR5=SQRT(400+R1*R1*0.1+R3*R1)\n"
    "G1 X=R5*R3 Y=R2 F500\nR2=R2+1\nENDWHILE\nR1=R1+1\nENDWHILE\nM30\n";

TEST(Tabulated, TheEndsOfTheOuterLoopAreEnoughForAWideTolerance) {
  const OptimizeResult made = tabulated(kNest, {.tolerance_mm = 0.2});
  EXPECT_EQ(made.obstacle + made.not_verified + made.not_tabulated, "");
  EXPECT_EQ(made.text,
            "G0 X0 Y0 Z5\nR1=0\nR100=0\nWHILE R100<2\nR1=R100*10\nR2=0\nWHILE R2<36\nR3=COS(10*R2)\n"
            "R5=SQRT(400+R1*R1*0.1+R3*R1)\nR[R100*37+R2+103]=R5*R3\nR2=R2+1\nENDWHILE\nR100=R100+1\nENDWHILE\nR1=0\n"
            "WHILE R1<11\nR101=R1/10\nR2=0\nWHILE R2<36\nG1 X=R[R2+103]+R101*(R[R2+140]-R[R2+103]) Y=R2 F500\nR2=R2+1\n"
            "ENDWHILE\nR1=R1+1\nENDWHILE\nM30\n");
  ASSERT_TRUE(made.off_mm);
  EXPECT_NEAR(*made.off_mm, measured(kNest, made.text, "sinumerik-840d"), 1e-12);
  EXPECT_GT(*made.off_mm, 0.01);
  EXPECT_LT(made.after->total_ms, made.before->total_ms);
}

TEST(Tabulated, ANarrowToleranceTakesMoreRows) {
  const OptimizeResult made = tabulated(kNest, {.tolerance_mm = 0.02});
  EXPECT_EQ(made.not_tabulated, "");
  ASSERT_TRUE(made.off_mm);
  EXPECT_LE(*made.off_mm, 0.02);
  EXPECT_NEAR(*made.off_mm, measured(kNest, made.text, "sinumerik-840d"), 1e-12);
  EXPECT_NE(made.text.find("TRUNC("), std::string::npos) << made.text;
  const OptimizeResult none = tabulated(kNest, {.tolerance_mm = 1e-7});
  EXPECT_EQ(none.text, kNest);
  EXPECT_NE(none.not_tabulated, "");
  EXPECT_FALSE(none.off_mm);
}

TEST(Tabulated, ALoopThatStandsAloneIsInterpolatedFromRoundToRound) {
  const std::string text =
      "O1\nG0X0.\n#101=0\nWHILE[#101LE200]DO1\n#102=20.*SIN[#101/4.]\n#103=SQRT[900.-#102*#102]\n#104=SQRT[#103+#102]\n"
      "#105=SQRT[#104+#103]\n#106=SQRT[#105+#102]*SQRT[#103]+SIN[#105]*COS[#104]\nG1X#106Y[#101/"
      "2.]F500.\n#101=#101+1.\n"
      "END1\nM30\n";
  const OptimizeResult made =
      tabulated(text, {.dialect = "fanuc", .tolerance_mm = 0.05, .free = {kFreeHash}, .own = {kOwnHash}});
  EXPECT_EQ(made.obstacle + made.not_verified + made.not_tabulated, "");
  ASSERT_TRUE(made.off_mm);
  EXPECT_LE(*made.off_mm, 0.05);
  EXPECT_GT(*made.off_mm, 0.0);
  EXPECT_NEAR(*made.off_mm, measured(text, made.text, "fanuc"), 1e-9);
  EXPECT_EQ(made.text.find("SIN", made.text.find("G1")), std::string::npos) << made.text;
}

TEST(Tabulated, WhatIsReadAfterTheLoopsIsComputedInThem) {
  std::string text = kNest;
  text.replace(text.find("M30"), 0, "G0 Z=R5\n");
  const OptimizeResult made = tabulated(text, {.tolerance_mm = 0.2});
  EXPECT_NE(made.text.find("R5=SQRT(400+R1*R1*0.1+R3*R1)\nG1"), std::string::npos) << made.text;
}

TEST(Tabulated, NoTableWhereTheLoopsOrTheNumbersAreInDoubt) {
  const auto with = [](std::string_view part, std::string_view by) {
    std::string text = kNest;
    return text.replace(text.find(part), part.size(), by);
  };
  for (std::string text : {
           with("R1<11", "R1<R9"),                                     // a person may change the number of rounds
           with("R1=R1+1\n", "R1=R1+1+R4/100\n"),                      // it does not count
           with("R3=COS(10*R2)", "R3=COS(10*R2+R8)\nR8=R8+1"),         // the formula changes from round to round
           with("G1 X", "/G1 X"),                                      // the operator decides
           with("R3=COS(10*R2)", "IF R2==7 GOTOF N9\nR3=COS(10*R2)"),  // a jump out of it
           with("G0 X0 Y0 Z5", "G0 X0 Y0 Z5 G41 D1"),                  // compensated
           with("R5=SQRT(", "R5=$AA_IM[X]+SQRT("),                     // a value of the machine
       }) {
    text.replace(text.find("M30"), 0, "N9 ");
    const OptimizeResult made = tabulated(text, {.tolerance_mm = 0.2});
    EXPECT_EQ(made.text, text);
    EXPECT_FALSE(made.off_mm) << text;
    EXPECT_NE(made.not_tabulated, "") << text;
  }
  const OptimizeResult few = tabulated(kNest, {.tolerance_mm = 0.2, .free = {{ir::Bank::r, 100, 103}}});
  EXPECT_EQ(few.text, kNest);
  EXPECT_EQ(few.not_tabulated,
            "no loop that counts from number to number computes a place, or too few variables are free");
}

// Steps add up what each of them is off: the places are compared, not the words.
TEST(Tabulated, IncrementsCountByWhereTheyLead) {
  std::string text = kNest;
  text.replace(text.find("G1 X"), 4, "G91 G1 X");
  const OptimizeResult made = tabulated(text, {.tolerance_mm = 0.2});
  ASSERT_TRUE(made.off_mm);
  EXPECT_LE(*made.off_mm, 0.2);
  EXPECT_NEAR(*made.off_mm, measured(text, made.text, "sinumerik-840d"), 1e-9);
}

}  // namespace
}  // namespace dripfeed::compile
