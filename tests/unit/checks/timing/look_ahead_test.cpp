// The plan of a whole path against closed forms, against a relaxation that knows nothing of sweeps, and against itself
// with other numbers of threads.
#include "checks/timing/look_ahead.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "checks/timing/limited_look_ahead.h"
#include "checks/timing/sweep.h"

namespace dripfeed::timing {
namespace {

PieceArrays arrays_of(const std::vector<Piece>& pieces) {
  PieceArrays arrays;
  for (const Piece& piece : pieces) arrays.push_back(piece);
  return arrays;
}

SpeedPlan plan(const std::vector<Piece>& pieces, std::size_t look_ahead = 0) {
  SpeedPlan made;
  plan_path(arrays_of(pieces), {look_ahead, 1}, made);
  return made;
}

std::vector<Piece> random_path(unsigned seed, std::size_t count, double rest_share = 0.02) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(0, 1);
  std::vector<Piece> pieces(count);
  for (Piece& piece : pieces) {
    piece.length = std::pow(10.0, 3 * unit(random) - 2);
    piece.speed2 = std::pow(10 + 190 * unit(random), 2);
    piece.start2 = unit(random) < rest_share ? 0.0 : std::pow(200 * unit(random), 2);
    piece.acceleration = 200 + 2000 * unit(random);
  }
  return pieces;
}

// Squares of speed at the junctions by lowering them until no limit is passed: the largest such profile.
std::vector<double> relaxed(const std::vector<Piece>& pieces, std::size_t look_ahead) {
  const std::size_t n = pieces.size();
  std::vector<double> speed2(n + 1, 0.0);
  for (std::size_t i = 1; i < n; ++i) {
    speed2[i] = std::min({pieces[i].start2, pieces[i].speed2, pieces[i - 1].speed2});
    if (look_ahead == 0) continue;
    double stop = 0;
    for (std::size_t j = i; j < std::min(n, i + look_ahead); ++j) stop += 2 * pieces[j].acceleration * pieces[j].length;
    speed2[i] = std::min(speed2[i], stop);
  }
  for (bool changed = true; changed;) {
    changed = false;
    for (std::size_t i = 0; i < n; ++i) {
      const double change = 2 * pieces[i].acceleration * pieces[i].length;
      for (const auto& [from, to] : {std::pair{i, i + 1}, std::pair{i + 1, i}}) {
        if (speed2[to] <= speed2[from] + change) continue;
        speed2[to] = speed2[from] + change;
        changed = true;
      }
    }
  }
  return speed2;
}

TEST(LookAhead, MakesATrapezoidOfOnePiece) { EXPECT_NEAR(plan({{100, 100.0 * 100, 0, 1000}}).total_s, 1.1, 1e-12); }

TEST(LookAhead, MakesATriangleOfAShortPiece) {
  EXPECT_NEAR(plan({{2.5, 100.0 * 100, 0, 1000}}).total_s, 2 * std::sqrt(2.5 / 1000), 1e-12);
}

TEST(LookAhead, OfNothingIsNothing) {
  const SpeedPlan none = plan({});
  EXPECT_EQ(none.total_s, 0.0);
  EXPECT_EQ(none.speed2, std::vector<double>{0.0});
}

TEST(LookAhead, PassesAStraightJunctionAsIfItWereNone) {
  const SpeedPlan planned = plan({{50, 1e4, 0, 1000}, {50, 1e4, kNoLimit, 1000}});
  EXPECT_NEAR(planned.total_s, 1.1, 1e-12);
  EXPECT_NEAR(planned.speed2[1], 1e4, 1e-9);
}

TEST(LookAhead, SlowsDownToACornerAndStopsAtARest) {
  const double leg = 0.1 + 0.09 + (50 - 5 - 4.95) / 100;
  EXPECT_NEAR(plan({{50, 1e4, 0, 1000}, {50, 1e4, 100, 1000}}).total_s, 2 * leg, 1e-12);
  EXPECT_NEAR(plan({{50, 1e4, 0, 1000}, {50, 1e4, 0, 1000}}).total_s, 1.2, 1e-12);
}

TEST(LookAhead, LooksBackOverManyShortPieces) {
  // 1000 pieces of 0.01 mm: 10 mm in all, triangle up to 100 mm/s in the middle.
  const SpeedPlan planned = plan(std::vector<Piece>(1000, {0.01, 1e6, kNoLimit, 1000}));
  EXPECT_NEAR(planned.total_s, 0.2, 1e-9);
  EXPECT_NEAR(planned.speed2[500], 1e4, 1e-4);
}

TEST(LookAhead, IsTheLargestPlanThatPassesNoLimit) {
  for (unsigned seed = 0; seed < 2000; ++seed) {
    const auto pieces = random_path(seed, 1 + seed % 60);
    const std::size_t look_ahead = seed % 3 == 0 ? 0 : 1 + seed % 7;
    const SpeedPlan planned = plan(pieces, look_ahead);
    const auto oracle = relaxed(pieces, look_ahead);
    for (std::size_t i = 0; i <= pieces.size(); ++i)
      ASSERT_NEAR(planned.speed2[i], oracle[i], 1e-6 + 1e-9 * oracle[i]) << seed << ' ' << i;
  }
}

// 10^5 paths: what the definition asks for, by itself.
void expect_no_limit_passed(const std::vector<Piece>& pieces, const SpeedPlan& planned, unsigned seed) {
  const std::size_t n = pieces.size();
  constexpr double kMore = 1 + 1e-12;
  ASSERT_EQ(planned.speed2.front(), 0.0);
  ASSERT_EQ(planned.speed2.back(), 0.0);
  for (std::size_t i = 0; i < n; ++i) {
    const double start2 = planned.speed2[i];
    const double end2 = planned.speed2[i + 1];
    const double change = 2 * pieces[i].acceleration * pieces[i].length;
    ASSERT_TRUE(i == 0 || start2 <= pieces[i].start2) << seed;
    ASSERT_TRUE(start2 <= pieces[i].speed2 && end2 <= pieces[i].speed2) << seed;
    ASSERT_LE(start2, (end2 + change) * kMore) << seed;
    ASSERT_LE(end2, (start2 + change) * kMore) << seed;
    // The time is not below that at the highest speed, nor below that of the change of speed.
    ASSERT_GE(planned.duration_s[i] * kMore, pieces[i].length / std::sqrt(pieces[i].speed2)) << seed;
    ASSERT_GE(planned.duration_s[i] * pieces[i].acceleration * kMore + 1e-9,
              std::fabs(std::sqrt(end2) - std::sqrt(start2)));
    // Nothing is given away: each junction is at one of its limits.
    const double own = i == 0 ? 0.0 : std::min({pieces[i].start2, pieces[i].speed2, pieces[i - 1].speed2});
    const double before = i == 0 ? 0.0 : planned.speed2[i - 1] + 2 * pieces[i - 1].acceleration * pieces[i - 1].length;
    ASSERT_TRUE(start2 == own || start2 == before || start2 == end2 + change) << seed << ' ' << i;
  }
}

TEST(LookAhead, NoLimitIsPassedOnAHundredThousandPaths) {
  for (unsigned seed = 0; seed < 100'000; ++seed) {
    const auto pieces = random_path(seed, 1 + seed % 40, 0.05);
    ASSERT_NO_FATAL_FAILURE(expect_no_limit_passed(pieces, plan(pieces), seed));
  }
}

TEST(LookAhead, NoJunctionBecomesSlowerWhereALimitIsRaised) {
  std::mt19937 random(7);
  for (unsigned seed = 0; seed < 20'000; ++seed) {
    auto pieces = random_path(seed, 2 + seed % 30);
    const SpeedPlan before = plan(pieces, seed % 4);
    Piece& one = pieces[random() % pieces.size()];
    double& figure = std::array{&one.speed2, &one.start2, &one.acceleration}[seed % 3][0];
    figure *= 1.5;
    const SpeedPlan after = plan(pieces, seed % 4);
    for (std::size_t i = 0; i < before.speed2.size(); ++i)
      ASSERT_GE(after.speed2[i] * (1 + 1e-12), before.speed2[i]) << seed;
  }
}

TEST(LookAhead, GivesTheSameBitsForAnyNumberOfThreads) {
  std::size_t reswept = 0;
  for (unsigned seed = 0; seed < 1500; ++seed) {
    auto pieces = random_path(seed, seed % 500, seed % 3 == 0 ? 0.0 : 0.02);
    if (seed % 5 == 0) {  // limited by acceleration alone: what was speculated is never true
      for (Piece& piece : pieces) {
        piece.length *= 0.01;
        piece.start2 = piece.speed2;
      }
    }
    const PieceArrays arrays = arrays_of(pieces);
    SpeedPlan serial;
    plan_path(arrays, {seed % 4 * 3, 1}, serial);
    for (const unsigned threads : {2U, 3U, 5U}) {
      SpeedPlan parallel;
      plan_path(arrays, {seed % 4 * 3, threads, 8}, parallel);
      ASSERT_EQ(parallel.speed2, serial.speed2) << seed;
      ASSERT_EQ(parallel.duration_s, serial.duration_s) << seed;
      ASSERT_EQ(parallel.total_s, serial.total_s) << seed;
      reswept += parallel.reswept;
    }
  }
  EXPECT_GT(reswept, 10'000U);  // otherwise the speculation was never wrong, and this tested nothing
}

TEST(LookAhead, ALongerSightIsNeverSlower) {
  const auto pieces = random_path(5, 2000);
  double before = 1e300;
  for (const std::size_t look_ahead : {1U, 2U, 5U, 20U, 100U, 1000U}) {
    const double time = plan(pieces, look_ahead).total_s;
    EXPECT_LE(time, before * (1 + 1e-12));
    before = time;
  }
  EXPECT_LE(plan(pieces).total_s, before * (1 + 1e-12));
}

// The look-ahead profile of the whole path: the backward sweep alone.
std::vector<double> swept_back(const PieceArrays& pieces) {
  std::vector<double> speed2(pieces.size() + 1, 0.0);
  junction_limits(pieces, {0, pieces.size()}, speed2.data());
  sweep_back(pieces, {0, pieces.size()}, 0.0, speed2.data());
  return speed2;
}

TEST(LimitedLookAhead, IsTheExactOneWhereTheOverlapSuffices) {
  std::size_t short_ones = 0;
  for (unsigned seed = 0; seed < 300; ++seed) {
    auto path = random_path(seed, 1 + seed * 7 % 1500, 0.0);
    for (Piece& piece : path) piece.length = 0.05 + 0.05 * piece.length;
    const PieceArrays pieces = arrays_of(path);
    const std::vector<double> exact = swept_back(pieces);
    LimitedPlan wide, narrow, parallel;
    plan_limited(pieces, {100, 5, 2000, 1}, wide);
    EXPECT_EQ(wide.cut, 0U);
    EXPECT_EQ(wide.limit2, exact) << seed;
    plan_limited(pieces, {100, 1, 3, 1}, narrow);
    plan_limited(pieces, {100, 1, 3, 3}, parallel);
    ASSERT_EQ(parallel.limit2, narrow.limit2);
    for (std::size_t i = 0; i < exact.size(); ++i) {
      ASSERT_LE(narrow.limit2[i], exact[i]) << seed;  // a drop, never more than the machine can
      short_ones += narrow.limit2[i] < exact[i] ? 1U : 0U;
    }
  }
  EXPECT_GT(short_ones, 1000U);
}

LinePath random_lines(unsigned seed, std::size_t count) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(-1, 1);
  LinePath path;
  for (auto& axis : path.points) {
    for (std::size_t i = 0; i <= count; ++i) axis.push_back(unit(random) * 10);
  }
  for (std::size_t i = 0; i < count; ++i) path.feed.push_back(20 + 100 * std::fabs(unit(random)));
  return path;
}

TEST(LookAhead, LinesAreTheMotionsTheyStandFor) {
  AxisRates rates;
  rates.rapid.fill(500);
  rates.feed = {100, 80, 60};
  rates.acceleration = {1000, 2000, 500};
  rates.jerk.fill(kNoLimit);
  rates.sample_s = 0.01;
  const LinePath path = random_lines(3, 3000);
  PieceArrays pieces, again;
  SpeedPlan made, parallel;
  plan_lines(path, rates, {0, 1}, pieces, made);
  plan_lines(path, rates, {0, 3, 16}, again, parallel);
  EXPECT_EQ(parallel.speed2, made.speed2);
  AxisVector before{};
  for (std::size_t i = 0; i < path.size(); ++i) {
    ir::Motion motion;
    motion.kind = ir::MotionKind::linear;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      motion.start[axis] = path.points[axis][i];
      motion.end[axis] = path.points[axis][i + 1];
    }
    const PathShape shape = shape_of(motion, false);
    const double speed = std::min(speed_limit(shape, rates, false), path.feed[i]);
    ASSERT_NEAR(pieces.length[i], shape.length, 1e-12 * shape.length);
    ASSERT_NEAR(pieces.speed2[i], speed * speed, 1e-9);
    ASSERT_NEAR(pieces.acceleration[i], path_acceleration(shape, rates), 1e-9);
    if (i > 0) {
      ASSERT_NEAR(pieces.start2[i], corner_speed2(before, shape.start_direction, rates, 0.0), 1e-9 * pieces.start2[i]);
    }
    before = shape.end_direction;
  }
}

}  // namespace
}  // namespace dripfeed::timing
