// Boring cycles that stop the spindle at the bottom, from one control to the other. Oracle: the moves that each
// control's interpreter makes of its own cycle.
#include <string>

#include <gtest/gtest.h>

#include "tests/unit/dialects/compile/harness.h"

namespace dripfeed::compile::test {
namespace {

ir::Control mill(const std::string& dialect) { return control(dialect, ir::MachineKind::mill); }

void expect_same_path(const std::vector<ir::Motion>& a, const std::vector<ir::Motion>& b, const std::string& what) {
  ASSERT_EQ(a.size(), b.size()) << what;
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].kind, b[i].kind) << what << ", move " << i;
    for (std::size_t axis = 0; axis < 3; ++axis) EXPECT_NEAR(a[i].end[axis], b[i].end[axis], 1e-9) << what << ", " << i;
    EXPECT_NEAR(a[i].feed, b[i].feed, 1e-9) << what << ", move " << i;
    // On the move down, that is; between holes one control has it turning already and the other not yet.
    if (a[i].kind == ir::MotionKind::linear) {
      EXPECT_EQ(a[i].spindle, b[i].spindle) << what << ", move " << i;
    }
  }
}

TEST(Boring, ModalCyclesOfHashControlsAsCalls) {
  const std::string text =
      "%\nO1\nG21 G17 G90 G94 G40 G54\nG00 X0. Y0. Z10.\nS500 M03\nG98 G86 X1. Z-20. R2. F200.\nX5.\n"
      "G99 G88 X10. Z-15. R2. P300\nY4.\nG80\nG01 X0. F300.\nM30\n%\n";
  const auto original = real_moves(run_text(text, mill("fanuc")).motions);
  const ConvertResult made = translated(text, "fanuc", "sinumerik-840d");
  ASSERT_FALSE(text::has_error(made.diagnostics)) << messages_of(made.diagnostics, text::Source("program", text));
  EXPECT_NE(made.text.find("CYCLE86"), std::string::npos) << made.text;
  EXPECT_NE(made.text.find("CYCLE88"), std::string::npos) << made.text;
  const auto moves = real_moves(run_text(made.text, mill("sinumerik-840d")).motions);
  expect_same_path(original, moves, made.text);
  EXPECT_EQ(moves.back().spindle, ir::SpindleState::clockwise);
}

TEST(Boring, CalledCyclesAsBlocks) {
  const std::string text =
      "G17 G71 G90 G94 G40 G54\nG0 X0 Y0 Z10\nS500 M3\nF200\nCYCLE86(10,0,2,-20,,0.3,3)\nX4\nCYCLE87(10,0,2,-20,,4)\n"
      "X8\nMCALL CYCLE88(10,0,2,-20,,0.3,3)\nX12\nX16\nMCALL\nM30\n";
  const auto original = silent(run_text(text, mill("sinumerik-840d")).motions);
  for (const std::string to : {"fanuc", "mazak", "mitsubishi-m80"}) {
    const ConvertResult made = translated(text, "sinumerik-840d", to);
    ASSERT_FALSE(text::has_error(made.diagnostics)) << messages_of(made.diagnostics, text::Source("program", text));
    const auto moves = silent(run_text(made.text, mill(to)).motions);
    expect_same_path(real_moves(original), real_moves(moves), made.text);
  }
}

TEST(Boring, AShiftAtTheBottom) {
  const std::string text =
      "G17 G71 G90 G94 G40 G54\nG0 X0 Y0 Z10\nS500 M3\nF200\nCYCLE86(10,0,2,-20,,0.3,3,1,-0.5,0.2)\nX8\n"
      "MCALL CYCLE86(10,0,2,-15,,,4,,0.6)\nX12\nX16\nMCALL\nM30\n";
  const auto original = real_moves(run_text(text, mill("sinumerik-840d")).motions);
  for (const std::string to : {"fanuc", "mazak", "mitsubishi-m80"}) {
    const ConvertResult made = translated(text, "sinumerik-840d", to);
    ASSERT_FALSE(text::has_error(made.diagnostics)) << messages_of(made.diagnostics, text::Source("program", text));
    expect_same_path(original, real_moves(run_text(made.text, mill(to)).motions), made.text);
  }
  // At an angle of the spindle: no code of these controls says it.
  EXPECT_TRUE(text::has_error(translated("G17 G71 G90 G94\nG0 Z10\nS500 M3\nF200\nCYCLE86(10,0,2,-20,,0,3,1,0,0,90)\n"
                                         "M30\n",
                                         "sinumerik-840d", "fanuc")
                                  .diagnostics));
}

