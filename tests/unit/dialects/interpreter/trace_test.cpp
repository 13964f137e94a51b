// The text of a trace, motion by motion, without a program.
#include "dialects/interpreter/machine/trace.h"

#include <gtest/gtest.h>

namespace dripfeed::interpreter {
namespace {

using ir::Motion;
using ir::MotionKind;

std::string write(const Motion& motion, std::string axes = "XYZ", const RunNames& names = {}) {
  ir::Control control;
  control.axes = std::move(axes);
  TraceWriter writer(control, names);
  writer.consume({&motion, 1});
  return writer.text();
}

Motion make(MotionKind kind) {
  Motion motion;
  motion.kind = kind;
  motion.place.line = 7;
  return motion;
}

TEST(Trace, AxesStandInOneOrderWhateverTheControlSays) {
  Motion motion = make(MotionKind::rapid);
  motion.end = {1, 2, 3, 4, 5, 6, 7, 8, 9};
  EXPECT_EQ(write(motion, "ZCX"), "7 rapid X1.0000 Z3.0000 C6.0000\n");
  EXPECT_EQ(write(motion, "XYZABCUVW"),
            "7 rapid X1.0000 Y2.0000 Z3.0000 A4.0000 B5.0000 C6.0000 U7.0000 V8.0000 W9.0000\n");
}

TEST(Trace, FourDecimalsRoundedAndNeverMinusZero) {
  Motion motion = make(MotionKind::linear);
  motion.end = {-0.00004, -0.0, 1.00005};
  motion.feed = 0.15;
  motion.feed_mode = ir::FeedMode::per_rev;
  EXPECT_EQ(write(motion), "7 linear X0.0000 Y0.0000 Z1.0001 F0.1500/rev\n");
}

TEST(Trace, ArcsNameThePlaneAndTheCentre) {
  Motion motion = make(MotionKind::arc_ccw);
  motion.end = {1, 2, 3};
  motion.center = {0.5, 0, -0.25};
  motion.plane = ir::Plane::zx;
  motion.feed = 900;
  EXPECT_EQ(write(motion), "7 arc-ccw X1.0000 Y2.0000 Z3.0000 G18 I0.5000 J0.0000 K-0.2500 F900.0000/min\n");
  motion.kind = MotionKind::arc_cw;
  motion.plane = ir::Plane::yz;
  motion.feed_mode = ir::FeedMode::inverse_time;
  EXPECT_EQ(write(motion), "7 arc-cw X1.0000 Y2.0000 Z3.0000 G19 I0.5000 J0.0000 K-0.2500 F900.0000/inv\n");
}

TEST(Trace, Events) {
  RunNames names;
  names.strings = {"CUTTER\n12"};
  Motion motion = make(MotionKind::offset);
  EXPECT_EQ(write(motion), "7 offset 0\n");
  motion = make(MotionKind::tool);
  motion.number = 6;
  EXPECT_EQ(write(motion), "7 tool 6\n");
  motion.tool_offset = 16;
  EXPECT_EQ(write(motion), "7 tool 6 offset 16\n");
  motion.text = 0;
  motion.tool_offset = 0;
  EXPECT_EQ(write(motion, "XYZ", names), "7 tool \"CUTTER 12\"\n");
  motion = make(MotionKind::message);
  motion.text = 0;
  EXPECT_EQ(write(motion, "XYZ", names), "7 message \"CUTTER 12\"\n");
  motion = make(MotionKind::spindle);
  EXPECT_EQ(write(motion), "7 spindle off\n");
  motion.spindle = ir::SpindleState::counterclockwise;
  motion.spindle_rpm = 500;
  EXPECT_EQ(write(motion), "7 spindle ccw S500.0000/rpm\n");
  motion.surface_speed_m_min = 200;
  EXPECT_EQ(write(motion), "7 spindle ccw S200.0000/m_min limit 500.0000\n");
  motion = make(MotionKind::coolant);
  EXPECT_EQ(write(motion), "7 coolant off\n");
  motion = make(MotionKind::comp);
  motion.comp = ir::CompSide::right;
  EXPECT_EQ(write(motion), "7 comp right\n");
  motion = make(MotionKind::dwell);
  motion.feed = 1.5;
  EXPECT_EQ(write(motion), "7 dwell P1.5000\n");
  EXPECT_EQ(write(make(MotionKind::end)), "7 end\n");
}

TEST(Trace, CalledProgramsAreDeclaredOnce) {
  RunNames names;
  names.programs = {"MAIN", "O9010", "O9020"};
  ir::Control control;
  TraceWriter writer(control, names);
  for (const std::uint32_t program : {0U, 2U, 0U, 1U, 2U}) {
    Motion motion = make(MotionKind::end);
    motion.place.program = program;
    writer.consume({&motion, 1});
  }
  EXPECT_EQ(writer.text(), "7 end\n@2 O9020\n@2:7 end\n7 end\n@1 O9010\n@1:7 end\n@2:7 end\n");
}

TEST(Trace, AConsumerGetsEachBatch) {
  RunNames names;
  ir::Control control;
  std::vector<std::string> batches;
  TraceWriter writer(control, names, [&](std::string_view text) { batches.emplace_back(text); });
  const Motion motion = make(MotionKind::end);
  writer.consume({&motion, 1});
  writer.consume({&motion, 1});
  EXPECT_EQ(batches, (std::vector<std::string>{"7 end\n", "7 end\n"}));
  EXPECT_TRUE(writer.text().empty());
}

}  // namespace
}  // namespace dripfeed::interpreter
