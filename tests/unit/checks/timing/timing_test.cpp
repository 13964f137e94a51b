// Whole programs as motions, against times computed by hand.
#include "checks/timing/timing.h"

#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <vector>

#include <gtest/gtest.h>

namespace dripfeed::timing {
namespace {

constexpr double kPi = std::numbers::pi;

checks::Machine mill() {
  checks::Machine machine;
  for (const ir::Axis axis : {ir::Axis::x, ir::Axis::y, ir::Axis::z}) {
    machine.axes.push_back({.axis = axis, .rapid_mm_min = 12000, .acceleration_mm_s2 = 1000});
  }
  machine.timing.sample_time_ms = 10;
  return machine;
}

// Builds a program move by move; positions go on from one to the next.
class Program {
 public:
  ir::Motion& move(ir::MotionKind kind, double x, double y, double z, double feed) {
    ir::Motion motion;
    motion.kind = kind;
    motion.start = at_;
    motion.end = at_ = {x, y, z};
    motion.feed = feed;
    return add(motion);
  }
  ir::Motion& event(ir::MotionKind kind, double value = 0) {
    ir::Motion motion;
    motion.kind = kind;
    motion.feed = value;
    return add(motion);
  }
  ir::Motion& add(ir::Motion motion) {
    motion.place = {0, static_cast<std::uint32_t>(motions_.size() + 1), motions_.size()};
    return motions_.emplace_back(motion);
  }
  Report run(const Settings& settings) const {
    Timing timing(settings);
    timing.consume(motions_);
    return timing.finish();
  }

