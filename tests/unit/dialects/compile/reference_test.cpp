// The approach of the reference point: G28, and G75 of the fixed point that the profile says lies there. Where the
// point is only the machine knows, so nothing is claimed of the axes afterwards. Oracle: the programming manual's
// section on the approach to fixed points, and that both controls name the same axes.
#include <gtest/gtest.h>

#include "tests/unit/dialects/compile/sinumerik_run.h"

namespace dripfeed::compile::test {
namespace {

constexpr std::string_view kFromUnknown = "increments from a position that is not known";
const std::string kStart = "G17 G710 G90 G94 G40\nG0 X10 Y0 Z0\n";

ir::Control siemens(int fixed_point, ir::MachineKind kind = ir::MachineKind::mill) {
  ir::Control made = control("sinumerik-840d", kind);
  made.semantics.reference_fixed_point = fixed_point;
  return made;
}

bool names(const interpreter::RunResult& result, std::string_view what) {
  return std::ranges::any_of(result.not_interpreted,
                             [&](const interpreter::NotInterpreted& one) { return one.name == what; });
}

ConvertResult converted(const std::string& text, const ir::Control& from, const ir::Control& to) {
  const text::Source source("p", text);
  ConvertRequest request;
  request.source = source;
  request.from = from;
  request.to = to;
  return convert(request);
}

TEST(PlacesOnlyTheMachineKnows, AreNotKnownAfterwards) {
  for (const std::string code : {"G75 FP=1 Z1=0", "G75 Z0", "G74 Z1=0", "REPOSL", "G0 Z1=5"})
    EXPECT_TRUE(run(kStart + code + "\nG0 Z=IC(5)\nM30\n").names(kFromUnknown)) << code;
  for (const std::string code : {"G25 Z0", "G4 F1", "G0 Z5"})
    EXPECT_FALSE(run(kStart + code + "\nG0 Z=IC(5)\nM30\n").names(kFromUnknown)) << code;
}

// Only the axes that the block names.
TEST(FixedPoints, AtTheReferencePointTakeTheirAxesThere) {
  const std::string text = kStart + "G75 FP=2 Z1=0\nG0 X=IC(1)\n";
  const Played played = run_text(text + "M30\n", siemens(2));
  EXPECT_FALSE(names(played.result, kFromUnknown));
  EXPECT_TRUE(names(played.result, "the move to the reference point"));
  EXPECT_TRUE(names(run_text(text + "G0 Z=IC(1)\nM30\n", siemens(2)).result, kFromUnknown));
  EXPECT_TRUE(names(run_text(text + "M30\n", siemens(1)).result, "G75")) << "another fixed point";
}

TEST(ReferencePoint, IsAFixedPointOfTheOtherControl) {
  const std::string text =
      "O1\nG17 G21 G90 G94 G40 G80\nG0 X0. Y0. Z0.\nG91 G28 Z0. M9\nG28 X0. Y0.\nG90 G0 X5.\nM30\n";
  const ConvertResult made = converted(text, control("fanuc", ir::MachineKind::mill), siemens(3));
  EXPECT_TRUE(made.text.contains("G91\nG75 Z1=0 FP=3\nM9\nG75 X1=0 Y1=0 FP=3\nG90 G0 X5.\n")) << made.text;
  expect_same(run_text(text, control("fanuc", ir::MachineKind::mill)).motions, run_text(made.text, siemens(3)).motions,
              1e-9, made.text);
}

TEST(ReferencePoint, OverAnotherPoint) {
  const std::string text = "O1\nG17 G21 G90 G94 G40 G80\nG0 X0. Y0. Z0.\nG28 X5. Z7.\nX1. Z1.\nM30\n";
  const ConvertResult made = converted(text, control("fanuc", ir::MachineKind::mill), siemens(1));
  EXPECT_TRUE(made.text.contains("X5. Z7.\nG75 X1=0 Z1=0 FP=1\nX1. Z1.\n")) << made.text;
  expect_same(run_text(text, control("fanuc", ir::MachineKind::mill)).motions, run_text(made.text, siemens(1)).motions,
              1e-9, made.text);
}

// The approach is rapid, and the motion code of before goes on.
TEST(ReferencePoint, FromAStraightCut) {
  const std::string text =
      "O1\nG17 G21 G90 G94 G40 G80\nG0 X0. Y0. Z0.\nN1 G1 X2. F100.\nN2 G28 Z7. M9\nX1. Z1.\nM30\n";
  const ConvertResult made = converted(text, control("fanuc", ir::MachineKind::mill), siemens(1));
  EXPECT_TRUE(made.text.contains("G0 Z7.\nG75 Z1=0 FP=1\nG1 M9\nX1. Z1.\n")) << made.text;
  expect_same(run_text(text, control("fanuc", ir::MachineKind::mill)).motions, run_text(made.text, siemens(1)).motions,
              1e-9, made.text);
}

TEST(ReferencePoint, OfALathe) {
  const std::string text = "O1\nG18 G21 G99 G40 G97\nG28 U0. W0.\nT0101\nG0 X50. Z2.\nG28 U5. W0.\nX10.\nM30\n";
  const ir::Control from = control("fanuc", ir::MachineKind::lathe);
  const ConvertResult made = converted(text, from, siemens(1, ir::MachineKind::lathe));
  EXPECT_TRUE(made.text.contains("X=IC(5.) Z=IC(0.)\nG75 X1=0 Z1=0 FP=1\n")) << made.text;
}

TEST(ReferencePoint, ComesBack) {
  const std::string text = kStart + "G75 FP=1 Z1=0\nG75 X1=0 Y1=0\nG0 X5\nM30\n";
  for (const std::string to : {"fanuc", "mazak", "mitsubishi-m80"}) {
    const ConvertResult made = converted(text, siemens(1), control(to, ir::MachineKind::mill));
    EXPECT_TRUE(made.text.contains("G91\nG28 Z0.\nG90\n")) << to << "\n" << made.text;
    EXPECT_TRUE(made.text.contains("G91\nG28 X0. Y0.\nG90\n")) << to << "\n" << made.text;
  }
}

// Each would be a guess.
TEST(ReferencePoint, IsRefusedWithItsReason) {
  struct Row {
    std::string block;
    int fixed_point;
    std::string_view says;
  };
  const std::vector<Row> rows = {
      {"G91 G28 Z0.", 0, "while control.reference_fixed_point of the machine is not stated"},
      {"G91 G30 Z0.", 1, "G30"},
      {"G91 G28 Z0. M6", 1, "in the same block as a tool or an M function of the machine"},
      {"G91 G28 Z0. M88", 1, "in the same block as a tool or an M function of the machine"},
      {"G28", 1, "G28 without axes"},
      {"G2 X1. R1. F100.\nG28 Z5.", 1, "the intermediate point of G28 where neither G0 nor G1 is known"},
      {"N5 G28 Z5.\nG1 X1. F100.\nIF[#100EQ1]GOTO5", 1,
       "the intermediate point of G28 where neither G0 nor G1 is known"},
  };
  for (const Row& row : rows) {
    const std::string text = "O1\nG17 G21 G90 G94 G40 G80\nG0 X0. Y0. Z0.\n" + row.block + "\nM30\n";
    const ConvertResult made = converted(text, control("fanuc", ir::MachineKind::mill), siemens(row.fixed_point));
    EXPECT_TRUE(text::has_error(made.diagnostics)) << row.block;
    EXPECT_TRUE(messages_of(made.diagnostics, text::Source("p", text)).contains(row.says))
        << row.block << "\n"
        << messages_of(made.diagnostics, text::Source("p", text)) << made.text;
  }
}

}  // namespace
}  // namespace dripfeed::compile::test
