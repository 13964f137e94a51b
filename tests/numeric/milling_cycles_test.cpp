// What SINUMERIK's milling cycles remove, seen by a check that knows nothing of cycles: their motions cut a block on
// the height map of checks/gouge, and each place of the map is compared with the drawing of the form, at 480 seeded
// calls. Nothing outside of the form may be cut, all of it lies at the base or the allowance above, and no rapid
// touches material. Programming Manual Cycles (PGZ), "Milling cycles".
#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "checks/gouge/milling.h"
#include "dialects/compile/dialect/dialect.h"
#include "dialects/compile/dialect/execute.h"
#include "dialects/text/number.h"
#include "tests/unit/dialects/compile/milled_region.h"

namespace dripfeed {
namespace {

using compile::test::RoundRectangle;

constexpr double kStep_mm = 0.4;
constexpr double kSame_mm = 1e-6;
// Of the map's arcs, which are chords, and of what rings may leave between them.
constexpr double kWall_mm = 0.02;
constexpr double kTop_mm = 0.0;

struct Left {
  gouge::HeightMap::Grid grid;
  gouge::Report report;

  template <class Visit>
  void for_places(Visit&& visit) const {
    for (std::size_t row = 0; row < grid.rows; ++row)
      for (std::size_t column = 0; column < grid.columns; ++column)
        visit(compile::test::Spot{grid.x_low + (static_cast<double>(column) + 0.5) * kStep_mm,
                                  grid.y_low + (static_cast<double>(row) + 0.5) * kStep_mm, 0.0},
              grid.heights[row * grid.columns + column]);
  }
};

gouge::Blank block(double half_x = 60.0, double half_y = 60.0) {
  return {.x = {-half_x, half_x}, .y = {-half_y, half_y}, .z = {-30.0, kTop_mm}};
}

Left mill(const std::string& calls, double radius_mm, const gouge::Blank& blank) {
  const compile::Dialect* dialect = compile::find_dialect("sinumerik-840d");
  ir::Control control = dialect->control(ir::MachineKind::mill, ir::GSystem::a);
  control.tool_radii = {{.tool = 1, .offset = 1, .radius_mm = radius_mm}};
  const text::Source source("cycle.mpf",
                            "G17 G90 G94 G54 G71 G40\nT1 D1 M6\nS1000 M3 F200\nG0 X0 Y0 Z100\n" + calls + "M30\n");
  const ir::ReadResult read = dialect->read(source, control);
  EXPECT_FALSE(text::has_error(read.diagnostics)) << source.text();
  gouge::MillingSettings settings;
  settings.stock = blank;
  settings.tools = {{.number = 1, .offset = 1, .diameter_mm = 2.0 * radius_mm}};
  settings.step_mm = kStep_mm;
  gouge::Milling milling(settings);
  const auto run = compile::execute(read.program, control, nullptr, milling, {});
  EXPECT_EQ(run.ended, interpreter::Ended::end) << source.text();
  for (const interpreter::NotInterpreted& one : run.not_interpreted) EXPECT_TRUE(one.is_model) << one.name;
  gouge::Report report = milling.finish();
  EXPECT_EQ(milling.map()->step_mm(), kStep_mm);
  return {milling.map()->grid(), std::move(report)};
}

std::string n(double value) { return text::format_shortest(value); }

// Numbers of two decimals, as people write them.
class Dice {
 public:
  explicit Dice(unsigned seed) : random_(seed) {}
  double between(double low, double high) {
    return std::round(std::uniform_real_distribution(low, high)(random_) * 100.0) / 100.0;
  }
  int one_of(int count) { return std::uniform_int_distribution(0, count - 1)(random_); }

