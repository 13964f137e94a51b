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
    ASSERT_FALSE(text::has_error(result.diagnostics)) << messages_of(result.diagnostics, text::Source("program", text));
    expect_same(original, real_moves(run_text(result.text, control(to, ir::MachineKind::mill)).motions), 1e-9,
                to + "\n" + result.text);
  }
}

std::string refused(const std::string& text) {
  const ConvertResult result = translated(text, "sinumerik-840d", "fanuc");
  EXPECT_TRUE(text::has_error(result.diagnostics)) << result.text;
  return messages_of(result.diagnostics, text::Source("program", text));
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
  const std::string messages = refused("G17 G710 G90 G94\nG0 X=FIXTURE_HEIGHT\nM30\n");
  EXPECT_NE(messages.find("program:2:"), std::string::npos) << messages;
  EXPECT_NE(messages.find("the global data FIXTURE_HEIGHT, whose value is not known here,"), std::string::npos)
      << messages;
  // … also where one path does not set it.
  const std::string one_path = refused("G17 G710 G90 G94\nIF R1>2\nDEPTH_OF=3\nENDIF\nG0 X=DEPTH_OF\nM30\n");
  EXPECT_NE(one_path.find("DEPTH_OF, whose value is not known here"), std::string::npos) << one_path;
  expect_moves_kept("", "FIXTURE_HEIGHT=5\nG0 X=FIXTURE_HEIGHT\n");
}

// Variables there hold numbers only.
TEST(ValueTypes, ATextAsAValueIsRefusedAtItsPlace) {
  const std::string messages = refused("G17 G710 G90 G94\nNAME_OF=\"five\"\nG0 X=NAME_OF\nM30\n");
  EXPECT_NE(messages.find("program:2:"), std::string::npos) << messages;
  EXPECT_NE(messages.find("\"five\" has no counterpart"), std::string::npos) << messages;
  EXPECT_NE(refused("DEF INT NUM=V\nG17 G710 G90 G94\nR2=NUM\nM30\n").find("program:1:"), std::string::npos);
}

TEST(ValueTypes, SystemVariablesInExpressionsAreRefused) {
  const std::string messages = refused("G17 G710 G90 G94\nR1=2+$P_TOOLNO*R2\nG0 X=$A_DBB[3]+R1 Y=$P_TOOLR\nM30\n");
  EXPECT_NE(messages.find("$P_TOOLNO"), std::string::npos) << messages;
  EXPECT_NE(messages.find("$A_DBB[3]"), std::string::npos) << messages;
}

TEST(ValueTypes, GlobalDataOfSeveralProgramsIsRefused) {
  const std::string messages = refused("G17 G710 G90 G94\nDEPTH_OF=3\nL100\nG0 X1\nM30\n");
  EXPECT_NE(messages.find("the global data DEPTH_OF, which other programs share,"), std::string::npos) << messages;
}

// What a definition file says of the control's data.
constexpr std::string_view kGud =
    "DEF NCK STRING[20] SHAPE\nDEF NCK REAL WHEEL[4]=SET(1,2.5)\nDEF CHAN INT PASSES=4\nDEF NCK REAL GRID[2,3]\n"
    "DEF NCK BOOL READY\nDEF NCK REAL HUGE[900]\nDEF NCK REAL TOOL_SET[40]=REP(3)\nM17\n";

ConvertResult with_gud(const std::string& text, const std::string& to) {
  const ir::Control from = control("sinumerik-840d", ir::MachineKind::mill);
  ProgramLibrary library(from, [](std::string_view name) -> std::optional<text::Source> {
    if (name != "UGUD") return std::nullopt;
    return text::Source("UGUD.DEF", std::string(kGud));
  });
  ConvertRequest request;
  request.source = text::Source("program", text);
  request.from = from;
  request.to = control(to, ir::MachineKind::mill);
  request.library = &library;
  return convert(request);
}

