// Blocks of moves that are mirrored, repeated and turned, in all dialects and both forms: their points and centres
// against the closed form.
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/unit/dialects/compile/render/family_run.h"

namespace dripfeed::compile::test {
namespace {

using Place = std::array<double, 3>;

void expect_places(const std::vector<ir::Motion>& found, const std::vector<Place>& wanted) {
  ASSERT_EQ(found.size(), wanted.size());
  for (std::size_t i = 0; i < found.size(); ++i)
    for (std::size_t axis = 0; axis < 3; ++axis)
      EXPECT_NEAR(found[i].end[axis], wanted[i][axis], 1e-3) << "move " << i << " axis " << axis;
}

constexpr double kCos30 = 0.8660254037844386;

// The subprogram is called before and after: its own moves stay.
TEST(FamilyCopies, MirroredMovesKeepTheSubprogramAsItIs) {
  const auto found =
      one_trace(with("param wide length 20 mm in 1..90\n"
                     "sub hook\n  cut x 5 mm y 1 mm\n  cut x wide\n  arc ccw x wide + 4 mm y 5 mm center i 0 mm j "
                     "4 mm\n  cut x by -2 mm y by 3 mm\nend\n",
                     "  call hook\n  mirror x at 30 mm\n    call hook\n  end\n  mirror y\n    call hook\n  end\n"
                     "  call hook\n"));
  const std::vector<Place> hook = {{5, 1, 0}, {20, 1, 0}, {24, 5, 0}, {22, 8, 0}};
  std::vector<Place> wanted = hook;
  for (const Place& one : hook) wanted.push_back({60 - one[0], one[1], 0});
  for (const Place& one : hook) wanted.push_back({one[0], -one[1], 0});
  wanted.insert(wanted.end(), hook.begin(), hook.end());
  expect_places(found, wanted);
  const auto arc = [&](std::size_t i, ir::MotionKind kind, double center_x, double center_y) {
    EXPECT_EQ(found[i].kind, kind) << i;
    EXPECT_NEAR(found[i].center[0], center_x, 1e-3) << i;
    EXPECT_NEAR(found[i].center[1], center_y, 1e-3) << i;
  };
  arc(2, ir::MotionKind::arc_ccw, 0.0, 4.0);
  arc(6, ir::MotionKind::arc_cw, 0.0, 4.0);
  arc(10, ir::MotionKind::arc_cw, 0.0, -4.0);
  arc(14, ir::MotionKind::arc_ccw, 0.0, 4.0);
}

TEST(FamilyCopies, ShiftedMovesAndLayers) {
  const auto found = one_trace(with("param copies count 2 in 1..9\n",
                                    "  repeat copies by z -1.5 mm\n    repeat 3 by x 10 mm y 2 mm\n"
                                    "      cut x 1 mm y 2 mm z 0 mm\n      cut y 4 mm\n    end\n  end\n"));
  std::vector<Place> wanted;
  for (int layer = 0; layer < 2; ++layer)
    for (int copy = 0; copy < 3; ++copy) {
      wanted.push_back({1.0 + 10.0 * copy, 2.0 + 2.0 * copy, -1.5 * layer});
      wanted.push_back({1.0 + 10.0 * copy, 4.0 + 2.0 * copy, -1.5 * layer});
    }
  expect_places(found, wanted);
}

TEST(FamilyCopies, TurnedMoves) {
  const auto found =
      one_trace(with("param by_angle angle 30 deg in 0..360\n",
                     "  repeat 3 turn by_angle at x 10 mm y 5 mm\n    cut x 30 mm y 5 mm\n    cut z -1 mm\n"
                     "    arc ccw x 20 mm y 15 mm center i -10 mm\n    cut x by 0 mm y by 2 mm\n    cut z 0 mm\n"
                     "  end\n"));
  std::vector<Place> wanted;
  for (int copy = 0; copy < 3; ++copy) {
    const double a = 30.0 * copy * std::numbers::pi / 180.0;
    const auto at = [&](double x, double y, double z) {
      return Place{10.0 + (x - 10.0) * std::cos(a) - (y - 5.0) * std::sin(a),
                   5.0 + (x - 10.0) * std::sin(a) + (y - 5.0) * std::cos(a), z};
    };
    wanted.push_back(at(30, 5, 0));
    wanted.push_back(at(30, 5, -1));
    wanted.push_back(at(20, 15, -1));
    wanted.push_back(at(20, 17, -1));
    wanted.push_back(at(20, 17, 0));
  }
  expect_places(found, wanted);
  EXPECT_NEAR(found[7].center[0], -10.0 * kCos30, 1e-3);
  EXPECT_NEAR(found[7].center[1], -5.0, 1e-3);
}

// A curve, a pocket and holes among the moves; compensation on the other side.
TEST(FamilyCopies, VerbsOfManyMoves) {
  const std::string head =
      "param wide length 30 mm in 1..90\nlist xs = 0 mm, 10 mm, 20 mm\nlist ys = 0 mm, 15 mm, 0 mm\n";
  const std::string moves =
      "    rapid z 5 mm\n    rapid x 2 mm y 3 mm\n    cut along bezier x xs y ys within 0.05 mm\n"
      "    drill from 2 mm to -5 mm\n      at x wide y 4 mm\n      at x 8 mm y 9 mm\n    end\n";
  const auto plain = one_trace(with(head, moves));
  const auto mirrored = one_trace(with(head, "  mirror y\n" + moves + "  end\n"));
  ASSERT_EQ(plain.size(), mirrored.size());
  for (std::size_t i = 0; i < plain.size(); ++i) {
    EXPECT_NEAR(mirrored[i].end[0], plain[i].end[0], 1e-3) << i;
    EXPECT_NEAR(mirrored[i].end[1], -plain[i].end[1], 1e-3) << i;
    EXPECT_NEAR(mirrored[i].end[2], plain[i].end[2], 1e-3) << i;
  }
}

// A face in a turned block: its moves are those of a face, turned.
TEST(FamilyCopies, AFaceIsTurned) {
  const std::string face =
      "    face x 20 mm to 50 mm  y -8 mm to 8 mm  z 1 mm to 0 mm  depth 0.5 mm  stepover 4 mm  beyond 2 mm  "
      "return 5 mm\n";
  const std::string head = "  tool 1  diameter 6 mm\n  rapid x 0 mm  y 0 mm\n  rapid z 5 mm\n";
  const auto plain = one_trace(with("", head + face));
  const auto turned = one_trace(with("", head + "  repeat 3 turn 120 deg at x 0 mm y 0 mm\n" + face + "  end\n"));
  const auto places = [](const std::vector<ir::Motion>& all) {
    std::vector<Place> out;
    for (const ir::Motion& m : all)
      if (m.kind == ir::MotionKind::linear) out.push_back({m.end[0], m.end[1], m.end[2]});
    return out;
  };
  const std::vector<Place> one = places(plain), found = places(turned);
  ASSERT_FALSE(one.empty());
  std::vector<Place> cuts;
  for (int copy = 0; copy < 3; ++copy) {
    const double angle = copy * 2.0 * std::numbers::pi / 3.0, c = std::cos(angle), s = std::sin(angle);
    for (const Place& p : one) cuts.push_back({p[0] * c - p[1] * s, p[0] * s + p[1] * c, p[2]});
  }
  ASSERT_EQ(found.size(), cuts.size());
  for (std::size_t i = 0; i < cuts.size(); ++i)
    for (std::size_t axis = 0; axis < 3; ++axis)
      EXPECT_NEAR(found[i][axis], cuts[i][axis], 1e-3) << "cut " << i << " axis " << axis;
}

TEST(FamilyCopies, WhatCannotBeCopiedIsRefused) {
  const auto fault = [](const std::string& steps) {
    const RenderResult out =
        rendered(with("param text_ text \"A\" count 0..9\n", steps), "fanuc", RenderMode::macro, {});
    return out.diagnostics.empty() ? std::string() : out.diagnostics.front().arguments.front();
  };
  EXPECT_THAT(fault("  repeat 3 turn 30 deg at x 0 mm y 0 mm\n    cut x 3 mm\n  end\n"),
              testing::HasSubstr("both x and y"));
  EXPECT_THAT(fault("  mirror x\n    plane zx\n    cut x 3 mm\n    plane xy\n  end\n"),
              testing::HasSubstr("not mirrored"));
  EXPECT_THAT(fault("  mirror z\n    cut x 3 mm\n  end\n"), testing::HasSubstr("x or y"));
  EXPECT_THAT(fault("  repeat 3 along x 3 mm\n    cut x 3 mm\n  end\n"), testing::HasSubstr("by"));
  EXPECT_THAT(fault("  repeat 2 by z -1 mm\n    drill from 2 mm to -5 mm\n      at x 1 mm y 1 mm\n    end\n  end\n"),
              testing::HasSubstr("levels"));
  EXPECT_THAT(
      fault("  compensate left\n  cut x 1 mm\n  mirror x\n    cut x 3 mm\n  end\n  compensate off\n  cut x 9 mm\n"),
      testing::HasSubstr("compensation"));
  EXPECT_EQ(fault("  mirror x\n    cut x 3 mm\n  end\n"), "");
}

// Where the direction of milling is reversed, the block is named; mirrored twice it is not.
TEST(FamilyCopies, ReversedMillingIsAWarning) {
  const auto warnings = [](const std::string& steps) {
    const RenderResult out = rendered(with("", "  tool 1  diameter 6 mm\n  rapid x 0 mm  y -40 mm\n" + steps), "fanuc",
                                      RenderMode::macro, {});
    std::vector<std::string> found;
    for (const text::Diagnostic& d : out.diagnostics) {
      EXPECT_EQ(d.id, text::DiagnosticId::family_milling_reversed) << text::message_of(d);
      EXPECT_EQ(d.severity, text::Severity::warning);
      found.push_back(d.arguments.front());
    }
    EXPECT_NE(out.text, "");
    return found;
  };
  const std::string contour =
      "    rapid x 5 mm  y -30 mm\n    compensate left\n    cut x 5 mm  y -20 mm\n    cut x 25 mm\n"
      "    cut x 25 mm  y -30 mm\n    compensate off\n    cut x 25 mm  y -40 mm\n";
  const std::string pocket =
      "    pocket x 30 mm y 0 mm  diameter 30 mm  z 0 mm to -4 mm  depth 2 mm  stepover 4 mm  finish 0.2 mm  helix 3 "
      "deg  "
      "return 5 mm\n";
  EXPECT_THAT(warnings("  mirror x\n" + contour + "  end\n"), testing::ElementsAre("a contour with compensation"));
  EXPECT_THAT(warnings("  mirror x\n" + pocket + pocket + "  end\n"), testing::ElementsAre("a pocket"));
  EXPECT_THAT(warnings("  mirror x\n  mirror y\n" + pocket + "  end\n  end\n"), testing::IsEmpty());
  EXPECT_THAT(warnings("  repeat 2 turn 90 deg at x 0 mm y 0 mm\n" + pocket + "  end\n"), testing::IsEmpty());
  EXPECT_THAT(warnings("  mirror x\n    rapid x 5 mm  y 5 mm\n    cut x 9 mm  y 5 mm\n  end\n"), testing::IsEmpty());
}

// The side of compensation changes with the mirror.
TEST(FamilyCopies, CompensationChangesSides) {
  const RenderResult out =
      rendered(with("",
                    "  mirror x\n    compensate left\n    cut x 1 mm y 1 mm\n    cut y 5 mm\n    compensate "
                    "off\n    cut x 9 mm y 9 mm\n  end\n"),
               "fanuc", RenderMode::macro, {});
  EXPECT_TRUE(out.text.contains("G42")) << out.text;
  EXPECT_FALSE(out.text.contains("G41")) << out.text;
}

}  // namespace
}  // namespace dripfeed::compile::test
