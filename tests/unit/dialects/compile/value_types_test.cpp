// What a SINUMERIK program gets from the types of its variables and from data of the control, on controls whose
// variables have no types.
#include <string>

#include <gtest/gtest.h>

#include "tests/unit/dialects/compile/harness.h"

namespace dripfeed::compile::test {
namespace {

constexpr std::string_view kHead = "G17 G710 G90 G94\n";

// The same moves on every other control.
void expect_moves_kept(const std::string& definitions, const std::string& body) {
  const std::string text = definitions + std::string(kHead) + body + "M30\n";
  const ir::Control from = control("sinumerik-840d", ir::MachineKind::mill);
  const std::vector<ir::Motion> original = real_moves(run_text(text, from).motions);
  ASSERT_FALSE(original.empty());
  for (const std::string& to : dialect_names()) {
    if (to == "sinumerik-840d") continue;
    const ConvertResult result = translated(text, "sinumerik-840d", to);
    ASSERT_FALSE(text::has_error(result.diagnostics)) << said(result.diagnostics, text::Source("program", text));
    expect_same(original, real_moves(run_text(result.text, control(to, ir::MachineKind::mill)).motions), 1e-9,
                to + "\n" + result.text);
  }
}

std::string refused(const std::string& text) {
  const ConvertResult result = translated(text, "sinumerik-840d", "fanuc");
  EXPECT_TRUE(text::has_error(result.diagnostics)) << result.text;
  return said(result.diagnostics, text::Source("program", text));
}

TEST(ValueTypes, AnIntegerIsRoundedWhereItIsSet) {
  expect_moves_kept("DEF INT I\n", "R1=7 I=R1/2\nG0 X=I Y=I/3\nR1=-5 I=R1/2\nG0 X=I\nI=R1/2+0.75 G0 X=I\n");
  expect_moves_kept("DEF INT I=2.5, K=-2.5\n", "G0 X=I Y=K+7\n");
}

// -2.5 goes to -2 there and to -3 here.
TEST(ValueTypes, HalvesBelowZeroRoundUpward) {
  expect_moves_kept("", "R1=-2.5\nG0 X=ROUND(R1) Y=ROUNDUP(R1-0.2) Z=ROUND(-R1)\nIF ROUND(R1)==-2\nG0 X9\nENDIF\n");
  expect_moves_kept("", "R1=-4.5\nWHILE ROUND(R1)<-1\nR1=R1+1\nG0 X=R1\nENDWHILE\n");
}

TEST(ValueTypes, ATruthIsOneOrZero) {
  expect_moves_kept("DEF BOOL B\n", "R1=7 B=R1\nG0 X=B+1\nB=NOT B\nG0 X=B+3\nB=NOT B\nG0 X=B+3\nB=R1>3 G0 Y=B+1\n");
}

TEST(ValueTypes, OneOfTwoAndNotTheOther) {
  expect_moves_kept("DEF BOOL B\n",
                    "R1=7 R2=1 B=R2\nIF (R1>3) XOR (R2>3)\nG0 X4\nENDIF\nIF NOT ((R1>3) XOR (R2<3))\nG0 X5\nENDIF\n"
                    "B=(R1>3) XOR B G0 X=B+6\nIF B XOR (R2==1)\nG0 X8\nELSE\nG0 X9\nENDIF\n");
}

TEST(ValueTypes, GlobalDataThatIsOnlyReadIsRefused) {
  const std::string told = refused("G17 G710 G90 G94\nG0 X=FIXTURE_HEIGHT\nM30\n");
  EXPECT_NE(told.find("program:2:"), std::string::npos) << told;
  EXPECT_NE(told.find("the global data FIXTURE_HEIGHT, whose value is not known here,"), std::string::npos) << told;
  // … also where one way does not set it.
  const std::string way = refused("G17 G710 G90 G94\nIF R1>2\nDEPTH_OF=3\nENDIF\nG0 X=DEPTH_OF\nM30\n");
  EXPECT_NE(way.find("DEPTH_OF, whose value is not known here"), std::string::npos) << way;
  expect_moves_kept("", "FIXTURE_HEIGHT=5\nG0 X=FIXTURE_HEIGHT\n");
}

// Variables there hold numbers only.
TEST(ValueTypes, ATextAsAValueIsRefusedAtItsPlace) {
  const std::string told = refused("G17 G710 G90 G94\nNAME_OF=\"five\"\nG0 X=NAME_OF\nM30\n");
  EXPECT_NE(told.find("program:2:"), std::string::npos) << told;
  EXPECT_NE(told.find("\"five\" has no counterpart"), std::string::npos) << told;
  EXPECT_NE(refused("DEF INT NUM=V\nG17 G710 G90 G94\nR2=NUM\nM30\n").find("program:1:"), std::string::npos);
}

TEST(ValueTypes, GlobalDataOfSeveralProgramsIsRefused) {
  const std::string told = refused("G17 G710 G90 G94\nDEPTH_OF=3\nL100\nG0 X1\nM30\n");
  EXPECT_NE(told.find("the global data DEPTH_OF, which other programs share,"), std::string::npos) << told;
}

}  // namespace
}  // namespace dripfeed::compile::test