 private:
  std::array<double, ir::kAxisCount> at_{};
  std::vector<ir::Motion> motions_;
};

using enum ir::MotionKind;

struct BufferCase {
  double baud;
  checks::BufferSize buffer;
  std::uint32_t look_ahead;
};

TEST(Timing, OneMoveIsATrapezoid) {
  Program program;
  program.move(linear, 100, 0, 0, 6000);
  const Report report = program.run({.machine = mill()});
  EXPECT_NEAR(report.cycle_s, 1.1, 1e-12);
  EXPECT_NEAR(report.motion_s, 1.1, 1e-12);
  EXPECT_EQ(report.blocks, 1U);
  EXPECT_EQ(report.stalls, 0U);
  EXPECT_NEAR(report.path_mm, 100, 1e-12);
}

TEST(Timing, EachMotionHasItsOwnTimeWhereThatIsAskedFor) {
  Program program;
  program.move(linear, 100, 0, 0, 6000);
  program.event(dwell, 2.0);
  program.move(linear, 100, 50, 0, 6000);
  const Report report = program.run({.machine = mill(), .most_motion_times = 100});
  ASSERT_EQ(report.motion_times.size(), 3U);
  EXPECT_NEAR(report.motion_times[0].end_s, 1.1, 1e-12);
  EXPECT_NEAR(report.motion_times[1].start_s, 1.1, 1e-12);
  EXPECT_NEAR(report.motion_times[2].start_s, 3.1, 1e-12);
  EXPECT_NEAR(report.motion_times[2].end_s, report.cycle_s, 1e-12);
  EXPECT_EQ(program.run({.machine = mill(), .most_motion_times = 2}).motion_times.size(), 2U);
  EXPECT_TRUE(program.run({.machine = mill()}).motion_times.empty());
}

TEST(Timing, ARightAngleIsTakenAtAccelerationTimesSampleTime) {
  Program program;
  program.move(linear, 50, 0, 0, 6000);
  program.move(linear, 50, 50, 0, 6000);
  const double leg = 0.1 + 0.09 + (50 - 5 - 4.95) / 100;
  EXPECT_NEAR(program.run({.machine = mill()}).cycle_s, 2 * leg, 1e-12);
}

TEST(Timing, ACornerIsRoundedWithinTheContourTolerance) {
  // A right angle with 0.05 mm: r = 0.05/(sqrt(2) - 1) = 0.1207 mm, v² = 1000·r, 10.99 mm/s; sharp: 10 mm/s.
  Program program;
  program.move(linear, 100, 0, 0, 6000);
  program.move(linear, 100, 100, 0, 6000);
  const auto ramps = [](double corner) {  // of one leg of 100 mm between rest and the corner, to 100 mm/s
    return 0.1 + (100 - corner) / 1000 + (100 - 5 - (1e4 - corner * corner) / 2000) / 100;
  };
  Settings settings{.machine = mill()};
  EXPECT_NEAR(program.run(settings).cycle_s, 2 * ramps(10), 1e-9);
  settings.machine.timing.contour_tolerance_mm = 0.05;
  EXPECT_NEAR(program.run(settings).cycle_s, 2 * ramps(std::sqrt(1000 * 0.05 / (std::numbers::sqrt2 - 1))), 1e-9);
  // Half of a short move is the room that the arc has: of 0.1 mm, r = 0.05 mm, which is slower than the sharp corner.
  Program steps;
  for (int i = 1; i <= 50; ++i) steps.move(linear, 0.1 * ((i + 1) / 2), 0.1 * (i / 2), 0, 6000);
  Settings sharp{.machine = mill()};
  settings.machine.timing.contour_tolerance_mm = 5;
  EXPECT_EQ(steps.run(settings).cycle_s, steps.run(sharp).cycle_s);
  // An exact stop and a reversal stay what they are.
  Program there;
  there.move(linear, 100, 0, 0, 6000).exact_stop = true;
  there.move(linear, 100, 100, 0, 6000);
  there.move(linear, 100, 0, 0, 6000);
  EXPECT_GE(there.run(settings).cycle_s, 3.2);
}

TEST(Timing, ExactStopsAndRapidsEndAtRest) {
  Program exact;
  exact.move(linear, 50, 0, 0, 6000).exact_stop = true;
  exact.move(linear, 100, 0, 0, 6000);
  EXPECT_NEAR(exact.run({.machine = mill()}).cycle_s, 1.2, 1e-12);
  Program rapids;
  rapids.move(rapid, 100, 100, 0, 0);  // both axes at 200 mm/s: 0.2 + 0.5
  rapids.move(linear, 100, 150, 0, 6000);
  const Report report = rapids.run({.machine = mill()});
  EXPECT_NEAR(report.rapid_s, 0.7, 1e-12);
  EXPECT_NEAR(report.cycle_s, 0.7 + 0.6, 1e-12);
}

TEST(Timing, DwellsAndToolChangesAddUp) {
  Program program;
  program.event(tool).number = 1;
  program.event(dwell, 2.5);
  program.event(tool).number = 1;
  program.event(tool).number = 2;
  Settings settings{.machine = mill()};
  settings.machine.timing.tool_change_s = 4;
  EXPECT_NEAR(program.run(settings).cycle_s, 10.5, 1e-12);
}

TEST(Timing, ArcsHaveTheirLengthAndTheirCentripetalLimit) {
  Program slow;
  slow.event(dwell);
  ir::Motion& arc = slow.move(arc_ccw, 0, 100, 0, 600);
  arc.start = {100, 0, 0};
  arc.center = {-100, 0, 0};
  const double acceleration = 1000 / std::sqrt(2.0);
  EXPECT_NEAR(slow.run({.machine = mill()}).cycle_s, 50 * kPi / 10 + 10 / acceleration, 1e-9);
  Program fast;
  ir::Motion& circle = fast.move(arc_cw, 0, 0, 0, 60000);
  circle.start = circle.end = {10, 0, 0};
  circle.center = {-10, 0, 0};
  const double speed = std::sqrt(acceleration * 10);
  EXPECT_NEAR(fast.run({.machine = mill()}).cycle_s, 20 * kPi / speed + speed / acceleration, 1e-9);
}

TEST(Timing, AHelixIsLongerThanItsCircle) {
  Program program;
  ir::Motion& helix = program.move(arc_ccw, 0, 0, 0, 600);
  helix.start = {10, 0, 0};
  helix.end = {10, 0, 5};
  helix.center = {-10, 0, 0};
  EXPECT_NEAR(program.run({.machine = mill()}).path_mm, std::hypot(20 * kPi, 5.0), 1e-9);
}

TEST(Timing, FeedPerRevolutionTakesTheSpindle) {
  Program program;
  ir::Motion& cut = program.move(linear, 0, 0, -60, 0.2);
  cut.feed_mode = ir::FeedMode::per_rev;
  cut.spindle_rpm = 600;  // 120 mm/min
  EXPECT_NEAR(program.run({.machine = mill()}).cycle_s, 30 + 0.002, 1e-9);
  program.move(linear, 0, 0, 0, 0.2).feed_mode = ir::FeedMode::per_rev;  // no spindle
  const Report report = program.run({.machine = mill()});
  EXPECT_NEAR(report.cycle_s, 30.002, 1e-9);
  ASSERT_EQ(report.not_checked.list().size(), 2U);
  EXPECT_EQ(report.not_checked.list()[1].line, 2U);
}

TEST(Timing, FacingWithSurfaceSpeedSlowsTheTurnsOutside) {
  // From diameter 200 to 0 at 200 m/min, at most 2000 rpm: the limit holds below diameter 31.83.
  checks::Machine machine = mill();
  for (auto& axis : machine.axes) axis.acceleration_mm_s2 = 0;
  Program program;
  ir::Motion& face = program.move(linear, 0, 0, 0, 0.25);
  face.start[0] = 200;
  face.feed_mode = ir::FeedMode::per_rev;
  face.surface_speed_m_min = 200;
  face.spindle_rpm = 2000;
  const double knee = 200000 / (kPi * 2000);  // mm of diameter
  const double minutes = (knee / 2 / 0.25) / 2000 + kPi / (4 * 200000 * 0.25) * (200 * 200 - knee * knee);
  EXPECT_NEAR(program.run({.machine = machine, .x_is_diameter = true}).cycle_s, minutes * 60, 1e-6);
}

TEST(Timing, InverseTimeIsTheTimeItself) {
  checks::Machine machine = mill();
  for (auto& axis : machine.axes) axis.acceleration_mm_s2 = 0;
  Program program;
  program.move(linear, 37, 11, 5, 4).feed_mode = ir::FeedMode::inverse_time;
  EXPECT_NEAR(program.run({.machine = machine}).cycle_s, 15, 1e-9);
}

TEST(Timing, TheLineStarvesShortMovesAndTheFirstIsNamed) {
  // 9600 baud, 7E2: 1.1458 ms a character; 24 characters a block take 27.5 ms.
  Program program;
  program.move(linear, 100, 0, 0, 6000);  // 1 s: two more blocks come meanwhile
  for (int i = 1; i <= 60; ++i) program.move(linear, 100 + i, 0, 0, 6000);
  Settings settings{.machine = mill()};
  settings.line = Line{.baud = 9600, .bits_per_char = 11};
  settings.line_bytes.assign(61, 24);
  settings.machine.buffer = {0, 30};
  const Report report = program.run(settings);
  EXPECT_GT(report.stalls, 0U);
  // 100 mm take 1.1 s from rest to rest: 40 blocks come meanwhile, and the buffer holds 30.
  EXPECT_GT(report.first_stall_line, 30U);
  EXPECT_LT(report.first_stall_line, 61U);
  EXPECT_NEAR(report.line_s, 61 * 24 * 11.0 / 9600, 1e-9);
  EXPECT_NEAR(report.first_move_s, 24 * 11.0 / 9600, 1e-12);
  EXPECT_NEAR(report.cycle_s, report.motion_s + report.stall_s + report.first_move_s, 1e-9);
  EXPECT_EQ(report.lowest_buffer_blocks, 0U);
  EXPECT_GT(report.limited_s[static_cast<std::size_t>(Limiter::line)], 0.2);
  EXPECT_EQ(report.findings.count(text::DiagnosticId::line_starves), report.stalls);
  settings.line->baud = 115200;
  EXPECT_EQ(program.run(settings).stalls, 0U);
}

TEST(Timing, SaysWhatWouldNotStarve) {
  Program program;
  for (int i = 1; i <= 400; ++i) program.move(linear, i, 0, 0, 6000);
  Settings settings{.machine = mill(), .keep_whole = true, .wants_curve = true};
  settings.line = Line{.baud = 9600, .bits_per_char = 11};
  settings.line_bytes.assign(400, 24);
  settings.machine.buffer = {0, 100};
  const Report starved = program.run(settings);
  ASSERT_GT(starved.stalls, 0U);
  ASSERT_TRUE(starved.advice.baud && starved.advice.feed_share && starved.advice.standard_baud);
  // 1 mm needs 264 bits: 100 mm/s need 26,400 baud at least.
  EXPECT_GT(*starved.advice.baud, 26'000);
  EXPECT_EQ(*starved.advice.standard_baud, 38'400);
  EXPECT_NEAR(*starved.advice.feed_mm_min, *starved.advice.feed_share * 6000, 1e-6);
  EXPECT_LT(*starved.advice.feed_mm_min, 9600 / 264.0 * 60 * 1.3);
  EXPECT_FALSE(starved.curve.empty());
  settings.line->baud = *starved.advice.baud;
  EXPECT_EQ(program.run(settings).standstill_s, 0.0);
  EXPECT_LE(program.run(settings).stall_s, 0.001 * starved.motion_s);
  Program slow;
  for (int i = 1; i <= 400; ++i) slow.move(linear, i, 0, 0, *starved.advice.feed_mm_min);
  settings.line->baud = 9600;
  const Report cured = slow.run(settings);
  EXPECT_LE(cured.stall_s, 0.001 * cured.motion_s);
  EXPECT_FALSE(cured.advice.baud);
}

TEST(Timing, AWindowGivesWhatTheWholeProgramGives) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> unit(-1, 1);
  Program program;
  double x = 0, y = 0, angle = 0;
  for (int i = 0; i < 60'000; ++i) {
    angle += 0.3 * unit(random);
    if (i % 7919 == 7918) {
      program.event(dwell, 0.05);
      continue;
    }
    x += 0.2 * std::cos(angle);
    y += 0.2 * std::sin(angle);
    program.move(i % 5000 == 0 ? rapid : linear, x, y, 0, 2400);
  }
  for (const BufferCase& one : {BufferCase{0, {}, 0}, {19200, {2048, 0}, 0}, {38400, {0, 30}, 20}, {4800, {}, 0}}) {
    Settings settings{.machine = mill()};
    settings.machine.buffer = one.buffer;
    settings.machine.timing.look_ahead_blocks = one.look_ahead;
    if (one.baud > 0) settings.line = Line{.baud = one.baud, .bits_per_char = 11, .latency_s = 0.01};
    if (one.baud > 0) settings.line_bytes.assign(60'000, 22);
    const Report window = program.run(settings);
    settings.keep_whole = true;
    settings.threads = 3;
    const Report whole = program.run(settings);
    EXPECT_NEAR(window.cycle_s, whole.cycle_s, 1e-9 * whole.cycle_s) << one.baud;
    EXPECT_NEAR(window.motion_s, whole.motion_s, 1e-9 * whole.motion_s);
    EXPECT_EQ(window.first_stall_line, whole.first_stall_line);
    EXPECT_NEAR(static_cast<double>(window.stalls), static_cast<double>(whole.stalls), 2);
    EXPECT_EQ(window.lowest_buffer_blocks, whole.lowest_buffer_blocks);
    double sum = 0;
    for (const double part : whole.limited_s) sum += part;
    EXPECT_NEAR(sum + whole.first_move_s, whole.cycle_s, 1e-6);
    settings.threads = 1;
    EXPECT_EQ(program.run(settings).cycle_s, whole.cycle_s);
  }
}

// 1 mm at first and 0.5 more in each turn are 8 mm in four turns; the lead of a cone counts along its longer axis.
TEST(Timing, AThreadTakesItsTurns) {
  const checks::Machine machine;  // no limits: turns alone take time
  const auto seconds = [&](double x, double z, double lead, double change) {
    Program program;
    ir::Motion& cut = program.move(thread, x, 0, z, lead);
    cut.feed_mode = ir::FeedMode::per_rev;
    cut.spindle = ir::SpindleState::clockwise;
    cut.spindle_rpm = 60;
    cut.center[0] = change;
    return program.run({.machine = machine}).cycle_s;
  };
  EXPECT_NEAR(seconds(0, -8, 1, 0), 8, 1e-12);
  EXPECT_NEAR(seconds(0, -8, 1, 0.5), 4, 1e-12);
  EXPECT_NEAR(seconds(0, -8, 3, -0.5), 4, 1e-12);
  EXPECT_NEAR(seconds(3, -8, 1, 0.5), 4, 1e-12);
  EXPECT_NEAR(seconds(3, -8, 1, 0), 8, 1e-12);
}

TEST(Timing, JerkMakesALongMoveExactlySoMuchLonger) {
  Program program;
  program.move(linear, 100, 0, 0, 6000);
  Settings settings{.machine = mill()};
  for (auto& axis : settings.machine.axes) axis.jerk_mm_s3 = 20'000;
  EXPECT_NEAR(program.run(settings).cycle_s, 1.1 + 1000.0 / 20'000, 1e-12);
  // Acceleration is not reached: two halves of sqrt(v/j) at each end.
  for (auto& axis : settings.machine.axes) axis.jerk_mm_s3 = 2500;
  EXPECT_NEAR(program.run(settings).cycle_s, 1.0 + 2 * std::sqrt(100.0 / 2500), 1e-12);
  settings.limit_jerk = false;
  EXPECT_NEAR(program.run(settings).cycle_s, 1.1, 1e-12);
}

TEST(Timing, AbsurdNumbersEndInSentencesAndFiniteTimes) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double inf = std::numeric_limits<double>::infinity();
  const double figures[] = {nan, inf, -inf, 0.0, -1.0, 1e-320, 1e-30, 1e30, 1e308};
  for (const double a : figures) {
    for (const double b : figures) {
      Program program;
      program.move(linear, 10, 0, 0, 600);
      program.move(linear, a, b, 0, 600);
      program.move(linear, 10, 10, 0, b);
      program.move(rapid, 20, 10, 0, a);
      program.event(dwell, a);
      ir::Motion& arc = program.move(arc_cw, 30, 10, 0, 600);
      arc.center = {a, b, 0};
      ir::Motion& turned = program.move(linear, 0, 0, 5, a);
      turned.feed_mode = ir::FeedMode::per_rev;
      turned.spindle_rpm = b;
      turned.surface_speed_m_min = a;
      program.move(linear, 0, 0, 7, b).feed_mode = ir::FeedMode::inverse_time;
      Settings settings{.machine = mill(),
                        .cost = {.block_ms = a,
                                 .number_read_ms = b,
                                 .named_read_ms = a,
                                 .operator_ms = b,
                                 .function_ms = a,
                                 .origin = {}},
                        .keep_whole = true};
      for (auto& axis : settings.machine.axes) {
        axis.acceleration_mm_s2 = a;
        axis.rapid_mm_min = b;
        axis.jerk_mm_s3 = b;
      }
      settings.machine.timing.sample_time_ms = a;
      settings.machine.timing.tool_change_s = b;
      settings.machine.feed_limit_mm_min = b;
      settings.line = Line{.baud = a, .bits_per_char = b, .latency_s = a, .char_delay_s = b, .line_delay_s = a};
      settings.line_bytes.assign(8, 20);
      for (const bool whole : {false, true}) {
        settings.keep_whole = whole;
        const Report report = program.run(settings);
        EXPECT_TRUE(std::isfinite(report.cycle_s) && report.cycle_s >= 0) << a << ' ' << b;
        EXPECT_TRUE(std::isfinite(report.motion_s) && std::isfinite(report.stall_s) && std::isfinite(report.line_s));
        EXPECT_FALSE(report.not_checked.empty() && !(a > 0)) << a << ' ' << b;
      }
    }
  }
}

TEST(Timing, LinesWithoutMotionTakeTheirTimeOnTheLine) {
  Program program;
  program.move(linear, 10, 0, 0, 6000).place.line = 1;
  program.move(linear, 20, 0, 0, 6000).place.line = 5;
  Settings settings{.machine = mill()};
  settings.line = Line{.baud = 1000, .bits_per_char = 10};
  settings.line_bytes = {10, 100, 100, 100, 10, 50};
  const Report report = program.run(settings);
  EXPECT_NEAR(report.line_s, 3.7, 1e-12);
  EXPECT_EQ(report.first_stall_line, 5U);
  EXPECT_GT(report.cycle_s, 3.2);
}

TEST(Timing, DelaysAndAnUnhurriedSenderMakeTheLineSlower) {
  Program program;
  program.move(linear, 10, 0, 0, 6000).place.line = 1;
  program.move(linear, 20, 0, 0, 6000).place.line = 3;
  Settings settings{.machine = mill()};
  settings.line = Line{.baud = 1000, .bits_per_char = 10, .pace = 0.5, .char_delay_s = 0.005, .line_delay_s = 0.25};
  settings.line_bytes = {10, 20, 10};
  const Report report = program.run(settings);
  EXPECT_NEAR(report.line_s, 40 * 0.025 + 3 * 0.25, 1e-12);
  EXPECT_NEAR(report.first_move_s, 10 * 0.025, 1e-12);            // the line rests after what the control has by then
  EXPECT_NEAR(report.cycle_s, report.line_s - 0.25 + 0.2, 1e-9);  // the second move, from rest to rest
}

TEST(Timing, ComputingSlowsALoopInTheMemory) {
  Program program;
  for (int i = 1; i <= 50; ++i) {
    program.move(linear, i * 0.1, 0, 0, 6000).compute = {.blocks = 4,
                                                         .number_reads = 10,
                                                         .number_writes = 3,
                                                         .operators = 8,
                                                         .functions = 1,
                                                         .jumps = 1,
                                                         .rounds = 2,
                                                         .calls = 1,
                                                         .indexed = 2};
  }
  Settings settings{.machine = mill(),
                    .cost = {.block_ms = 1.0,
                             .number_read_ms = 0.45,
                             .number_write_ms = 0.1,
                             .operator_ms = 0.05,
                             .function_ms = 0.6,
                             .jump_ms = 2.0,
                             .round_ms = 0.5,
                             .call_ms = 3.0,
                             .indexed_ms = 0.25,
                             .spread = 1.5,
                             .source = ir::CostSource::paper,
                             .origin = "a test"}};
  settings.machine.timing.look_ahead_blocks = 3;
  const Report report = program.run(settings);
  EXPECT_NEAR(report.compute_s, 50 * 0.0163, 1e-9);
  EXPECT_EQ(report.cost_source, ir::CostSource::paper);
  EXPECT_EQ(report.cost_origin, "a test");
  EXPECT_EQ(report.cost_spread, 1.5);
  // The machine's own model outranks the control's; one without a source is an assumption.
  settings.machine.timing.cost = ir::CostModel{.block_ms = 1.0, .origin = {}};
  settings.machine.timing.cost_origin = "a shop";
  const Report own = program.run(settings);
  EXPECT_EQ(own.cost_source, ir::CostSource::assumed);
  EXPECT_EQ(own.cost_origin, "a shop");
  EXPECT_EQ(own.cost_spread, ir::kAssumedSpread);
  EXPECT_GT(report.stalls, 0U);
  EXPECT_GE(report.cycle_s, report.compute_s);
}

TEST(Timing, SaysWhatIsMissing) {
  Program program;
  program.move(linear, 60, 0, 0, 600);
  const Report report = program.run({});
  EXPECT_NEAR(report.cycle_s, 6, 1e-9);
  EXPECT_EQ(report.not_checked.list().size(), 4U);  // rapid, acceleration, sample time, cost
}

TEST(Timing, GivesTheSameForEveryBatch) {
  std::vector<ir::Motion> motions(5000);
  for (std::size_t i = 0; i < motions.size(); ++i) {
    const double t = 0.01 * static_cast<double>(i);
    motions[i].kind = i % 97 == 0 ? dwell : linear;
    motions[i].place = {0, static_cast<std::uint32_t>(i + 1), i};
    motions[i].start = {50 * std::cos(t - 0.01), 50 * std::sin(t - 0.01)};
    motions[i].end = {50 * std::cos(t), 50 * std::sin(t)};
    motions[i].feed = i % 97 == 0 ? 0.01 : 3000;
  }
  const auto run = [&](std::size_t batch) {
    Timing timing({.machine = mill()});
    const std::span all(motions);
    for (std::size_t i = 0; i < all.size(); i += batch) timing.consume(all.subspan(i, std::min(batch, all.size() - i)));
    return timing.finish();
  };
  const Report whole = run(motions.size());
  for (const std::size_t batch : {1U, 7U, 1024U}) EXPECT_EQ(run(batch).cycle_s, whole.cycle_s);
  EXPECT_EQ(whole.blocks, 5000U);
}

// The control's buffer counts blocks, and one block may make any number of moves: the window that waits is limited.
TEST(Timing, ABlockOfTooManyMovesEndsItWithAReason) {
  Settings settings{.machine = mill()};
  settings.machine.buffer.blocks = 100;
  settings.most_kept = 50'000;
  Timing timing(settings);
  ir::Motion motion;
  motion.kind = ir::MotionKind::linear;
  motion.feed = 1000;
  motion.place = {0, 4, 0};
  for (int i = 0; i < 200'000; ++i) {
    motion.start = motion.end;
    motion.end[2] = i % 2 == 0 ? -1.0 : 0.0;
    timing.consume({&motion, 1});
  }
  const Report report = timing.finish();
  EXPECT_FALSE(report.is_whole);
  ASSERT_FALSE(report.not_checked.empty());
  EXPECT_EQ(report.not_checked.list().back().text, "blocks make too many moves to be timed: the time ends here");
  EXPECT_EQ(report.not_checked.list().back().line, 4U);
}

}  // namespace
}  // namespace dripfeed::timing