 private:
  std::mt19937 random_;
};

// By the distance from the nearest of the forms, negative within: cut to `base` where it is less than 0, and not at all
// where it is more.
template <class Form>
void expect_emptied(const Left& left, const std::vector<Form>& forms, double base) {
  std::size_t cut_outside = 0;
  std::size_t left_inside = 0;
  std::string worst;
  left.for_places([&](const compile::test::Spot& at, double height) {
    double nearest = 1e9;
    for (const Form& form : forms) nearest = std::min(nearest, form.distance(at));
    const bool outside = nearest > kWall_mm && height < kTop_mm - kSame_mm;
    const bool inside = nearest < -kWall_mm && std::abs(height - base) > kSame_mm;
    if ((outside || inside) && worst.empty()) worst = fmt::format("x {} y {} z {}, {}", at.x, at.y, height, nearest);
    cut_outside += outside ? 1U : 0U;
    left_inside += inside ? 1U : 0U;
    EXPECT_GE(height, base - kSame_mm);
  });
  EXPECT_EQ(cut_outside, 0U) << worst;
  EXPECT_EQ(left_inside, 0U) << worst;
  EXPECT_TRUE(left.report.findings.empty());
  EXPECT_FALSE(left.report.has_unjudged_cuts);
}

// --- pockets

struct Pocket {
  RoundRectangle form;  // as drawn
  double depth = 0.0;
  double infeed = 0.0;
  double side = 0.0;
  double base = 0.0;
  double step = 0.0;
  double helix = 0.0;
  double turn = 0.0;
  int direction = 0;
  int entry = 1;

  // PGZ, POCKET3: what cuts is in the units of VARI.
  [[nodiscard]] std::string rectangle(int kind) const {
    return fmt::format("POCKET3(20,0,2,{},{},{},{},{},{},{},{},{},{},300,100,{},{},{},0,0,0,{},{})\n", n(-depth),
                       n(form.length), n(form.width), n(form.corner), n(form.x), n(form.y), n(form.angle_deg),
                       n(infeed), n(side), n(base), direction, 10 * entry + kind, n(step), n(helix), n(turn));
  }
  // PGZ, POCKET4.
  [[nodiscard]] std::string circle(int kind) const {
    return fmt::format("POCKET4(20,0,2,{},{},{},{},{},{},{},300,100,{},{},{},0,0,{},{})\n", n(-depth),
                       n(form.length / 2.0), n(form.x), n(form.y), n(infeed), n(side), n(base), direction,
                       10 * entry + kind, n(step), n(helix), n(turn));
  }
  // As far as the tool reaches into corners.
  [[nodiscard]] RoundRectangle emptied(double allowance, double radius) const {
    RoundRectangle out = form;
    out.length -= 2.0 * allowance;
    out.width -= 2.0 * allowance;
    out.corner = std::max(form.corner - allowance, radius);
    return out;
  }
};

Pocket any_pocket(Dice& dice, double radius, bool is_round) {
  Pocket p;
  p.form = {.length = dice.between(2.2 * radius + 1.0, 70.0),
            .width = dice.between(2.2 * radius + 1.0, 70.0),
            .x = dice.between(-8.0, 8.0),
            .y = dice.between(-8.0, 8.0)};
  if (is_round) p.form.length = p.form.width = 2.0 * std::round(p.form.length * 50.0) / 100.0;
  const double half = std::min(p.form.length, p.form.width) / 2.0;
  const int corners = dice.one_of(3);
  p.form.corner = is_round ? half : corners == 0 ? 0.0 : dice.between(0.0, half - 0.01);
  p.form.angle_deg = is_round ? 0.0 : dice.between(-180.0, 180.0);
  p.depth = dice.between(1.0, 25.0);
  p.infeed = dice.one_of(5) == 0 ? 0.0 : dice.between(0.8, 9.0);
  p.side = dice.one_of(3) == 0 ? 0.0 : dice.between(0.05, std::min(0.6, half - radius - 0.05));
  p.base = dice.one_of(3) == 0 ? 0.0 : dice.between(0.05, 0.6);
  p.step = dice.one_of(2) == 0 ? 0.0 : dice.between(0.3 * radius, 2.0 * radius);
  p.direction = dice.one_of(4);
  p.entry = 1 + dice.one_of(3);
  p.helix = p.entry == 2 ? dice.between(0.5, 3.0 * radius) : dice.between(1.0, 8.0);
  p.turn = dice.between(0.5, 3.0);
  return p;
}

void check_pockets(bool is_round, unsigned seed) {
  Dice dice(seed);
  for (int trial = 0; trial < 60; ++trial) {
    const double radius = dice.between(1.5, 8.0);
    const Pocket p = any_pocket(dice, radius, is_round);
    const std::string rough = is_round ? p.circle(1) : p.rectangle(1);
    const std::string finish = is_round ? p.circle(2) : p.rectangle(2);
    SCOPED_TRACE(rough + n(radius));
    expect_emptied(mill(rough, radius, block()), std::vector{p.emptied(p.side, radius)}, p.base - p.depth);
    if (trial % 2 == 0)
      expect_emptied(mill(rough + finish, radius, block()), std::vector{p.emptied(0.0, radius)}, -p.depth);
    if (testing::Test::HasFailure()) return;
  }
}

TEST(MilledMaterial, RectangularPockets) { check_pockets(false, 3); }
TEST(MilledMaterial, RoundPockets) { check_pockets(true, 5); }

// A finishing call alone cuts along the wall and over the base, and nowhere outside.
TEST(MilledMaterial, FinishingAloneStaysWithinThePocket) {
  Dice dice(11);
  for (int trial = 0; trial < 40; ++trial) {
    const double radius = dice.between(1.5, 8.0);
    const Pocket p = any_pocket(dice, radius, trial % 2 == 0);
    for (const int kind : {2, 4}) {
      const std::string call = trial % 2 == 0 ? p.circle(kind) : p.rectangle(kind);
      SCOPED_TRACE(call + n(radius));
      const RoundRectangle form = p.emptied(0.0, radius);
      mill(call, radius, block()).for_places([&](const compile::test::Spot& at, double height) {
        EXPECT_TRUE(height == kTop_mm || form.distance(at) <= kWall_mm) << at.x << " " << at.y;
        EXPECT_GE(height, -p.depth - kSame_mm);
      });
      if (HasFailure()) return;
    }
  }
}

// --- forms on rays around a centre

struct Rays {
  int count = 1;
  double length = 0.0;
  double width = 0.0;
  double x = 0.0;
  double y = 0.0;
  double from = 0.0;  // the inner end, from the centre
  double first_deg = 0.0;
  double step_deg = 0.0;