// Each kind of access, in a program that calls one which finds what its caller set.
TEST(ValueTypes, GlobalDataOfADefinitionFileHasOnePlaceForAllPrograms) {
  const std::string text =
      "%_N_MAIN_MPF\n;$PATH=/_N_MPF_DIR\nG17 G710 G90 G94\nG0 X=WHEEL[1]\nX=PASSES+WHEEL[3]\nPASSES=6.6\nR100=9\n"
      "GRID[1,2]=20 READY=R100\nL100\nG0 X=GRID[0,1]+60\nM30\n"
      "%_N_L100_SPF\n;$PATH=/_N_SPF_DIR\nDEF INT I\nG0 X=PASSES\nI=1\nX=GRID[I,I+1]+READY\nI=2\n"
      "X=TOOL_SET[I*19]+R100\nGRID[0,1]=WHEEL[0]\nM17\n";
  for (const std::string& to : dialect_names()) {
    if (to == "sinumerik-840d") continue;
    const ConvertResult result = with_gud(text, to);
    ASSERT_FALSE(text::has_error(result.diagnostics)) << messages_of(result.diagnostics, text::Source("program", text));
    std::vector<double> ends;
    for (const ir::Motion& m : real_moves(run_text(result.text, control(to, ir::MachineKind::mill)).motions))
      ends.push_back(m.end[0]);
    EXPECT_EQ(ends, (std::vector<double>{2.5, 4, 7, 21, 12, 61})) << result.text;
    EXPECT_NE(result.text.find("IF[#501 EQ #0]THEN #501=2.5"), std::string::npos) << result.text;
    EXPECT_NE(result.text.find("[6.6]"), std::string::npos) << result.text;
  }
}

// By itself a definition file becomes a program that sets all that is vacant.
TEST(ValueTypes, ADefinitionFileBecomesItsInitialValues) {
  const ConvertResult result = with_gud(std::string(kGud), "fanuc");
  ASSERT_FALSE(text::has_error(result.diagnostics))
      << messages_of(result.diagnostics, text::Source("program", std::string(kGud)));
  EXPECT_NE(result.text.find("IF[#500 EQ #0]THEN #500=1.\nIF[#501 EQ #0]THEN #501=2.5\n"), std::string::npos)
      << result.text;
  EXPECT_NE(result.text.find("IF[#504 EQ #0]THEN #504=4.\n"), std::string::npos) << result.text;
  EXPECT_NE(result.text.find("THEN #[#1+512]=3.\n"), std::string::npos) << "40 alike are a loop: " << result.text;
}

// Values alone are no definitions: each run sets them.
TEST(ValueTypes, AProgramThatOnlySetsGlobalDataSetsIt) {
  const ConvertResult result = with_gud("WHEEL[1]=5\nPASSES=2\nM17\n", "fanuc");
  ASSERT_FALSE(text::has_error(result.diagnostics));
  EXPECT_NE(result.text.find("#501=5\n#504=2\nM99\n"), std::string::npos) << result.text;
  EXPECT_EQ(result.text.find("IF"), std::string::npos) << result.text;
}

TEST(ValueTypes, GlobalDataThatDoesNotFitIsRefusedWhereItIsUsed) {
  const auto messages = [](const std::string& text) {
    const ConvertResult result = with_gud(text, "fanuc");
    EXPECT_TRUE(result.text.empty()) << result.text;
    return messages_of(result.diagnostics, text::Source("program", text));
  };
  const std::string huge = messages("G17 G710 G90 G94\nG0 X=HUGE[3]\nM30\n");
  EXPECT_NE(huge.find("program:2:6"), std::string::npos) << huge;
  EXPECT_NE(huge.find("the global data HUGE (900 numbers), for which no permanent variables are left,"),
            std::string::npos)
      << huge;
  EXPECT_NE(messages("G17 G710 G90 G94\nG0 X=WHEEL[4]\nM30\n").find("an element of WHEEL beyond its 4 elements"),
            std::string::npos);
  const std::string text = messages("G17 G710 G90 G94\nSHAPE=\"A\"\nG0 X1\nM30\n");
  EXPECT_NE(text.find("program:2:"), std::string::npos) << text;
  EXPECT_NE(text.find("the variable SHAPE, which is not a number,"), std::string::npos) << text;
  EXPECT_NE(messages("G17 G710 G90 G94\nG0 X=NOWHERE\nM30\n").find("NOWHERE, whose value is not known here"),
            std::string::npos);
}

TEST(ValueTypes, ArraysOfThreeDimensionsKeepTheirElementsApart) {
  expect_moves_kept("DEF REAL A[2,3,4]\nDEF INT I\n",
                    "A[1,2,3]=9 A[1,2,2]=8 A[0,2,3]=7 A[1,1,3]=6\nG0 X=A[1,2,3] Y=A[1,2,2]\nX=A[0,2,3] Y=A[1,1,3]\n"
                    "I=1\nX=A[I,I+1,I+2] Y=A[I,I,3]\n");
}

}  // namespace
}  // namespace dripfeed::compile::test
