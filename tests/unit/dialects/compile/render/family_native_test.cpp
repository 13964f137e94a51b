// Planes, steps from where an axis is, and blocks of a control's own language in families: alike in all dialects and
// both forms, and word for word in the text.
#include <cmath>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include "tests/unit/dialects/compile/render/family_run.h"

namespace dripfeed::compile::test {
namespace {

constexpr std::string_view kAll =
    "native fanuc \"M68\" haas \"M68\" mazak \"M68\" mitsubishi-m80 \"M68\" sinumerik-840d \"M68\" changes ";

std::string refused_for(const text::Source& family, const std::string& dialect = "fanuc") {
  const RenderResult result = rendered(family, dialect, RenderMode::macro, {});
  EXPECT_TRUE(result.text.empty());
  return result.diagnostics.empty() ? "" : messages_of({result.diagnostics.front()}, family);
}

TEST(FamilyPlanes, ArcsLieInTheirPlane) {
  const auto moves = one_trace(with(
      "",
      "  rapid x 0 mm y 0 mm z 0 mm\n  plane zx\n  arc cw x 20 mm z 0 mm center i 10 mm k 0 mm\n  plane yz\n"
      "  arc ccw y 20 mm z 0 mm center j 10 mm k 0 mm\n  plane xy\n  arc ccw x 0 mm y 20 mm center i -10 mm j 0 mm\n"));
  ASSERT_EQ(moves.size(), 4U);
  EXPECT_EQ(moves[1].plane, ir::Plane::zx);
  EXPECT_EQ(moves[1].kind, ir::MotionKind::arc_cw);
  EXPECT_EQ(moves[2].plane, ir::Plane::yz);
  EXPECT_EQ(moves[3].plane, ir::Plane::xy);
  EXPECT_NEAR(moves[3].end[0], 0.0, 1e-6);
}

TEST(FamilyPlanes, AHelixClimbsWithTheThirdAxis) {
  const auto moves =
      one_trace(with("", "  rapid x 10 mm y 0 mm z 0 mm\n  arc ccw x 10 mm y 0 mm z 3 mm center i -10 mm j 0 mm\n"));
  ASSERT_EQ(moves.size(), 2U);
  EXPECT_NEAR(moves[1].end[2], 3.0, 1e-6);
}

TEST(FamilySteps, ByCountsFromWhereTheAxisIs) {
  const auto moves = one_trace(
      with("param d length 4 mm in 1..9\n",
           "  rapid x 5 mm y 0 mm\n  for n from 1 to 3 step 1\n    cut x by d\n    cut x by -1 mm y by 2*d\n  end\n"
           "  cut x 0 mm\n"));
  ASSERT_EQ(moves.size(), 8U);
  double x = 5.0;
  double y = 0.0;
  for (std::size_t i = 1; i < 7; ++i) {
    x += i % 2 == 1 ? 4.0 : -1.0;
    y += i % 2 == 1 ? 0.0 : 8.0;
    EXPECT_NEAR(moves[i].end[0], x, 1e-6) << i;
    EXPECT_NEAR(moves[i].end[1], y, 1e-6) << i;
  }
  EXPECT_NEAR(moves[7].end[0], 0.0, 1e-6);
}

TEST(FamilyCorners, AreBrokenOrRounded) {
  const auto moves =
      one_trace(with("",
                     "  rapid x 0 mm y 0 mm\n  cut x 20 mm y 0 mm chamfer 2 mm\n  cut x 20 mm y 30 mm rounding 5 mm\n"
                     "  cut x 0 mm y 30 mm\n"));
  ASSERT_EQ(moves.size(), 6U);
  EXPECT_NEAR(moves[1].end[0], 18.0, 1e-6);
  EXPECT_NEAR(moves[2].end[1], 2.0, 1e-6);
  EXPECT_NEAR(moves[3].end[1], 25.0, 1e-6);
  EXPECT_EQ(moves[4].kind, ir::MotionKind::arc_ccw);
  EXPECT_NEAR(moves[4].end[0], 15.0, 1e-6);
  EXPECT_NEAR(moves[4].center[0], -5.0, 1e-6);
}

TEST(FamilyCorners, ACutFollowsThem) {
  for (const std::string after : {"  rapid x 0 mm\n", "  feed 50 mm/min\n  cut x 0 mm\n", "  stop\n"})
    EXPECT_NE(refused_for(with("", "  rapid x 0 mm y 0 mm\n  cut x 20 mm chamfer 2 mm\n" + after))
                  .find("the cut or arc that it leads to"),
              std::string::npos)
        << after;
}

TEST(FamilyNative, StandsWordForWordInBothForms) {
  const text::Source family = with("",
                                   "  rapid x 1 mm\n  native fanuc \"M68 (CLAMP)\" sinumerik-840d \"M68 ; clamp\" "
                                   "changes nothing\n  cut x 2 mm\n");
  for (const RenderMode mode : {RenderMode::macro, RenderMode::explicit_blocks}) {
    EXPECT_TRUE(rendered(family, "fanuc", mode, {}).text.contains("\nM68 (CLAMP)\n"));
    EXPECT_TRUE(rendered(family, "sinumerik-840d", mode, {}).text.contains("\nM68 ; clamp\n"));
  }
  EXPECT_NE(refused_for(family, "haas").find("native text of another language has no counterpart"), std::string::npos);
}

TEST(FamilyNative, WhatItChangesIsStatedAgain) {
  const auto text_with = [](std::string_view changes) {
    return rendered(with("", "  cut x 1 mm\n  " + std::string(kAll) + std::string(changes) + "\n  cut x 2 mm\n"),
                    "fanuc", RenderMode::macro, {})
        .text;
  };
  EXPECT_TRUE(text_with("nothing").contains("M68\nX2.\n")) << text_with("nothing");
  EXPECT_TRUE(text_with("motion").contains("M68\nG01 X2.\n")) << text_with("motion");
  EXPECT_TRUE(text_with("motion, feed").contains("M68\nG01 X2. F100.\n")) << text_with("motion, feed");
}

TEST(FamilyNative, IsRefusedWhereItMovesOrIsNoBlock) {
  const auto fault = [](const std::string& text) {
    return refused_for(with("", "  rapid x 1 mm\n  native fanuc \"" + text + "\" changes nothing\n"));
  };
  EXPECT_NE(fault("G0 X10.").find("moves no axis"), std::string::npos);
  EXPECT_NE(fault("G28").find("moves no axis"), std::string::npos);
  EXPECT_NE(fault("M98 P5").find("moves no axis"), std::string::npos);
  EXPECT_NE(fault("GOTO 5").find("moves no axis"), std::string::npos);
  EXPECT_NE(fault("M68 [").find("the native text"), std::string::npos);
}

TEST(FamilyNative, ItsLineNeedsATextAndItsEffects) {
  const auto fault = [](const std::string& line) { return refused_for(with("", "  " + line + "\n")); };
  EXPECT_NE(fault("native fanuc \"M68\"").find("changes"), std::string::npos);
  EXPECT_NE(fault("native fanuc \"M68\" changes coolant").find("nothing, motion or feed"), std::string::npos);
  EXPECT_NE(fault("native fanuc \"M68\" fanuc \"M69\" changes nothing").find("given twice"), std::string::npos);
  EXPECT_NE(fault("native fanuc \" \" changes nothing").find("in quotes"), std::string::npos);
  EXPECT_NE(fault("plane zy").find("xy, zx or yz"), std::string::npos);
}

}  // namespace
}  // namespace dripfeed::compile::test