  [[nodiscard]] std::vector<RoundRectangle> forms(double allowance) const {
    std::vector<RoundRectangle> out;
    for (int i = 0; i < count; ++i) {
      const double angle_deg = first_deg + i * (step_deg == 0.0 ? 360.0 / count : step_deg);
      const double angle = angle_deg * std::numbers::pi / 180.0;
      out.push_back({.length = length - 2.0 * allowance,
                     .width = width - 2.0 * allowance,
                     .corner = width / 2.0 - allowance,
                     .x = x + (from + length / 2.0) * std::cos(angle),
                     .y = y + (from + length / 2.0) * std::sin(angle),
                     .angle_deg = angle_deg});
    }
    return out;
  }
};

Rays any_rays(Dice& dice, double width) {
  Rays r{.count = 1 + dice.one_of(5),
         .length = dice.between(width + 0.5, width + 15.0),
         .width = width,
         .x = dice.between(-5.0, 5.0),
         .y = dice.between(-5.0, 5.0),
         .from = dice.between(0.0, 12.0),
         .first_deg = dice.between(-180.0, 180.0)};
  if (dice.one_of(2) == 0) r.step_deg = dice.between(20.0, 70.0);
  return r;
}

TEST(MilledMaterial, Slots) {
  Dice dice(17);
  for (int trial = 0; trial < 60; ++trial) {
    const double radius = dice.between(1.5, 5.0);
    const double width = dice.between(2.0 * radius + 0.3, 4.0 * radius);
    const Rays rays = any_rays(dice, width);
    const double depth = dice.between(1.0, 25.0);
    const double side = dice.one_of(2) == 0 ? 0.0 : dice.between(0.05, width / 2.0 - radius - 0.05);
    const double base = dice.one_of(2) == 0 ? 0.0 : dice.between(0.05, 0.6);
    const int kind = dice.one_of(2);  // 0: rough and finish
    const std::string call = fmt::format(
        "SLOT1(20,0,2,{},,{},{},{},{},{},{},{},{},100,300,{},{},{},{},{},0,0,{},{},{})\n", n(-depth), rays.count,
        n(rays.length), n(width), n(rays.x), n(rays.y), n(rays.from), n(rays.first_deg), n(rays.step_deg),
        n(dice.between(0.8, 9.0)), dice.one_of(4), n(side), kind + 10 * (1 + dice.one_of(3)), n(dice.between(1.0, 9.0)),
        n(base), n(dice.between(1.0, 8.0)), n(dice.between(0.3, 2.0)));
    SCOPED_TRACE(call + n(radius));
    expect_emptied(mill(call, radius, block()), rays.forms(kind == 1 ? side : 0.0), (kind == 1 ? base : 0.0) - depth);
    if (HasFailure()) return;
  }
}

TEST(MilledMaterial, LongHoles) {
  Dice dice(19);
  for (int trial = 0; trial < 60; ++trial) {
    const double radius = dice.between(1.5, 6.0);
    const Rays rays = any_rays(dice, 2.0 * radius);
    const double depth = dice.between(1.0, 25.0);
    const std::string call =
        fmt::format("LONGHOLE(20,0,2,,{},{},{},{},{},{},{},{},100,300,{})\n", n(depth), rays.count, n(rays.length),
                    n(rays.x), n(rays.y), n(rays.from), n(rays.first_deg), n(rays.step_deg), n(dice.between(0.8, 9.0)));
    SCOPED_TRACE(call + n(radius));
    expect_emptied(mill(call, radius, block()), rays.forms(0.0), -depth);
    if (HasFailure()) return;
  }
}

// --- slots on a circle

// As drawn: the places no farther than half of the width from an arc.
struct BentForm {
  double x = 0.0;
  double y = 0.0;
  double radius = 0.0;
  double first_deg = 0.0;
  double angle_deg = 0.0;
  double width = 0.0;

