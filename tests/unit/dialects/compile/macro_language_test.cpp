// Programs in the macro language of the '#' controls, read and run: calls in all forms, several programs in one text,
// modal calls, output, names, offsets. What is expected is written out by hand.
#include <algorithm>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/unit/dialects/compile/harness.h"

namespace dripfeed::compile::test {
namespace {

struct Result {
  interpreter::RunResult result;
  std::string trace;
  std::vector<text::Diagnostic> reading;
};

Result run(const std::string& text, const std::string& dialect = "fanuc", ir::MachineKind kind = ir::MachineKind::mill,
           std::vector<interpreter::InitialValue> values = {}, std::vector<ir::CodeCall> code_calls = {}) {
  ir::Control machine = control(dialect, kind);
  machine.code_calls = std::move(code_calls);
  const text::Source source("program", text);
  const ir::ReadResult read = find_dialect(dialect)->read(source, machine);
  interpreter::RunNames names;
  interpreter::TraceWriter writer(machine, names);
  interpreter::RunOptions options;
  options.want_variables = true;
  options.initial_values = std::move(values);
  options.names = &names;
  Result out;
  out.reading = read.diagnostics;
  out.result = execute(read.program, machine, nullptr, writer, options);
  out.trace = writer.text();
  return out;
}

// X of each move, the rest left out: "1 2 3 ".
std::string x_of(const Result& run) {
  std::string out;
  for (std::size_t at = run.trace.find(" X"); at != std::string::npos; at = run.trace.find(" X", at + 1)) {
    const std::string word = run.trace.substr(at + 2, run.trace.find(' ', at + 2) - at - 2);
    out += word.substr(0, word.find('.')) + " ";
  }
  return out;
}
double value_of(const Result& run, const std::string& name) {
  for (const interpreter::VariableValue& v : run.result.variables)
    if (v.name == name) return v.value.value_or(-999.0);
  return -999.0;
}
interpreter::InitialValue number(std::uint32_t n, double value) { return {ir::Bank::hash, n, {}, value}; }

constexpr const char* kTwoSubs =
    "%\nO0001\nG21 G90 G94 G00\nM98 P0002 L2\nM98 P30003\nM98 P0009 Q20\nM30\n"
    "O0002\nX1.\nM99\nO0003\nX3.\nM99\nO0009\nX8.\nN20 X9.\nM99\n%\n";

TEST(MacroLanguage, ProgramsOfOneTextCallOneAnother) {
  const Result r = run(kTwoSubs);
  EXPECT_EQ(x_of(r), "1 1 3 3 3 9 ");
  EXPECT_EQ(r.result.ended, interpreter::Ended::end);
  EXPECT_EQ(r.result.programs, (std::vector<std::string>{"O0001", "O0002", "O0003", "O0009"}));
  EXPECT_NE(r.trace.find("@1 O0002\n@1:9 rapid"), std::string::npos) << r.trace;
}

TEST(MacroLanguage, TheMainProgramEndsWhereTheNextBegins) {
  EXPECT_EQ(run("%\nO1\nG00 X1.\nO2\nX2.\nM99\n%\n").result.ended, interpreter::Ended::text_end);
}

TEST(MacroLanguage, MitsubishiStartsASubprogramAtH) {
  EXPECT_EQ(x_of(run("%\nO1\nG90 G00\nM98 P2 H20 L2\nM30\nO2\nX8.\nN20 X9.\nM99\n%\n", "mitsubishi-m80")), "9 9 ");
  // Without P: a part of the program itself.
  EXPECT_EQ(x_of(run("%\nO1\nG90 G00\nM98 H20\nM30\nN20 X9.\nM99\n%\n", "mitsubishi-m80")), "9 ");
}

TEST(MacroLanguage, OnlyFanucPacksTheCountIntoP) {
  const std::string text = "%\nO1\nG90 G00\nM98 P20003\nM30\nO3\nX3.\nM99\nO20003\nX9.\nM99\n%\n";
  EXPECT_EQ(x_of(run(text)), "3 3 ");
  EXPECT_EQ(x_of(run(text, "mazak")), "9 ");
  EXPECT_EQ(x_of(run(text, "mitsubishi-m80")), "9 ");
}

TEST(MacroLanguage, AMissingStartBlockIsAnAlarm) {
  const Result r = run("%\nO1\nM98 P2 Q50\nM30\nO2\nM99\n%\n", "mazak");
  ASSERT_EQ(r.result.ended, interpreter::Ended::alarm);
  EXPECT_EQ(r.result.diagnostics.back().diagnostic.alarm, "843");
}

TEST(MacroLanguage, ReturnsToABlockOfTheCaller) {
  EXPECT_EQ(x_of(run("%\nO1\nG90 G00\nM98 P2\nX1.\nN30 X2.\nM30\nO2\nX7.\nM99 P30\n%\n")), "7 2 ");
  EXPECT_EQ(x_of(run("%\nO1\nG90 G00\n#1=30\nM98 P2\nX1.\nN30 X2.\nM30\nO2\nM99 P#1\n%\n")), "2 ");
}

TEST(MacroLanguage, M99OfTheMainProgramJumpsOrStartsAgain) {
  EXPECT_EQ(x_of(run("%\nO1\nG90 G00\nX1.\nIF[#1EQ1]GOTO90\n#1=1\nM99 P20\nX5.\nN20 X2.\nN90 M30\n%\n")), "1 2 ");
  EXPECT_TRUE(run("%\nO1\nG90 G00 X1.\nM99\n%\n").result.diagnostics.empty()) << "a subprogram by itself";
  const Result r = run("%\nO1\nG90 G00 X1.\nM99\nM30\n%\n");
  EXPECT_EQ(r.result.ended, interpreter::Ended::end);
  EXPECT_EQ(r.result.diagnostics.back().diagnostic.id, text::DiagnosticId::endless_loop);
}

TEST(MacroLanguage, ArgumentsOfBothTypes) {
  const Result one =
      run("%\nO1\nG65 P2 A1. B2. D7. I4. J5. K6. M13. Z26.\nM30\n"
          "O2\n#101=#1+#2*10+#7*100\n#102=#4*100+#5*10+#6\n#103=#13+#26\nM99\n%\n");
  EXPECT_EQ(value_of(one, "#101"), 721.0);
  EXPECT_EQ(value_of(one, "#102"), 456.0);
  EXPECT_EQ(value_of(one, "#103"), 39.0);
  const Result two =
      run("%\nO1\nG65 P2 I1. J2. K3. I4. J5. I7.\nM30\n"
          "O2\n#101=#4*100+#5*10+#6\n#102=#7*10+#8\n#103=#10\nM99\n%\n");
  EXPECT_EQ(value_of(two, "#101"), 123.0);
  EXPECT_EQ(value_of(two, "#102"), 45.0);
  EXPECT_EQ(value_of(two, "#103"), 7.0);
}

TEST(MacroLanguage, ModalCallsFollowEachMove) {
  const Result r =
      run("%\nO1\nG90 G00\nG66 P2 A5.\nX1.\nM08\nX2. (two)\nG67\nX3.\nM30\n"
          "O2\n#100=#100+#1\nG91 X10.\nG90\nM99\n%\n");
  EXPECT_EQ(value_of(r, "#100"), 10.0);
  EXPECT_EQ(x_of(r), "1 11 2 12 3 ");  // the macro's own move calls nothing
}

TEST(MacroLanguage, ModalCallsRepeat) {
  const Result r = run("%\nO1\nG90 G00\nG66 P2 L3 A5.\nX1.\nG67\nM30\nO2\n#100=#100+#1\n#1=0\nM99\n%\n");
  EXPECT_EQ(value_of(r, "#100"), 15.0);
}

TEST(MacroLanguage, CodesOfTheMachineCall) {
  const std::vector<ir::CodeCall> calls = {{'G', 1000, 9010, true}, {'M', 500, 9020, false}};
  const Result r = run("%\nO1\nG90 G00\nG100 X5. L2\nX2. M50\nM30\nO9010\n#100=#100+#24\nM99\nO9020\nX7.\nM99\n%\n",
                       "fanuc", ir::MachineKind::mill, {}, calls);
  EXPECT_EQ(value_of(r, "#100"), 10.0);
  EXPECT_EQ(x_of(r), "2 7 ");
}

TEST(MacroLanguage, PrintsToADeviceAsTheManualShows) {
  // B-64604EN, DPRNT: #2=128.47398, #5=-91.2, #30=123.456
  const Result r =
      run("%\nO1\n#2=128.47398\n#5=-91.2\n#30=123.456\nPOPEN\nDPRNT[X#2[53]*Y#5[53]*T#30[20]]\nPCLOS\nM30\n%\n");
  EXPECT_EQ(r.trace, "7 message \"X   128.474 Y-   91.200 T 23\"\n9 end\n");
}

TEST(MacroLanguage, VariablesHaveNames) {
  const Result r = run("%\nO1\nSETVN 101[DEPTH,WIDTH]\n[#DEPTH]=5.\n#102=[#DEPTH]*2\n#103=[#WIDTH]+1\nM30\n%\n");
  EXPECT_EQ(value_of(r, "#101"), 5.0);
  EXPECT_EQ(value_of(r, "#103"), 11.0);
}

TEST(MacroLanguage, ConditionBlocksWhereTheControlHasThem) {
  const std::string text = "%\nO1\nIF[#1EQ#0]THEN\n#101=1\nELSE\n#101=2\nENDIF\nIF[#101EQ2]THEN #102=3\nM30\n%\n";
  for (const char* dialect : {"mazak", "mitsubishi-m80"}) {
    const Result r = run(text, dialect);
    EXPECT_EQ(value_of(r, "#101"), 1.0) << dialect;
    EXPECT_EQ(value_of(r, "#102"), -999.0) << dialect;
  }
}

TEST(MacroLanguage, ComputedJumpsAndNestedLoops) {
  const Result r =
      run("%\nO1\n#1=20\nGOTO#1\nN10 #101=1\nN20 #102=1\nGOTO[#1+10]\n#101=2\nN30\n#3=0\n#2=0\n"
          "WHILE[#2LT3]DO1\n#2=#2+1\n#4=0\nWHILE[#4LT2]DO2\n#4=#4+1\n#3=#3+1\nEND2\nEND1\n#103=#3\nM30\n%\n");
  EXPECT_EQ(value_of(r, "#101"), -999.0);
  EXPECT_EQ(value_of(r, "#102"), 1.0);
  EXPECT_EQ(value_of(r, "#103"), 6.0);
}

// An offset that is set to a value that only the control knows, and then to another: where the axis is, is not known.
TEST(MacroLanguage, AnOffsetOfAnUnknownValue) {
  const Result ran = run("%\nO1\nG90 G54 G00 X0. Y5.\n#5222=#5122\n#5222=0\n#101=#5042\nG91 Y1.\nM30\n%\n");
  EXPECT_FALSE(ran.trace.contains("nan")) << ran.trace;
  EXPECT_TRUE(std::ranges::any_of(ran.result.not_interpreted, [](const interpreter::NotInterpreted& one) {
    return one.name == "increments from a position that is not known";
  })) << ran.trace;
}

TEST(MacroLanguage, OffsetsThatAreSetMoveThePosition) {
  // G54 X is 100 before; set to 130 the same place is 30 less in the offset.
  const Result r =
      run("%\nO1\nG90 G54 G00 X50.\nG10 L2 P1 X130.\n#101=#5041\n#102=#5021\n#5221=100.\n#103=#5041\nM30\n%\n", "fanuc",
          ir::MachineKind::mill, {number(5221, 100.0)});
  EXPECT_EQ(value_of(r, "#101"), 20.0);
  EXPECT_EQ(value_of(r, "#102"), 150.0);
  EXPECT_EQ(value_of(r, "#103"), 50.0);
}

// G54.1 P2 X is #7021 on all of them and has another number besides; P60 has none below 8000, but G10 L20 sets it. The
// zero moves from 100 to 130, so that the same place is 30 less.
TEST(MacroLanguage, AnOffsetWithTwoNumbersIsOne) {
  struct Case {
    std::string dialect;
    std::string active;
    std::string set;
    std::uint32_t before;
  };
  for (const Case& one : {
           Case{"fanuc", "P2", "#14021=130.", 7021},
           Case{"fanuc", "P2", "#7021=130.", 14021},
           Case{"fanuc", "P2", "G10 L20 P2 X130.", 14021},
           Case{"fanuc", "P60", "G10 L20 P60 X130.", 15181},
           Case{"mazak", "P60", "#71181=130.", 71181},
           Case{"mazak", "P2", "#70021=130.", 7021},
           Case{"mitsubishi-m80", "P60", "G10 L20 P60 X130.", 101221},
       }) {
    const Result r = run("%\nO1\nG90 G54.1 " + one.active + " G00 X50.\n" + one.set + "\n#101=#5041\nM30\n%\n",
                         one.dialect, ir::MachineKind::mill, {number(one.before, 100.0)});
    EXPECT_EQ(value_of(r, "#101"), 20.0) << one.dialect << " " << one.set;
  }
}

TEST(MacroLanguage, ToolOffsetsByData) {
  const Result mill = run("%\nO1\nG90\nG10 L10 P3 R12.5\nG91\nG10 L10 P3 R0.5\n#101=#11003\nM30\n%\n");
  EXPECT_EQ(value_of(mill, "#101"), 13.0);
  const Result lathe = run("%\nO1\nG10 P4 X1.5 Z-2. R0.8 Q3\n#101=#2004\n#102=#2104\n#103=#2204\n#104=#2304\nM30\n%\n",
                           "fanuc", ir::MachineKind::lathe);
  EXPECT_EQ(value_of(lathe, "#101"), 1.5);
  EXPECT_EQ(value_of(lathe, "#102"), -2.0);
  EXPECT_EQ(value_of(lathe, "#103"), 0.8);
  EXPECT_EQ(value_of(lathe, "#104"), 3.0);
}

TEST(MacroLanguage, ASkipMoveEndsWhereTheProbeTouches) {
  const std::string text = "%\nO1\nG21 G90 G94 G00 X0. Y0. Z0.\nG31 Z-20. F100.\n#101=#5063\nM30\n%\n";
  EXPECT_EQ(value_of(run(text), "#101"), -20.0);
  const Result touched = run(text, "fanuc", ir::MachineKind::mill, {number(5063, -12.5)});
  EXPECT_EQ(value_of(touched, "#101"), -12.5);
  EXPECT_NE(touched.trace.find("linear X0.0000 Y0.0000 Z-12.5000"), std::string::npos);
}

// G66.1: each block, its own too, is the macro with its words as arguments; nothing in it moves by itself.
TEST(MacroLanguage, AMacroInPlaceOfEachBlock) {
  for (const std::string dialect : {"fanuc", "mazak", "mitsubishi-m80"}) {
    const Result r =
        run("%\nO1\nG90 G00 X9. Y0. Z0.\nG66.1 P2 X4.\nX1. A5.\n#110=0\nX2. (two)\nG67\nX3.\nM30\n"
            "O2\n#100=#100+#24\n#101=#1\nM99\n%\n",
            dialect);
    EXPECT_EQ(x_of(r), "9 3 ") << dialect << r.trace;
    EXPECT_EQ(value_of(r, "#100"), 7.0) << dialect;
    // The second block has no A: a call's locals are new.
    EXPECT_EQ(value_of(r, "#101"), -999.0) << dialect;
    const auto& unread = r.result.not_interpreted;
    EXPECT_TRUE(std::ranges::none_of(unread, [](const auto& n) { return n.name == "G66.1"; })) << dialect;
  }
}

TEST(MacroLanguage, ABlockUnderEachBlockCallWithACodeIsNotCertain) {
  const Result r = run("%\nO1\nG90 G00 X9. Y0. Z0.\nG66.1 P2\nG01 X1. F100.\nG67\nM30\nO2\n#100=1.\nM99\n%\n");
  EXPECT_EQ(x_of(r), "9 ") << r.trace;
  EXPECT_TRUE(std::ranges::any_of(r.result.not_interpreted,
                                  [](const auto& n) { return n.name == "a block under G66.1" && n.first_line == 5; }));
}

TEST(MacroLanguage, ThreeDimensionalCodesAreReportedWithTheirLine) {
  for (const std::string code : {"G68.2 X0. Y0. Z0. I0. J45. K0.", "G43.4 H1"}) {
    const Result r = run("%\nO1\nG90 G00 X9. Y0. Z0.\n" + code + "\nX1.\nM30\n%\n");
    const std::string name = code.substr(0, 5);
    EXPECT_TRUE(std::ranges::any_of(r.result.not_interpreted, [&](const auto& n) {
      return n.name == name && n.first_line == 4 && !n.effects_known;
    })) << code;
  }
}

TEST(MacroLanguage, ModesCanBeRead) {
  const Result r =
      run("%\nO1\nG21 G90 G94 G17 G01 X1. F250. S800 T5 M6\nG43 H7 D9\n#101=#4001\n#102=#4003\n#103=#4109\n"
          "#104=#4119\n#105=#4120\n#106=#4111\n#107=#4107\n#108=#5001\nM30\n%\n");
  const std::vector<double> expected = {1.0, 90.0, 250.0, 800.0, 5.0, 7.0, 9.0, 1.0};
  for (std::size_t i = 0; i < expected.size(); ++i)
    EXPECT_EQ(value_of(r, "#" + std::to_string(101 + i)), expected[i]) << i;
}

TEST(MacroLanguage, TheClockGoesOnWithBlocksAndDwells) {
  const Result r = run("%\nO1\n#3001=0\nG04 P1500\nWHILE[#3001LT2000]DO1\nEND1\n#101=#3001\nM30\n%\n");
  EXPECT_EQ(r.result.ended, interpreter::Ended::end);
  EXPECT_GE(value_of(r, "#101"), 2000.0);
  EXPECT_LT(value_of(r, "#101"), 2010.0);
}

TEST(MacroLanguage, UserAlarmsAreNumberedAsTheControlShowsThem) {
  const auto alarm = [](const char* dialect, const char* n) {
    const Result r = run(std::string("%\nO1\n#3000=") + n + "(NO TOOL)\nM30\n%\n", dialect);
    EXPECT_EQ(r.result.ended, interpreter::Ended::alarm);
    return r.result.diagnostics.back().diagnostic;
  };
  EXPECT_EQ(text::message_of(alarm("fanuc", "5")).find("3005 NO TOOL") != std::string::npos, true);
  EXPECT_EQ(alarm("mazak", "5").alarm, "984");
  EXPECT_EQ(alarm("mazak", "21").alarm, "979");
  EXPECT_EQ(alarm("mitsubishi-m80", "5").alarm, "P277");
}

TEST(MacroLanguage, WorkOffsetsByComputedNumber) {
  const Result r = run("%\nO1\n#1=4\nG54.1 P#1\nG90 G00 X1.\nG54.1 P7\nM30\n%\n");
  EXPECT_NE(r.trace.find("offset 104\n"), std::string::npos) << r.trace;
  EXPECT_NE(r.trace.find("offset 107\n"), std::string::npos) << r.trace;
}

TEST(MacroLanguage, SingleTurningCycles) {
  const Result r =
      run("%\nO1\nG21 G99 G18\nG00 X60. Z2.\nG90 X50. Z-20. F0.2\nX45.\nG00 X60. Z2.\nG94 X40. Z-1. R-2. F0.1\n"
          "G92 X30. Z-10. F1.5\nG00 X100.\nM30\n%\n",
          "fanuc", ir::MachineKind::lathe);
  EXPECT_EQ(
      r.trace,
      "4 rapid X60.0000 Z2.0000\n"
      "5 rapid X50.0000 Z2.0000\n5 linear X50.0000 Z-20.0000 F0.2000/rev\n5 linear X60.0000 Z-20.0000 F0.2000/rev\n"
      "5 rapid X60.0000 Z2.0000\n"
      "6 rapid X45.0000 Z2.0000\n6 linear X45.0000 Z-20.0000 F0.2000/rev\n6 linear X60.0000 Z-20.0000 F0.2000/rev\n"
      "6 rapid X60.0000 Z2.0000\n"
      "7 rapid X60.0000 Z2.0000\n"
      "8 rapid X60.0000 Z-3.0000\n8 linear X40.0000 Z-1.0000 F0.1000/rev\n8 linear X40.0000 Z2.0000 F0.1000/rev\n"
      "8 rapid X60.0000 Z2.0000\n"
      "9 rapid X30.0000 Z2.0000\n9 thread X30.0000 Z-10.0000 F1.5000/rev\n9 rapid X60.0000 Z-10.0000\n"
      "9 rapid X60.0000 Z2.0000\n"
      "10 rapid X100.0000 Z2.0000\n11 end\n");
}

// ,R1 of Mitsubishi: F is the lead, in G94 too.
TEST(MacroLanguage, ASynchronousTapFeedsByItsLead) {
  const std::string body = "%\nO1\nG21 G17 G90 G94 G40\nG00 X0 Y0 Z5.\nG84 Z-5. R2. F1. S500 ,R";
  const Result tap = run(body + "1\nG80\nM30\n%\n", "mitsubishi-m80");
  EXPECT_NE(tap.trace.find("thread X0.0000 Y0.0000 Z-5.0000 F1.0000/rev"), std::string::npos) << tap.trace;
  EXPECT_NE(tap.trace.find("thread X0.0000 Y0.0000 Z2.0000 F1.0000/rev"), std::string::npos) << tap.trace;
  const Result other = run(body + "0\nG80\nM30\n%\n", "mitsubishi-m80");
  EXPECT_NE(other.trace.find("linear X0.0000 Y0.0000 Z-5.0000 F1.0000/min"), std::string::npos) << other.trace;
}

// 30i, 0i-F: the control's own names, with a number where there are several.
TEST(MacroLanguage, SystemVariablesHaveNames) {
  const Result r =
      run("%\nO1\nG21 G17 G90 G94 G40\nG00 X3. Y4.\n#1=2\n#100=[#_ABSIO[1]]\n#101=[#_ABSIO[#1]]\n#102=[#_BUFG[3]]\n"
          "[#_WZG54[1]]=7.\n#103=#5221\nM30\n%\n");
  EXPECT_EQ(value_of(r, "#100"), 3.0);
  EXPECT_EQ(value_of(r, "#101"), 4.0);
  EXPECT_EQ(value_of(r, "#102"), 90.0);
  EXPECT_EQ(value_of(r, "#103"), 7.0);
}

// Groups that the controls number alike are known; beyond them only Fanuc's are.
TEST(MacroLanguage, CodesInEffectAreReadByGroup) {
  const std::string body =
      "%\nO1\nG21 G17 G90 G94 G40\nG55 G43 H1 G00 Z5.\n#100=#4008\n#101=#4014\nG49\n#102=#4008\nM30\n%\n";
  const Result fanuc = run(body);
  EXPECT_EQ(value_of(fanuc, "#100"), 43.0);
  EXPECT_EQ(value_of(fanuc, "#101"), 55.0);
  EXPECT_EQ(value_of(fanuc, "#102"), 49.0);
  const Result mitsubishi = run(body, "mitsubishi-m80");
  EXPECT_EQ(value_of(mitsubishi, "#100"), 43.0);
  EXPECT_EQ(value_of(mitsubishi, "#101"), -999.0);
}

// G05 P10000 and P0 are modes that change no place; what else G05 does is not known.
TEST(MacroLanguage, ContourControlIsAMode) {
  const auto unread = [](const std::string& block) {
    const Result r = run("%\nO1\nG21 G17 G90 G94 G40\n" + block + "\nG01 X1. F100.\nM30\n%\n");
    return std::ranges::any_of(r.result.not_interpreted, [](const auto& n) {
      return n.name == "G05" && n.function == ir::Function::not_modelled;
    });
  };
  EXPECT_FALSE(unread("G05 P10000"));
  EXPECT_FALSE(unread("G05 P0"));
  EXPECT_TRUE(unread("G05 P2"));
  EXPECT_TRUE(unread("G05 P#1"));
}

TEST(MacroLanguage, TapersStartNextToTheEnd) {
  const Result r = run("%\nO1\nG21 G99 G18\nG00 X60. Z2.\nG90 X50. Z-20. R-2.5 F0.2\nU-14.\nM30\n%\n", "fanuc",
                       ir::MachineKind::lathe);
  EXPECT_EQ(
      r.trace,
      "4 rapid X60.0000 Z2.0000\n"
      "5 rapid X45.0000 Z2.0000\n5 linear X50.0000 Z-20.0000 F0.2000/rev\n5 linear X60.0000 Z-20.0000 F0.2000/rev\n"
      "5 rapid X60.0000 Z2.0000\n"
      "6 rapid X41.0000 Z2.0000\n6 linear X46.0000 Z-20.0000 F0.2000/rev\n6 linear X60.0000 Z-20.0000 F0.2000/rev\n"
      "6 rapid X60.0000 Z2.0000\n7 end\n");
}

// What a block read when it raised an alarm is noted; what it was to write is not.
TEST(MacroLanguage, AnAlarmNotesWhatItsBlockRead) {
  const auto notes_of = [](const std::string& block) {
    const Result r = run("%\nO1\nG21 G90 G94\n#100=7\n" + block + "\nM30\n%\n");
    EXPECT_EQ(r.result.ended, interpreter::Ended::alarm) << block;
    std::string out;
    for (const text::DiagnosticNote& note : r.result.diagnostics.back().diagnostic.notes) out += note.text + "; ";
    return out;
  };
  EXPECT_EQ(notes_of("GOTO#149"), "here #149 is vacant; ");
  EXPECT_EQ(notes_of("#101=#100/[#100-7.+#3]"), "here #100 is 7, #3 is vacant; ");
  EXPECT_EQ(notes_of("#101=#[2900000+#4111]"), "here #4111 is 0; ");
}

// M and what is calculated for it is a whole number (M[3.5] is M4); G keeps its tenths.
TEST(MacroLanguage, CalculatedCodesAreRounded) {
  const Result r = run("%\nO1\nG21 G90 G94 G17\nS100\nM[3.5]\n#1=4.6\nM#1\n#2=54.1\nG#2 P1\nM30\n%\n");
  EXPECT_EQ(r.trace, "5 spindle ccw S100.0000/rpm\n7 spindle off\n9 offset 101\n10 end\n");
  EXPECT_EQ(run("%\nO1\nM3.5\nM30\n%\n").reading.front().id, text::DiagnosticId::unknown_code);
}

// What the machine's parameters hold is an input of the run, by name.
TEST(MacroLanguage, ParametersOfTheMachineAreInputs) {
  const std::string text =
      "%\nO1\nG21 G90 G94 G17\n#1=8130\nG00 X[PRM[#1]]\nX[PRM[4012,6]/[1]+2.]\nX[PRM[1241]/[3]/10.]\nX[PRM[19,2]+5.]\n"
      "M30\n%\n";
  const auto named = [](std::string name, double value) {
    interpreter::InitialValue one;
    one.bank = ir::Bank::named;
    one.name = std::move(name);
    one.value = value;
    return one;
  };
  const Result known = run(text, "fanuc", ir::MachineKind::mill,
                           {named("PRM[8130]", 6), named("PRM_OF_AXIS[4012,1,6]", 1), named("PRM_OF_AXIS[1241,3]", 40),
                            named("PRM[19,2]", 0)});
  EXPECT_EQ(x_of(known), "6 3 4 5 ");
  EXPECT_TRUE(known.result.not_interpreted.empty());
  const Result open = run("%\nO1\nG21 G90 G94 G17\n#101=PRM[1241]/[3]\nM30\n%\n");
  ASSERT_EQ(open.result.not_interpreted.size(), 1U);
  EXPECT_TRUE(open.result.not_interpreted.front().is_input);
  EXPECT_EQ(open.result.not_interpreted.front().name, "PRM_OF_AXIS[1241,3]");
  const ir::Control mill = control("fanuc", ir::MachineKind::mill);
  const ir::ReadResult read = find_dialect("fanuc")->read(text::Source("program", text), mill);
  const std::string printed = find_dialect("fanuc")->print(read.program, mill).text;
  for (const char* words : {"X[PRM[#1]]", "X[PRM[4012,6]/[1]+2.]", "X[PRM[1241]/[3]/10.]", "X[PRM[19,2]+5.]"})
    EXPECT_NE(printed.find(words), std::string::npos) << printed;
  for (const std::string& to : dialect_names()) {
    if (to == "fanuc") continue;
    const ConvertResult refused = translated(text, "fanuc", to);
    EXPECT_NE(messages_of(refused.diagnostics, text::Source("program", text)).find("PRM[#1] has no counterpart"),
              std::string::npos)
        << to << messages_of(refused.diagnostics, text::Source("program", text));
  }
}

}  // namespace
}  // namespace dripfeed::compile::test
