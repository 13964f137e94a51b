// What counts as the same motion on both sides of a translation, and what does not: each of the things by which two
// motions may differ, one at a time.
#include "dialects/compile/translate/same_motion.h"

#include <functional>
#include <string>

#include <gtest/gtest.h>

#include "tests/unit/dialects/compile/harness.h"

namespace dripfeed::compile::test {
namespace {

using ir::Motion;
using ir::MotionKind;
using ir::SpindleState;

constexpr std::uint16_t kX = 1;
constexpr std::uint16_t kZ = 4;

Motion cut(MotionKind kind = MotionKind::linear) {
  Motion m;
  m.kind = kind;
  m.axes_commanded = kX;
  m.end = {10.0, 20.0, 30.0};
  m.feed = kind == MotionKind::rapid ? 0.0 : kind == MotionKind::thread ? 1.5 : 100.0;
  m.spindle_rpm = 500.0;
  m.spindle = SpindleState::clockwise;
  return m;
}
Motion with(Motion m, const std::function<void(Motion&)>& change) {
  change(m);
  return m;
}

SameMotion mills(bool inch = false) {
  return {control("sinumerik-840d", ir::MachineKind::mill), control("fanuc", ir::MachineKind::mill), inch};
}

TEST(SameMotion, OneDifferenceIsEnough) {
  const struct {
    const char* what;
    std::function<void(Motion&)> change;
  } rows[] = {
      {"end", [](Motion& m) { m.end[0] = 10.01; }},
      {"end of an axis that is not named", [](Motion& m) { m.end[1] = 20.01; }},
      {"kind", [](Motion& m) { m.kind = MotionKind::rapid; }},
      {"machine coordinates", [](Motion& m) { m.machine_coordinates = true; }},
      {"compensation", [](Motion& m) { m.comp = ir::CompSide::left; }},
      {"coolant", [](Motion& m) { m.coolant = ir::CoolantState::flood; }},
      {"direction of the spindle", [](Motion& m) { m.spindle = SpindleState::counterclockwise; }},
      {"speed", [](Motion& m) { m.spindle_rpm = 510.0; }},
      {"surface speed", [](Motion& m) { m.surface_speed_m_min = 150.0; }},
      {"feed", [](Motion& m) { m.feed = 101.0; }},
      {"feed mode", [](Motion& m) { m.feed_mode = ir::FeedMode::per_rev; }},
  };
  const SameMotion compared = mills();
  EXPECT_TRUE(compared.same(cut(), cut(), CyclePart::none));
  for (const auto& [what, change] : rows) {
    EXPECT_FALSE(compared.same(cut(), with(cut(), change), CyclePart::none)) << what;
    EXPECT_FALSE(compared.same(with(cut(), change), cut(), CyclePart::none)) << what;
  }
}

TEST(SameMotion, TheEndIsThatOfThePrintedDecimals) {
  const auto shifted = [](double by) { return with(cut(), [by](Motion& m) { m.end[0] += by; }); };
  EXPECT_TRUE(mills().same(cut(), shifted(0.00109), CyclePart::none));
  EXPECT_FALSE(mills().same(cut(), shifted(0.00112), CyclePart::none));
  EXPECT_TRUE(mills(true).same(cut(), shifted(0.0027), CyclePart::none));  // 0.0001 inch
  EXPECT_FALSE(mills(true).same(cut(), shifted(0.0029), CyclePart::none));
}

TEST(SameMotion, OnlyAnAxisThatIsNamedMustBeKnown) {
  const auto unknown = [](std::uint16_t axis) {
    return with(cut(), [axis](Motion& m) {
      m.axes_unknown = axis;
      m.end[0] = axis == kX ? 11.0 : 10.0;
      m.end[2] = axis == kZ ? 99.0 : 30.0;
    });
  };
  EXPECT_TRUE(mills().same(cut(), unknown(kZ), CyclePart::none));
  EXPECT_FALSE(mills().same(cut(), unknown(kX), CyclePart::none));
  EXPECT_FALSE(mills().same(with(unknown(kZ), [](Motion& m) { m.axes_commanded |= kZ; }), cut(), CyclePart::none));
}

TEST(SameMotion, AnEndThatASettingDecidesIsNoEnd) {
  const Motion open = with(cut(), [](Motion& m) { m.gaps = ir::kEndUnknown; });
  EXPECT_FALSE(mills().same(cut(), open, CyclePart::none));
  EXPECT_TRUE(mills().same(open, open, CyclePart::none));
  EXPECT_TRUE(mills().same(open, cut(), CyclePart::none));
}

TEST(SameMotion, ADiameterIsTwiceARadius) {
  const ir::Control lathe = control("fanuc", ir::MachineKind::lathe);
  ir::Control by_radius = lathe;
  by_radius.semantics.power_on_diameter = ir::DiameterMode::radius;
  const auto wide = with(cut(), [](Motion& m) { m.end[0] = 20.0; });
  EXPECT_TRUE(SameMotion(by_radius, lathe, false).same(cut(), wide, CyclePart::none));
  EXPECT_TRUE(SameMotion(lathe, by_radius, false).same(wide, cut(), CyclePart::none));
  EXPECT_FALSE(SameMotion(lathe, lathe, false).same(wide, cut(), CyclePart::none));
}

TEST(SameMotion, ASpindleThatStandsHasNoSpeed) {
  const auto standing = [](double rpm) {
    return with(cut(), [rpm](Motion& m) {
      m.spindle = SpindleState::stopped;
      m.spindle_rpm = rpm;
    });
  };
  EXPECT_TRUE(mills().same(standing(500.0), standing(0.0), CyclePart::none));
  EXPECT_FALSE(mills().same(cut(), standing(500.0), CyclePart::none));
}

TEST(SameMotion, ArcsAndThreadsHaveCenters) {
  for (const MotionKind kind : {MotionKind::arc_cw, MotionKind::arc_ccw, MotionKind::thread}) {
    const Motion other = with(cut(kind), [](Motion& m) { m.center[1] = 0.01; });
    EXPECT_TRUE(mills().same(cut(kind), cut(kind), CyclePart::none));
    EXPECT_FALSE(mills().same(cut(kind), other, CyclePart::none));
  }
  const Motion line = with(cut(), [](Motion& m) { m.center[1] = 0.01; });
  EXPECT_TRUE(mills().same(cut(), line, CyclePart::none));
  EXPECT_TRUE(mills().same(cut(MotionKind::spline), cut(), CyclePart::none));  // a chord
  EXPECT_FALSE(mills().same(cut(), cut(MotionKind::spline), CyclePart::none));
}

TEST(SameMotion, ADwellIsItsTime) {
  const auto dwell = [](double seconds) {
    return with(cut(MotionKind::dwell), [seconds](Motion& m) { m.feed = seconds; });
  };
  EXPECT_TRUE(mills().same(dwell(1.0), with(dwell(1.0), [](Motion& m) { m.end[0] = 5.0; }), CyclePart::none));
  EXPECT_FALSE(mills().same(dwell(1.0), dwell(1.1), CyclePart::none));
  EXPECT_FALSE(mills().same(dwell(100.0), cut(), CyclePart::none));
}

TEST(SameMotion, WithinACycleATapMayBeAThread) {
  const SameMotion compared = mills();
  for (const CyclePart part : {CyclePart::entry, CyclePart::other}) {
    EXPECT_TRUE(compared.same(cut(), cut(MotionKind::thread), part));
    EXPECT_TRUE(compared.same(cut(MotionKind::rapid), cut(), part));
    EXPECT_FALSE(compared.same(cut(MotionKind::rapid), cut(MotionKind::thread), part));
  }
  EXPECT_FALSE(compared.same(cut(), cut(MotionKind::thread), CyclePart::none));
  const Motion back = with(cut(), [](Motion& m) { m.spindle = SpindleState::counterclockwise; });
  EXPECT_TRUE(compared.same(cut(), back, CyclePart::other));
  EXPECT_FALSE(compared.same(cut(), back, CyclePart::entry));
}

TEST(SameMotion, ALeftHandThreadTurnsCounterclockwise) {
  const Motion left = with(cut(MotionKind::thread), [](Motion& m) { m.feed = -1.5; });
  const auto right = [](double lead, SpindleState spindle, double rpm = 500.0) {
    return with(cut(MotionKind::thread), [&](Motion& m) {
      m.feed = lead;
      m.spindle = spindle;
      m.spindle_rpm = rpm;
    });
  };
  const SameMotion compared = mills();
  for (const CyclePart part : {CyclePart::none, CyclePart::entry}) {
    EXPECT_TRUE(compared.same(left, right(1.5, SpindleState::counterclockwise), part));
    EXPECT_TRUE(compared.same(right(1.5, SpindleState::counterclockwise), left, part));
    EXPECT_FALSE(compared.same(left, right(1.5, SpindleState::clockwise), part));
    EXPECT_FALSE(compared.same(left, right(1.5, SpindleState::counterclockwise, 600.0), part));
  }
  EXPECT_TRUE(compared.same(left, right(1.5, SpindleState::clockwise), CyclePart::other));
  EXPECT_FALSE(compared.same(left, right(1.501, SpindleState::counterclockwise), CyclePart::other));
}

TEST(SameMotion, AShortStraightMoveStays) {
  const auto move = [](MotionKind kind, double length) {
    return with(cut(kind), [length](Motion& m) {
      m.start = m.end;
      m.start[0] -= length;
    });
  };
  const SameMotion compared = mills();
  EXPECT_TRUE(compared.stays(move(MotionKind::rapid, 0.001)));
  EXPECT_TRUE(compared.stays(move(MotionKind::linear, 0.0)));
  EXPECT_FALSE(compared.stays(move(MotionKind::linear, 0.01)));
  EXPECT_FALSE(compared.stays(move(MotionKind::arc_cw, 0.0)));
  EXPECT_FALSE(compared.stays(with(move(MotionKind::rapid, 0.0), [](Motion& m) { m.machine_coordinates = true; })));
  EXPECT_FALSE(compared.stays(with(move(MotionKind::rapid, 0.0), [](Motion& m) { m.axes_unknown = kX; })));
  EXPECT_TRUE(compared.stays(with(move(MotionKind::rapid, 0.0), [](Motion& m) { m.axes_unknown = kZ; })));
}

TEST(SameMotion, ATapHasItsLead) {
  const SameMotion compared = mills();
  const Motion by_time = with(cut(), [](Motion& m) { m.feed = 750.0; });
  EXPECT_TRUE(compared.same_of_tap(by_time, cut(MotionKind::thread)));  // 750 a minute at 500 rpm
  EXPECT_FALSE(compared.same_of_tap(by_time, with(cut(MotionKind::thread), [](Motion& m) { m.feed = 1.6; })));
  EXPECT_FALSE(compared.same_of_tap(by_time, with(by_time, [](Motion& m) { m.spindle = SpindleState::stopped; })));
  EXPECT_TRUE(compared.same_of_tap(
      by_time, with(cut(MotionKind::thread), [](Motion& m) { m.spindle = SpindleState::stopped; })));
  EXPECT_FALSE(compared.same_of_tap(by_time, with(cut(MotionKind::thread), [](Motion& m) { m.end[2] = 1.0; })));
  EXPECT_FALSE(compared.same_of_tap(by_time, with(by_time, [](Motion& m) { m.coolant = ir::CoolantState::flood; })));
  EXPECT_FALSE(compared.same_of_tap(by_time, with(by_time, [](Motion& m) { m.comp = ir::CompSide::left; })));
  EXPECT_FALSE(compared.same_of_tap(by_time, cut(MotionKind::rapid)));
  const Motion rapid = cut(MotionKind::rapid);
  EXPECT_TRUE(compared.same_of_tap(rapid, with(rapid, [](Motion& m) { m.spindle_rpm = 1.0; })));
  EXPECT_FALSE(compared.same_of_tap(rapid, with(rapid, [](Motion& m) { m.end[0] = 1.0; })));
  EXPECT_FALSE(compared.same_of_tap(rapid, with(rapid, [](Motion& m) { m.comp = ir::CompSide::left; })));
  EXPECT_FALSE(compared.same_of_tap(rapid, cut()));
  EXPECT_FALSE(compared.same_of_tap(cut(MotionKind::arc_cw), cut(MotionKind::arc_cw)));
  const Motion dwell = with(cut(MotionKind::dwell), [](Motion& m) { m.feed = 1.0; });
  EXPECT_TRUE(compared.same_of_tap(dwell, with(dwell, [](Motion& m) { m.end[0] = 1.0; })));
  EXPECT_FALSE(compared.same_of_tap(dwell, with(dwell, [](Motion& m) { m.feed = 2.0; })));
}

}  // namespace
}  // namespace dripfeed::compile::test
