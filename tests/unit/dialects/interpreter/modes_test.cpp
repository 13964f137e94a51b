// What codes and words do to the modal state: distance, unit, diameter, decimals, coordinates, feed, events.
#include <gtest/gtest.h>

#include "tests/unit/dialects/interpreter/run_trace.h"

namespace dripfeed::test {
namespace {

using ir::Address;
using ir::Function;
using ir::ModalGroup;
using ir::WordMode;
using Builder = ProgramBuilder;
using Word = Builder::WordText;

// The trace of blocks without the end.
std::string trace_of(Builder& b, const ir::Control& control) {
  b.end();
  std::string trace = run_program(b.build(), control).trace;
  const std::size_t last = trace.rfind('\n', trace.size() - 2);
  return trace.substr(0, last == std::string::npos ? 0 : last + 1);
}

TEST(Modes, AbsoluteIncrementalAndPerWord) {
  Builder b;
  b.block({{Function::rapid}, {Function::absolute}}, {{Address::x, 10.0}, {Address::y, 20.0}, {Address::z, 5.0}});
  b.block({{Function::incremental}}, {{Address::x, 1.5}, Word(Address::y, 7.0, WordMode::absolute)});
  b.block({{Function::absolute}}, {Word(Address::x, -1.0, WordMode::incremental), {Address::z, 0.0}});
  EXPECT_EQ(trace_of(b, sinumerik_control()),
            "1 rapid X10.0000 Y20.0000 Z5.0000\n"
            "2 rapid X11.5000 Y7.0000 Z5.0000\n"
            "3 rapid X10.5000 Y7.0000 Z0.0000\n");
}

TEST(Modes, LettersAsIncrements) {
  Builder b;
  b.block({{Function::rapid}}, {{Address::x, 100.0}, {Address::z, 10.0}});
  b.block({}, {{Address::u, -4.0}, {Address::w, -2.5}});
  b.block({}, {{Address::x, 90.0}, {Address::w, 1.0}});
  EXPECT_EQ(trace_of(b, lathe_control()),
            "1 rapid X100.0000 Z10.0000\n2 rapid X96.0000 Z7.5000\n3 rapid X90.0000 Z8.5000\n");
}

TEST(Modes, InchConvertsLengthsAndFeedsButNoAngles) {
  ir::Control control = mill_control();
  control.axes = "XYZA";
  Builder b;
  b.block({{Function::unit_inch}, {Function::linear}}, {{Address::x, 1.0}, {Address::a, 90.0}, {Address::f, 10.0}});
  b.block({{Function::unit_mm}}, {{Address::x, 1.0}, {Address::f, 10.0}});
  b.block({{Function::unit_inch, 1}}, {{Address::x, 2.0}, {Address::f, 30.0}});  // lengths only
  EXPECT_EQ(trace_of(b, control),
            "1 linear X25.4000 Y0.0000 Z0.0000 A90.0000 F254.0000/min\n"
            "2 linear X1.0000 Y0.0000 Z0.0000 A90.0000 F10.0000/min\n"
            "3 linear X50.8000 Y0.0000 Z0.0000 A90.0000 F30.0000/min\n");
}

TEST(Modes, NumbersWithoutAPointCountIncrements) {
  ir::Control control = mill_control();
  control.semantics.decimal_mode = ir::DecimalMode::least_increment;
  Builder b;
  b.block({{Function::linear}}, {{Address::x, b.number(100, false)},
                                 {Address::y, b.number(100, true)},
                                 {Address::z, b.apply(ir::Operator::negate, b.number(5, false))},
                                 {Address::f, b.number(200, false)}});
  b.block({{Function::unit_inch}}, {{Address::x, b.number(10000, false)}, {Address::f, b.number(100, false)}});
  b.assign(Builder::hash(1), b.number(100, false));
  b.block({{Function::unit_mm}}, {{Address::x, b.read(Builder::hash(1))}, {Address::f, b.number(1)}});
  b.block({{Function::feed_per_rev}}, {{Address::x, b.number(0, false)}, {Address::f, b.number(15, false)}});
  b.block({{Function::dwell}}, {{Address::x, b.number(1500, false)}});
  b.block({{Function::dwell}}, {{Address::p, b.number(1500, false)}});
  EXPECT_EQ(trace_of(b, control),
            "1 linear X0.1000 Y100.0000 Z-0.0050 F200.0000/min\n"
            "2 linear X25.4000 Y100.0000 Z-0.0050 F25.4000/min\n"
            "4 linear X100.0000 Y100.0000 Z-0.0050 F1.0000/min\n"
            "5 linear X0.0000 Y100.0000 Z-0.0050 F0.1500/rev\n"
            "6 dwell P1.5000\n"
            "7 dwell P1.5000\n");
}

TEST(Modes, CalculatorTakesNumbersAsWritten) {
  Builder b;
  b.block({{Function::rapid}}, {{Address::x, b.number(100, false)}});
  EXPECT_EQ(trace_of(b, mill_control()), "1 rapid X100.0000 Y0.0000 Z0.0000\n");
}

TEST(Modes, DiameterModes) {
  ir::Control control = sinumerik_control();
  control.kind = ir::MachineKind::lathe;
  control.axes = "XZ";
  Builder b;
  b.block({{Function::rapid}, {Function::diameter_on}}, {{Address::x, 100.0}, {Address::z, 0.0}});
  b.block({{Function::incremental}}, {{Address::x, -10.0}});
  b.block({{Function::diameter_absolute_only}}, {{Address::x, -10.0}});
  b.block({}, {Word(Address::x, 50.0, WordMode::absolute)});
  b.block({{Function::diameter_off}}, {{Address::x, 1.0}});
  b.block({{Function::absolute}}, {{Address::x, 20.0}});
  EXPECT_EQ(trace_of(b, control),
            "1 rapid X100.0000 Z0.0000\n2 rapid X90.0000 Z0.0000\n3 rapid X70.0000 Z0.0000\n"
            "4 rapid X50.0000 Z0.0000\n5 rapid X52.0000 Z0.0000\n6 rapid X40.0000 Z0.0000\n");
}

TEST(Modes, DiameterOnAMillHalves) {
  Builder b;
  b.block({{Function::rapid}, {Function::diameter_on}}, {{Address::x, 100.0}});
  EXPECT_EQ(trace_of(b, sinumerik_control()), "1 rapid X50.0000 Y0.0000 Z0.0000\n");
}

TEST(Modes, LocalShiftsReplaceOrAdd) {
  Builder b;
  b.block({{Function::local_shift}}, {{Address::x, 10.0}, {Address::y, 1.0}});
  b.block({{Function::rapid}}, {{Address::x, 5.0}, {Address::y, 5.0}, {Address::z, 0.0}});
  b.block({{Function::local_shift}}, {{Address::x, 20.0}});  // Y keeps its shift
  b.block({}, {{Address::x, 5.0}, {Address::y, 5.0}});
  b.block({{Function::local_shift, 1}}, {{Address::x, 30.0}});  // a whole frame: Y loses it
  b.block({}, {{Address::x, 5.0}, {Address::y, 5.0}});
  b.block({{Function::local_shift_add}}, {{Address::x, 1.0}});
  b.block({}, {{Address::x, 5.0}});
  b.block({{Function::local_shift, 1}});
  b.block({}, {{Address::x, 5.0}});
  EXPECT_EQ(trace_of(b, mill_control()),
            "2 rapid X15.0000 Y6.0000 Z0.0000\n4 rapid X25.0000 Y6.0000 Z0.0000\n6 rapid X35.0000 Y5.0000 Z0.0000\n"
            "8 rapid X36.0000 Y5.0000 Z0.0000\n10 rapid X5.0000 Y5.0000 Z0.0000\n");
}

TEST(Modes, SetCoordinatesShiftsWithoutMoving) {
  Builder b;
  b.block({{Function::set_coordinates}}, {{Address::x, 100.0}});  // unknown before: this is where it is
  b.block({{Function::rapid}, {Function::incremental}}, {{Address::x, -10.0}});
  b.block({{Function::set_coordinates}, {Function::absolute}}, {{Address::x, 0.0}});
  b.block({{Function::rapid}}, {{Address::x, 5.0}});
  EXPECT_EQ(trace_of(b, mill_control()), "2 rapid X90.0000 Y0.0000 Z0.0000\n4 rapid X95.0000 Y0.0000 Z0.0000\n");
}

TEST(Modes, SetCoordinatesWithSIsTheSpindleLimit) {
  Builder b;
  b.block({{Function::set_coordinates}}, {{Address::s, 3200.0}});
  b.block({{Function::surface_speed_on}, {Function::spindle_cw}}, {{Address::s, 200.0}});
  b.block({}, {{Address::spindle_limit, 2500.0}});
  b.block({{Function::surface_speed_off}}, {{Address::s, 800.0}});
  b.block({{Function::spindle_stop}});
  EXPECT_EQ(trace_of(b, lathe_control()),
            "2 spindle cw S200.0000/m_min limit 3200.0000\n"
            "3 spindle cw S200.0000/m_min limit 2500.0000\n"
            "4 spindle cw S800.0000/rpm\n"
            "5 spindle off\n");
}

// 500 mm a minute are not 500 mm a turn.
TEST(Modes, AnFOfTheOtherKindIsNone) {
  Builder b;
  b.block({{Function::linear}, {Function::feed_per_min}}, {{Address::x, 1.0}, {Address::f, 500.0}});
  b.block({{Function::feed_per_rev}}, {{Address::x, 2.0}});
  b.block({}, {{Address::x, 3.0}, {Address::f, 0.2}});
  EXPECT_EQ(trace_of(b, mill_control()),
            "1 linear X1.0000 Y0.0000 Z0.0000 F500.0000/min\n2 linear X2.0000 Y0.0000 Z0.0000 F0.0000/rev\n"
            "3 linear X3.0000 Y0.0000 Z0.0000 F0.2000/rev\n");
}

TEST(Modes, AFeedCodeEndsTheSurfaceSpeedWhereTheyAreOfOneGroup) {
  const auto make = [](const ir::Control& control) {
    Builder b;
    // The feed code with G96 belongs to it.
    b.block({{Function::surface_speed_on}, {Function::feed_per_rev}, {Function::spindle_cw}, {Function::linear}},
            {{Address::s, 100.0}, {Address::x, 1.0}, {Address::f, 0.2}});
    b.block({{Function::feed_per_min}}, {{Address::x, 2.0}, {Address::s, 900.0}, {Address::f, 0.2}});
    return trace_of(b, control);
  };
  ir::Control one_group = sinumerik_control();
  one_group.semantics.feed_code_ends_surface_speed = true;
  EXPECT_EQ(make(one_group),
            "1 spindle cw S100.0000/m_min\n1 linear X1.0000 Y0.0000 Z0.0000 F0.2000/rev\n"
            "2 spindle cw S900.0000/rpm\n2 linear X2.0000 Y0.0000 Z0.0000 F0.2000/min\n");
  EXPECT_EQ(make(mill_control()),
            "1 spindle cw S100.0000/m_min\n1 linear X1.0000 Y0.0000 Z0.0000 F0.2000/rev\n"
            "2 spindle cw S900.0000/m_min\n2 linear X2.0000 Y0.0000 Z0.0000 F0.2000/min\n");
}

TEST(Modes, EventsStandInTheirOrderAndOnceAChange) {
  Builder b;
  b.block({{Function::work_offset, 2},
           {Function::spindle_ccw},
           {Function::coolant_flood},
           {Function::comp_left},
           {Function::tool_change},
           {Function::linear}},
          {{Address::x, 1.0}, {Address::f, 50.0}, {Address::s, 500.0}, {Address::t, 6.0}});
  b.block({{Function::work_offset, 2}, {Function::coolant_flood}, {Function::comp_left}});
  b.block({{Function::comp_off}, {Function::coolant_off}, {Function::spindle_stop}, {Function::program_stop}},
          {{Address::x, 2.0}});
  b.block({{Function::coolant_off}, {Function::spindle_stop}, {Function::optional_stop}});
  b.block({{Function::work_offset, 0}, {Function::coolant_mist}});
  EXPECT_EQ(trace_of(b, mill_control()),
            "1 offset 2\n1 tool 6\n1 spindle ccw S500.0000/rpm\n1 coolant flood\n1 comp left\n"
            "1 linear X1.0000 Y0.0000 Z0.0000 F50.0000/min\n"
            "3 comp off\n3 linear X2.0000 Y0.0000 Z0.0000 F50.0000/min\n3 coolant off\n3 spindle off\n"
            "3 stop program\n4 stop optional\n5 offset 0\n5 coolant mist\n");
}

TEST(Modes, ToolWords) {
  Builder lathe;
  lathe.block({}, {{Address::t, 606.0}});
  lathe.block({}, {{Address::t, 606.0}});
  lathe.block({}, {{Address::t, 600.0}});
  lathe.block({}, {{Address::t, 12012.0}});
  EXPECT_EQ(trace_of(lathe, lathe_control()), "1 tool 6\n3 tool 6 offset 0\n4 tool 12\n");

  Builder mill;
  mill.block({}, {{Address::t, 3.0}});
  mill.block({{Function::tool_change}});
  mill.block({}, {{Address::t, mill.text("DRILL 8")}});
  mill.block({{Function::tool_change}}, {{Address::d, 2.0}});
  EXPECT_EQ(trace_of(mill, sinumerik_control()), "2 tool 3\n4 tool \"DRILL 8\" offset 2\n");

  ir::Control sinumerik_lathe = sinumerik_control();
  sinumerik_lathe.kind = ir::MachineKind::lathe;
  Builder turning;
  turning.block({}, {{Address::t, 1.0}, {Address::d, 1.0}});
  EXPECT_EQ(trace_of(turning, sinumerik_lathe), "1 tool 1\n");
}

TEST(Modes, DwellWordsAreNoModalFeedOrSpeed) {
  Builder b;
  b.block({{Function::linear}, {Function::spindle_cw}}, {{Address::x, 1.0}, {Address::f, 100.0}, {Address::s, 600.0}});
  b.block({{Function::dwell}}, {{Address::f, 2.5}});
  b.block({{Function::dwell}}, {{Address::s, 10.0}});
  b.block({}, {{Address::x, 2.0}});
  EXPECT_EQ(trace_of(b, sinumerik_control()),
            "1 spindle cw S600.0000/rpm\n1 linear X1.0000 Y0.0000 Z0.0000 F100.0000/min\n2 dwell P2.5000\n"
            "3 dwell P1.0000\n4 linear X2.0000 Y0.0000 Z0.0000 F100.0000/min\n");
}

TEST(Modes, ReferenceReturnLeavesThePositionUnknown) {
  Builder b;
  b.block({{Function::rapid}}, {{Address::x, 1.0}, {Address::y, 2.0}, {Address::z, 3.0}});
  b.block({{Function::reference_return}, {Function::incremental}}, {{Address::z, 0.0}});  // nothing to go through
  b.block({{Function::absolute}}, {{Address::x, 10.0}});
  b.block({}, {{Address::z, 50.0}});
  b.block({{Function::reference_return}}, {{Address::z, 100.0}});
  b.block({{Function::incremental}}, {{Address::z, -5.0}});
  b.end();
  const Ran ran = run_program(b.build(), mill_control());
  EXPECT_EQ(ran.trace,
            "1 rapid X1.0000 Y2.0000 Z3.0000\n3 rapid X10.0000 Y2.0000 Z3.0000\n4 rapid X10.0000 Y2.0000 Z50.0000\n"
            "5 rapid X10.0000 Y2.0000 Z100.0000\n6 rapid X10.0000 Y2.0000 Z95.0000\n7 end\n");
  constexpr std::uint16_t kZ = 4;
  EXPECT_EQ(ran.motions[0].axes_unknown & 7U, 7U);  // nothing was known at the start
  EXPECT_EQ(ran.motions[1].axes_unknown & 7U, kZ);
  EXPECT_EQ(ran.motions[2].axes_unknown & 7U, kZ);
  EXPECT_EQ(ran.motions[3].axes_unknown & 7U, 0U);
  EXPECT_EQ(ran.motions[4].axes_unknown & 7U, kZ);
  ASSERT_EQ(ran.result.not_interpreted.size(), 2U);
  EXPECT_EQ(ran.result.not_interpreted[0].function, Function::reference_return);
  EXPECT_EQ(ran.result.not_interpreted[0].first_line, 2U);
  EXPECT_EQ(ran.result.not_interpreted[0].count, 2U);
  EXPECT_EQ(ran.result.not_interpreted[1].function, Function::incremental);
}

TEST(Modes, MachineCoordinatesAreForOneBlock) {
  Builder b;
  b.block({{Function::rapid}}, {{Address::x, 1.0}, {Address::y, 2.0}, {Address::z, 3.0}});
  b.block({{Function::machine_coordinates}}, {{Address::z, 0.0}});
  b.block({}, {{Address::z, 10.0}});
  b.end();
  const Ran ran = run_program(b.build(), mill_control());
  EXPECT_EQ(ran.trace,
            "1 rapid X1.0000 Y2.0000 Z3.0000\n2 rapid X1.0000 Y2.0000 Z0.0000 G53\n"
            "3 rapid X1.0000 Y2.0000 Z10.0000\n4 end\n");
  EXPECT_EQ(ran.motions[2].axes_unknown & 7U, 4U);
}

// Fanuc goes to machine positions at rapid and leaves increments out; Mitsubishi goes as programmed (M700V
// programming manual, 14.4).
TEST(Modes, MovesToThePlacesOfTheMachineAreOfTheControl) {
  Builder b;
  b.block({{Function::linear}}, {{Address::x, 1.0}, {Address::z, 3.0}, {Address::f, 100.0}});
  b.block({{Function::machine_coordinates}}, {{Address::z, 0.0}});
  b.block({}, {{Address::z, 4.0}});
  b.block({{Function::incremental}, {Function::machine_coordinates}}, {{Address::x, 5.0}});
  b.end();
  ir::Control control = mill_control();
  const Ran fanuc = run_program(b.build(), control);
  EXPECT_EQ(fanuc.trace,
            "1 linear X1.0000 Y0.0000 Z3.0000 F100.0000/min\n2 rapid X1.0000 Y0.0000 Z0.0000 G53\n"
            "3 linear X1.0000 Y0.0000 Z4.0000 F100.0000/min\n5 end\n");
  EXPECT_EQ(fanuc.motions.back().axes_unknown & 1U, 1U);
  control.semantics.machine_move = ir::MachineMove::programmed;
  EXPECT_EQ(run_program(b.build(), control).trace,
            "1 linear X1.0000 Y0.0000 Z3.0000 F100.0000/min\n2 linear X1.0000 Y0.0000 Z0.0000 G53 F100.0000/min\n"
            "3 linear X1.0000 Y0.0000 Z4.0000 F100.0000/min\n4 linear X6.0000 Y0.0000 Z4.0000 F100.0000/min\n5 end\n");
}

TEST(Modes, MoveWithoutACodeIsTheUsualOneAndReportedOnce) {
  ir::Control control = mill_control();
  control.semantics.power_on_known = false;
  Builder b;
  b.block({}, {{Address::x, 1.0}, {Address::z, 2.0}});
  b.block({}, {{Address::x, 3.0}});
  b.end();
  const Ran ran = run_program(b.build(), control);
  EXPECT_EQ(ran.trace, "1 rapid X1.0000 Y0.0000 Z2.0000\n2 rapid X3.0000 Y0.0000 Z2.0000\n3 end\n");
  ASSERT_EQ(ran.result.diagnostics.size(), 1U);
  EXPECT_EQ(ran.result.diagnostics[0].diagnostic.id, text::DiagnosticId::motion_without_code);
  EXPECT_EQ(ran.result.diagnostics[0].diagnostic.arguments, std::vector<std::string>{"X Z"});
}

TEST(Modes, CutWithoutFeedIsReportedOnce) {
  Builder b;
  b.block({{Function::linear}}, {{Address::x, 1.0}});
  b.block({}, {{Address::x, 2.0}});
  b.end();
  const Ran ran = run_program(b.build(), mill_control());
  ASSERT_EQ(ran.result.diagnostics.size(), 1U);
  EXPECT_EQ(ran.result.diagnostics[0].diagnostic.id, text::DiagnosticId::no_feed);
  EXPECT_EQ(ran.result.ended, interpreter::Ended::end);
}

TEST(Modes, CyclesThatAreNotModelledMoveNothing) {
  Builder b;
  b.block({{Function::rapid}}, {{Address::x, 1.0}, {Address::y, 1.0}, {Address::z, 5.0}});
  b.block({{Function::not_modelled, 0, ModalGroup::cycle, "G81"}},
          {{Address::x, 10.0}, {Address::z, -20.0}, {Address::r, 2.0}});
  b.block({}, {{Address::x, 20.0}});
  b.block({{Function::cycle_off}});
  b.block({}, {{Address::x, 30.0}, {Address::z, 5.0}});
  b.block({{Function::not_modelled, 0, ModalGroup::non_modal, "G10"}}, {{Address::y, 99.0}});
  b.end();
  const Ran ran = run_program(b.build(), mill_control());
  EXPECT_EQ(ran.trace, "1 rapid X1.0000 Y1.0000 Z5.0000\n5 rapid X30.0000 Y1.0000 Z5.0000\n7 end\n");
  ASSERT_EQ(ran.result.not_interpreted.size(), 3U);
  EXPECT_EQ(ran.result.not_interpreted[0].name, "G81");
  EXPECT_EQ(ran.result.not_interpreted[1].count, 2U);
  EXPECT_EQ(ran.result.not_interpreted[2].name, "G10");
  EXPECT_EQ(ran.motions[1].axes_unknown & 7U, 5U);
}

TEST(Modes, WordsThatAreNotInterpretedAreNamed) {
  Builder b;
  Word native(Address::other, 1.0);
  native.name = "FB";
  Word second_spindle(Address::s, 800.0);
  second_spindle.extension = 2;
  b.block({{Function::rapid}},
          {{Address::x, 1.0}, {Address::a, 5.0}, native, {Address::rounding, 2.0}, second_spindle});
  b.native("STOPRE", true);
  b.end();
  const Ran ran = run_program(b.build(), mill_control());
  std::vector<std::string> names;
  for (const auto& item : ran.result.not_interpreted) names.push_back(item.name);
  EXPECT_EQ(names, (std::vector<std::string>{"A", "FB", "S2", "a chamfer or rounding that does not fit its corner",
                                             "STOPRE"}));
  EXPECT_TRUE(ran.result.not_interpreted.back().effects_known);
  EXPECT_FALSE(ran.result.not_interpreted.front().effects_known);
}

TEST(Modes, ThreadHasItsLead) {
  Builder b;
  b.block({{Function::rapid}}, {{Address::x, 20.0}, {Address::z, 5.0}});
  b.block({{Function::thread}}, {{Address::z, -30.0}, {Address::f, 1.5}});
  EXPECT_EQ(trace_of(b, lathe_control()), "1 rapid X20.0000 Z5.0000\n2 thread X20.0000 Z-30.0000 F1.5000/rev\n");
  Builder s;
  s.block({{Function::thread}}, {{Address::z, -30.0}, {Address::k, 2.0}});
  EXPECT_EQ(trace_of(s, sinumerik_control()), "1 thread X0.0000 Y0.0000 Z-30.0000 F2.0000/rev\n");
}

TEST(Modes, ComputedCodesComeFromTheControlsTable) {
  constexpr ir::CodeRow kCodes[] = {{"G00", 0, Function::rapid, 0, ModalGroup::motion, ""},
                                    {"G01", 10, Function::linear, 0, ModalGroup::motion, ""}};
  ir::Control control = mill_control();
  control.g_codes = kCodes;
  Builder b;
  b.assign(Builder::hash(130), b.number(1));
  b.block({{Function::none, 0, ModalGroup::none, {}, b.read(Builder::hash(130))}},
          {{Address::x, 5.0}, {Address::f, 100.0}});
  b.block({{Function::none, 0, ModalGroup::none, {}, b.number(77)}});
  b.end();
  const Ran ran = run_program(b.build(), control);
  EXPECT_EQ(ran.trace, "2 linear X5.0000 Y0.0000 Z0.0000 F100.0000/min\n");
  EXPECT_EQ(ran.result.ended, interpreter::Ended::alarm);
  EXPECT_EQ(ran.last_diagnostic()->diagnostic.id, text::DiagnosticId::unknown_code);
  EXPECT_EQ(ran.last_diagnostic()->diagnostic.arguments, std::vector<std::string>{"G77"});
}

TEST(Modes, ExactStopForOneBlockOrAsAMode) {
  Builder b;
  b.block({{Function::linear}, {Function::exact_stop_once}}, {{Address::x, 1.0}, {Address::f, 100.0}});
  b.block({}, {{Address::x, 2.0}});
  b.block({{Function::exact_stop_mode}}, {{Address::x, 3.0}});
  b.block({{Function::continuous_path}}, {{Address::x, 4.0}});
  b.end();
  const Ran ran = run_program(b.build(), mill_control());
  ASSERT_EQ(ran.motions.size(), 5U);
  EXPECT_TRUE(ran.motions[0].exact_stop);
  EXPECT_FALSE(ran.motions[1].exact_stop);
  EXPECT_TRUE(ran.motions[2].exact_stop);
  EXPECT_FALSE(ran.motions[3].exact_stop);
}

}  // namespace
}  // namespace dripfeed::test
