// Contours that are moved aside, in all dialects and both forms. Oracle: the contour as places close together, and the
// distance of every place of the path from all of them; and each of its places, moved along its normal, lies on the
// path unless it comes too near to another one.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/unit/dialects/compile/milled_region.h"
#include "tests/unit/dialects/compile/render/family_run.h"

namespace dripfeed::compile::test {
namespace {

using enum ir::MotionKind;

constexpr double kSpacing_mm = 0.02;
constexpr double kAllowed_mm = 0.006;  // what is printed is rounded, and so are the ends of arcs

// A place of a contour and the direction in which it leads there.
struct Along {
  double x = 0.0, y = 0.0;
  double dx = 0.0, dy = 0.0;
};
struct Source {
  std::string text;                        // its cuts and arcs
  std::vector<std::string> numbers;        // of its parameters
  std::vector<std::vector<Along>> pieces;  // its elements
};

class Contours {
 public:
  explicit Contours(unsigned seed) : random_(seed) {}
  double between(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }
  bool chance(double share) { return between(0.0, 1.0) < share; }

  // Lines and arcs of every kind of corner; numbers as parameters or as they are.
  Source next(bool by_parameters, bool is_closed) {
    Source out;
    const double x0 = rounded(between(-20.0, 20.0));
    const double y0 = rounded(between(-20.0, 20.0));
    double x = x0;
    double y = y0;
    double heading = between(-std::numbers::pi, std::numbers::pi);
    const auto number = [&](double value) {
      if (!by_parameters) return fmt::format("{} mm", value);
      out.numbers.push_back(fmt::format("{} mm", value));
      return fmt::format("p{}", out.numbers.size() - 1);
    };
    out.text = fmt::format("    cut x {} y {}\n", number(x), number(y));
    const int count = std::uniform_int_distribution<int>(1, 5)(random_);
    for (int n = 0; n < count; ++n) {
      if (chance(0.75)) heading += between(-2.2, 2.2);  // else smooth
      const double length = between(4.0, 25.0);
      if (chance(0.5)) {
        line(out, x, y, rounded(x + length * std::cos(heading)), rounded(y + length * std::sin(heading)), number);
      } else if (chance(0.25)) {
        line(out, x, y, chance(0.5) ? rounded(x + length) : rounded(x - length), y, number);
      } else {
        heading = arc(out, x, y, heading, number);
      }
    }
    if (is_closed && std::hypot(x - x0, y - y0) > 2.0) line(out, x, y, x0, y0, number);
    return out;
  }

 private:
  static double rounded(double value) { return std::round(value * 1000.0) / 1000.0; }

  template <class Number>
  static void line(Source& out, double& x, double& y, double to_x, double to_y, const Number& number) {
    out.text += to_y == y ? fmt::format("    cut x {}\n", number(to_x))
                          : fmt::format("    cut x {} y {}\n", number(to_x), number(to_y));
    std::vector<Along> places;
    const double length = std::hypot(to_x - x, to_y - y);
    const int steps = std::max(2, static_cast<int>(length / kSpacing_mm));
    for (int n = 0; n <= steps; ++n)
      places.push_back(
          {x + (to_x - x) * n / steps, y + (to_y - y) * n / steps, (to_x - x) / length, (to_y - y) / length});
    out.pieces.push_back(std::move(places));
    x = to_x;
    y = to_y;
  }

  // Returns where it leads at its end.
  template <class Number>
  double arc(Source& out, double& x, double& y, double heading, const Number& number) {
    const bool clockwise = chance(0.5);
    const double radius = between(1.0, 15.0);
    const double sweep = between(0.2, 5.0);
    const double side = clockwise ? -1.0 : 1.0;
    const double i = rounded(-side * radius * std::sin(heading));
    const double j = rounded(side * radius * std::cos(heading));
    const double r = std::hypot(i, j);
    const double begin = std::atan2(-j, -i);
    const double to_x = rounded(x + i + r * std::cos(begin + side * sweep));
    const double to_y = rounded(y + j + r * std::sin(begin + side * sweep));
    const bool by_radius = sweep < 2.5 && chance(0.4);
    const std::string to = fmt::format("    arc {} x {} y {}", clockwise ? "cw" : "ccw", number(to_x), number(to_y));
    out.text += by_radius ? to + fmt::format(" radius {}\n", number(rounded(r)))
                          : to + fmt::format(" center i {} j {}\n", number(i), number(j));
    std::vector<Along> places;
    const int steps = std::max(2, static_cast<int>(r * sweep / kSpacing_mm));
    for (int n = 0; n <= steps; ++n) {
      const double at = begin + side * sweep * n / steps;
      places.push_back({x + i + r * std::cos(at), y + j + r * std::sin(at), -side * std::sin(at), side * std::cos(at)});
    }
    out.pieces.push_back(std::move(places));
    x = to_x;
    y = to_y;
    return heading + side * sweep;
  }

