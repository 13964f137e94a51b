// Drilling cycles as motions. What is expected follows from the levels: initial, R and depth, by hand.
#include <gtest/gtest.h>

#include "dialects/ir/cycle.h"
#include "tests/unit/dialects/interpreter/run_trace.h"

namespace dripfeed::test {
namespace {

using ir::Address;
using ir::drill_argument;
using ir::DrillCycle;
using ir::Function;
using Builder = ProgramBuilder;

Ran drilled(Builder& b, const ir::Control& control) {
  b.end();
  return run_program(b.build(), control);
}
// The trace without its first `skip` lines and the end.
std::string trace_of(const Ran& ran, int skip) {
  std::size_t begin = 0;
  for (int i = 0; i < skip; ++i) begin = ran.trace.find('\n', begin) + 1;
  const std::size_t end = ran.trace.rfind('\n', ran.trace.size() - 2) + 1;
  return end > begin ? ran.trace.substr(begin, end - begin) : std::string();
}
void start_at(Builder& b, double level) {
  b.block({{Function::rapid}, {Function::absolute}}, {{Address::x, 0.0}, {Address::y, 0.0}, {Address::z, level}});
}
Builder::CodeText code(DrillCycle cycle, std::int16_t along = 0) {
  return {Function::drill, drill_argument(cycle, along)};
}

TEST(Drilling, EachPositionIsAHoleUntilTheCycleEnds) {
  Builder b;
  start_at(b, 50.0);
  b.block({code(DrillCycle::drill), {Function::return_to_r}},
          {{Address::x, 10.0}, {Address::z, -5.0}, {Address::r, 2.0}, {Address::f, 100.0}});
  b.block({}, {{Address::y, 20.0}});
  b.block({}, {{Address::f, 200.0}});  // no position: no hole
  b.block({{Function::return_to_initial}}, {{Address::x, 30.0}, {Address::z, -7.0}});
  b.block({{Function::cycle_off}});
  b.block({}, {{Address::x, 0.0}});
  EXPECT_EQ(trace_of(drilled(b, mill_control()), 1),
            "2 rapid X10.0000 Y0.0000 Z50.0000\n2 rapid X10.0000 Y0.0000 Z2.0000\n"
            "2 linear X10.0000 Y0.0000 Z-5.0000 F100.0000/min\n2 rapid X10.0000 Y0.0000 Z2.0000\n"
            "3 rapid X10.0000 Y20.0000 Z2.0000\n3 linear X10.0000 Y20.0000 Z-5.0000 F100.0000/min\n"
            "3 rapid X10.0000 Y20.0000 Z2.0000\n"
            "5 rapid X30.0000 Y20.0000 Z2.0000\n5 linear X30.0000 Y20.0000 Z-7.0000 F200.0000/min\n"
            "5 rapid X30.0000 Y20.0000 Z50.0000\n"
            "7 rapid X0.0000 Y20.0000 Z50.0000\n");
}

TEST(Drilling, AMotionCodeEndsTheCycleAndForgetsItsWords) {
  Builder b;
  start_at(b, 10.0);
  b.block({code(DrillCycle::drill)}, {{Address::z, -5.0}, {Address::r, 2.0}, {Address::f, 100.0}});
  b.block({{Function::linear}}, {{Address::x, 5.0}});
  b.block({code(DrillCycle::drill)}, {{Address::x, 6.0}});  // no depth any more
  const Ran ran = drilled(b, mill_control());
  EXPECT_EQ(trace_of(ran, 4), "3 linear X5.0000 Y0.0000 Z10.0000 F100.0000/min\n4 rapid X6.0000 Y0.0000 Z10.0000\n");
  ASSERT_EQ(ran.result.not_interpreted.size(), 1U);
  EXPECT_EQ(ran.result.not_interpreted[0].name, "a drilling cycle without a depth");
}

TEST(Drilling, IncrementsCountFromTheInitialAndTheRLevel) {
  Builder b;
  start_at(b, 20.0);
  b.block({{Function::incremental}, {Function::return_to_r}, code(DrillCycle::drill)},
          {{Address::x, 4.0}, {Address::z, -6.0}, {Address::r, -17.0}, {Address::f, 50.0}, {Address::k, 3.0}});
  // R = 20 - 17, depth = 3 - 6; holes at 4, 8, 12
  std::string expected = "2 rapid X4.0000 Y0.0000 Z20.0000\n2 rapid X4.0000 Y0.0000 Z3.0000\n";
  for (const char* x : {"4.0000", "8.0000", "12.0000"}) {
    const std::string at = std::string(" X") + x + " Y0.0000 Z";
    if (x[0] != '4') expected += "2 rapid" + at + "3.0000\n";
    expected += "2 linear" + at + "-3.0000 F50.0000/min\n2 rapid" + at + "3.0000\n";
  }
  EXPECT_EQ(trace_of(drilled(b, mill_control()), 1), expected);
}

TEST(Drilling, NoRepeatsStoresTheWordsOnly) {
  Builder b;
  start_at(b, 10.0);
  b.block({code(DrillCycle::drill)},
          {{Address::x, 1.0}, {Address::z, -1.0}, {Address::r, 1.0}, {Address::f, 50.0}, {Address::k, 0.0}});
  b.block({}, {{Address::x, 2.0}});
  EXPECT_EQ(trace_of(drilled(b, mill_control()), 1),
            "3 rapid X2.0000 Y0.0000 Z10.0000\n3 rapid X2.0000 Y0.0000 Z1.0000\n"
            "3 linear X2.0000 Y0.0000 Z-1.0000 F50.0000/min\n3 rapid X2.0000 Y0.0000 Z10.0000\n");
}

std::string deep(DrillCycle cycle) {
  ir::Control control = mill_control();
  control.semantics.chip_break_retract_mm = 0.5;
  control.semantics.peck_clearance_mm = 0.25;
  Builder b;
  start_at(b, 2.0);
  b.block({code(cycle)}, {{Address::z, -10.0}, {Address::r, 2.0}, {Address::q, 5.0}, {Address::f, 80.0}});
  std::string levels;
  for (const ir::Motion& m : drilled(b, control).motions) {
    if (m.place.line != 2) continue;
    levels += (m.kind == ir::MotionKind::rapid ? "r" : "f") + std::to_string(m.end[2]).substr(0, 6) + " ";
  }
  return levels;
}

TEST(Drilling, PecksGoOutToRAndBackToJustAboveTheLastDepth) {
  EXPECT_EQ(deep(DrillCycle::deep_hole), "f-3.000 r2.0000 r-2.750 f-8.000 r2.0000 r-7.750 f-10.00 r2.0000 ");
}

TEST(Drilling, ChipBreakingGoesBackByALittle) {
  EXPECT_EQ(deep(DrillCycle::chip_break), "f-3.000 r-2.500 f-8.000 r-7.500 f-10.00 r2.0000 ");
}

TEST(Drilling, PecksWithoutADepthAreAnAlarmWhereTheControlSaysSo) {
  for (const bool needed : {false, true}) {
    ir::Control control = mill_control();
    control.semantics.pecks_need_depth = needed;
    Builder b;
    start_at(b, 2.0);
    b.block({code(DrillCycle::deep_hole)}, {{Address::z, -10.0}, {Address::r, 2.0}, {Address::f, 80.0}});
    const Ran ran = drilled(b, control);
    EXPECT_EQ(ran.result.ended, needed ? interpreter::Ended::alarm : interpreter::Ended::end);
    EXPECT_EQ(ran.motions.size(), needed ? 1U : 4U);  // start; cut, out; end
    if (needed) {
      EXPECT_EQ(ran.last_diagnostic()->diagnostic.id, text::DiagnosticId::peck_without_depth);
    }
  }
}

TEST(Drilling, EndlessPecksAreALimit) {
  Builder b;
  start_at(b, 2.0);
  b.block({code(DrillCycle::deep_hole)},
          {{Address::z, -1000.0}, {Address::r, 2.0}, {Address::q, 1e-6}, {Address::f, 80.0}});
  EXPECT_EQ(drilled(b, mill_control()).result.ended, interpreter::Ended::limit);
}

TEST(Drilling, TapsReverseAtTheBottomAndGoOutByFeed) {
  Builder b;
  start_at(b, 10.0);
  b.block({{Function::spindle_cw}}, {{Address::s, 300.0}});
  b.block({code(DrillCycle::tap_right)},
          {{Address::z, -8.0}, {Address::r, 3.0}, {Address::p, 200.0}, {Address::f, 300.0}});
  EXPECT_EQ(trace_of(drilled(b, mill_control()), 2),
            "3 rapid X0.0000 Y0.0000 Z3.0000\n3 linear X0.0000 Y0.0000 Z-8.0000 F300.0000/min\n"
            "3 dwell P0.2000\n3 spindle ccw S300.0000/rpm\n3 linear X0.0000 Y0.0000 Z3.0000 F300.0000/min\n"
            "3 rapid X0.0000 Y0.0000 Z10.0000\n3 spindle cw S300.0000/rpm\n");
}

TEST(Drilling, BoringStopsShiftsAndComesBack) {
  Builder b;
  start_at(b, 10.0);
  b.block({{Function::spindle_cw}}, {{Address::s, 300.0}});
  b.block({code(DrillCycle::fine_bore)},
          {{Address::z, -8.0}, {Address::r, 3.0}, {Address::q, 0.5}, {Address::f, 60.0}});
  EXPECT_EQ(trace_of(drilled(b, mill_control()), 2),
            "3 rapid X0.0000 Y0.0000 Z3.0000\n3 linear X0.0000 Y0.0000 Z-8.0000 F60.0000/min\n3 spindle off\n"
            "3 rapid X0.5000 Y0.0000 Z-8.0000\n3 rapid X0.5000 Y0.0000 Z10.0000\n3 rapid X0.0000 Y0.0000 Z10.0000\n"
            "3 spindle cw S300.0000/rpm\n");
}

TEST(Drilling, BackBoringCutsUpward) {
  Builder b;
  start_at(b, 10.0);
  b.block({{Function::spindle_cw}}, {{Address::s, 300.0}});
  b.block({code(DrillCycle::back_bore)},
          {{Address::z, -20.0}, {Address::r, -30.0}, {Address::q, 2.0}, {Address::f, 60.0}});
  EXPECT_EQ(trace_of(drilled(b, mill_control()), 2),
            "3 spindle off\n3 rapid X2.0000 Y0.0000 Z10.0000\n3 rapid X2.0000 Y0.0000 Z-30.0000\n"
            "3 rapid X0.0000 Y0.0000 Z-30.0000\n3 spindle cw S300.0000/rpm\n"
            "3 linear X0.0000 Y0.0000 Z-20.0000 F60.0000/min\n3 spindle off\n3 rapid X2.0000 Y0.0000 Z-20.0000\n"
            "3 rapid X2.0000 Y0.0000 Z10.0000\n3 rapid X0.0000 Y0.0000 Z10.0000\n3 spindle cw S300.0000/rpm\n");
}

TEST(Drilling, TheAxisIsThePlanesNormal) {
  Builder b;
  start_at(b, 10.0);
  b.block({{Function::plane_zx}, code(DrillCycle::drill_dwell)},
          {{Address::z, 4.0}, {Address::y, -9.0}, {Address::r, -1.0}, {Address::p, 500.0}, {Address::f, 60.0}});
  EXPECT_EQ(trace_of(drilled(b, mill_control()), 1),
            "2 rapid X0.0000 Y0.0000 Z4.0000\n2 rapid X0.0000 Y-1.0000 Z4.0000\n"
            "2 linear X0.0000 Y-9.0000 Z4.0000 F60.0000/min\n2 dwell P0.5000\n2 rapid X0.0000 Y0.0000 Z4.0000\n");
}

TEST(Drilling, ALatheDrillsAlongZWithRFromTheInitialLevel) {
  ir::Control control = lathe_control();
  control.semantics.drill_r_from_initial = true;
  Builder b;
  b.block({{Function::rapid}}, {{Address::x, 0.0}, {Address::z, 30.0}});
  b.block({code(DrillCycle::deep_hole, ir::kDrillAlongZ)},
          {{Address::z, -10.0}, {Address::r, -28.0}, {Address::f, 60.0}});
  b.block({code(DrillCycle::feed_out_dwell, ir::kDrillAlongX)}, {{Address::w, -5.0}, {Address::x, 8.0}});
  const Ran ran = drilled(b, control);
  EXPECT_EQ(
      trace_of(ran, 1),
      "2 rapid X0.0000 Z2.0000\n2 linear X0.0000 Z-10.0000 F60.0000/min\n2 rapid X0.0000 Z30.0000\n"
      "3 rapid X0.0000 Z25.0000\n3 linear X8.0000 Z25.0000 F60.0000/min\n3 linear X0.0000 Z25.0000 F60.0000/min\n");
}

TEST(Drilling, AnInitialLevelThatIsNotKnownStaysSo) {
  Builder b;
  b.block({{Function::rapid}, {Function::absolute}}, {{Address::x, 0.0}, {Address::y, 0.0}});
  b.block({code(DrillCycle::drill)}, {{Address::z, -5.0}, {Address::r, 2.0}, {Address::f, 100.0}});
  b.block({}, {{Address::x, 1.0}});
  const Ran ran = drilled(b, mill_control());
  ASSERT_EQ(ran.motions.size(), 7U);  // X Y; R, cut; X, R, cut; end
  EXPECT_EQ(ran.motions[3].axes_unknown, 4U | 0x1F8U);
  ASSERT_EQ(ran.result.not_interpreted.size(), 1U);
  EXPECT_EQ(ran.result.not_interpreted[0].name, "the retract to an initial level that is not known");
}

// M functions in the block of a hole act when its first positioning begins (Fanuc, "Canned cycle for drilling").
TEST(Drilling, MFunctionsActBeforeTheHole) {
  Builder b;
  b.block({{Function::coolant_flood}}, {});
  start_at(b, 50.0);
  b.block({code(DrillCycle::drill), {Function::return_to_r}, {Function::coolant_off}},
          {{Address::x, 10.0}, {Address::z, -5.0}, {Address::r, 2.0}, {Address::f, 100.0}});
  const std::string trace = drilled(b, mill_control()).trace;
  EXPECT_LT(trace.find("coolant off"), trace.find("rapid X10.0000")) << trace;
}

}  // namespace
}  // namespace dripfeed::test
