// Verbs that stand for many moves: grooves, whole threads and engraved texts against their closed forms, in all
// dialects and both forms.
#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/unit/dialects/compile/render/family_run.h"

namespace dripfeed::compile::test {
namespace {

using enum ir::MotionKind;

text::Source lathe(const std::string& steps, const std::string& x_is = "diameter") {
  return {"test.family",
          "family test\nmachine lathe, x is " + x_is +
              "\nparam bottom length 50 mm in 1..99\nparam pecks length 2 mm in 0.1..9\nparam n count 4 in 1..9\n"
              "program test\n  spindle 600 rpm cw\n  feed 0.1 mm/rev\n" +
              steps + "end\n"};
}

struct Place {
  ir::MotionKind kind;
  double x;
  double z;
};
void expect_places(const text::Source& family, const std::vector<Place>& wanted, const Values& values = {}) {
  const std::vector<ir::Motion> found = one_trace(family, values);
  ASSERT_EQ(found.size(), wanted.size());
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    EXPECT_EQ(found[i].kind, wanted[i].kind) << "move " << i;
    EXPECT_NEAR(found[i].end[0], wanted[i].x, 1e-3) << "move " << i;
    EXPECT_NEAR(found[i].end[2], wanted[i].z, 1e-3) << "move " << i;
  }
}

std::string first_fault(const text::Source& family) {
  const RenderResult result = rendered(family, "fanuc", RenderMode::macro, {});
  return result.diagnostics.empty() ? "" : messages_of({result.diagnostics.front()}, family);
}

TEST(FamilyGrooves, APlungeGoesInAndOut) {
  expect_places(
      lathe("  rapid x 70 mm z 5 mm\n  groove from 64 mm to bottom z -20 mm dwell 0.2 s\n  cut x 65 mm\n"),
      {{rapid, 70, 5}, {rapid, 70, -20}, {rapid, 64, -20}, {linear, 50, -20}, {rapid, 64, -20}, {linear, 65, -20}});
}

TEST(FamilyGrooves, AWideOneIsPlungesSideBySide) {
  expect_places(lathe("  rapid x 66 mm z 5 mm\n  groove from 64 mm to bottom z -20 mm down to -25 mm step 2 mm\n"),
                {{rapid, 66, 5},
                 {rapid, 66, -20},
                 {rapid, 64, -20},
                 {rapid, 64, -20},
                 {linear, 50, -20},
                 {rapid, 64, -20},
                 {rapid, 64, -22},
                 {linear, 50, -22},
                 {rapid, 64, -22},
                 {rapid, 64, -24},
                 {linear, 50, -24},
                 {rapid, 64, -24},
                 {rapid, 64, -25},
                 {linear, 50, -25},
                 {rapid, 64, -25}});
}

// A peck is on the radius; after each the tool goes back by half a millimeter.
TEST(FamilyGrooves, PecksAreOnTheRadius) {
  expect_places(lathe("  rapid x 70 mm z 5 mm\n  groove from 64 mm to bottom z 0 mm peck 3 mm\n"), {{rapid, 70, 5},
                                                                                                    {rapid, 70, 0},
                                                                                                    {rapid, 64, 0},
                                                                                                    {linear, 58, 0},
                                                                                                    {rapid, 59, 0},
                                                                                                    {linear, 52, 0},
                                                                                                    {rapid, 53, 0},
                                                                                                    {linear, 50, 0},
                                                                                                    {rapid, 51, 0},
                                                                                                    {linear, 50, 0},
                                                                                                    {rapid, 64, 0}});
  // Moves have x as a diameter, also of a family that has radii.
  expect_places(lathe("  rapid x 18 mm z 5 mm\n  groove inside from 20 mm to 27 mm z -3 mm peck 4 mm\n", "radius"),
                {{rapid, 36, 5},
                 {rapid, 36, -3},
                 {rapid, 40, -3},
                 {linear, 48, -3},
                 {rapid, 47, -3},
                 {linear, 54, -3},
                 {rapid, 53, -3},
                 {linear, 54, -3},
                 {rapid, 40, -3}});
  // Deeper than the groove: one cut.
  expect_places(lathe("  rapid x 70 mm z 5 mm\n  groove from 52 mm to bottom z 0 mm peck 9 mm\n"), {{rapid, 70, 5},
                                                                                                    {rapid, 70, 0},
                                                                                                    {rapid, 52, 0},
                                                                                                    {linear, 50, 0},
                                                                                                    {rapid, 51, 0},
                                                                                                    {linear, 50, 0},
                                                                                                    {rapid, 52, 0}});
}

TEST(FamilyThreadCycle, EachPassTakesAChipOfTheSameArea) {
  const text::Source family = lathe(
      "  rapid x 60 mm z 9 mm\n  thread x 40 mm z -18 mm pitch 2 mm depth 1.2 mm passes n from 4 mm return 44 mm "
      "spring 2\n  cut x 50 mm\n");
  std::vector<Place> wanted = {{rapid, 60, 9}, {rapid, 44, 9}, {rapid, 44, 4}};
  for (const double share : {std::sqrt(0.25), std::sqrt(0.5), std::sqrt(0.75), 1.0, 1.0, 1.0}) {
    const double x = 40 - 2.4 * share;
    wanted.insert(wanted.end(), {{rapid, x, 4}, {thread, x, -18}, {rapid, 44, -18}, {rapid, 44, 4}});
  }
  wanted.push_back({linear, 50, 4});
  expect_places(family, wanted);
  for (const ir::Motion& one : one_trace(family)) {
    if (one.kind == rapid) continue;
    EXPECT_DOUBLE_EQ(one.feed, one.kind == thread ? 2.0 : 0.1);  // after the thread the feed before
  }
}

TEST(FamilyThreadCycle, InsideItCutsOutward) {
  expect_places(lathe("  rapid x 30 mm z 9 mm\n  thread x 36 mm z -9 mm pitch 1.5 mm depth 0.8 mm passes 1 from 4 mm "
                      "return 34 mm inside\n"),
                {{rapid, 30, 9},
                 {rapid, 34, 9},
                 {rapid, 34, 4},
                 {rapid, 37.6, 4},
                 {thread, 37.6, -9},
                 {rapid, 34, -9},
                 {rapid, 34, 4}});
}

TEST(FamilyVerbs, FaultsNameWhatIsWrong) {
  EXPECT_TRUE(first_fault(with("", "  groove from 2 mm to 1 mm z 0 mm\n")).contains("on a mill a groove is cut along"));
  EXPECT_TRUE(first_fault(lathe("  groove from 20 mm z 0 mm\n")).contains("expected 'to'"));
  EXPECT_TRUE(first_fault(lathe("  groove from 20 mm to 10 mm z 0 mm to 5 mm\n")).contains("expected 'step'"));
  EXPECT_TRUE(first_fault(lathe("  thread z -9 mm pitch 1 mm depth 1 mm passes 2 from 4 mm return 34 mm\n"))
                  .contains("has x, its diameter before"));
  EXPECT_TRUE(first_fault(lathe("  thread x 9 mm z -9 mm pitch 1 mm depth 1 mm passes 0 from 4 mm return 34 mm\n"))
                  .contains("counts up from 1 to 0"));
  EXPECT_TRUE(first_fault(with("param part text \"A_1\" count 1..9\n",
                               "  engrave part x 0 mm y 0 mm height 6 mm z -1 mm return 2 mm\n"))
                  .contains("part: character 2, '_', cannot be engraved"));
  EXPECT_TRUE(first_fault(with("", "  engrave part x 0 mm y 0 mm height 6 mm z -1 mm return 2 mm\n"))
                  .contains("the name of a text parameter"));
}

// "L" and, a letter farther, "7": the glyphs of a height of six are those of the font itself.
TEST(FamilyEngraving, StrokesAreWhereTheTextStands) {
  const text::Source family =
      with("param part text \"l 7\" count 1..9\nparam high length 6 mm in 1..50\nparam begin length 10 mm in 0..50\n",
           "  engrave part  x begin  y 5 mm  height high  z -0.3 mm  return 2 mm\n");
  const auto strokes = [&](double scale, const Values& values) {
    std::vector<std::array<double, 3>> wanted;
    const auto at = [&](double x, double y, double z) { wanted.push_back({10 + scale * x, 5 + scale * y, z}); };
    at(0, 6, 2), at(0, 6, -0.3), at(0, 0, -0.3), at(4, 0, -0.3), at(4, 0, 2);
    at(12, 6, 2), at(12, 6, -0.3), at(16, 6, -0.3), at(13, 0, -0.3), at(13, 0, 2);
    std::vector<ir::Motion> found = one_trace(family, values);
    ASSERT_FALSE(found.empty());
    found.erase(found.begin());  // to the return level
    ASSERT_EQ(found.size(), wanted.size());
    for (std::size_t i = 0; i < wanted.size(); ++i)
      for (std::size_t axis = 0; axis < 3; ++axis)
        EXPECT_NEAR(found[i].end[axis], wanted[i][axis], 1e-3) << "move " << i << " axis " << axis;
  };
  strokes(1.0, {});
  strokes(0.5, {{"high", "3 mm"}});
}

// The name that the verb keeps its values under meets no name of the family.
TEST(FamilyEngraving, NamesOfTheFamilyStayItsOwn) {
  const text::Source family =
      with("param part text \"I\" count 1..9\n",
           "  let text_x = 3 mm\n  engrave part  x text_x + 1 mm  y 0 mm  height 6 mm  z -1 mm  return 2 mm\n"
           "  engrave part  x text_x + 9 mm  y 0 mm  height 6 mm  z -1 mm  return 2 mm\n  cut x text_x\n");
  EXPECT_DOUBLE_EQ(one_trace(family).back().end[0], 3.0);
}

}  // namespace
}  // namespace dripfeed::compile::test
