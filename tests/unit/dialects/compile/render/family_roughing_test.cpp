// Roughing along a contour: each pass against the contour's own points, in all dialects and both forms, for every side
// and direction; and what is refused.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/unit/dialects/compile/render/family_run.h"

namespace dripfeed::compile::test {
namespace {

using enum ir::MotionKind;

text::Source turned_part(const std::string& steps, const std::string& x_is = "diameter") {
  return {
      "test.family",
      "family test\nmachine lathe, x is " + x_is +
          "\nparam deep length 3 mm in 0.1..99\nparam stays length 0.25 mm in 0..2\nparam foot length 30 mm in 4..99\n"
          "program test\n  spindle 600 rpm cw\n  feed 0.2 mm/rev\n" +
          steps + "end\n"};
}

std::string turning_fault(const text::Source& family, const Values& values = {}) {
  const RenderResult result = rendered(family, "fanuc", RenderMode::macro, values);
  return result.diagnostics.empty() ? "" : messages_of({result.diagnostics.front()}, family);
}

// A place of a turned part, x on the radius.
struct Turned {
  double x = 0.0;
  double z = 0.0;
};

// Which sides the passes have: a height counts towards where they begin, a length back along a pass.
struct Sides {
  bool facing = false;
  bool inside = false;
  [[nodiscard]] double height(Turned p) const { return facing ? p.z : inside ? -p.x : p.x; }
  [[nodiscard]] double length(Turned p) const { return !facing ? p.z : inside ? -p.x : p.x; }
};

void add_line(std::vector<Turned>& out, Turned to) {
  const Turned from = out.back();
  for (int n = 1; n <= 2000; ++n)
    out.push_back({from.x + (to.x - from.x) * n / 2000.0, from.z + (to.z - from.z) * n / 2000.0});
}
// A quarter turn around a center, from one angle to another (degrees, 0 along +z, 90 along +x).
void add_arc(std::vector<Turned>& out, Turned center, double radius, double from, double to) {
  for (int n = 1; n <= 2000; ++n) {
    const double angle = (from + (to - from) * n / 2000.0) * std::numbers::pi / 180.0;
    out.push_back({center.x + radius * std::sin(angle), center.z + radius * std::cos(angle)});
  }
}

struct Job {
  Sides sides;
  std::vector<Turned> contour;  // without allowance, points close together
  Turned begin;
  double depth = 3.0;
  double retract = 1.0;
  Turned left = {};
};

// Where a pass at a height ends: the farthest place of the contour at or below it.
double end_of(const Job& job, const std::vector<Turned>& contour, double height) {
  double length = job.sides.length(contour.front());
  for (const Turned& one : contour)
    if (job.sides.height(one) <= height + 1e-9) length = std::min(length, job.sides.length(one));
  return length;
}

// How far a place lies in the material that stays.
double gouge(const Job& job, const std::vector<Turned>& contour, Turned at) {
  double height = job.sides.height(contour.front());
  for (const Turned& one : contour)
    if (job.sides.length(one) >= job.sides.length(at) + 1e-6) height = std::max(height, job.sides.height(one));
  return height - job.sides.height(at);
}

// All moves are as the contour says: the passes in steps of the depth, then one along it.
void expect_roughed(const text::Source& family, const Job& job, const Values& values = {}) {
  std::vector<Turned> contour = job.contour;
  for (Turned& one : contour) {
    one.x += job.sides.inside ? -job.left.x : job.left.x;
    one.z += job.left.z;
  }
  const std::vector<ir::Motion> moves = one_trace(family, values);
  ASSERT_FALSE(moves.empty());
  std::vector<Turned> ends;  // of passes
  const auto place = [](const auto& at) { return Turned{at[0] / 2.0, at[2]}; };
  const double lowest = job.sides.height(contour.front());
  std::size_t along = moves.size();
  for (std::size_t i = 0; i < moves.size(); ++i) {
    const Turned from = place(moves[i].start);
    const Turned to = place(moves[i].end);
    if (moves[i].kind == rapid) continue;
    for (int n = 0; n <= 20 && moves[i].kind == linear; ++n)
      EXPECT_LT(gouge(job, contour, {from.x + (to.x - from.x) * n / 20.0, from.z + (to.z - from.z) * n / 20.0}), 0.012)
          << "move " << i;
    const bool is_pass = i + 1 < moves.size() && moves[i + 1].kind == rapid && moves[i - 1].kind == rapid;
    if (is_pass && along == moves.size())
      ends.push_back(to);
    else
      along = std::min(along, i);
  }
  const double first = job.sides.height(job.begin);
  const auto passes = static_cast<std::size_t>(std::max(1.0, std::ceil((first - lowest) / job.depth - 1e-6)));
  ASSERT_EQ(ends.size(), passes);
  for (std::size_t n = 0; n < ends.size(); ++n) {
    const double height = std::max(first - job.depth * static_cast<double>(n + 1), lowest);
    EXPECT_NEAR(job.sides.height(ends[n]), height, 1e-3) << "pass " << n;
    EXPECT_NEAR(job.sides.length(ends[n]), end_of(job, contour, height), 0.015) << "pass " << n;
  }
  // The last pass goes through the contour's start and end.
  ASSERT_LT(along, moves.size());
  EXPECT_NEAR(place(moves[along].end).x, contour.front().x, 1e-3);
  EXPECT_NEAR(place(moves[along].end).z, contour.front().z, 1e-3);
  std::size_t last = along;
  for (; last + 1 < moves.size() && moves[last + 1].kind != rapid; ++last) {
    const Turned at = place(moves[last + 1].end);
    const auto nearest = std::ranges::min_element(
        contour, {}, [&](const Turned& one) { return std::hypot(one.x - at.x, one.z - at.z); });
    EXPECT_NEAR(nearest->x, at.x, 1e-3);
    EXPECT_NEAR(nearest->z, at.z, 1e-3);
  }
  EXPECT_NEAR(place(moves[last].end).x, contour.back().x, 1e-3);
  EXPECT_NEAR(place(moves[last].end).z, contour.back().z, 1e-3);
}

// A cylinder, a fillet, a cone, a rounded shoulder: lines and arcs of both directions.
const std::string kShaft =
    "  rapid x 110 mm z 5 mm\n  rough x 100 mm z 2 mm depth deep retract 1 mm allowance x stays z stays/2\n"
    "    cut x foot z 0 mm\n    cut z -20 mm\n    arc cw x foot + 10 mm z -25 mm center i 5 mm k 0 mm\n"
    "    cut x 60 mm z -40 mm\n    arc ccw x 80 mm z -50 mm radius 10 mm\n    cut z -60 mm\n    cut x 104 mm\n  end\n";

std::vector<Turned> shaft(double foot) {
  std::vector<Turned> out = {{foot / 2.0, 0.0}};
  add_line(out, {foot / 2.0, -20.0});
  add_arc(out, {foot / 2.0 + 5.0, -20.0}, 5.0, -90.0, -180.0);
  out.back() = {foot / 2.0 + 5.0, -25.0};
  add_line(out, {30.0, -40.0});
  add_arc(out, {30.0, -50.0}, 10.0, 0.0, 90.0);
  add_line(out, {40.0, -60.0});
  add_line(out, {52.0, -60.0});
  return out;
}

TEST(FamilyRoughing, PassesEndWhereTheyMeetLinesAndArcs) {
  for (const double deep : {0.7, 3.0, 9.0, 60.0})
    for (const double left : {0.0, 0.25, 2.0})
      for (const double foot : {4.0, 30.0, 49.0}) {
        SCOPED_TRACE(fmt::format("deep {} left {} foot {}", deep, left, foot));
        Job job{.sides = {}, .contour = shaft(foot), .begin = {50.0, 2.0}, .depth = deep, .left = {left, left / 2.0}};
        // The fillet: a quarter around its center, on the side of smaller x and z.
        expect_roughed(turned_part(kShaft), job,
                       {{"deep", fmt::format("{} mm", deep)},
                        {"stays", fmt::format("{} mm", left)},
                        {"foot", fmt::format("{} mm", foot)}});
      }
}

TEST(FamilyRoughing, InsideItCutsOutward) {
  const std::string steps =
      "  rapid x 18 mm z 5 mm\n  rough inside x 20 mm z 2 mm depth deep retract 0.5 mm allowance x stays z stays\n"
      "    cut x 60 mm z 0 mm\n    cut x 50 mm z -10 mm\n    arc cw x 40 mm z -15 mm center i 0 mm k -5 mm\n    cut z "
      "-30 mm\n"
      "    arc ccw x 30 mm z -35 mm radius 5 mm\n    cut x 18 mm\n  end\n";
  std::vector<Turned> bore = {{30.0, 0.0}};
  add_line(bore, {25.0, -10.0});
  add_arc(bore, {25.0, -15.0}, 5.0, 0.0, -90.0);
  bore.back() = {20.0, -15.0};
  add_line(bore, {20.0, -30.0});
  add_arc(bore, {15.0, -30.0}, 5.0, 90.0, 180.0);
  bore.back() = {15.0, -35.0};
  add_line(bore, {9.0, -35.0});
  for (const double deep : {0.6, 3.0, 40.0}) {
    SCOPED_TRACE(deep);
    expect_roughed(
        turned_part(steps),
        {.sides = {.inside = true}, .contour = bore, .begin = {10.0, 2.0}, .depth = deep, .left = {0.25, 0.25}},
        {{"deep", fmt::format("{} mm", deep)}});
  }
}

TEST(FamilyRoughing, FacingGoesAlongX) {
  const std::string steps =
      "  rapid x 110 mm z 5 mm\n  rough facing x 106 mm z 1 mm depth deep retract 1 mm allowance x stays z stays\n"
      "    cut x 104 mm z -20 mm\n    cut x 80 mm\n    arc ccw x 70 mm z -15 mm center i 0 mm k 5 mm\n    cut x 40 mm "
      "z "
      "-8 mm\n"
      "    arc cw x 24 mm z 0 mm radius 8 mm\n    cut z 1 mm\n  end\n";
  std::vector<Turned> flange = {{52.0, -20.0}};
  add_line(flange, {40.0, -20.0});
  add_arc(flange, {40.0, -15.0}, 5.0, 180.0, 270.0);
  flange.back() = {35.0, -15.0};
  add_line(flange, {20.0, -8.0});
  add_arc(flange, {12.0, -8.0}, 8.0, 90.0, 0.0);
  flange.back() = {12.0, 0.0};
  add_line(flange, {12.0, 1.0});
  for (const double deep : {0.7, 3.0}) {
    SCOPED_TRACE(deep);
    expect_roughed(
        turned_part(steps),
        {.sides = {.facing = true}, .contour = flange, .begin = {53.0, 1.0}, .depth = deep, .left = {0.25, 0.25}},
        {{"deep", fmt::format("{} mm", deep)}});
  }
}

// The bottom of a bore, from the middle outward.
TEST(FamilyRoughing, FacingInsideGoesOutward) {
  const std::string steps =
      "  rapid x 18 mm z 5 mm\n  rough facing inside x 18 mm z 1 mm depth deep retract 1 mm allowance x stays z stays\n"
      "    cut x 20 mm z -20 mm\n    cut x 44 mm\n    arc cw x 54 mm z -15 mm center i 0 mm k 5 mm\n    cut x 84 mm z "
      "-8 mm\n    arc ccw x 100 mm z 0 mm radius 8 mm\n    cut z 1 mm\n  end\n";
  std::vector<Turned> bottom = {{10.0, -20.0}};
  add_line(bottom, {22.0, -20.0});
  add_arc(bottom, {22.0, -15.0}, 5.0, 180.0, 90.0);
  bottom.back() = {27.0, -15.0};
  add_line(bottom, {42.0, -8.0});
  add_arc(bottom, {50.0, -8.0}, 8.0, 270.0, 360.0);
  bottom.back() = {50.0, 0.0};
  add_line(bottom, {50.0, 1.0});
  for (const double deep : {0.7, 3.0}) {
    SCOPED_TRACE(deep);
    expect_roughed(turned_part(steps),
                   {.sides = {.facing = true, .inside = true},
                    .contour = bottom,
                    .begin = {9.0, 1.0},
                    .depth = deep,
                    .left = {0.25, 0.25}},
                   {{"deep", fmt::format("{} mm", deep)}});
  }
}

// Of a contour that is a subprogram, with arguments, and in radii.
TEST(FamilyRoughing, AContourMayBeCalled) {
  const text::Source family = {"test.family",
                               "family test\nmachine lathe, x is radius\nparam deep length 2 mm in 0.1..99\n"
                               "sub wall(low length, far length)\n  cut x low  z 0 mm\n  cut z far\n  cut x low + 8 mm "
                               " z far - 8 mm\n  cut x 30 mm\n"
                               "end\n"
                               "program test\n  spindle 600 rpm cw\n  feed 0.2 mm/rev\n  rapid x 40 mm z 5 mm\n"
                               "  rough x 30 mm z 2 mm depth deep retract 1 mm\n    call wall(10 mm, -15 mm)\n  end\n"
                               "  rapid x 10 mm\n  profile\n    call wall(10 mm, -15 mm)\n  end\nend\n"};
  std::vector<Turned> wall = {{10.0, 0.0}};
  add_line(wall, {10.0, -15.0});
  add_line(wall, {18.0, -23.0});
  add_line(wall, {30.0, -23.0});
  std::vector<ir::Motion> moves = one_trace(family);
  ASSERT_GT(moves.size(), 30U);
  // The fourth pass, at radius 22, and the seventh, on the cone.
  std::vector<double> ends;
  for (std::size_t i = 1; i + 1 < moves.size(); ++i)
    if (moves[i].kind == linear && moves[i - 1].kind == rapid && moves[i + 1].kind == rapid)
      ends.push_back(moves[i].end[2]);
  ASSERT_EQ(ends.size(), 10U);
  EXPECT_NEAR(ends[3], -23.0, 1e-3);
  EXPECT_NEAR(ends[6], -21.0, 1e-3);
  EXPECT_NEAR(ends[9], -15.0, 1e-3);
}

TEST(FamilyRoughing, WhatCannotBeRoughedIsRefused) {
  const auto contour = [](const std::string& steps,
                          const std::string& head = "x 100 mm z 2 mm depth 3 mm retract 1 mm") {
    return turning_fault(turned_part("  rapid x 110 mm z 5 mm\n  rough " + head + "\n" + steps + "  end\n"));
  };
  const std::string good = "    cut x 50 mm z 0 mm\n    cut z -20 mm\n    cut x 104 mm\n";
  EXPECT_EQ(contour(good), "");
  const std::vector<std::pair<std::string, std::string>> wrong = {
      {contour("    cut x 50 mm z 0 mm\n    cut x 40 mm z -20 mm\n    cut x 104 mm\n"), "turns back here"},
      {contour("    cut x 50 mm z 0 mm\n    cut x 60 mm z 1 mm\n    cut x 104 mm\n"), "turns back here"},
      {contour("    cut x 50 mm z 0 mm\n    cut z -20 mm\n    cut x 90 mm\n"), "ends before x"},
      {contour("    cut x 100 mm z 0 mm\n    cut z -20 mm\n    cut x 104 mm\n"), "nothing to rough"},
      {contour("    cut x 50 mm z 4 mm\n    cut z -20 mm\n    cut x 104 mm\n"), "begins beyond z"},
      {contour("    cut x 50 mm z 0 mm\n"), "a cut to its start and one further"},
      {contour("    cut x 50 mm z 0 mm\n    arc cw x 80 mm z -5 mm center i 15 mm k 0 mm\n    cut x 104 mm\n"),
       "not equally far"},
      {contour("    cut x 50 mm z 0 mm\n    arc ccw x 70 mm z -10 mm center i 10 mm k 0 mm\n    cut x 104 mm\n"),
       "turns back: make it of quarters"},
      {contour("    cut x 50 mm z 0 mm\n    arc cw x 80 mm z -40 mm radius 9 mm\n    cut x 104 mm\n"),
       "does not reach"},
      {contour("    cut x 50 mm z 0 mm\n    cut z -20 mm rounding 1 mm\n    cut x 104 mm\n"),
       "a chamfer or a rounding"},
      {contour("    cut x 50 mm z 0 mm\n    rapid z -20 mm\n    cut x 104 mm\n"), "stand only cut, arc, let"},
      {contour("    for n from 1 to 2 step 1\n    cut x n*1 mm\n  end\n"), "stand only cut, arc, let"},
      {contour("    arc cw x 50 mm z 0 mm radius 90 mm\n    cut x 104 mm\n"), "begins with a cut"},
      {contour(good, "x 100 mm z 2 mm depth 0 mm retract 1 mm"), "depth of cut of 'rough' is above 0"},
      {contour(good, "x 100 mm z 2 mm depth 1 mm retract 0 mm"), "retract of 'rough' is above 0"},
      {contour(good, "x 100 mm z 2 mm depth 1 mm retract 1 mm allowance x -1 mm z 0 mm"), "not below 0"},
      {contour(good, "x 100 mm z 2 mm depth 0.001 mm retract 1 mm"), "more than 10,000 passes"},
      {contour(good, "x 100 mm depth 1 mm retract 1 mm"), "expected 'z'"},
      {turning_fault(turned_part("  let here = 50 mm\n  set here = 40 mm\n  rough x 100 mm z 2 mm depth 3 mm retract 1 "
                                 "mm\n    cut x here z 0 mm\n"
                                 "    cut x 104 mm\n  end\n")),
       "checked before the program runs"},
      {turning_fault(turned_part("  compensate left\n  cut x 9 mm\n  rough x 100 mm z 2 mm depth 3 mm retract 1 mm\n" +
                                 good + "  end\n")),
       "compensate off"},
      {turning_fault(with("", "  rough x 100 mm z 2 mm depth 3 mm retract 1 mm\n" + good + "  end\n")),
       "on a mill 'face'"}};
  for (const auto& [found, wanted] : wrong) EXPECT_TRUE(found.contains(wanted)) << wanted << ": " << found;
}

}  // namespace
}  // namespace dripfeed::compile::test
