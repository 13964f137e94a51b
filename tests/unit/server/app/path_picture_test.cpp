// A toolpath as a small drawing: what fills it, what is drawn once, and how large it gets.
#include "server/app/checks/path_picture.h"

#include <cmath>
#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/unit/server/app/whole_shop.h"

namespace dripfeed::app {
namespace {

PathPicture picture_of_text(const std::string& text) {
  const auto path =
      follow_path({.dialect = "fanuc", .text = text}, test::PlainDocuments(), {.seconds = 10, .memory_bytes = 0});
  EXPECT_TRUE(path.has_value());
  return picture_of(*path);
}

const std::string kHead = "%\nO1\nG21 G90 G94 G17 G54\nG0 X0 Y0 Z5.\n";

TEST(PathPicture, CutsFillTheDrawingAndRapidsMayLeaveIt) {
  const PathPicture picture = picture_of_text(kHead + "G1 Z0 F100.\nX30.\nZ20.\nX0\nZ0\nG0 Z5.\nG0 X300.\nM30\n%\n");
  EXPECT_EQ(picture.view, PictureView::turning) << "y never moves";
  EXPECT_EQ(picture.cut, "M92 174 64 174 64 6 176 6 176 174 64 174") << "x 0 to 30 up, z 0 to 20 to the right";
  EXPECT_NE(picture.rapid.find('-'), std::string::npos) << picture.rapid;
}

TEST(PathPicture, OtherPathsAreSeenFromACorner) {
  const PathPicture picture = picture_of_text(kHead + "G1 Z0 F100.\nX10.\nY10.\nX0\nY0\nM30\n%\n");
  EXPECT_EQ(picture.view, PictureView::isometric);
  EXPECT_FALSE(picture.cut.empty());
}

TEST(PathPicture, ALineIsDrawnOnce) {
  std::string text = kHead + "G1 Z0 F100.\n";
  const std::string once = picture_of_text(text + "X10.\nX0\nM30\n%\n").cut;
  for (int i = 0; i < 50; ++i) text += "X10.\nX0\n";
  EXPECT_EQ(picture_of_text(text + "M30\n%\n").cut, once);
}

// 20,000 chords all over the drawing.
TEST(PathPicture, ALongPathGetsACoarserGrid) {
  std::string text = kHead + "G1 Z0 F100.\n";
  for (int i = 0; i < 20'000; ++i)
    text += fmt::format("X{}. Y{}.\n", std::lround(50.0 + 50.0 * std::sin(i * 0.7)),
                        std::lround(50.0 + 50.0 * std::cos(i * 1.3)));
  const PathPicture picture = picture_of_text(text + "M30\n%\n");
  EXPECT_GT(picture.cut.size(), 1000U);
  EXPECT_LT(picture.cut.size(), 60'000U);
}

TEST(PathPicture, ItStatesWhetherACutIsLeftOut) {
  EXPECT_TRUE(picture_of_text(kHead + "G1 Z0 F100.\nX5.\nG53 G0 Z0\nM30\n%\n").has_all_cuts) << "rapids alone";
  const PathPicture some = picture_of_text("%\nO1\nG21 G90 G94 G17 G54\nG1 X1. F100.\nG1 X0 Y0 Z0\nX5.\nM30\n%\n");
  EXPECT_FALSE(some.has_all_cuts) << "the first cuts come from a place that is not known";
  EXPECT_FALSE(some.cut.empty());
}

TEST(PathPicture, WithoutAMoveItIsEmpty) {
  const PathPicture picture = picture_of_text("%\nO1\nM30\n%\n");
  EXPECT_TRUE(picture.cut.empty() && picture.rapid.empty() && picture.has_all_cuts);
}

}  // namespace
}  // namespace dripfeed::app
