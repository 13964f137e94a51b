// Words that another control has not, or takes for something else: named at their place, never passed on.
#include <string>

#include <gtest/gtest.h>

#include "tests/unit/dialects/compile/harness.h"

namespace dripfeed::compile::test {
namespace {

const std::string kHead = "O0001\nG17 G21 G90 G94 G40 G80\n";

std::string complaints(const ConvertResult& result) {
  std::string out;
  for (const text::Diagnostic& d : result.diagnostics) out += text::message_of(d) + "\n";
  return out;
}

struct Case {
  std::string line;
  std::string from;
  std::string to;
  std::string says;  // empty: no error
};

TEST(ForeignWords, VariablesOfTheControlAreNotPassedOn) {
  const Case cases[] = {
      {"#1=#51998", "mazak", "fanuc", "#51998"},
      {"#1=#70001", "fanuc", "mitsubishi-m80", "#70001"},
      {"#1=#100001", "mitsubishi-m80", "mazak", "#100001"},
      {"#60001=3", "mazak", "mitsubishi-m80", "#60001"},
      {"#10001=2.", "fanuc", "mazak", "#10001"},
      {"#1=#1200", "mitsubishi-m80", "fanuc", "#1200"},
      {"#1=#2001", "fanuc", "sinumerik-840d", "#2001"},
      {"#1100=1", "fanuc", "sinumerik-840d", "#1100"},
      {"#3003=1", "fanuc", "sinumerik-840d", "#3003"},
      {"#1=#60001", "mazak", "sinumerik-840d", "#60001"},
      {"#1=#2001", "fanuc", "mazak", ""},
      {"#100=#5041", "fanuc", "mitsubishi-m80", ""},
      {"#500=1.", "fanuc", "mazak", ""},
      {"#1=#3020", "haas", "fanuc", "#3020"},  // a timer there, and nothing that the others share
      {"#1=#3020", "fanuc", "haas", "#3020"},
      {"#1=#3026", "haas", "mazak", "#3026"},  // the tool in the spindle
      {"#1=#1601", "haas", "mitsubishi-m80", "#1601"},
      {"#1=#5041", "haas", "fanuc", ""},
      {"#1=#2001", "haas", "mazak", ""},
      {"#5221=1.", "fanuc", "haas", ""},
      {"#3001=0", "haas", "mitsubishi-m80", ""},
  };
  for (const Case& c : cases) {
    const ConvertResult result = translated(kHead + c.line + "\nM30\n", c.from, c.to);
    EXPECT_EQ(text::has_error(result.diagnostics), !c.says.empty()) << c.line << " " << c.from << complaints(result);
    EXPECT_NE(complaints(result).find(c.says), std::string::npos) << c.line << " " << c.to << complaints(result);
  }
}

// G54.1 P1 to P48 are #7001 on all, and with more of them each control has them elsewhere.
TEST(ForeignWords, OffsetsKeepTheirMeaningUnderAnotherNumber) {
  EXPECT_NE(translated(kHead + "#1=#14022\nM30\n", "fanuc", "mazak").text.find("#1=#7022"), std::string::npos);
  EXPECT_NE(translated(kHead + "#1=#14961\nM30\n", "fanuc", "mitsubishi-m80").text.find("#1=#101001"),
            std::string::npos);
  EXPECT_NE(translated(kHead + "#1=#101022\nM30\n", "mitsubishi-m80", "fanuc").text.find("#1=#14982"),
            std::string::npos);
  EXPECT_NE(translated(kHead + "#1=#14961\nM30\n", "fanuc", "mazak").text.find("#1=#70961"), std::string::npos);
  EXPECT_NE(translated(kHead + "#1=#70002\nM30\n", "mazak", "fanuc").text.find("#1=#7002"), std::string::npos);
}

TEST(ForeignWords, MachineFunctionsAreNamedOnce) {
  const ConvertResult result = translated(kHead + "M60\nM61\nM60\nM30\n", "fanuc", "mazak");
  ASSERT_FALSE(text::has_error(result.diagnostics)) << complaints(result);
  const std::string messages = complaints(result);
  EXPECT_NE(messages.find("M60"), std::string::npos) << messages;
  EXPECT_EQ(messages.find("M60"), messages.rfind("M60")) << messages;
  EXPECT_NE(messages.find("M61"), std::string::npos) << messages;
}

// M17 would end the program there.
TEST(ForeignWords, AMachineFunctionIsNoFunctionOfTheOtherControl) {
  EXPECT_TRUE(text::has_error(translated(kHead + "M17\nM30\n", "fanuc", "sinumerik-840d").diagnostics));
  EXPECT_TRUE(text::has_error(translated("G90 G17\nM98\nM30\n", "sinumerik-840d", "fanuc").diagnostics));
  EXPECT_TRUE(text::has_error(translated("G90 G17\nM96\nM30\n", "sinumerik-840d", "fanuc").diagnostics));
}

TEST(ForeignWords, InterruptsByASignalAreRefused) {
  for (const std::string& to : dialect_names()) {
    if (to == "fanuc") continue;
    const ConvertResult result = translated(kHead + "M96 P1234\nG00 X1.\nM97\nM30\n", "fanuc", to);
    EXPECT_TRUE(text::has_error(result.diagnostics)) << to << result.text;
    EXPECT_NE(complaints(result).find("M96"), std::string::npos) << complaints(result);
  }
}

TEST(ForeignWords, AnArcNeedsACentreOrARadius) {
  for (const std::string& to : dialect_names()) {
    if (to == "fanuc") continue;
    const ConvertResult none = translated(kHead + "G01 X0. F100.\nG02 X10. Y0.\nM30\n", "fanuc", to);
    EXPECT_NE(complaints(none).find("an arc without a centre or radius"), std::string::npos) << to << none.text;
    const ConvertResult modal = translated(kHead + "G02 X10. Y0. I5. F100.\nX20.\nM30\n", "fanuc", to);
    EXPECT_NE(complaints(modal).find("an arc without a centre or radius"), std::string::npos) << to << modal.text;
    // One word left out is 0, also next to a move along the third axis.
    const std::string helix = kHead + "G00 X0. Y0. Z0.\nG02 X10. Y0. Z-2. I5. F100.\nG03 I-5.\nG01 X3.\nM30\n";
    const ConvertResult whole = translated(helix, "fanuc", to);
    ASSERT_FALSE(text::has_error(whole.diagnostics)) << to << complaints(whole);
    expect_same(real_moves(run_text(helix, control("fanuc", ir::MachineKind::mill)).motions),
                real_moves(run_text(whole.text, control(to, ir::MachineKind::mill)).motions), 1e-6, whole.text);
  }
}

// R wins on the control that takes both.
TEST(ForeignWords, OfACentreAndARadiusTheRadiusCounts) {
  const std::string both = kHead + "G00 X0. Y0.\nG02 X10. Y0. I2. R5. F100.\nM30\n";
  for (const std::string& to : dialect_names()) {
    if (to == "fanuc") continue;
    const ConvertResult result = translated(both, "fanuc", to);
    ASSERT_FALSE(text::has_error(result.diagnostics)) << to << complaints(result);
    EXPECT_EQ(result.text.find("I2."), std::string::npos) << result.text;
    expect_same(real_moves(run_text(both, control("fanuc", ir::MachineKind::mill)).motions),
                real_moves(run_text(result.text, control(to, ir::MachineKind::mill)).motions), 1e-6, result.text);
  }
}

TEST(ForeignWords, ABlockSkipInsideABlockIsNotMovedToItsStart) {
  const ConvertResult result = translated(kHead + "G00 X1. /2 G01 Y3. F9.\nM30\n", "fanuc", "sinumerik-840d");
  EXPECT_TRUE(text::has_error(result.diagnostics)) << result.text;
  EXPECT_TRUE(result.text.empty()) << result.text;
  EXPECT_NE(complaints(result).find("block skip inside a block"), std::string::npos) << complaints(result);
  const ConvertResult kept = translated(kHead + "G00 X1. /2 Y3.\nM30\n", "fanuc", "mazak");
  EXPECT_TRUE(kept.text.contains("X1. /2 Y3.") || text::has_error(kept.diagnostics)) << kept.text;
}

// The number of an alarm is a number: a text in its place is refused, not printed.
TEST(ForeignWords, AnAlarmWhoseNumberIsATextIsRefused) {
  for (const std::string& to : dialect_names()) {
    if (to == "sinumerik-840d") continue;
    const ConvertResult result = translated("G17 G710 G90 G94\nSETAL(\"A\")\nM30\n", "sinumerik-840d", to);
    EXPECT_TRUE(text::has_error(result.diagnostics)) << to << result.text;
    EXPECT_NE(complaints(result).find("a text as the number of an alarm"), std::string::npos) << complaints(result);
  }
}

// Where T is a plain number, H is a tool's length and no increment of C (a mill-turn center of Mazak).
TEST(ForeignWords, HOfAMillTurnCenterIsNoIncrementOfC) {
  ConvertRequest request;
  request.from = control("mazak", ir::MachineKind::mill_turn);
  request.to = control("sinumerik-840d", ir::MachineKind::mill_turn);
  const std::string head = "%\nO0001\nG21 G18 G99 G97 G40\nS500 M03\nG00 X50. Z5.\nG98\nC0.\n";
  request.source = text::Source("program", head + "G12.1\nG01 U3. H2. F80.\nX20. C9.\nG13.1\nM30\n%\n");
  for (const ConvertMode mode : {ConvertMode::macro, ConvertMode::explicit_blocks}) {
    request.mode = mode;
    const std::string made = convert(request).text;
    EXPECT_EQ(made.find("Y=IC(2"), std::string::npos) << made;
    EXPECT_EQ(made.find("C=IC(2"), std::string::npos) << made;
  }
}

}  // namespace
}  // namespace dripfeed::compile::test
