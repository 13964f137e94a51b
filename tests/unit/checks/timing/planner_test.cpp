// The plan against closed forms, against a relaxation that knows nothing of sweeps, and against itself with other
// chunks.
#include "checks/timing/planner.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include <gtest/gtest.h>

namespace dripfeed::timing {
namespace {

struct Planned {
  double duration, start, end;
  bool operator==(const Planned&) const = default;
};

class Collect final : public PlanSink {
 public:
  void planned(double duration_s, double start, double end) override { all.push_back({duration_s, start, end}); }
  std::vector<Planned> all;
};

std::vector<Planned> plan(const std::vector<PlannedPiece>& pieces, std::size_t look_ahead = 0,
                          std::size_t chunk = 4096) {
  Collect collect;
  Planner planner(collect, look_ahead, chunk);
  for (const PlannedPiece& piece : pieces) planner.append(piece);
  planner.finish();
  return collect.all;
}

double total(const std::vector<Planned>& planned) {
  double sum = 0;
  for (const Planned& one : planned) sum += one.duration;
  return sum;
}

std::vector<PlannedPiece> random_path(unsigned seed, std::size_t count, double rest_share = 0.02) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(0, 1);
  std::vector<PlannedPiece> pieces(count);
  for (PlannedPiece& piece : pieces) {
    piece.length = std::pow(10.0, 3 * unit(random) - 2);
    piece.speed2 = std::pow(10 + 190 * unit(random), 2);
    piece.start2 = unit(random) < rest_share ? 0.0 : std::pow(200 * unit(random), 2);
    piece.acceleration = 200 + 2000 * unit(random);
  }
  return pieces;
}

// Squares of speed at the junctions by lowering them until no limit is passed: the largest such profile.
std::vector<double> relaxed(const std::vector<PlannedPiece>& pieces, std::size_t look_ahead) {
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

TEST(Planner, MakesATrapezoidOfOnePiece) {
  const auto planned = plan({{100, 100.0 * 100, 0, 1000}});
  ASSERT_EQ(planned.size(), 1U);
  EXPECT_NEAR(planned[0].duration, 1.1, 1e-12);
}

TEST(Planner, MakesATriangleOfAShortPiece) {
  EXPECT_NEAR(total(plan({{2.5, 100.0 * 100, 0, 1000}})), 2 * std::sqrt(2.5 / 1000), 1e-12);
}

TEST(Planner, PassesAStraightJunctionAsIfItWereNone) {
  const auto planned = plan({{50, 1e4, 0, 1000}, {50, 1e4, kNoLimit, 1000}});
  EXPECT_NEAR(total(planned), 1.1, 1e-12);
  EXPECT_NEAR(planned[0].end, 100, 1e-9);
}

TEST(Planner, SlowsDownToACornerAndStopsAtARest) {
  const auto corner = plan({{50, 1e4, 0, 1000}, {50, 1e4, 100, 1000}});
  const double leg = 0.1 + 0.09 + (50 - 5 - 4.95) / 100;
  EXPECT_NEAR(total(corner), 2 * leg, 1e-12);
  const auto rest = plan({{50, 1e4, 0, 1000}, {50, 1e4, 0, 1000}});
  EXPECT_NEAR(total(rest), 1.2, 1e-12);
}

TEST(Planner, LooksBackOverManyShortPieces) {
  // 1000 pieces of 0.01 mm: 10 mm in all, triangle up to 100 mm/s at half way.
  std::vector<PlannedPiece> pieces(1000, {0.01, 1e6, kNoLimit, 1000});
  pieces.front().start2 = 0;
  const auto planned = plan(pieces);
  EXPECT_NEAR(total(planned), 0.2, 1e-9);
  EXPECT_NEAR(planned[499].end, 100, 1e-6);
}

TEST(Planner, IsTheLargestPlanThatPassesNoLimit) {
  for (unsigned seed = 0; seed < 200; ++seed) {
    const auto pieces = random_path(seed, 1 + seed % 60);
    const std::size_t look_ahead = seed % 3 == 0 ? 0 : 1 + seed % 7;
    const auto planned = plan(pieces, look_ahead, 2 + seed % 9);
    const auto oracle = relaxed(pieces, look_ahead);
    ASSERT_EQ(planned.size(), pieces.size());
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      EXPECT_NEAR(planned[i].start * planned[i].start, oracle[i], 1e-6 + 1e-9 * oracle[i]) << seed << ' ' << i;
      EXPECT_NEAR(planned[i].end * planned[i].end, oracle[i + 1], 1e-6 + 1e-9 * oracle[i + 1]);
      // The time cannot be below that at the highest speed, nor below that of the mean speed's change.
      EXPECT_GE(planned[i].duration, pieces[i].length / std::sqrt(pieces[i].speed2) * (1 - 1e-12));
      EXPECT_GE(planned[i].duration * pieces[i].acceleration * (1 + 1e-9) + 1e-9,
                std::fabs(planned[i].end - planned[i].start));
    }
  }
}

TEST(Planner, GivesTheSameBitsForEveryChunk) {
  for (const double rest_share : {0.0, 0.001, 0.05}) {
    const auto pieces = random_path(99, 20000, rest_share);
    for (const std::size_t look_ahead : {std::size_t{0}, std::size_t{5}, std::size_t{300}}) {
      const auto whole = plan(pieces, look_ahead, 1U << 20U);
      for (const std::size_t chunk : {2U, 17U, 1000U}) EXPECT_TRUE(plan(pieces, look_ahead, chunk) == whole) << chunk;
    }
  }
}

TEST(Planner, ALongerLookAheadIsNeverSlower) {
  const auto pieces = random_path(5, 2000);
  double before = 1e300;
  for (const std::size_t look_ahead : {1U, 2U, 5U, 20U, 100U, 1000U}) {
    const double time = total(plan(pieces, look_ahead));
    EXPECT_LE(time, before * (1 + 1e-12));
    before = time;
  }
  EXPECT_LE(total(plan(pieces, 0)), before * (1 + 1e-12));
}

TEST(Planner, KeepsFewPiecesOfALongPath) {
  Collect collect;
  Planner planner(collect, 0, 1024);
  std::size_t most = 0;
  for (int i = 0; i < 1000000; ++i) {
    planner.append({0.1, 1e4, i == 0 ? 0.0 : 8100.0, 1000});
    most = std::max(most, planner.kept());
    collect.all.clear();
  }
  EXPECT_LE(most, 2048U);
}

TEST(Planner, KeepsMoreWhereThePathNeedsItToStop) {
  // 0.0001 mm a piece at 100 mm/s and 100 mm/s²: 500000 pieces to stop.
  std::vector<PlannedPiece> pieces(1200000, {0.0001, 1e4, kNoLimit, 100});
  pieces.front().start2 = 0;
  const double time = total(plan(pieces, 0, 64));
  EXPECT_NEAR(time, 120.0 / 100 + 100.0 / 100, 1e-6);
}

}  // namespace
}  // namespace dripfeed::timing
