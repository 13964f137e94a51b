// What a translation between the controls gets wrong most easily, each as a row: a text, what its translation must say
// and must not, or the error that it must be. Equal moves are the samples' tests; these are about the words.
#include <array>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include "tests/unit/dialects/compile/harness.h"

namespace dripfeed::compile::test {
namespace {

constexpr std::string_view kS = "sinumerik-840d";
constexpr std::string_view kF = "fanuc";
constexpr std::string_view kZ = "mazak";
constexpr std::string_view kM = "mitsubishi-m80";
constexpr auto kMacro = ConvertMode::macro;
constexpr auto kPlain = ConvertMode::explicit_blocks;

// "S mill": the head of a program that leaves nothing to the power-on state.
constexpr std::string_view kMillS = "G710 G17 G90 G94 G40\n";
constexpr std::string_view kMillF = "%\nO1\nG21 G17 G90 G94 G40\n";
constexpr std::string_view kTurnF = "%\nO1\nG21 G18 G99 G40\n";

struct Pitfall {
  std::string_view name;
  std::string_view from;
  std::string_view to;
  ConvertMode mode;
  std::string_view head;
  std::string_view body;
  std::vector<std::string_view> says;      // of the translation, or of its error
  std::vector<std::string_view> says_not;  // of the translation
  bool refused = false;
};

const std::vector<Pitfall>& pitfalls() {
  static const std::vector<Pitfall> all = {
      {"1 decimal point", kS, kF, kMacro, kMillS, "G0 X100 Y=50\n", {"X100.", "Y50."}, {"X100 ", "Y50\n"}},
      {"1 increments", kF, kS, kMacro, kMillF, "G0 X100 Y1.\n", {"X0.1"}, {"X100"}},
      {"2 power-on state", kF, kS, kMacro, "%\nO1\nG21\n", "G0 X1.\nG1 X2. F10.\n", {"G17 G90 G94\n"}, {}},
      {"2 power-on state", kS, kF, kMacro, "G710\n", "G0 X1\nG1 X2 F10\n", {"G17 G90 G94\n"}, {}},
      {"3 comparisons",
       kF,
       kS,
       kMacro,
       kMillF,
       "IF[[#101EQ1]OR[#102EQ2]]GOTO5\nG0 X1.\nN5 G0 X2.\n",
       {"(R101==1) OR (R102==2)"},
       {}},
      {"5 no ELSE",
       kS,
       kF,
       kMacro,
       kMillS,
       "IF R1>2\nG0 X1\nELSE\nG0 X2\nENDIF\n",
       {"GOTO 10", "GOTO 20", "N10 "},
       {"ELSE", "ENDIF"}},
      {"6 vacant", kF, kS, kMacro, kMillF, "G0 X#5 Y1.\n", {"#5, which may be empty here"}, {}, true},
      {"6 vacant", kF, kS, kMacro, kMillF, "IF[#5EQ#0]GOTO5\nG0 X1.\nN5 G0 X2.\n", {"an empty value"}, {}, true},
      {"7 equality",
       kS,
       kF,
       kMacro,
       kMillS,
       "IF R1==R2 GOTOF LAST\nG0 X1\nLAST: G0 X2\n",
       {"ABS[#101-#102] LT 0.0000001"},
       {"EQ"}},
      {"8 comments", kF, kS, kMacro, kMillF, "(TOOL 1)\nG0 X1.(APPROACH)\n", {"G0 X1."}, {"(TOOL", "(APPROACH"}},
      {"9 labels",
       kS,
       kF,
       kMacro,
       kMillS,
       "N10 R1=0\nAGAIN:\nG0 X=R1\nR1=R1+1\nIF R1<3 GOTOB AGAIN\n",
       {"N10 #101=0", "N20", "GOTO 20"},
       {"AGAIN"}},
      {"10 scope", kF, kS, kMacro, kMillF, "#1=5.\n#101=6.\nG0 X#1 Y#101\n", {"R1=5", "R101=6"}, {}},
      {"11 persistence", kF, kS, kMacro, kMillF, "#1=5.\n#501=6.\nG0 X#1 Y#501\n", {"Y=R0"}, {"R501"}},
      {"12 arguments", kF, kS, kMacro, kMillF, "G65 P9010 A1. D2. K3.\n", {"L9010(1,,,,,3,2)"}, {"G65"}},
      {"12 arguments", kS, kM, kMacro, kMillS, "CUT_IT(1,,3,4)\n", {"G65 <CUT_IT> A1. C3. I4."}, {" B", "M98"}},
      {"12 arguments", kF, kS, kMacro, kMillF, "G65 P9010 A1. I2. J3. I4.\n", {"arguments of the second"}, {}, true},
      {"13 sequence number", kZ, kM, kMacro, kMillF, "M98 P1000 Q20 L2\n", {"M98 P1000 H20 L2"}, {"Q20"}},
      {"13 packed count", kF, kM, kMacro, kMillF, "M98 P51002\n", {"M98 P1002 L5"}, {"P51002"}},
      {"14 repeats", kS, kF, kMacro, kMillS, "LA: G0 X1\nLB: G0 X2\nREPEAT LA LB P=2\n", {"#100=2\n"}, {}},
      {"14 repeats", kS, kF, kMacro, kMillS, "L100 P3\n", {"M98 P100 L3"}, {}},
      {"14 repeats", kF, kS, kMacro, kMillF, "M98 P0100 L3\n", {"L0100 P=3"}, {"L3"}},
      {"15 arc center", kS, kF, kMacro, kMillS, "G0 X4 Y0\nG2 X20 Y0 I=AC(12) J0 F100\n", {"I8. J0."}, {"I12."}},
      {"15 arc center",
       kS,
       kF,
       kMacro,
       kMillS,
       "G0 X=R1 Y0\nG2 X=R1+20 Y0 I=AC(R1+10) J0 F100\n",
       {"I[#101+10-#5001] J0."},
       {}},
      {"15 arc center",
       kS,
       kF,
       kMacro,
       kMillS,
       "G0 X=R1 Y0\nROT RPL=30\nG2 X=R1+20 Y0 I=AC(R1+10) J0 F100\n",
       {"absolute arc centre"},
       {},
       true},
      {"15 arc center",
       kS,
       kF,
       kPlain,
       kMillS,
       "G0 X5 Y0 Z0\nG2 X25 Y0 I=AC(15) J=AC(0) F100\n",
       {"I10. J0."},
       {"I15."}},
      {"15 increments in absolute blocks",
       kS,
       kF,
       kMacro,
       kMillS,
       "G0 X5\nG90 G0 X=IC(3)\nX9\n",
       {"G91\nG00 X3.\nG90\n"},
       {}},
      {"16 sign of a radius", kS, kF, kMacro, kMillS, "G0 X0 Y0\nG2 X10 Y0 CR=-8 F100\n", {"R-8."}, {}},
      {"16 full circle", kF, kS, kMacro, kMillF, "G0 X0 Y0\nG2 I5. F100.\n", {"G2 I5."}, {"CR="}},
      {"16 radius back to the start",
       kF,
       kS,
       kPlain,
       kMillF,
       "G0 X0 Y0\nG2 X0 Y0 R5. F100.\n",
       {"the arc begins 5.0000 mm"},
       {},
       true},
      {"17 diameter",
       kS,
       kF,
       kMacro,
       "G710 G18 G90 G95 G40 DIAM90\n",
       "G0 X50 Z2\nG91 G1 X-2 F0.1\nG90 X40\n",
       {"U-4.", "X40."},
       {}},
      {"18 code system",
       kF,
       kS,
       kPlain,
       kTurnF,
       "G0 X50. Z2.\nG90 X48. Z-20. F.2\nG0 X60.\n",
       {"G1 Z-20. F0.2"},
       {"G90 X48"}},
      {"19 tool length", kF, kS, kMacro, kMillF, "T5 M6\nG43 H5 G0 Z10.\nG49\n", {"D1", "D0"}, {"G43", "G49"}},
      {"19 tool length", kS, kF, kMacro, kMillS, "T5 D1\nM6\nG0 Z10\n", {"G43 H5"}, {"D1"}},
      {"20 shift", kF, kS, kMacro, kMillF, "G52 X10.\nG0 X2.\nG52 X0 Y0 Z0\n", {"TRANS X10."}, {"ATRANS", "G52"}},
      {"20 offsets", kF, kS, kMacro, kMillF, "G58\nG0 X1.\nG54.1 P1\nG0 X1.\n", {"G505", "G507"}, {"G54.1", "G58"}},
      {"20 offsets", kS, kF, kMacro, kMillS, "G505\nG0 X1\nG507\nG0 X1\n", {"G58", "G54.1 P1"}, {"G505"}},
      {"20 added shift", kS, kF, kMacro, kMillS, "TRANS X10\nATRANS X5\nG0 X3\n", {"G52 X15."}, {"X5."}},
      {"21 frames",
       kS,
       kF,
       kPlain,
       kMillS,
       "TRANS X10\nAROT RPL=90\nG0 X5 Y0 Z0\nROT RPL=90\nG0 X5 Y1\n",
       {"X10. Y5.", "X-1."},
       {"G52", "G68"}},
      {"22 dwell", kF, kS, kMacro, kMillF, "F100.\nG04 P2500\nG04 X1.5\nG1 X1.\n", {"G4 F2.5", "G4 F1.5"}, {"P2500"}},
      {"22 dwell in turns", kS, kF, kMacro, kMillS, "G4 S3\nG0 X1\n", {"a dwell in turns"}, {}, true},
      {"23 inch", kS, kF, kMacro, "G70 G17 G90 G94 G40\n", "G0 X1\nG1 X2 F254\n", {"G20", "F10."}, {"G70", "F254"}},
      {"24 spindle limit", kF, kS, kMacro, kTurnF, "G50 S2500\nG96 S200 M3\nG0 X10.\n", {"LIMS=2500"}, {"G50"}},
      {"24 coordinates", kF, kS, kMacro, kMillF, "G92 X0 Y0\nG0 X1.\n", {"G92"}, {}, true},
      {"25 cycles",
       kF,
       kS,
       kPlain,
       kMillF,
       "G0 X0 Y0 Z20.\nG91 G99 G81 X5. Z-5. R-18. K2 F50.\nG80\n",
       {"Z2.", "Z-3.", "X10."},
       {"G81", "K2"}},
      {"25 rigid taps",
       kF,
       kM,
       kMacro,
       kMillF,
       "M29 S300\nG84 Z-9. R2. F450.\nG80\n",
       {"S300\n", "F1.5", ",R1\n"},
       {"M29", "R2. F450"}},
      {"25 rigid taps", kF, kZ, kMacro, kMillF, "M29 S300\nG84 Z-9. R2. F450.\nG80\n", {"G84.2 Z-9."}, {"M29"}},
      {"25 rigid taps",
       kM,
       kF,
       kMacro,
       kMillF,
       "S300\nG84 Z-9. R2. F1.5 ,R1\nG80\n",
       {"M29\nG84 Z-9.", "F450."},
       {",R"}},
      {"25 rigid taps", kZ, kF, kMacro, kMillF, "S300\nG84.2 Z-9. R2. F450.\nG80\n", {"M29\nG84 Z-9."}, {"84.2"}},
      {"25 rigid taps", kM, kF, kMacro, kMillF, "S300\nG84 Z-9. R2. F450. ,R0\nG80\n", {"G84 Z-9."}, {",R", "M29"}},
      {"25 rigid taps",
       kM,
       kS,
       kMacro,
       kMillF,
       "G0 Z9.\nS300 M3\nG84 X1. Z-9. R2. F1.5 ,R1\nG80\n",
       {"CYCLE84("},
       {"RND", "M29"}},
      {"25 rigid taps",
       kF,
       kS,
       kMacro,
       kMillF,
       "G0 Z9.\nS300 M3\nM29 S300\nG84 X1. Z-9. R2. F450.\nG80\n",
       {"CYCLE84("},
       {"M29"}},
      {"25 rigid taps",
       kS,
       kF,
       kMacro,
       kMillS,
       "S200 M3 F100\nG0 Z10\nMCALL CYCLE84(10,0,2,-12,,,3,,1.5,,300)\nX10\nMCALL\nG1 X20\n",
       {"S300\nM29\nG98 G84 Z-12. R2. K0. F450.\nX10.\nG80\nG00\nS200 F100. M03\n"},
       {"CYCLE"}},
      {"25 rigid taps",
       kS,
       kM,
       kMacro,
       kMillS,
       "S200 M3 F100\nG0 Z10\nCYCLE84(10,0,2,-12,,0.5,5,,-1.5,,300)\nG1 X20\n",
       {"G98 G74 Z-12. R2. P500 F1.5 ,R1\nG80\n"},
       {"M29"}},
      {"25 rigid taps",
       kS,
       kF,
       kMacro,
       kMillS,
       "G0 Z10\nCYCLE84(10,0,2,-12,,,3,,1.5,,300)\n",
       {"CYCLE84 after a feed or speed that is not known"},
       {},
       true},
      {"26 look-ahead", kF, kS, kMacro, kMillF, "#3001=0\nG0 X1.\n", {"#3001"}, {}, true},
      {"26 look-ahead", kS, kF, kMacro, kMillS, "STOPRE\nR1=$AA_IW[X]\nG0 X=R1\n", {"$AA_IW[X]"}, {}, true},
      {"27 angles", kF, kS, kMacro, kMillF, "#1=ATAN[-1.]/[-1.]\nG0 X#1\n", {"ATAN2(-1,-1)", "360"}, {}},
      {"29 tape",
       kF,
       kS,
       kPlain,
       kMillF,
       "#1=0\nWHILE[#1LT3]DO1\nG0 X#1\n#1=#1+1\nEND1\n",
       {"X0.\nX1.\nX2.\n"},
       {"WHILE", "R1"}},
      {"30 macro and motion", kS, kF, kMacro, kMillS, "R1=5 G0 X10 Y=R1\n", {"#101=5\nG00 X10. Y#101"}, {}},
  };
  return all;
}

ConvertRequest request_of(const Pitfall& row) {
  const bool turning = row.head == kTurnF || row.head.contains("G18");
  const ir::MachineKind kind = turning ? ir::MachineKind::lathe : ir::MachineKind::mill;
  std::string text = std::string(row.head) + std::string(row.body) + "M30\n";
  if (row.from != kS) text += "%\n";
  ConvertRequest request;
  request.source = text::Source("program", std::move(text));
  request.from = control(std::string(row.from), kind);
  request.to = control(std::string(row.to), kind);
  request.mode = row.mode;
  return request;
}

TEST(Pitfalls, OfTranslation) {
  for (const Pitfall& row : pitfalls()) {
    SCOPED_TRACE(std::string(row.name) + ": " + std::string(row.body));
    const ConvertRequest request = request_of(row);
    const ConvertResult result = convert(request);
    const std::string errors = messages_of(result.diagnostics, request.source);
    EXPECT_EQ(text::has_error(result.diagnostics), row.refused) << errors;
    const std::string& messages = row.refused ? errors : result.text;
    for (const std::string_view words : row.says)
      EXPECT_NE(messages.find(words), std::string::npos) << words << "\n" << messages;
    for (const std::string_view words : row.says_not) {
      EXPECT_EQ(result.text.find(words), std::string::npos) << words << "\n" << result.text;
    }
  }
}

// 2: a subprogram runs in its caller's modes, so none is put in front of it.
TEST(Pitfalls, ASubprogramIsGivenNoModes) {
  ConvertRequest request;
  request.source = text::Source("sub", "%\nO1000\nG01 X1. F100.\nY2.\nM99\n%\n");
  request.from = control(std::string(kF), ir::MachineKind::mill);
  for (const std::string_view to : {kS, kM}) {
    request.to = control(std::string(to), ir::MachineKind::mill);
    const ConvertResult result = convert(request);
    ASSERT_FALSE(text::has_error(result.diagnostics)) << messages_of(result.diagnostics, request.source);
    EXPECT_EQ(result.text.find("G90"), std::string::npos) << result.text;
    EXPECT_EQ(result.text.find("G17"), std::string::npos) << result.text;
  }
}

// 4: a fourth level of loops where there are three.
TEST(Pitfalls, LoopsAreUnnestedWhereTheyMayNotBeSoDeep) {
  std::string text(kMillF);
  for (int level = 1; level <= 4; ++level) {
    const std::string n = std::to_string(level);
    text += "#10" + n + "=0\nWHILE[#10" + n + "LT2]DO" + n + "\n";
  }
  text += "G0 X#104\n";
  for (int level = 4; level >= 1; --level) {
    const std::string n = std::to_string(level);
    text += "#10" + n + "=#10" + n + "+1\nEND" + n + "\n";
  }
  ConvertRequest request;
  request.source = text::Source("program", text + "M30\n%\n");
  request.from = control(std::string(kM), ir::MachineKind::mill);
  request.to = control(std::string(kF), ir::MachineKind::mill);
  const ConvertResult result = convert(request);
  ASSERT_FALSE(text::has_error(result.diagnostics)) << messages_of(result.diagnostics, request.source);
  EXPECT_EQ(result.text.find("DO4"), std::string::npos) << result.text;
  EXPECT_NE(result.text.find("DO3"), std::string::npos) << result.text;
  expect_same(moves_of(run_text(text + "M30\n%\n", request.from).motions),
              moves_of(run_text(result.text, request.to).motions), 1e-9, result.text);
}

// 28: a block that the other control does not read is no translation.
TEST(Pitfalls, ABlockThatIsTooLongThereIsRefusedAtItsLine) {
  std::string block = "G0 X=R1";
  for (int i = 0; i < 20; ++i) block += "+SIN(R2*3.25)";
  ConvertRequest request;
  request.source = text::Source("program", std::string(kMillS) + block + "\nM30\n");
  request.from = control(std::string(kS), ir::MachineKind::mill);
  request.to = control(std::string(kZ), ir::MachineKind::mill);
  const ConvertResult result = convert(request);
  ASSERT_TRUE(text::has_error(result.diagnostics));
  EXPECT_EQ(result.text, "");
  const text::Diagnostic& error = result.diagnostics.back();
  EXPECT_EQ(error.id, text::DiagnosticId::block_too_long);
  EXPECT_EQ(request.source.position(error.span.begin).line, 2U);
  EXPECT_EQ(error.alarm, "708");
}

}  // namespace
}  // namespace dripfeed::compile::test
