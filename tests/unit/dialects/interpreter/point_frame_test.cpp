// Mirror, scale and rotation about points of their own (G51.1, G51, G68), polar words (G16) and the returns to and from
// reference points. Expected coordinates are closed forms: cos 30 = 0.8660, sin 30 = 0.5.
#include <algorithm>

#include <gtest/gtest.h>

#include "dialects/ir/cycle.h"
#include "dialects/ir/frame_use.h"
#include "tests/unit/dialects/interpreter/run_trace.h"

namespace dripfeed::test {
namespace {

using ir::Address;
using ir::Function;
using ir::kFrameAboutPoint;
using ir::kFrameEnds;
using ir::ModalGroup;
using ir::WordMode;
using Builder = ProgramBuilder;
using Word = Builder::WordText;

Ran run_blocks(Builder& b, const ir::Control& control = mill_control()) {
  b.end();
  return run_program(b.build(), control);
}

// The trace of the last block before the end.
std::string last_of(Builder& b, const ir::Control& control = mill_control()) {
  const std::string trace = run_blocks(b, control).trace;
  const std::size_t end = trace.rfind('\n', trace.size() - 2);
  const std::size_t begin = trace.rfind('\n', end - 1);
  const std::string line = trace.substr(begin == std::string::npos ? 0 : begin + 1);
  return line.substr(line.find(' ') + 1, line.find('\n') - line.find(' ') - 1);
}

Builder started(double x = 0.0, double y = 0.0, double z = 0.0) {
  Builder b;
  b.block({{Function::rapid}, {Function::absolute}}, {{Address::x, x}, {Address::y, y}, {Address::z, z}});
  return b;
}

bool reports(const Ran& ran, std::string_view name) {
  return std::ranges::any_of(ran.result.not_interpreted, [&](const auto& row) { return row.name.contains(name); });
}

TEST(PointFrame, RotationTurnsAboutItsOwnCenterAndEnds) {
  Builder b = started();
  b.block({{Function::rotate, kFrameAboutPoint}}, {{Address::x, 10.0}, {Address::y, 10.0}, {Address::r, 90.0}});
  b.block({}, {{Address::x, 20.0}, {Address::y, 10.0}});
  Builder ended = b;
  EXPECT_EQ(last_of(b), "rapid X10.0000 Y20.0000 Z0.0000");
  ended.block({{Function::rotate, kFrameEnds}}, {});
  ended.block({}, {{Address::x, 20.0}, {Address::y, 10.0}});
  EXPECT_EQ(last_of(ended), "rapid X20.0000 Y10.0000 Z0.0000");
}

TEST(PointFrame, RotationLeavesTheLocalShiftAlone) {
  Builder b = started();
  b.block({{Function::local_shift}}, {{Address::x, 5.0}});
  b.block({{Function::rotate, kFrameAboutPoint}}, {{Address::x, 0.0}, {Address::y, 0.0}, {Address::r, 90.0}});
  b.block({}, {{Address::x, 10.0}, {Address::y, 0.0}});
  Builder ended = b;
  EXPECT_EQ(last_of(b), "rapid X5.0000 Y10.0000 Z0.0000");
  ended.block({{Function::rotate, kFrameEnds}}, {});
  ended.block({}, {{Address::x, 10.0}, {Address::y, 0.0}});
  EXPECT_EQ(last_of(ended), "rapid X15.0000 Y0.0000 Z0.0000");
}

TEST(PointFrame, ACenterThatIsNotNamedIsWhereTheToolStands) {
  Builder b = started(10.0, 0.0);
  b.block({{Function::rotate, kFrameAboutPoint}}, {{Address::r, 30.0}});
  b.block({{Function::incremental}}, {{Address::x, 10.0}});
  EXPECT_EQ(last_of(b), "rapid X18.6603 Y5.0000 Z0.0000");
}

TEST(PointFrame, RotationIsInThePlaneInEffect) {
  Builder b = started();
  b.block({{Function::plane_zx}, {Function::rotate, kFrameAboutPoint}},
          {{Address::x, 0.0}, {Address::z, 0.0}, {Address::r, 90.0}});
  b.block({}, {{Address::x, 0.0}, {Address::z, 10.0}});
  EXPECT_EQ(last_of(b), "rapid X10.0000 Y0.0000 Z0.0000");
}

TEST(PointFrame, RotationInSpaceTurnsAboutADirection) {
  Builder b = started();
  b.block({{Function::rotate, kFrameAboutPoint}}, {{Address::x, 0.0},
                                                   {Address::y, 0.0},
                                                   {Address::z, 0.0},
                                                   {Address::i, 2.0},
                                                   {Address::j, 0.0},
                                                   {Address::k, 0.0},
                                                   {Address::r, 90.0}});
  b.block({}, {{Address::x, 1.0}, {Address::y, 10.0}, {Address::z, 0.0}});
  EXPECT_EQ(last_of(b), "rapid X1.0000 Y0.0000 Z10.0000");
}

TEST(PointFrame, ScaleTakesArcsWithIt) {
  Builder b = started(10.0, 0.0);
  b.block({{Function::scale, kFrameAboutPoint}},
          {{Address::x, 0.0}, {Address::y, 0.0}, {Address::z, 0.0}, {Address::p, 0.5}});
  b.block({{Function::arc_ccw}},
          {{Address::x, 0.0}, {Address::y, 20.0}, {Address::i, -20.0}, {Address::j, 0.0}, {Address::f, 100.0}});
  EXPECT_EQ(last_of(b), "arc-ccw X0.0000 Y10.0000 Z0.0000 G17 I-10.0000 J0.0000 K0.0000 F100.0000/min");
}

TEST(PointFrame, AFactorWithoutAPointCountsTheControlsUnit) {
  Builder b = started();
  b.block({{Function::scale, kFrameAboutPoint}},
          {{Address::x, 0.0}, {Address::y, 0.0}, {Address::z, 0.0}, {Address::p, b.number(2000, false)}});
  b.block({}, {{Address::x, 10.0}});
  b.end();
  const ir::Program program = b.build();
  const Ran guessed = run_program(program, mill_control());
  EXPECT_NE(guessed.trace.find("3 rapid X20.0000"), std::string::npos) << guessed.trace;
  EXPECT_TRUE(reports(guessed, "scaling factor without a point"));
  ir::Control control = mill_control();
  control.semantics.scale_unit = 1e-5;
  control.semantics.scale_unit_known = true;
  const Ran known = run_program(program, control);
  EXPECT_NE(known.trace.find("3 rapid X0.2000"), std::string::npos) << known.trace;
  EXPECT_FALSE(reports(known, "scaling factor without a point"));
}

TEST(PointFrame, AMirrorTurnsArcsAndSidesRound) {
  Builder b = started(10.0, 0.0);
  b.block({{Function::mirror, kFrameAboutPoint}}, {{Address::x, 0.0}});
  b.block({{Function::comp_left}, {Function::linear}}, {{Address::x, 20.0}, {Address::y, 0.0}, {Address::f, 100.0}});
  b.block({{Function::arc_cw}}, {{Address::x, 30.0}, {Address::y, -10.0}, {Address::r, 10.0}});
  const Ran ran = run_blocks(b);
  EXPECT_NE(ran.trace.find("4 arc-ccw X-30.0000 Y-10.0000 Z0.0000 G17 I0.0000 J-10.0000"), std::string::npos)
      << ran.trace;
  EXPECT_EQ(ran.motions[ran.motions.size() - 2].comp, ir::CompSide::right);
}

TEST(PointFrame, AMirrorEndsAxisByAxis) {
  Builder b = started();
  b.block({{Function::mirror, kFrameAboutPoint}}, {{Address::x, 10.0}, {Address::y, 0.0}});
  b.block({{Function::mirror, kFrameEnds}}, {{Address::y, 0.0}});
  b.block({}, {{Address::x, 2.0}, {Address::y, 3.0}});
  EXPECT_EQ(last_of(b), "rapid X18.0000 Y3.0000 Z0.0000");
}

TEST(PointFrame, TheRotationLiesInsideTheMirror) {
  Builder b = started();
  b.block({{Function::mirror, kFrameAboutPoint}}, {{Address::x, 10.0}});
  b.block({{Function::rotate, kFrameAboutPoint}}, {{Address::x, 0.0}, {Address::y, 0.0}, {Address::r, 30.0}});
  b.block({}, {{Address::x, 10.0}, {Address::y, 0.0}});
  EXPECT_EQ(last_of(b), "rapid X11.3397 Y5.0000 Z0.0000");
}

TEST(PointFrame, HolesLieOnTheTurnedPattern) {
  Builder b = started(0.0, 0.0, 10.0);
  b.block({{Function::rotate, kFrameAboutPoint}}, {{Address::x, 0.0}, {Address::y, 0.0}, {Address::r, 90.0}});
  b.block({{Function::drill, ir::drill_argument(ir::DrillCycle::drill), ModalGroup::cycle}},
          {{Address::x, 5.0}, {Address::y, 0.0}, {Address::z, -3.0}, {Address::r, 2.0}, {Address::f, 60.0}});
  const std::string trace = run_blocks(b).trace;
  EXPECT_NE(trace.find("3 rapid X0.0000 Y5.0000 Z10.0000\n3 rapid X0.0000 Y5.0000 Z2.0000\n"
                       "3 linear X0.0000 Y5.0000 Z-3.0000 F60.0000/min\n3 rapid X0.0000 Y5.0000 Z10.0000\n"),
            std::string::npos)
      << trace;
}

TEST(PointFrame, AHoleThatAFrameTiltsIsReported) {
  Builder b = started(0.0, 0.0, 10.0);
  b.block({{Function::scale, kFrameAboutPoint}},
          {{Address::x, 0.0}, {Address::y, 0.0}, {Address::z, 0.0}, {Address::p, 2.0}});
  b.block({{Function::drill, ir::drill_argument(ir::DrillCycle::drill), ModalGroup::cycle}},
          {{Address::z, -3.0}, {Address::r, 2.0}, {Address::f, 60.0}});
  EXPECT_TRUE(reports(run_blocks(b), "drilling cycle along an axis"));
}

TEST(PolarWords, AreARadiusAndAnAngle) {
  Builder b = started(1.0, 1.0);
  b.block({{Function::polar_words_on}}, {{Address::x, 10.0}, {Address::y, 30.0}});
  Builder more = b;
  Builder relative = b;
  EXPECT_EQ(last_of(b), "rapid X8.6603 Y5.0000 Z0.0000");
  more.block({}, {{Address::y, 60.0}});
  Builder off = more;
  EXPECT_EQ(last_of(more), "rapid X5.0000 Y8.6603 Z0.0000");
  off.block({{Function::polar_words_off}}, {{Address::x, 10.0}, {Address::y, 30.0}});
  EXPECT_EQ(last_of(off), "rapid X10.0000 Y30.0000 Z0.0000");
  // A radius by an increment counts from the tool, an angle from the last one: 60 degrees.
  relative.block({{Function::incremental}}, {{Address::x, 10.0}, {Address::y, 30.0}});
  EXPECT_EQ(last_of(relative), "rapid X13.6603 Y13.6603 Z0.0000");
}

TEST(PolarWords, HolesLieOnACircle) {
  Builder b = started(0.0, 0.0, 10.0);
  b.block({{Function::polar_words_on}, {Function::drill, ir::drill_argument(ir::DrillCycle::drill), ModalGroup::cycle}},
          {{Address::x, 10.0}, {Address::y, 30.0}, {Address::z, -3.0}, {Address::r, 2.0}, {Address::f, 60.0}});
  b.block({}, {{Address::y, 90.0}});
  const std::string trace = run_blocks(b).trace;
  EXPECT_NE(trace.find("2 linear X8.6603 Y5.0000 Z-3.0000"), std::string::npos) << trace;
  EXPECT_NE(trace.find("3 linear X0.0000 Y10.0000 Z-3.0000"), std::string::npos) << trace;
}

TEST(Reference, G29ComesBackThroughTheIntermediatePoint) {
  Builder b = started(1.0, 2.0, 3.0);
  b.block({{Function::reference_return, 1, ModalGroup::non_modal}}, {{Address::x, 10.0}, {Address::y, 20.0}});
  b.block({{Function::leave_reference, 0, ModalGroup::non_modal}}, {{Address::x, 30.0}, {Address::y, 40.0}});
  const std::string trace = run_blocks(b).trace;
  EXPECT_NE(trace.find("2 rapid X10.0000 Y20.0000 Z3.0000\n3 rapid X10.0000 Y20.0000 Z3.0000\n"
                       "3 rapid X30.0000 Y40.0000 Z3.0000\n"),
            std::string::npos)
      << trace;
}

TEST(Reference, LimitsOfG22AreNoMove) {
  Builder b = started(1.0, 2.0, 3.0);
  b.block({{Function::stroke_check}}, {{Address::x, 100.0}, {Address::y, 100.0}});
  EXPECT_EQ(last_of(b), "rapid X1.0000 Y2.0000 Z3.0000");
}

TEST(Reference, ACheckedApproachIsARapidOfItsBlock) {
  Builder b = started();
  b.block({{Function::linear}}, {{Address::x, 1.0}, {Address::f, 100.0}});
  b.block({{Function::approach, 0, ModalGroup::non_modal, "G60"}}, {{Address::x, 5.0}});
  b.block({}, {{Address::x, 6.0}});
  const Ran ran = run_blocks(b);
  EXPECT_NE(ran.trace.find("3 rapid X5.0000 Y0.0000 Z0.0000\n4 linear X6.0000"), std::string::npos) << ran.trace;
  EXPECT_TRUE(reports(ran, "G60"));
}

TEST(Arc, WithoutACenterGoesStraightWhereTheControlDoes) {
  Builder b = started();
  b.block({{Function::arc_cw}}, {{Address::x, 5.0}, {Address::y, 1.0}, {Address::f, 100.0}});
  b.end();
  const ir::Program program = b.build();
  ir::Control control = mill_control();
  const Ran alarm = run_program(program, control);
  ASSERT_NE(alarm.last_diagnostic(), nullptr);
  EXPECT_EQ(alarm.last_diagnostic()->diagnostic.id, text::DiagnosticId::arc_without_center);
  control.semantics.arc_without_center_is_line = true;
  const Ran straight = run_program(program, control);
  EXPECT_NE(straight.trace.find("2 linear X5.0000 Y1.0000"), std::string::npos) << straight.trace;
  EXPECT_TRUE(reports(straight, "arcs without centre"));
}

TEST(Coordinates, G92AndG52AreTakenBackByG92Point1) {
  Builder b = started(10.0, 10.0);
  b.block({{Function::local_shift}}, {{Address::x, 2.0}, {Address::y, 2.0}});
  b.block({{Function::set_coordinates}}, {{Address::x, 0.0}, {Address::y, 0.0}});
  b.block({{Function::set_coordinates, 1}}, {{Address::x, 0.0}});
  b.block({}, {{Address::x, 1.0}, {Address::y, 1.0}});
  EXPECT_EQ(last_of(b), "rapid X1.0000 Y11.0000 Z0.0000");
}

}  // namespace
}  // namespace dripfeed::test
