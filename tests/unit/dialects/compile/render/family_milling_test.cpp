// Faces and pockets of families: what the cutter covers against the region itself, at the corners of what may be asked
// for, in all dialects and both forms; and what is refused.
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/unit/dialects/compile/milled_region.h"
#include "tests/unit/dialects/compile/render/family_run.h"

namespace dripfeed::compile::test {
namespace {

using enum ir::MotionKind;

text::Source milled_part(const std::string& steps) {
  return {"test.family",
          "family test\nmachine mill\nparam wide length 12 mm in 0.5..99\nparam floor length -9 mm in -50..50\n"
          "param place length 3 mm in -99..99\nprogram test\n  tool 1  diameter wide\n  spindle 600 rpm cw\n"
          "  feed 300 mm/min\n  rapid z 60 mm\n" +
              steps + "end\n"};
}

std::string milling_fault(const text::Source& family, const Values& values = {}) {
  const RenderResult result = rendered(family, "fanuc", RenderMode::macro, values);
  return result.diagnostics.empty() ? "" : messages_of({result.diagnostics.front()}, family);
}

struct Pocket {
  RoundRectangle region;
  double cutter = 12.0;
  double top = 0.0;
  double bottom = -9.0;
  double depth = 4.0;
  double stepover = 7.0;
  double finish = 0.3;
  double angle_deg = 3.0;
  double clear = 5.0;
  std::string entry = "helix";
  bool is_round = false;
};

std::string milling_verb(const Pocket& p) {
  const std::string shape = p.is_round ? fmt::format("diameter {} mm", p.region.length)
                                       : fmt::format("length {} mm width {} mm corner {} mm", p.region.length,
                                                     p.region.width, p.region.corner);
  return fmt::format(
      "  pocket x place y {} mm {} z {} mm to floor depth {} mm stepover {} mm finish {} mm {} {} deg feed 120 mm/min "
      "return "
      "{} mm\n",
      p.region.y, shape, p.top, p.depth, p.stepover, p.finish, p.entry, p.angle_deg, p.clear);
}
Values pocket_values(const Pocket& p) {
  return {{"wide", fmt::format("{} mm", p.cutter)},
          {"floor", fmt::format("{} mm", p.bottom)},
          {"place", fmt::format("{} mm", p.region.x)}};
}

// Nothing outside the region is cut, all inside is at every level, entries are no steeper than asked for, and rapids
// stay above what stands.
void expect_milled(const Pocket& p) {
  const double radius = p.cutter / 2.0;
  const std::vector<ir::Motion> moves = one_trace(milled_part(milling_verb(p)), pocket_values(p));
  ASSERT_GT(moves.size(), 8U);
  std::map<long, std::vector<Spot>> spots;  // by level, in micrometers
  double lowest = p.top;
  for (const ir::Motion& one : moves) {
    const bool rapid_down = one.kind == rapid && one.end[2] < one.start[2];
    if (rapid_down) {
      EXPECT_GE(one.end[2], p.top + 0.5 - 1e-6);
    }
    if (one.kind == rapid) {
      if (one.start[2] < p.clear - 1e-6 && one.end[2] < p.top) ADD_FAILURE() << "a rapid in the part";
      if (one.start[0] != one.end[0] || one.start[1] != one.end[1]) {
        EXPECT_GE(one.start[2], p.clear - 1e-6);
      }
      continue;
    }
    const std::vector<Spot> along = spots_of(one, 0.2);
    double length = 0.0;
    for (std::size_t i = 1; i < along.size(); ++i) {
      EXPECT_LE(p.region.distance(along[i]), -radius + 2e-3);
      length += std::hypot(along[i].x - along[i - 1].x, along[i].y - along[i - 1].y);
    }
    const double down = one.start[2] - one.end[2];
    if (down > 1e-6) {
      EXPECT_LE(down, length * std::tan(p.angle_deg * std::numbers::pi / 180.0) * 1.001 + 1e-3);
      EXPECT_DOUBLE_EQ(one.feed, 120.0);
    } else {
      EXPECT_LE(one.end[2], one.start[2] + 1e-6);
      EXPECT_DOUBLE_EQ(one.feed, one.end[2] < p.top ? 300.0 : one.feed);
    }
    lowest = std::min(lowest, one.end[2]);
    if (std::abs(down) < 1e-9)
      for (const Spot& at : along) spots[std::lround(at.z * 1000.0)].push_back(at);
  }
  EXPECT_NEAR(lowest, p.bottom, 1e-6);
  RoundRectangle rough = p.region;  // up to what the last pass takes
  rough.length -= 2.0 * p.finish;
  rough.width -= 2.0 * p.finish;
  rough.corner = std::max(rough.corner - p.finish, radius);
  const auto levels = static_cast<int>(std::ceil((p.top - p.bottom) / p.depth - 1e-9));
  for (int n = 1; n <= levels; ++n) {
    const double level = std::max(p.top - n * p.depth, p.bottom);
    const bool is_floor = n == levels;
    const auto here = spots.find(std::lround(level * 1000.0));
    ASSERT_NE(here, spots.end()) << level;
    EXPECT_LE(uncovered_mm(is_floor ? p.region : rough, here->second, radius, p.region.length / 60.0, 0.02), 0.02)
        << level;
  }
}

Pocket rectangle(double length, double width, double corner) {
  return {.region = {.length = length, .width = width, .corner = corner, .x = 3.0, .y = -2.0}};
}

TEST(FamilyPockets, ARectangleIsClearedAtEveryLevel) {
  Pocket p = rectangle(80, 50, 8);
  expect_milled(p);
  p.entry = "ramp";
  expect_milled(p);
  std::swap(p.region.length, p.region.width);
  expect_milled(p);
}

// At the corners of what is accepted: sharpest corners, widest stepover, a slot-like one, a round one, one layer, many.
TEST(FamilyPockets, CornersOfWhatIsAccepted) {
  for (const double corner : {6.0, 15.0}) {
    Pocket p = rectangle(60, 30, corner);
    p.stepover = 10.2;
    p.angle_deg = 45.0;
    p.depth = 30.0;
    expect_milled(p);
    p.entry = "ramp";
    p.depth = 0.9;
    p.angle_deg = 0.5;
    expect_milled(p);
  }
  Pocket square = rectangle(40, 40, 6);
  square.stepover = 10.2;
  square.finish = 2.0;
  expect_milled(square);
  Pocket narrow = rectangle(30, 14.4, 6);
  narrow.finish = 0.4 / 2.0;
  narrow.bottom = 40.0;
  narrow.top = 41.0;
  narrow.clear = 41.5;
  narrow.entry = "ramp";
  expect_milled(narrow);
  Pocket helix = rectangle(30, 14.8, 6);
  helix.finish = 0.2;
  expect_milled(helix);
}

TEST(FamilyPockets, ARoundOne) {
  for (const double diameter : {14.8, 30.0, 61.0})
    for (const double finish : {0.05, 0.2}) {
      Pocket p = rectangle(diameter, diameter, diameter / 2.0);
      p.is_round = true;
      p.stepover = 11.4;
      p.finish = finish;
      expect_milled(p);
    }
}

// The feed of the entry ends with it, whichever feed was before.
TEST(FamilyPockets, TheFeedBeforeComesBack) {
  const std::string pocket =
      "pocket x 0 mm y 0 mm diameter 30 mm z 0 mm to -2 mm depth 2 mm stepover 6 mm finish 0.2 mm helix 5 deg feed 50 "
      "mm/min "
      "return 5 mm\n";
  const std::string steps =
      "  for n from 1 to 2 step 1\n    feed n*100 mm/min\n    " + pocket + "    cut x n*1 mm\n  end\n";
  std::vector<double> feeds;
  for (const ir::Motion& one : one_trace(milled_part(steps)))
    if (one.kind != rapid && (feeds.empty() || feeds.back() != one.feed)) feeds.push_back(one.feed);
  EXPECT_EQ(feeds, (std::vector<double>{100, 50, 100, 200, 50, 200}));
}

TEST(FamilyPockets, WhatCannotBeMilledIsRefused) {
  const auto pocket = [](const Pocket& p) { return milling_fault(milled_part(milling_verb(p)), pocket_values(p)); };
  const auto changed = [&](auto change) {
    Pocket p = rectangle(80, 50, 8);
    change(p);
    return pocket(p);
  };
  EXPECT_EQ(pocket(rectangle(80, 50, 8)), "");
  const std::vector<std::pair<std::string, std::string>> wrong = {
      {changed([](Pocket& p) { p.bottom = 1.0; }), "leads down"},
      {changed([](Pocket& p) { p.depth = 0.0; }), "depth of cut of 'pocket' is above 0"},
      {changed([](Pocket& p) { p.stepover = 0.0; }), "stepover of 'pocket' is above 0"},
      {changed([](Pocket& p) { p.stepover = 10.3; }), "at most 0.85 of the cutter's"},
      {changed([](Pocket& p) { p.finish = 0.0; }), "leaves on the wall"},
      {changed([](Pocket& p) { p.angle_deg = 0.0; }), "the angle of the entry"},
      {changed([](Pocket& p) { p.angle_deg = 46.0; }), "the angle of the entry"},
      {changed([](Pocket& p) { p.clear = 0.4; }), "returns to 0.5 mm above"},
      {changed([](Pocket& p) { p.region.corner = 5.9; }), "does not fit into the corners"},
      {changed([](Pocket& p) { p.region.corner = 25.1; }), "run into each other"},
      {changed([](Pocket& p) {
         p.region.width = 13.0;
         p.region.corner = 6.0;
       }),
       "too wide for the pocket"},
      {changed([](Pocket& p) {
         p.region.width = 14.0;
         p.region.corner = 6.0;
       }),
       "too narrow for a helix"},
      {changed([](Pocket& p) {
         p.region.width = 69.0;
         p.entry = "ramp";
       }),
       "too short for a ramp"},
      {changed([](Pocket& p) { p.entry = "plunge"; }), "helix or ramp"},
      {milling_fault(milled_part("  let size = 60 mm\n  set size = size + 1 mm\n  pocket x 0 mm y 0 mm diameter size z "
                                 "0 mm to -2 mm depth 2 mm "
                                 "stepover 6 mm finish 0.2 "
                                 "mm helix 5 deg return 5 mm\n")),
       "are checked before the program runs"},
      {milling_fault(with("", "  " + std::string("pocket x 0 mm y 0 mm diameter 30 mm\n"))),
       "takes the diameter of its tool"},
      {milling_fault(milled_part("  compensate left\n  cut x 0 mm\n" + milling_verb(rectangle(80, 50, 8)))),
       "compensate off"},
      {milling_fault(milled_part("  plane zx\n" + milling_verb(rectangle(80, 50, 8)))), "plane xy before it"},
      {milling_fault(milled_part("  for n from 1 to 2 step 1\n  " + milling_verb(rectangle(80, 50, 8)) +
                                 "    tool 2 diameter 3 mm\n  end\n")),
       "call that tool in the loop, too"},
      {milling_fault(
           milled_part("  if wide > 3 mm\n    tool 2 diameter 3 mm\n  end\n" + milling_verb(rectangle(80, 50, 8)))),
       "takes the diameter of its tool"}};
  for (const auto& [found, wanted] : wrong) EXPECT_TRUE(found.contains(wanted)) << wanted << ": " << found;
}

// What is not reached is not checked; a branch that these values take is.
TEST(FamilyPockets, ABranchThatIsNotTakenIsNotChecked) {
  const std::string narrow =
      "    pocket x 0 mm y 0 mm diameter 13 mm z 0 mm to -2 mm depth 2 mm stepover 6 mm finish 0.2 mm helix "
      "5 deg return 5 mm\n";
  EXPECT_EQ(milling_fault(milled_part("  if wide < 3 mm\n" + narrow + "  end\n  cut x 0 mm\n")), "");
  EXPECT_EQ(milling_fault(milled_part("  if wide > 3 mm\n    cut x 0 mm\n  else\n" + narrow + "  end\n")), "");
  EXPECT_TRUE(
      milling_fault(milled_part("  if wide > 3 mm\n" + narrow + "  end\n")).contains("too wide for the pocket"));
}

struct Face {
  double x = 60.0;  // half of it
  double y = 40.0;
  double top = 2.0;
  double bottom = 0.0;
  double depth = 0.7;
  double stepover = 35.0;
  double beyond = 3.0;
  double cutter = 50.0;
  bool along_y = false;
};
std::string milling_verb(const Face& f) {
  const std::string x = fmt::format("x {} mm to {} mm", -f.x + 3.0, f.x + 3.0);
  const std::string y = fmt::format("y {} mm to {} mm", -f.y, f.y);
  return fmt::format("  face {} {} z {} mm to floor depth {} mm stepover {} mm beyond {} mm return 9 mm\n",
                     f.along_y ? y : x, f.along_y ? x : y, f.top, f.depth, f.stepover, f.beyond);
}

TEST(FamilyFaces, EveryLevelIsCoveredAndEveryPassLeavesThePart) {
  for (const bool along_y : {false, true})
    for (const double cutter : {4.0, 50.0, 160.0})
      for (const double share : {0.2, 0.95}) {
        Face f{.stepover = share * cutter, .cutter = cutter, .along_y = along_y};
        SCOPED_TRACE(milling_verb(f));
        const Values values = {{"wide", fmt::format("{} mm", std::min(cutter, 99.0))}, {"floor", "0 mm"}};
        if (cutter > 99.0) f.cutter = 99.0, f.stepover = share * 99.0;
        const std::vector<ir::Motion> moves = one_trace(milled_part(milling_verb(f)), values);
        const RoundRectangle part = {.length = 2 * f.x, .width = 2 * f.y, .x = 3.0};
        std::map<long, std::vector<Spot>> spots;
        for (const ir::Motion& one : moves) {
          if (one.kind == rapid) {
            const bool level = one.start[0] == one.end[0] && one.start[1] == one.end[1];
            // Outside the part, or above it.
            if (one.end[2] < f.top) {
              EXPECT_TRUE(level && part.distance({one.end[0], one.end[1]}) > f.cutter / 2);
            }
            continue;
          }
          EXPECT_EQ(one.start[2], one.end[2]);
          for (const Spot& at : spots_of(one, 1.0)) spots[std::lround(at.z * 1000.0)].push_back(at);
        }
        ASSERT_EQ(spots.size(), 3U);
        for (const double level : {1300.0, 600.0, 0.0}) {
          const auto here = spots.find(static_cast<long>(level));
          ASSERT_NE(here, spots.end()) << level;
          EXPECT_LE(uncovered_mm(part, here->second, f.cutter / 2.0, 2.0, 0.0), 0.3) << level;
        }
      }
}

TEST(FamilyFaces, WhatCannotBeFacedIsRefused) {
  const auto face = [](const std::string& steps) {
    return milling_fault(milled_part("  face " + steps + "\n"), {{"floor", "0 mm"}});
  };
  const std::string y = " y 0 mm to 30 mm z 2 mm to floor depth 1 mm";
  EXPECT_EQ(face("x 0 mm to 50 mm" + y + " stepover 6 mm beyond 1 mm return 5 mm"), "");
  EXPECT_TRUE(face("x 0 mm to 0 mm" + y + " stepover 6 mm beyond 1 mm return 5 mm").contains("smaller place along"));
  EXPECT_TRUE(face("y 0 mm to 9 mm x 5 mm to 0 mm z 2 mm to floor depth 1 mm stepover 6 mm beyond 1 mm return 5 mm")
                  .contains("smaller place across"));
  EXPECT_TRUE(face("x 0 mm to 50 mm" + y + " stepover 11.5 mm beyond 1 mm return 5 mm").contains("at most 0.95"));
  EXPECT_TRUE(face("x 0 mm to 50 mm" + y + " stepover 6 mm beyond 0 mm return 5 mm").contains("leaves the part"));
  EXPECT_TRUE(face("x 0 mm to 50 mm" + y + " stepover 6 mm beyond 1 mm return 2 mm").contains("above the stock"));
  EXPECT_TRUE(face("x 0 mm to 50 mm" + y + " beyond 1 mm return 2 mm").contains("expected 'stepover'"));
}

}  // namespace
}  // namespace dripfeed::compile::test