TEST(Boring, FineAndBackBoringOfHashControls) {
  const std::string text =
      "%\nO1\nG21 G17 G90 G94 G40 G54\nG00 X0. Y0. Z10.\nS500 M03\nG98 G76 X1. Z-20. R2. I1. J-0.5 P300 F200.\nX5.\n"
      "G99 G76 X7. Z-15. R2. I0.5\nG80\nG00 Z10.\nG98 G87 X20. Y5. Z-10. R-30. I2. F100.\nY9.\n"
      "G81 X30. Z-5. R2.\nG80\nG01 X0. F300.\nM30\n%\n";
  const auto original = real_moves(run_text(text, mill("fanuc")).motions);
  const ConvertResult made = translated(text, "fanuc", "sinumerik-840d");
  ASSERT_FALSE(text::has_error(made.diagnostics)) << messages_of(made.diagnostics, text::Source("program", text));
  EXPECT_NE(made.text.find("CYCLE86"), std::string::npos) << made.text;
  EXPECT_NE(made.text.find("X=IC(-2"), std::string::npos) << made.text;
  expect_same_path(original, real_moves(run_text(made.text, mill("sinumerik-840d")).motions), made.text);
  // In which direction Q shifts, a parameter of the machine says.
  const std::string by_q =
      "%\nO1\nG21 G17 G90 G94\nG00 X0. Y0. Z10.\nS500 M03\nG98 G76 X1. Z-20. R2. Q1. F200.\nG80\nM30\n%\n";
  const ConvertResult guessed = translated(by_q, "fanuc", "sinumerik-840d");
  EXPECT_FALSE(text::has_error(guessed.diagnostics));
  EXPECT_NE(messages_of(guessed.diagnostics, text::Source("program", by_q)).find("taken as X+"), std::string::npos);
  // The level to come back to is anywhere.
  EXPECT_TRUE(
      text::has_error(translated("%\nO1\nG21 G17 G90 G94\nS500 M03\nG98 G87 X1. Z-10. R-30. I1. F200.\nG80\nM30\n%\n",
                                 "fanuc", "sinumerik-840d")
                          .diagnostics));
}

// A tap in a compensating chuck: by its lead or at the feed in effect.
TEST(Boring, FloatingTaps) {
  const std::string text =
      "G17 G71 G90 G94 G40 G54\nG0 X0 Y0 Z10\nS500 M3\nF250\nCYCLE840(10,0,2,-20,,,0,3,0,,1.25)\nX4\n"
      "CYCLE840(10,0,2,-15,,0.3,4,3,1)\nG1 X8\nM30\n";
  const auto original = real_moves(run_text(text, mill("sinumerik-840d")).motions);
  for (const std::string to : {"fanuc", "mazak", "mitsubishi-m80"}) {
    const ConvertResult made = translated(text, "sinumerik-840d", to);
    ASSERT_FALSE(text::has_error(made.diagnostics)) << messages_of(made.diagnostics, text::Source("program", text));
    EXPECT_EQ(made.text.find("M29"), std::string::npos) << made.text;
    const auto moves = real_moves(run_text(made.text, mill(to)).motions);
    ASSERT_EQ(original.size(), moves.size()) << made.text;
    for (std::size_t i = 0; i < moves.size(); ++i) {
      for (std::size_t axis = 0; axis < 3; ++axis) EXPECT_NEAR(original[i].end[axis], moves[i].end[axis], 1e-9) << i;
      // 1.25 mm a turn at 500 turns a minute.
      const bool by_lead = original[i].kind == ir::MotionKind::thread;
      EXPECT_NEAR(by_lead ? original[i].feed * 500.0 : original[i].feed, moves[i].feed, 1e-9) << i << made.text;
    }
    EXPECT_EQ(moves.back().spindle, ir::SpindleState::clockwise);
  }
  // The direction in which it turns is not known.
  EXPECT_TRUE(text::has_error(
      translated("G17 G71 G90 G94\nG0 Z10\nF250\nCYCLE840(10,0,2,-20,,,0,3,1)\nM30\n", "sinumerik-840d", "fanuc")
          .diagnostics));
}

}  // namespace
}  // namespace dripfeed::compile::test
