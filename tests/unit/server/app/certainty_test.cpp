// What an examination of a '#' program calls an error, what it leaves open, and which likely faults a run reports.
#include <algorithm>

#include <gtest/gtest.h>

#include "server/app/checks/examine.h"

namespace dripfeed::app {
namespace {

using text::DiagnosticId;
using text::Severity;

struct Setting {
  std::string dialect = "fanuc";
  ir::MachineKind kind = ir::MachineKind::mill;
  const machine::Profile* profile = nullptr;
  compile::FindText find_called = {};
};

CheckReport check(const std::string& text, const Setting& setting = {}) {
  const compile::Dialect* dialect = compile::find_dialect(setting.dialect);
  ir::Control control = dialect->control(setting.kind, ir::GSystem::a);
  if (setting.profile != nullptr) control = machine::control_of(*setting.profile, control);
  return examine({.source = text::Source("x.nc", text),
                  .dialect = dialect,
                  .control = control,
                  .inferred = false,
                  .profile = setting.profile,
                  .delivery = ir::Delivery::memory,
                  .find_called = setting.find_called,
                  .geometry = {},
                  .profile_lines = {}});
}

// nullptr: not said.
const text::Diagnostic* find(const CheckReport& report, DiagnosticId id) {
  for (const text::Diagnostic& one : report.checks.diagnostics)
    if (one.id == id) return &one;
  return nullptr;
}

std::uint32_t line_of(const CheckReport& report, const text::Diagnostic& one) {
  return (one.elsewhere == nullptr ? report.source : *one.elsewhere).position(one.span.begin).line;
}

bool reports(const CheckReport& report, std::string_view part) {
  for (const checks::NotChecked& one : checks::not_checked_of(report.checks))
    if (one.text.contains(part)) return true;
  return false;
}

const std::string kHead = "%\nO1\nG21 G17 G90 G94 G40 G49 G80 G54\n";

// --- what no one gave is not known

TEST(Certainty, AMacroByItselfHasNoArgumentsAndThatIsNoError) {
  const CheckReport report = check("%\nO9001\nIF[#1NE#0]GOTO10\n#3000=1(NO A)\nN10 G01 X#1\nM99\n%\n");
  EXPECT_FALSE(text::has_error(report.checks.diagnostics));
  EXPECT_EQ(report.verdict, checks::Verdict::unknown);
  EXPECT_TRUE(reports(report, "#1: input not known"));
}

// Ended by M30, and still it may be called by G65: then its local variables are arguments.
TEST(Certainty, AProgramThatReadsLocalVariablesMayBeAMacro) {
  const CheckReport report = check(kHead + "IF[#1NE#0]GOTO10\n#3000=1(NO A)\nN10 M30\n%\n");
  EXPECT_FALSE(text::has_error(report.checks.diagnostics));
  EXPECT_EQ(report.verdict, checks::Verdict::unknown);
  EXPECT_TRUE(reports(report, "#1: input not known"));
}

TEST(Certainty, TheGuardOfAValueThatTheProgramSetsStrikes) {
  const CheckReport report = check(kHead + "#1=0\nIF[#1NE0]GOTO10\n#3000=1(NO A)\nN10 M30\n%\n");
  ASSERT_NE(find(report, DiagnosticId::user_alarm), nullptr);
  EXPECT_EQ(find(report, DiagnosticId::user_alarm)->severity, Severity::error);
}

TEST(Certainty, CommonVariablesAndInputsHoldWhatTheMachineHas) {
  for (const char* variable : {"#500", "#100", "#1000", "#4120", "#901050", "#[2000+#4111]"}) {
    const CheckReport report = check(kHead + "IF[" + variable + " EQ 0]GOTO10\n#3000=1(NONE)\nN10 M30\n%\n");
    EXPECT_FALSE(text::has_error(report.checks.diagnostics)) << variable;
    EXPECT_EQ(report.verdict, checks::Verdict::unknown) << variable;
  }
  EXPECT_EQ(check(kHead + "#500=1\nIF[#500 EQ 1]GOTO10\n#3000=1(NONE)\nN10 M30\n%\n").verdict, checks::Verdict::pass);
}

TEST(Certainty, AnUnknownValueStaysUnknownThroughArithmetic) {
  const CheckReport report = check(kHead + "#1=#500*0+1\nG00 X#1\nIF[#1 GT 0]GOTO10\n#3000=1(NONE)\nN10 M30\n%\n");
  EXPECT_FALSE(text::has_error(report.checks.diagnostics));
  EXPECT_TRUE(reports(report, "X from a value that is not known"));
}

TEST(Certainty, VariablesFrom34To99ExistNowhere) {
  const CheckReport report = check(kHead + "#50=1\nM30\n%\n");
  ASSERT_NE(find(report, DiagnosticId::variable_out_of_range), nullptr);
  EXPECT_EQ(find(report, DiagnosticId::variable_out_of_range)->severity, Severity::error);
  const CheckReport option = check(kHead + "#400=1\nG00 X#400\n#400=2\nM30\n%\n");
  ASSERT_NE(find(option, DiagnosticId::variable_out_of_range), nullptr);
  EXPECT_EQ(find(option, DiagnosticId::variable_out_of_range)->severity, Severity::warning);
  EXPECT_EQ(option.checks.diagnostics.size(), 1U) << "once a number";
}

TEST(Certainty, TheEndOfASubprogramByItselfIsNoLoop) {
  EXPECT_EQ(find(check("%\nO9001\nG00 X1.\nM99\n%\n"), DiagnosticId::endless_loop), nullptr);
  EXPECT_EQ(find(check("%\nO9001\nG01 X1.\nM99\n%\n"), DiagnosticId::no_feed), nullptr) << "its caller has one";
  const CheckReport loop = check(kHead + "IF[#100EQ1]GOTO5\nM99\nN5 M30\n%\n");
  EXPECT_NE(find(loop, DiagnosticId::endless_loop), nullptr);
}

// --- called programs

TEST(Certainty, AProgramThatIsNotThereMayBeInTheMemory) {
  const CheckReport report = check(kHead + "/M98 P9999\nM98 P9999\nG02 X10. Y0. I1. J0. F100.\nM30\n%\n");
  const text::Diagnostic* missing = find(report, DiagnosticId::call_target_missing);
  ASSERT_NE(missing, nullptr);
  EXPECT_EQ(missing->severity, Severity::warning);
  EXPECT_EQ(line_of(report, *missing), 4U) << "once a name";
  EXPECT_EQ(report.verdict, checks::Verdict::unknown);
  EXPECT_TRUE(report.ran);
}

TEST(Certainty, AFaultOfACalledProgramStandsInItsText) {
  const compile::FindText finder = [](std::string_view name) -> std::optional<text::Source> {
    if (name != "O0002") return std::nullopt;
    return text::Source("/nc/second.nc", "O0002\n\nG00 X0. Y0.\nG02 X10. Y0. I1. J0. F100.\nM99\n");
  };
  const CheckReport report = check(kHead + "M98 P2\nM30\n%\n", {.find_called = finder});
  const text::Diagnostic* arc = find(report, DiagnosticId::arc_radius_mismatch);
  ASSERT_NE(arc, nullptr);
  ASSERT_NE(arc->elsewhere, nullptr);
  EXPECT_EQ(arc->elsewhere->name(), "/nc/second.nc");
  EXPECT_EQ(line_of(report, *arc), 4U);
  EXPECT_TRUE(text::format_diagnostic(*arc, report.source, "").starts_with("/nc/second.nc:4:"));
}

TEST(Certainty, AFaultOfAProgramOfTheSameTextStandsThere) {
  const CheckReport report = check(kHead + "M98 P2\nM30\nO2\nG00 X0. Y0.\nG02 X10. Y0. I1. J0. F100.\nM99\n%\n");
  const text::Diagnostic* arc = find(report, DiagnosticId::arc_radius_mismatch);
  ASSERT_NE(arc, nullptr);
  EXPECT_EQ(arc->elsewhere, nullptr);
  EXPECT_EQ(line_of(report, *arc), 8U);
}

TEST(Certainty, AModalCallInsideAnotherIsNotCarriedOut) {
  const CheckReport report = check(kHead + "G66 P2\nG66 P2\nG00 X1.\nG67\nG67\nM30\nO2\nM99\n%\n");
  EXPECT_TRUE(reports(report, "a modal call (G66) inside another"));
  EXPECT_EQ(report.verdict, checks::Verdict::unknown);
  EXPECT_EQ(check(kHead + "G66 P2\nG00 X1.\nG67\nG66 P2\nG00 X2.\nG67\nM30\nO2\nM99\n%\n").verdict,
            checks::Verdict::pass);
}

// --- jumps

TEST(Certainty, AComputedJumpIntoALoopIsOneLikeAnyOther) {
  const std::string loop = "#2=0\nWHILE[#2LT2]DO1\nN20 #2=#2+1\nEND1\nM30\n%\n";
  EXPECT_NE(find(check(kHead + "#9=20\nGOTO#9\n" + loop), DiagnosticId::jump_into_loop), nullptr);
  const std::string before = "N10 #2=0\nWHILE[#2LT2]DO1\n#9=30\nGOTO#9\n#2=5\nN30 #2=#2+1\nEND1\nM30\n%\n";
  EXPECT_EQ(find(check(kHead + "#9=10\nGOTO#9\n" + before), DiagnosticId::jump_into_loop), nullptr);
}

// --- tools, holes, feeds, arcs

TEST(Certainty, AToolMovesAlongTheSpindleWithItsOwnLength) {
  const auto id_of = [](const std::string& blocks, const std::string& dialect = "fanuc") {
    const CheckReport report = check(kHead + blocks + "M30\n%\n", {.dialect = dialect});
    if (find(report, DiagnosticId::length_offset_missing) != nullptr) return std::string("missing");
    if (find(report, DiagnosticId::length_offset_of_other_tool) != nullptr) return std::string("other");
    return std::string(checks::name_of(report.verdict));
  };
  EXPECT_EQ(id_of("T1 M6\nG00 Z5.\n"), "missing");
  EXPECT_EQ(id_of("T1 M6\nG43 H0 Z5.\n"), "missing");
  EXPECT_EQ(id_of("T1 M6\nG43 Z5.\n"), "missing") << "no H was in effect";
  EXPECT_EQ(id_of("T1 M6\nG43 H1 Z5.\nG49\nG00 Z6.\n"), "missing");
  EXPECT_EQ(id_of("T1 M6\nG43 H2 Z5.\n"), "other");
  EXPECT_EQ(id_of("T1 M6\nG43 H1 Z5.\nT2 M6\nG00 Z5.\n"), "other") << "the length of T1 is still in effect";
  EXPECT_EQ(id_of("T1 M6\nG00 G43 H1 Z5.\nT2 M6\nG43 H2 Z5.\n"), "pass");
  EXPECT_EQ(id_of("T1 M6\nG00 X5.\nG53 Z0.\n"), "pass");
  EXPECT_EQ(id_of("G00 Z5.\n"), "pass") << "no tool was changed";
  EXPECT_EQ(id_of("T1 M6\nG00 Z5.\n", "mitsubishi-m80"), "missing");
  EXPECT_EQ(id_of("T1 M6\nG00 Z5.\n", "mazak"), "pass") << "a parameter lets the length act by M6";
}

TEST(Certainty, AProfileSaysWhichOffsetIsATools) {
  machine::Profile profile;
  profile.control.dialect = "fanuc";
  profile.machine.tools = {{.number = 1, .offset = 21}};
  const std::string text = kHead + "T1 M6\nG43 H21 Z5.\nM30\n%\n";
  EXPECT_EQ(find(check(text, {.profile = &profile}), DiagnosticId::length_offset_of_other_tool), nullptr);
  EXPECT_NE(find(check(text), DiagnosticId::length_offset_of_other_tool), nullptr);
}

TEST(Certainty, AHoleEndsBelowItsR) {
  const auto is_reported = [](const std::string& block) {
    return find(check(kHead + "G00 X0. Y0. Z10.\n" + block + "\nG80\nM30\n%\n"), DiagnosticId::hole_levels) != nullptr;
  };
  EXPECT_TRUE(is_reported("G81 X1. Z5. R2. F100."));
  EXPECT_TRUE(is_reported("G81 X1. Z-5. F100."));
  EXPECT_TRUE(is_reported("G91 G81 X1. Z5. R-2. F100."));
  EXPECT_FALSE(is_reported("G81 X1. Z-5. R2. F100."));
  EXPECT_FALSE(is_reported("G91 G81 X1. Z-5. R-2. F100."));
}

TEST(Certainty, AFeedOfTheOtherModeIsReported) {
  const auto is_reported = [](const std::string& block, ir::MachineKind kind) {
    return find(check("%\nO1\nG21\n" + block + "\nM30\n%\n", {.kind = kind}), DiagnosticId::feed_suspicion) != nullptr;
  };
  EXPECT_TRUE(is_reported("G99 G01 X10. Z0. F100.", ir::MachineKind::lathe));
  EXPECT_TRUE(is_reported("G98 G01 X10. Z0. F0.2", ir::MachineKind::lathe));
  EXPECT_FALSE(is_reported("G99 G01 X10. Z0. F0.2", ir::MachineKind::lathe));
  EXPECT_FALSE(is_reported("G98 G01 X10. Z0. F100.", ir::MachineKind::lathe));
  EXPECT_TRUE(is_reported("G17 G90 G95 G01 X10. F100.", ir::MachineKind::mill));
  EXPECT_FALSE(is_reported("G17 G90 G94 G01 X10. F0.5", ir::MachineKind::mill));
}

TEST(Certainty, AnArcWithoutCentreIsReported) {
  const CheckReport report = check(kHead + "G00 X0. Y0.\nG02 X10. Y0. F100.\nM30\n%\n");
  const text::Diagnostic* arc = find(report, DiagnosticId::arc_without_center);
  ASSERT_NE(arc, nullptr);
  EXPECT_EQ(arc->severity, Severity::warning);
  EXPECT_EQ(report.verdict, checks::Verdict::unknown);
}

TEST(Certainty, AnAllowanceLiesOnTheToolsSide) {
  const auto is_reported = [](const char* start, const char* first, const char* u) {
    const std::string text = std::string("%\nO1\nG21 G99 G40\nG00 X") + start + " Z2.\nG71 U1. R0.5\nG71 P10 Q20 U" +
                             u + " W0.1 F0.2\nN10 G00 X" + first + "\nG01 Z-10.\nN20 X" + start + "\nM30\n%\n";
    return find(check(text, {.kind = ir::MachineKind::lathe}), DiagnosticId::allowance_inside_part) != nullptr;
  };
  EXPECT_TRUE(is_reported("20.", "30.", "0.5"));
  EXPECT_FALSE(is_reported("20.", "30.", "-0.5"));
  EXPECT_FALSE(is_reported("40.", "30.", "0.5"));
  EXPECT_TRUE(is_reported("40.", "30.", "-0.5"));
}

TEST(Certainty, AShapeMayGoBackByLessThanAnIncrement) {
  const auto text = [](const char* x) {
    return std::string(
               "%\nO1\nG21 G99 G40\nG00 X60. Z2.\nG71 U1. R0.5\nG71 P10 Q20 U0.5 W0.1 F0.2\nN10 G00 X30.\nG01 "
               "Z-5.\nX40.\nZ-10. X") +
           x + "\nN20 X50.\nM30\n%\n";
  };
  const Setting lathe = {.kind = ir::MachineKind::lathe};
  EXPECT_EQ(find(check(text("39.99999"), lathe), DiagnosticId::cycle_shape_not_monotonic), nullptr);
  const CheckReport doubtful = check(text("39.9"), lathe);
  ASSERT_NE(find(doubtful, DiagnosticId::cycle_shape_not_monotonic), nullptr);
  EXPECT_EQ(find(doubtful, DiagnosticId::cycle_shape_not_monotonic)->severity, Severity::warning) << "5145 decides";
  EXPECT_TRUE(doubtful.ran);
  const CheckReport reversal = check(text("36."), lathe);
  EXPECT_EQ(find(reversal, DiagnosticId::cycle_shape_not_monotonic)->severity, Severity::error);
}

// --- what a setting of the machine decides

TEST(Certainty, HowFarTheRadiiOfAnArcMayDifferAParameterDecides) {
  const auto arc = [](const char* x) {
    return check(kHead + "G00 X0. Y0.\nG02 X" + x + " Y0. I5. J0. F100.\nM30\n%\n");
  };
  EXPECT_EQ(find(arc("10.01"), DiagnosticId::arc_radius_mismatch), nullptr);
  const CheckReport doubtful = arc("10.1");
  ASSERT_NE(find(doubtful, DiagnosticId::arc_radius_mismatch), nullptr);
  EXPECT_EQ(find(doubtful, DiagnosticId::arc_radius_mismatch)->severity, Severity::warning);
  EXPECT_TRUE(doubtful.ran);
  EXPECT_EQ(find(arc("10.5"), DiagnosticId::arc_radius_mismatch)->severity, Severity::error);
}

TEST(Certainty, BeforeAMotionCodeTheMachineDecidesWhetherABlockCuts) {
  const Setting own = {.dialect = "sinumerik-840d"};
  const CheckReport open = check("G17 G710 G90 G94\nX10\nM30\n", own);
  EXPECT_EQ(find(open, DiagnosticId::no_feed), nullptr);
  EXPECT_NE(find(open, DiagnosticId::motion_without_code), nullptr);
  EXPECT_NE(find(check("G17 G710 G90 G94\nX10\nG1 X20\nM30\n", own), DiagnosticId::no_feed), nullptr);
}

TEST(Certainty, PlacesOfNumbersWithoutAPointAreOpen) {
  const CheckReport report = check(kHead + "G00 X0. Y10\nG02 X10. Y10. I5. J0. F100.\nM30\n%\n");
  const text::Diagnostic* arc = find(report, DiagnosticId::arc_radius_mismatch);
  ASSERT_NE(arc, nullptr);
  EXPECT_EQ(arc->severity, Severity::warning);
  EXPECT_TRUE(arc->is_open);
  EXPECT_EQ(report.verdict, checks::Verdict::unknown);
  const CheckReport certain = check(kHead + "G00 X0. Y1.\nG02 X10. Y10. I5. J0. F100.\nM30\n%\n");
  EXPECT_EQ(find(certain, DiagnosticId::arc_radius_mismatch)->severity, Severity::error);
}

TEST(Certainty, OneSettingIsOneWarning) {
  const auto warnings = [](const CheckReport& report, DiagnosticId id) {
    return std::ranges::count_if(report.checks.diagnostics, [id](const text::Diagnostic& one) {
      return one.id == id && one.severity == Severity::warning;
    });
  };
  const CheckReport points = check(kHead + "G00 X10 Y20\nX30\nM30\n%\n");
  EXPECT_EQ(warnings(points, DiagnosticId::missing_decimal_point), 1);
  EXPECT_EQ(std::ranges::count(points.checks.diagnostics, DiagnosticId::missing_decimal_point, &text::Diagnostic::id),
            3);
  const CheckReport names = check("G17 G710 G90 G94\nG0 X=CLEAR_X Y=CLEAR_Y\nM30\n", {.dialect = "sinumerik-840d"});
  EXPECT_EQ(warnings(names, DiagnosticId::unknown_name), 1);
  EXPECT_EQ(names.verdict, checks::Verdict::unknown);
}

TEST(Certainty, AFeedWithoutAPointIsOpenInInchOnly) {
  const auto reported = [](const char* unit) {
    const CheckReport report =
        check("%\nO1\n" + std::string(unit) + " G17 G90 G94 G40 G49 G80 G54\nG01 X1. F100\nM30\n%\n");
    return find(report, DiagnosticId::missing_decimal_point) != nullptr;
  };
  EXPECT_TRUE(reported("G20"));
  EXPECT_FALSE(reported("G21"));
}

TEST(Certainty, WhatAnOutputDoesTheMachineSays) {
  const CheckReport report = check(kHead + "#1100=1\nM30\n%\n");
  EXPECT_EQ(report.verdict, checks::Verdict::unknown);
  EXPECT_TRUE(reports(report, "#1100: what this output does"));
  EXPECT_EQ(check("%\nO1\nG20 G17 G90 G94\n#12029=1\nM30\n%\n", {.dialect = "haas"}).verdict, checks::Verdict::unknown);
  const CheckReport named = check("$A_OUT[3]=1\nM30\n", {.dialect = "sinumerik-840d"});
  EXPECT_EQ(named.verdict, checks::Verdict::unknown);
  EXPECT_TRUE(reports(check("H1=5\nM30\n", {.dialect = "sinumerik-840d"}), "H: what this output does"));
  EXPECT_EQ(check(kHead + "#3901=1\nM30\n%\n").verdict, checks::Verdict::pass) << "a count of parts";
}

TEST(Certainty, AMarkOfUtf8AndTheEndOfADosFileAreNoFaults) {
  const CheckReport leader = check("\xEF\xBB\xBF" + kHead + "G00 X1.\nM30\n%\n\x1A");
  EXPECT_TRUE(leader.checks.diagnostics.empty());
  const CheckReport mark = check("\xEF\xBB\xBFO1\nG21 G17 G90 G94\nM30\n\x1A");
  ASSERT_NE(find(mark, DiagnosticId::invalid_character), nullptr);
  EXPECT_EQ(find(mark, DiagnosticId::invalid_character)->severity, Severity::warning);
  EXPECT_EQ(find(check(kHead + "G00 X1. \xC3\xA9\nM30\n%\n"), DiagnosticId::invalid_character)->severity,
            Severity::error);
}

TEST(Certainty, ABracketThatEndsNoCommentIsPassedOver) {
  const CheckReport report = check(kHead + "(A (B))\nG00 X1. (C (D))\nM30\n%\n");
  EXPECT_FALSE(text::has_error(report.checks.diagnostics));
  EXPECT_EQ(std::ranges::count(report.checks.diagnostics, DiagnosticId::nested_comment, &text::Diagnostic::id), 2);
  EXPECT_TRUE(text::has_error(check(kHead + "(A (B) C)\nM30\n%\n").checks.diagnostics));
}

TEST(Certainty, AHaasReadsPartsOfParameters) {
  const Setting haas = {.dialect = "haas"};
  const std::string text = kHead + "IF [#30057.21] GOTO5\n#1=#30003.078\nN5 (AT 50% SPEED)\nM30\n%\n";
  const CheckReport report = check(text, haas);
  EXPECT_FALSE(text::has_error(report.checks.diagnostics));
  ASSERT_NE(find(report, DiagnosticId::tape_mark_in_comment), nullptr);
  EXPECT_EQ(find(report, DiagnosticId::tape_mark_in_comment)->severity, Severity::warning);
  const CheckReport other = check(text);
  EXPECT_NE(find(other, DiagnosticId::variable_out_of_range), nullptr);
  EXPECT_EQ(find(other, DiagnosticId::tape_mark_in_comment)->severity, Severity::error);
}

TEST(Certainty, AHaasTakesAStatementAfterIfWithoutThen) {
  const std::string text = kHead + "IF [#598 NE 1.] G65 P9725\nIF [#598 EQ 2.] #1= 5.\nM30\n%\n";
  EXPECT_FALSE(text::has_error(check(text, {.dialect = "haas"}).checks.diagnostics));
  EXPECT_TRUE(text::has_error(check(text).checks.diagnostics));
  EXPECT_TRUE(text::has_error(check(kHead + "IF [#1 EQ 2.]\nM30\n%\n", {.dialect = "haas"}).checks.diagnostics));
}

TEST(Certainty, AFactorTakesAPoint) {
  EXPECT_EQ(find(check(kHead + "G51 X0. Y0. Z0. P2.\nG50\nM30\n%\n"), DiagnosticId::decimal_point_not_allowed),
            nullptr);
  EXPECT_NE(find(check(kHead + "G04 P2.\nM30\n%\n"), DiagnosticId::decimal_point_not_allowed), nullptr);
}

TEST(Certainty, CommentsBeforeTheFirstMarkAreNotRead) {
  EXPECT_FALSE(text::has_error(check("(OF THE SHOP)\n" + kHead + "M30\n%\n").checks.diagnostics));
  EXPECT_FALSE(text::has_error(check("(OF THE SHOP)\n" + kHead + "M30\n").checks.diagnostics));
  EXPECT_TRUE(text::has_error(check("(O1)\n%\n").checks.diagnostics));
}

TEST(Certainty, ANumberAloneIsNoProgramWithoutAnEnd) {
  EXPECT_FALSE(text::has_error(check("%\nO2\nO1\nG21 G17 G90 G94\nM30\n%\n", {.dialect = "fanuc"}).checks.diagnostics));
  EXPECT_TRUE(text::has_error(check("%\nO1\n%\n").checks.diagnostics));
}

// --- what the profile settles

TEST(Certainty, TheReferencePointIsTheProfiles) {
  machine::Profile profile;
  profile.control.dialect = "fanuc";
  profile.machine.axes = {{.axis = ir::Axis::x}, {.axis = ir::Axis::y}, {.axis = ir::Axis::z}};
  const std::string text = kHead + "G91 G28 Z0.\nG90 G00 X1. Y1.\nM30\n%\n";
  EXPECT_EQ(check(text).verdict, checks::Verdict::pass) << "where it lies is the machine's, and none is named";
  const CheckReport open = check(text, {.profile = &profile});
  EXPECT_EQ(open.verdict, checks::Verdict::unknown);
  EXPECT_TRUE(reports(open, "\"reference_mm\" of X, Y, Z in the machine's profile decides this"));
  for (checks::MachineAxis& axis : profile.machine.axes) axis.reference = 0.0;
  EXPECT_NE(check(text, {.profile = &profile}).verdict, checks::Verdict::unknown);
  const std::string second = kHead + "G91 G30 Z0.\nG90 G00 X1. Y1.\nM30\n%\n";
  EXPECT_EQ(check(second, {.profile = &profile}).verdict, checks::Verdict::unknown);
  for (checks::MachineAxis& axis : profile.machine.axes) axis.second_reference = 0.0;
  EXPECT_NE(check(second, {.profile = &profile}).verdict, checks::Verdict::unknown);
}

TEST(Certainty, MFunctionsAreTheProfiles) {
  const std::string text = kHead + "M61\nM30\n%\n";
  const CheckReport open = check(text);
  EXPECT_EQ(open.verdict, checks::Verdict::unknown);
  EXPECT_TRUE(reports(open, "M61: what it does is not known; \"machine_functions\""));
  machine::Profile profile;
  profile.control.dialect = "fanuc";
  profile.control.machine_functions = {61};
  EXPECT_NE(check(text, {.profile = &profile}).verdict, checks::Verdict::unknown);
  const std::string tap = kHead + "S500 M3\nG00 X0. Y0. Z5.\nM29 S500\nG84 X1. Z-5. R2. F500.\nG80\nM30\n%\n";
  EXPECT_EQ(check(tap).verdict, checks::Verdict::pass);
}

TEST(Certainty, TwoSystemsOfOneLatheAreNotGuessed) {
  const compile::Dialect* dialect = compile::find_dialect("fanuc");
  const text::Source source("x.nc", "%\nO1\nG21 G40\nG92 S2000\nT0101\nG00 U50. Z2.\nM30\n%\n");
  const ir::Control control = dialect->infer_control(source);
  ASSERT_EQ(control.contradiction.size(), 2U);
  const CheckReport report = examine({.source = source,
                                      .dialect = dialect,
                                      .control = control,
                                      .inferred = true,
                                      .find_called = {},
                                      .geometry = {},
                                      .profile_lines = {}});
  ASSERT_NE(find(report, DiagnosticId::control_contradicted), nullptr);
  EXPECT_EQ(report.verdict, checks::Verdict::unknown);
  const text::Source clear("x.nc", "%\nO1\nG21 G40 G99\nG50 S2000\nT0101\nG00 X50. Z2.\nM30\n%\n");
  EXPECT_TRUE(dialect->infer_control(clear).contradiction.empty());
}

CheckReport check_for_line(const std::string& text) {
  machine::Profile profile;
  profile.name = "m";
  profile.control.dialect = "fanuc";
  profile.line.link = machine::parse_link_url("serial:/dev/ttyS0").value();
  profile.line.character_set = "fanuc-iso";
  return check(text, {.profile = &profile});
}

// "SEVERITY CHARACTER: LAST NOTE" of each diagnostic about characters.
std::vector<std::string> characters_in(const CheckReport& report) {
  std::vector<std::string> all;
  for (const text::Diagnostic& one : report.checks.diagnostics)
    if (one.id == DiagnosticId::invalid_character)
      all.push_back(std::string(text::name_of(one.severity)) + " " + one.arguments.at(0) + ": " +
                    one.notes.back().text);
  return all;
}

TEST(Certainty, CharactersOfCommentsAreReportedOnceAKind) {
  const std::string rest = "G21G90G94G17\nG0X1.\nM30\n%\n";
  EXPECT_EQ(characters_in(check_for_line("%\nO1(Shaft)\n(of Steel)\n" + rest)),
            (std::vector<std::string>{"warning h: the first of 10 lower-case letters in comments"}));
  EXPECT_EQ(characters_in(check_for_line("%\nO1(a)\n(B;C)\n(D!)\n" + rest)),
            (std::vector<std::string>{"warning a: the control does not take the character 'a'",
                                      "warning ;: the first of 2 such characters in comments"}));
  EXPECT_TRUE(characters_in(check_for_line("%\nO1(SHAFT)\n" + rest)).empty());
}

// However many a comment has, those of blocks are seen.
TEST(Certainty, CharactersOfCommentsHideNone) {
  const CheckReport report =
      check_for_line("%\nO1(" + std::string(100, 'a') + ")\nG21G90G94G17\n#100=[#_DATE]\nM30\n%\n");
  EXPECT_EQ(characters_in(report),
            (std::vector<std::string>{"warning a: the first of 100 lower-case letters in comments",
                                      "error _: the control does not take the character '_'"}));
}

// Whose tool the profile knows is milled, in an order that the control need not have; without it nothing is known.
TEST(Certainty, AMillingCycleIsAsCertainAsItsTool) {
  const std::string text =
      "G17 G90 G94 G40 G71 G54\nT1 M6\nD1\nS1000 M3\nG0 X0 Y0 "
      "Z50\nPOCKET3(20,0,2,-5,60,40,8,0,0,0,2,0,0,300,100,0,11)\n"
      "M30\n";
  machine::Profile profile;
  profile.machine.tools = {{.number = 1, .offset = 1, .diameter_mm = 10.0}};
  const CheckReport known = check(text, {.dialect = "sinumerik-840d", .profile = &profile});
  EXPECT_FALSE(text::has_error(known.checks.diagnostics));
  EXPECT_FALSE(known.checks.has_unknown_effects);
  EXPECT_TRUE(reports(known, "the order in which POCKET3 removes the material: the control has its own"));
  const CheckReport open = check(text, {.dialect = "sinumerik-840d"});
  EXPECT_TRUE(open.checks.has_unknown_effects);
  EXPECT_TRUE(reports(open, "POCKET3 by a tool whose radius is not known: not interpreted"));
}

// --- orders whose effect on the moves is known

TEST(Certainty, OrdersToOtherSpindlesAndHowFeedsCountLeaveTheVerdict) {
  const std::string head = "G18 G90 G95 G710 G40 G54 DIAMON\nT1 D1\nS500 M3\nG0 X10 Z5\n";
  struct Row {
    const char* line;
    const char* consequence;  // nullptr: none
  };
  for (const Row& row :
       {Row{"S2=900 M2=3", "S2: the machine's profile states the limits of the main spindle alone"},
        Row{"SPOS=90", nullptr}, Row{"CYCLE832(0.02,_FINISH,1)", "CYCLE832: how far the machine leaves the path"},
        Row{"FGROUP(X,Z)", "FGROUP: it states how feeds count"}}) {
    const CheckReport report =
        check(head + row.line + "\nM30\n", {.dialect = "sinumerik-840d", .kind = ir::MachineKind::lathe});
    EXPECT_NE(report.verdict, checks::Verdict::unknown) << row.line;
    EXPECT_TRUE(row.consequence == nullptr || reports(report, row.consequence)) << row.line;
  }
  EXPECT_EQ(check(head + "M2=70\nM30\n", {.dialect = "sinumerik-840d", .kind = ir::MachineKind::lathe}).verdict,
            checks::Verdict::unknown);
}

}  // namespace
}  // namespace dripfeed::app