  [[nodiscard]] double distance(const compile::test::Spot& at) const {
    constexpr double kDegree = std::numbers::pi / 180.0;
    const double dx = at.x - x;
    const double dy = at.y - y;
    double turned = std::fmod(std::atan2(dy, dx) / kDegree - first_deg, 360.0);
    if (turned < 0.0) turned += 360.0;
    if (turned <= angle_deg) return std::abs(std::hypot(dx, dy) - radius) - width / 2.0;
    const auto from_end = [&](double degrees) {
      return std::hypot(dx - radius * std::cos(degrees * kDegree), dy - radius * std::sin(degrees * kDegree));
    };
    return std::min(from_end(first_deg), from_end(first_deg + angle_deg)) - width / 2.0;
  }
};

struct BentSlots {
  BentForm first;
  int count = 1;
  double step_deg = 0.0;

  [[nodiscard]] std::vector<BentForm> forms(double allowance) const {
    std::vector<BentForm> out(static_cast<std::size_t>(count), first);
    for (int i = 0; i < count; ++i) {
      out[static_cast<std::size_t>(i)].first_deg += i * (step_deg == 0.0 ? 360.0 / count : step_deg);
      out[static_cast<std::size_t>(i)].width -= 2.0 * allowance;
    }
    return out;
  }
};

BentSlots any_bent_slots(Dice& dice, double width, bool is_ring) {
  BentSlots slots;
  slots.first = {.x = dice.between(-5.0, 5.0),
                 .y = dice.between(-5.0, 5.0),
                 .radius = dice.between(width / 2.0 + 0.5, 40.0),
                 .first_deg = dice.between(-180.0, 180.0),
                 .angle_deg = 360.0,
                 .width = width};
  if (is_ring) return slots;
  const double ends_deg = 2.0 * std::asin(width / 2.0 / slots.first.radius) * 180.0 / std::numbers::pi;
  slots.count = 1 + dice.one_of(4);
  double pitch = 360.0 / slots.count;
  if (dice.one_of(2) == 0) pitch = slots.step_deg = dice.between(0.7 * pitch, pitch);
  if (pitch < ends_deg + 8.0) slots.count = 1;
  slots.first.angle_deg = dice.between(1.0, slots.count == 1 ? 340.0 : pitch - ends_deg - 1.0);
  return slots;
}

TEST(MilledMaterial, SlotsOnACircle) {
  Dice dice(37);
  for (int trial = 0; trial < 80; ++trial) {
    const double radius = dice.between(1.5, 5.0);
    const double width = trial % 8 == 0 ? 2.0 * radius : dice.between(2.0 * radius + 0.1, 4.0 * radius);
    const BentSlots slots = any_bent_slots(dice, width, trial % 10 == 0);
    const double depth = dice.between(1.0, 25.0);
    const double side =
        dice.one_of(2) == 0 || width < 2.0 * radius + 0.2 ? 0.0 : dice.between(0.05, width / 2.0 - radius - 0.03);
    const int direction = dice.one_of(4);
    const std::string infeed = n(dice.between(0.8, 9.0));
    const std::string finish_infeed = n(dice.one_of(2) == 0 ? 0.0 : dice.between(1.0, 9.0));
    const BentForm& form = slots.first;
    const auto call = [&](int kind) {
      return fmt::format("SLOT2(20,0,2,{},,{},{},{},{},{},{},{},{},100,300,{},{},{},{},{})\n", n(-depth), slots.count,
                         n(form.angle_deg), n(form.width), n(form.x), n(form.y), n(form.radius), n(form.first_deg),
                         n(slots.step_deg), infeed, direction, n(side), kind, finish_infeed);
    };
    SCOPED_TRACE(call(0) + n(radius));
    expect_emptied(mill(call(0), radius, block()), slots.forms(0.0), -depth);
    if (trial % 2 == 0) expect_emptied(mill(call(1), radius, block()), slots.forms(side), -depth);
    if (trial % 2 == 1) expect_emptied(mill(call(1) + call(2), radius, block()), slots.forms(0.0), -depth);
    if (HasFailure()) return;
  }
}

// --- what is left standing, and faces

// Around the spigot the tool cuts a ring as wide as itself; from beyond the blank it comes in.
void expect_standing(const Left& left, const RoundRectangle& form, double allowance, double radius, double base) {
  left.for_places([&](const compile::test::Spot& at, double height) {
    if (!std::isfinite(height)) return;
    const double off = form.distance(at) - allowance;
    if (off < -kWall_mm) {
      EXPECT_EQ(height, kTop_mm) << at.x << " " << at.y;
    }
    if (off > kWall_mm && off < 2.0 * radius - kWall_mm) {
      EXPECT_NEAR(height, base, kSame_mm) << at.x << " " << at.y;
    }
    EXPECT_GE(height, base - kSame_mm);
  });
  EXPECT_TRUE(left.report.findings.empty());
}

TEST(MilledMaterial, Spigots) {
  Dice dice(23);
  for (int trial = 0; trial < 60; ++trial) {
    const double radius = dice.between(3.0, 8.0);
    const bool is_round = trial % 2 == 0;
    RoundRectangle form = {.length = dice.between(20.0, 45.0), .width = dice.between(20.0, 45.0)};
    if (is_round) form.width = form.length;
    form.corner = is_round ? form.length / 2.0 : dice.between(0.0, std::min(form.length, form.width) / 2.0 - 0.01);
    const double over = dice.between(0.5, radius);  // of the blank, on each side
    const double depth = dice.between(1.0, 25.0);
    const double side = dice.one_of(2) == 0 ? 0.0 : dice.between(0.05, 0.4);
    const double base = dice.one_of(2) == 0 ? 0.0 : dice.between(0.05, 0.6);
    const std::string infeed = n(dice.between(0.8, 9.0));
    const int direction = dice.one_of(4);
    const double length = form.length + 2.0 * over;
    const double width = form.width + 2.0 * over;
    const auto call = [&](int kind) {
      if (is_round)
        return fmt::format("CYCLE77(20,0,2,{},,{},0,0,{},{},{},300,100,{},{},{})\n", n(-depth), n(form.length), infeed,
                           n(side), n(base), direction, kind, n(length));
      return fmt::format("CYCLE76(20,0,2,{},,{},{},{},0,0,0,{},{},{},300,100,{},{},{},{})\n", n(-depth), n(form.length),
                         n(form.width), n(form.corner), infeed, n(side), n(base), direction, kind, n(length), n(width));
    };
    gouge::Blank blank = block(length / 2.0, width / 2.0);
    if (is_round) blank.diameter_mm = length;
    SCOPED_TRACE(call(1) + n(radius));
    expect_standing(mill(call(1), radius, blank), form, side, radius, base - depth);
    expect_standing(mill(call(1) + call(2), radius, blank), form, 0.0, radius, -depth);
    if (HasFailure()) return;
  }
}

TEST(MilledMaterial, Faces) {
  Dice dice(29);
  for (int trial = 0; trial < 60; ++trial) {
    const double radius = dice.between(4.0, 25.0);
    const double length = dice.between(20.0, 100.0);
    const double width = dice.between(20.0, 100.0);
    const double top = dice.between(0.5, 6.0);
    const double base = dice.one_of(2) == 0 ? 0.0 : dice.between(0.05, 0.3);
    const double infeed = dice.between(0.4, 3.0);
    const auto call = [&](int kind) {
      return fmt::format("CYCLE61(50,0,2,{},{},{},{},{},{},{},{},900,{},0,1,10)\n", n(-top), n(-length / 2.0),
                         n(-width / 2.0), n(length), n(width), n(infeed), n(80.0), n(base), kind);
    };
    const int cuts = 10 * (1 + trial % 4);
    SCOPED_TRACE(call(cuts + 1) + n(radius));
    const gouge::Blank blank = block(length / 2.0, width / 2.0);
    const auto expect_flat = [&](const Left& left, double level) {
      left.for_places([&](const compile::test::Spot& at, double height) {
        if (std::isfinite(height)) {
          EXPECT_NEAR(height, level, kSame_mm) << at.x << " " << at.y;
        }
      });
      EXPECT_TRUE(left.report.findings.empty());
    };
    expect_flat(mill(call(cuts + 1), radius, blank), base - top);
    if (base > 0.0) expect_flat(mill(call(cuts + 1) + call(cuts + 2), radius, blank), -top);
    if (HasFailure()) return;
  }
}

// From any of its corners, turned by quarters: the block is as wide as the face.
TEST(MilledMaterial, FacesFromACorner) {
  Dice dice(31);
  for (int trial = 0; trial < 60; ++trial) {
    const double radius = dice.between(4.0, 25.0);
    const double x = dice.between(10.0, 50.0);
    const double y = dice.between(10.0, 50.0);
    const int quarters = dice.one_of(4);
    const double corner_x = dice.one_of(2) == 0 ? x : -x;
    const double corner_y = dice.one_of(2) == 0 ? y : -y;
    // To the opposite corner, in axes that are turned.
    double length = -2.0 * corner_x;
    double width = -2.0 * corner_y;
    for (int n = 0; n < quarters; ++n) length = std::exchange(width, -length);
    const double top = dice.between(0.5, 6.0);
    const double base = dice.one_of(2) == 0 ? 0.0 : dice.between(0.05, 0.3);
    const std::string infeed = n(dice.between(0.4, 3.0));
    const std::string step = dice.one_of(3) == 0 ? "0" : n(dice.between(1.0, 1.6 * radius));
    const std::string beyond = n(dice.between(0.0, 5.0)) + "," + n(base) + ",900,";
    const std::string last_beyond = dice.one_of(2) == 0 ? "" : "," + n(dice.between(0.1, 3.0));
    const auto call = [&](int kind) {
      return fmt::format("CYCLE71(50,0,2,{},{},{},{},{},{},{},{},{}{}{})\n", n(-top), n(corner_x), n(corner_y),
                         n(length), n(width), 90 * quarters, infeed, step, beyond, kind, last_beyond);
    };
    const int cuts = 10 * (1 + trial % 4);
    SCOPED_TRACE(call(cuts + 1) + n(radius));
    const auto expect_flat = [&](const Left& left, double level) {
      left.for_places([&](const compile::test::Spot& at, double height) {
        if (std::isfinite(height)) {
          EXPECT_NEAR(height, level, kSame_mm) << at.x << " " << at.y;
        }
      });
      EXPECT_TRUE(left.report.findings.empty());
    };
    expect_flat(mill(call(cuts + 1), radius, block(x, y)), base - top);
    if (base > 0.0) expect_flat(mill(call(cuts + 1) + call(cuts + 2), radius, block(x, y)), -top);
    if (HasFailure()) return;
  }
}

}  // namespace
}  // namespace dripfeed