  std::mt19937 random_;
};

text::Source family_of(const Source& source, bool is_left, double distance) {
  std::string declarations;
  for (std::size_t n = 0; n < source.numbers.size(); ++n)
    declarations += fmt::format("param p{} length {} in -500..500\n", n, source.numbers[n]);
  return with(declarations + fmt::format("param aside length {} mm in 0..100\n", distance),
              "  rapid x 90 mm y 90 mm z 0 mm\n  offset " + std::string(is_left ? "left" : "right") + " aside\n" +
                  source.text + "  end\n");
}

double distance_of(const Source& source, double x, double y) {
  double least = 1e18;
  for (const std::vector<Along>& piece : source.pieces)
    for (const Along& one : piece) least = std::min(least, (one.x - x) * (one.x - x) + (one.y - y) * (one.y - y));
  return std::sqrt(least);
}

// The path, without the move to its start.
std::vector<Spot> path_of(const std::vector<ir::Motion>& moves, double spacing_mm) {
  std::vector<Spot> out;
  bool is_first = true;
  for (const ir::Motion& one : moves) {
    if (one.kind == rapid) continue;
    if (!std::exchange(is_first, false))
      for (const Spot& at : spots_of(one, spacing_mm)) out.push_back(at);
  }
  return out;
}

// Of each element: how much of it, moved along its normal, keeps the distance; and in how many stretches.
struct Left {
  double share = 0.0;
  int stretches = 0;
};
// Of the arc around an outer corner.
Left left_of_corner(const Source& source, const Along& before, const Along& after, bool is_left, double distance) {
  const double side = is_left ? 1.0 : -1.0;
  const double turn =
      std::atan2(before.dx * after.dy - before.dy * after.dx, before.dx * after.dx + before.dy * after.dy);
  if (side * turn >= 0.0) return {1.0, 1};
  const double begin = std::atan2(side * before.dx, -side * before.dy);
  Left out{0.0, 1};
  for (int n = 0; n <= 100; ++n) {
    const double angle = begin + turn * n / 100.0;
    const double keeps =
        distance_of(source, after.x + distance * std::cos(angle), after.y + distance * std::sin(angle));
    out.share += keeps > distance - 1e-3 ? 1.0 / 101.0 : 0.0;
  }
  return out;
}

std::vector<Left> left_of(const Source& source, bool is_left, double distance, std::vector<Spot>& moved) {
  std::vector<Left> out;
  for (const std::vector<Along>& piece : source.pieces) {
    Left left;
    bool before = false;
    const std::size_t step = std::max<std::size_t>(piece.size() / 150, 1);
    std::size_t tried = 0;
    for (std::size_t n = 0; n < piece.size() + step - 1; n += step, ++tried) {
      const Along& one = piece[std::min(n, piece.size() - 1)];
      const double side = is_left ? 1.0 : -1.0;
      const Spot at{one.x - side * distance * one.dy, one.y + side * distance * one.dx, 0.0};
      const bool keeps = distance_of(source, at.x, at.y) > distance - 1e-3;
      if (keeps) {
        moved.push_back(at);
        left.share += 1.0;
        left.stretches += before ? 0 : 1;
      }
      before = keeps;
    }
    left.share /= static_cast<double>(tried);
    out.push_back(left);
  }
  for (std::size_t n = 1; n < source.pieces.size(); ++n)
    out.push_back(left_of_corner(source, source.pieces[n - 1].back(), source.pieces[n].front(), is_left, distance));
  return out;
}

double aside_of(const std::vector<Spot>& path, const Spot& at) {
  double least = 1e18;
  for (const Spot& one : path)
    least = std::min(least, (one.x - at.x) * (one.x - at.x) + (one.y - at.y) * (one.y - at.y));
  return std::sqrt(least);
}

std::string fault_in(const text::Source& family, const Values& values = {}) {
  const RenderResult result = rendered(family, "fanuc", RenderMode::macro, values);
  return result.diagnostics.empty() ? "" : messages_of({result.diagnostics.front()}, family);
}

TEST(FamilyOffset, EveryPlaceHasTheDistance) {
  Contours contours(2511);
  int moved_count = 0;
  int refused_count = 0;
  for (int trial = 0; trial < 240; ++trial) {
    const Source source = contours.next(trial % 2 == 0, trial % 3 == 0);
    const bool is_left = contours.chance(0.5);
    const double distance = std::round(contours.between(0.1, 5.0) * 100.0) / 100.0;
    const text::Source family = family_of(source, is_left, distance);
    SCOPED_TRACE(fmt::format("trial {}\n{}", trial, family.text()));
    std::vector<Spot> wanted;
    const std::vector<Left> left = left_of(source, is_left, distance, wanted);
    if (const std::string fault = fault_in(family); !fault.empty()) {
      if (fault.contains("turns back on itself")) continue;
      ++refused_count;
      // There is a reason: an element that vanishes, is divided, or loses most of its length.
      EXPECT_TRUE(std::ranges::any_of(left, [](const Left& one) {
        return one.share < 1.0 - 1e-9 || one.stretches != 1;
      })) << fault;
      continue;
    }
    ++moved_count;
    std::vector<ir::Motion> moves;
    if (trial % 5 == 0) {
      moves = one_trace(family);
    } else {
      const RenderResult result = rendered(family, "fanuc", RenderMode::macro, {});
      moves = moves_of(run_text(result.text, control("fanuc", ir::MachineKind::mill)).motions);
    }
    const std::vector<Spot> path = path_of(moves, 0.05);
    ASSERT_FALSE(path.empty());
    for (std::size_t n = 0; n < path.size(); n += 5)
      ASSERT_NEAR(distance_of(source, path[n].x, path[n].y), distance, kAllowed_mm) << path[n].x << " " << path[n].y;
    for (const Spot& at : wanted) ASSERT_LT(aside_of(path, at), 0.06) << at.x << " " << at.y;
  }
  EXPECT_GT(moved_count, 70);
  EXPECT_GT(refused_count, 40);
}

// Lathes: x is a diameter, left and right are those of z and x; in a rough and on a face, too.
TEST(FamilyOffset, OnALatheItIsThatOfTheProfile) {
  for (const std::string x_is : {"diameter", "radius"}) {
    const int two = x_is == "diameter" ? 2 : 1;
    const text::Source family = {
        "test.family", fmt::format("family test\nmachine lathe, x is {}\nparam aside length 1.5 mm in 0..9\n"
                                   "sub shape\n  cut x {} mm z 0 mm\n  cut z -10 mm\n  cut x {} mm z -14 mm\n"
                                   "  arc cw x {} mm z -20 mm center i {} mm k 0 mm\n  cut x {} mm\nend\n"
                                   "program test\n  spindle 600 rpm cw\n  feed 0.2 mm/rev\n  rapid x 90 mm z 9 mm\n"
                                   "  profile\n  offset right aside\n    call shape\n  end\n  end\nend\n",
                                   x_is, 10 * two, 13 * two, 19 * two, 6, 30 * two)};
    const std::vector<ir::Motion> moves = one_trace(family);
    std::vector<std::array<double, 2>> ends;
    for (const ir::Motion& one : moves)
      if (one.kind != rapid) ends.push_back({one.end[0] / 2.0, one.end[2]});
    // Along x 10; the inner corner of 36.87 degrees; the outer one before the fillet, which shrinks; up.
    const double tilt = std::atan2(3.0, 4.0);
    const std::vector<std::array<double, 2>> wanted = {{11.5, 0.0},
                                                       {11.5, -10.0 + 1.5 * std::tan(tilt / 2.0)},
                                                       {13.0 + 1.5 * std::cos(tilt), -14.0 + 1.5 * std::sin(tilt)},
                                                       {13.0 + 1.5, -14.0},
                                                       {19.0, -20.0 + 1.5},
                                                       {30.0, -20.0 + 1.5}};
    ASSERT_EQ(ends.size(), wanted.size()) << family.text();
    for (std::size_t n = 0; n < wanted.size(); ++n) {
      EXPECT_NEAR(ends[n][0], wanted[n][0], 1e-3) << n;
      EXPECT_NEAR(ends[n][1], wanted[n][1], 1e-3) << n;
    }
  }
}

TEST(FamilyOffset, RoughingLeavesTheDistanceEverywhere) {
  const std::string contour =
      "    cut x 20 mm z 0 mm\n    cut z -10 mm\n    cut x 26 mm z -14 mm\n    arc cw x 38 mm z -20 mm center i 6 mm k "
      "0 "
      "mm\n    cut x 44 mm\n    cut z -30 mm\n    cut x 104 mm\n";
  const text::Source family = {"test.family",
                               "family test\nmachine lathe, x is diameter\nparam aside length 0.8 mm in 0..9\n"
                               "program test\n  spindle 600 rpm cw\n  feed 0.2 mm/rev\n  rapid x 110 mm z 9 mm\n"
                               "  rough x 100 mm z 2 mm depth 2 mm retract 1 mm\n  offset right aside\n" +
                                   contour + "  end\n  end\nend\n"};
  // The contour on the radius, z first.
  Source source;
  const std::vector<std::array<double, 2>> corners = {{0, 10},   {-10, 10}, {-14, 13}, {-20, 19},
                                                      {-20, 22}, {-30, 22}, {-30, 52}};
  for (std::size_t n = 1; n < corners.size(); ++n) {
    std::vector<Along> places;
    for (int k = 0; k <= 4000; ++k) {
      const double t = k / 4000.0;
      if (n == 3)
        places.push_back({-14 - 6 * std::sin(t * std::numbers::pi / 2), 19 - 6 * std::cos(t * std::numbers::pi / 2)});
      else
        places.push_back({corners[n - 1][0] + t * (corners[n][0] - corners[n - 1][0]),
                          corners[n - 1][1] + t * (corners[n][1] - corners[n - 1][1])});
    }
    source.pieces.push_back(std::move(places));
  }
  const std::vector<ir::Motion> moves = one_trace(family);
  int passes = 0;
  std::size_t last_cut = 0;
  for (std::size_t n = 1; n < moves.size(); ++n)
    if (moves[n].kind != rapid) last_cut = n;
  for (std::size_t n = 1; n < moves.size(); ++n) {
    const ir::Motion& one = moves[n];
    if (one.kind == rapid) continue;
    const double off = distance_of(source, one.end[2], one.end[0] / 2.0);
    EXPECT_GT(off, 0.8 - kAllowed_mm) << n;
    const bool is_pass = moves[n - 1].kind == rapid && n + 1 < moves.size() && moves[n + 1].kind == rapid;
    if (!is_pass) continue;
    EXPECT_NEAR(off, 0.8, kAllowed_mm) << n;  // it ends at the moved contour
    ++passes;
  }
  EXPECT_EQ(passes, 20);
  EXPECT_GT(last_cut, 0U);
}

TEST(FamilyOffset, ItStandsInSubprogramsCopiesAndFaces) {
  // Two calls with distances of their own, mirrored and turned.
  const std::string steps =
      "  rapid x 0 mm y 0 mm z 0 mm\n  repeat 2 turn 180 deg at x 0 mm y 0 mm\n    mirror x\n      call around(1 mm)\n"
      "    end\n    call around(twice)\n  end\n";
  const std::string sub =
      "param wide length 20 mm in 5..50\nlet twice = wide/10\nsub around(by_ length)\n  offset left by_\n"
      "    cut x wide  y 0 mm\n    cut x wide  y 10 mm\n    arc cw x wide + 5 mm y 15 mm center i 5 mm j 0 mm\n"
      "    cut x wide + 20 mm  y 15 mm\n  end\nend\n";
  const std::vector<ir::Motion> moves = one_trace(with(sub, steps));
  std::vector<std::array<double, 2>> ends;
  for (const ir::Motion& one : moves)
    if (one.kind != rapid) ends.push_back({one.end[0], one.end[1]});
  const std::vector<std::array<double, 2>> first = {{-19, 0}, {-19, 10}, {-25, 16}, {-40, 16}};
  const std::vector<std::array<double, 2>> second = {{18, 0}, {18, 10}, {25, 17}, {40, 17}};
  ASSERT_EQ(ends.size(), 16U);
  for (std::size_t n = 0; n < 4; ++n)
    for (std::size_t axis = 0; axis < 2; ++axis) {
      EXPECT_NEAR(ends[n][axis], first[n][axis], 1e-3) << n;
      EXPECT_NEAR(ends[n + 4][axis], second[n][axis], 1e-3) << n;
      EXPECT_NEAR(ends[n + 8][axis], -first[n][axis], 1e-3) << n;
      EXPECT_NEAR(ends[n + 12][axis], -second[n][axis], 1e-3) << n;
    }
  const text::Source face = {"test.family",
                             "family test\nmachine lathe, x is diameter\nprogram test\n  spindle 600 rpm cw\n"
                             "  feed 90 mm/min\n  rapid x 90 mm z 2 mm\n  polar\n  cut x 80 mm y 0 mm\n"
                             "  offset right 3 mm\n    cut x 40 mm y 0 mm\n    cut x 0 mm y 20 mm\n"
                             "    cut x -40 mm y 0 mm\n  end\n  cut x 80 mm y 50 mm\n  end\nend\n"};
  ir::Control control_with_c = control("fanuc", ir::MachineKind::lathe);
  if (!control_with_c.axes.contains('C')) control_with_c.axes += 'C';
  RenderRequest request;
  request.family = face;
  request.target = control_with_c;
  request.mode = RenderMode::macro;
  const RenderResult result = render(request);
  EXPECT_TRUE(result.diagnostics.empty()) << messages_of(result.diagnostics, face);
  EXPECT_TRUE(result.text.contains("G03")) << result.text;
}

TEST(FamilyOffset, WhatCannotBeMovedIsRefused) {
  const auto fault = [](const std::string& contour, const std::string& head = "left 2 mm") {
    return fault_in(with("", "  rapid x 0 mm y 0 mm z 0 mm\n  offset " + head + "\n" + contour + "  end\n"));
  };
  const std::string start = "    cut x 0 mm y 0 mm\n";
  EXPECT_EQ(fault(start + "    cut x 9 mm\n"), "");
  EXPECT_EQ(fault(start + "    cut x 9 mm\n", "right 0 mm"), "");
  const std::vector<std::pair<std::string, std::string>> wrong = {
      {fault(start), "a cut to its start and one further"},
      {fault("    cut x 0 mm\n    cut x 9 mm\n"), "names both axes"},
      {fault("    cut x by 1 mm y 0 mm\n    cut x 9 mm\n"), "names both axes"},
      {fault(start + "    cut x 9 mm z -1 mm\n"), "the two axes of its plane alone"},
      {fault(start + "    cut x 9 mm rounding 1 mm\n    cut y 9 mm\n"), "the two axes of its plane alone"},
      {fault(start + "    rapid x 9 mm\n"), "stand only cut, arc, let"},
      {fault(start + "    skip cut x 9 mm\n"), "not skipped in parts"},
      {fault(start + "    cut x 9 mm\n    offset left 1 mm\n    end\n"), "in the contour of another one"},
      {fault(start + "    cut x 9 mm\n", "up 1 mm"), "left or right"},
      {fault(start + "    cut x 9 mm\n", "left -1 mm"), "is not below 0"},
      {fault(start + "    cut x 9 mm\n    cut x 2 mm\n"), "turns back on itself"},
      {fault(start + "    cut x 9 mm\n    cut x 9 mm\n"), "has no length"},
      {fault(start + "    arc ccw x 2 mm y 2 mm center i 0 mm j 2 mm\n"), "this arc vanishes"},
      {fault(start + "    arc ccw x 9 mm y 2 mm center i 0 mm j 4 mm\n"), "not equally far"},
      {fault(start + "    arc cw x 9 mm y 0 mm radius 4 mm\n"), "does not reach"},
      {fault(start + "    cut x 20 mm\n    cut x 21 mm y 1 mm\n    cut y 20 mm\n"), "this line vanishes"},
      {fault(start + "    cut x 20 mm\n    cut x 30 mm y 30 mm\n    cut x -5 mm\n    cut x 10 mm y 1 mm\n"),
       "comes as near as"},
      {fault(start + "    cut x 20 mm y 0 mm\n    arc ccw x 20 mm y 10 mm center i 0 mm j 5 mm\n", "left 5.5 mm"),
       "this arc vanishes"},
      {fault_in(with(
           "", "  let wide = 1 mm\n  set wide = wide*2\n  offset left wide\n" + start + "    cut x 9 mm\n  end\n")),
       "depend on parameters only"},
      {fault_in(with("", "  plane zx\n  offset left 1 mm\n" + start + "    cut x 9 mm\n  end\n")),
       "plane xy before it"},
      {fault_in(
           with("sub twice(up length)\n  offset left 1 mm\n    cut x 0 mm y 0 mm\n    cut x 9 mm y up\n    cut x 18 "
                "mm y 0 mm\n  end\nend\n",
                "  call twice(5 mm)\n  call twice(-5 mm)\n")),
       "the calls of this contour differ"}};
  for (const auto& [found, wanted] : wrong) EXPECT_TRUE(found.contains(wanted)) << wanted << ": " << found;
}

}  // namespace
}  // namespace dripfeed::compile::test
