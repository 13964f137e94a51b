// Bisection: a faster line never makes a block come later, a slower feed never makes the machine want it earlier.
#include "checks/timing/advice.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "checks/timing/execution.h"
#include "checks/timing/look_ahead.h"

namespace dripfeed::timing {

namespace {

constexpr std::array<double, 15> kBauds = {300,   600,   1200,   2400,   4800,   9600,   14400, 19200,
                                           38400, 57600, 115200, 230400, 460800, 921600, 4e6};
constexpr double kMostSlower = 64.0;
constexpr double kFeedStep = 1.03;
constexpr double kBaudStep = 1.02;
constexpr double kFirstStep = 1.1;
constexpr double kSlack = 1e-3;  // of the time: so much slower by short sight is not yet starving

// Ends the run at the first stall, or when too much time was lost.
class Watch final : public RanSink {
 public:
  explicit Watch(double most_s) : most_s_(most_s) {}
  bool ran(const Row& /*row*/, const Ran& how) override {
    spent_s_ += how.duration_s;
    starves_ = how.waited_s > kStall_s || spent_s_ > most_s_;
    return !starves_;
  }
  [[nodiscard]] bool starves() const { return starves_; }

 private:
  double most_s_;
  double spent_s_ = 0.0;
  bool starves_ = false;
};

class Advisor {
 public:
  Advisor(const WholeProgram& program, const SupplySettings& supply, std::size_t look_ahead, unsigned threads)
      : program_(program),
        supply_(supply),
        look_ahead_{look_ahead, threads},
        execution_(supply),
        pieces_(program.pieces) {
    double line_s = 0.0;
    double compute_s = 0.0;
    for (const Row& row : program.rows) {
      events_s_ += row.event_s;
      line_s += row.bytes * supply.char_s + row.lines * supply.line_delay_s;
      compute_s += row.compute_s;
    }
    change_sums(pieces_, sums_);
    plan_path(pieces_, look_ahead_, plan_);
    const double planned_s = plan_.total_s + events_s_;
    shortage_ = planned_s > 0.0 ? std::max(line_s, compute_s) / planned_s : 1.0;
  }

  // How many times longer line or computing take than the motion: a buffer helps beyond that for a while only.
  [[nodiscard]] double shortage() const { return shortage_; }
  bool starves(double char_s) {
    SupplySettings supply = supply_;
    supply.char_s = char_s;
    Watch watch((plan_.total_s + events_s_) * (1.0 + kSlack));
    execution_.restart(supply);
    execution_.run({program_.rows, pieces_, plan_.speed2, plan_.duration_s, sums_, pieces_.size(), true}, watch);
    return watch.starves();
  }
  bool starves_at(double share) {
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
      const double feed = program_.feed_mm_s[i] < kNoLimit ? program_.feed_mm_s[i] * share : kNoLimit;
      const double speed = std::min(program_.limit_mm_s[i], feed);
      pieces_.speed2[i] = std::min(speed * speed, kNoLimit);
    }
    plan_path(pieces_, look_ahead_, plan_);
    return starves(supply_.char_s);
  }

 private:
  const WholeProgram& program_;
  SupplySettings supply_;
  LookAhead look_ahead_;
  Execution execution_;
  PieceArrays pieces_;
  std::vector<double> sums_;
  SpeedPlan plan_;
  double events_s_ = 0.0;
  double shortage_ = 1.0;
};

// The least value that does not starve, to the share `within`: `low` starves, `high` may; nothing when that starves,
// too. From `guess` on in growing steps, because a run takes as long as the program is; then by halves.
template <class Starves>
std::optional<double> least(double low, double high, double guess, double within, Starves&& starves) {
  if (!(low < high)) return std::nullopt;  // it is beyond what can be tried already
  double at = std::clamp(guess, low, high);
  const bool first = starves(at);
  (first ? low : high) = at;
  bool held = !first;
  for (double step = kFirstStep;; step *= step) {
    at = first ? low * step : high / step;
    if (!(at > low && at < high)) break;
    const bool now = starves(at);
    (now ? low : high) = at;
    held = held || !now;
    if (now != first) break;
  }
  while (high > low * within) {
    at = std::sqrt(low * high);
    const bool now = starves(at);
    (now ? low : high) = at;
    held = held || !now;
  }
  if (!held && starves(high)) return std::nullopt;
  return high;
}

std::optional<double> least_baud(Advisor& advisor, const Line& line) {
  const auto baud = least(line.baud, kBauds.back(), line.baud * advisor.shortage(), kBaudStep,
                          [&](double at) { return advisor.starves(line.char_s(at)); });
  return baud ? std::optional(std::ceil(*baud)) : std::nullopt;
}
// As how many times slower the feeds must be.
std::optional<double> most_share(Advisor& advisor) {
  const auto slower =
      least(1.0, kMostSlower, advisor.shortage(), kFeedStep, [&](double at) { return advisor.starves_at(1.0 / at); });
  return slower ? std::optional(1.0 / *slower) : std::nullopt;
}

}  // namespace

Advice advise(const WholeProgram& program, const SupplySettings& supply, const std::optional<Line>& line,
              std::size_t look_ahead, unsigned threads) {
  Advice advice;
  Advisor advisor(program, supply, look_ahead, threads);
  if (!advisor.starves(supply.char_s)) return advice;
  if (line && supply.char_s > 0.0) {
    advice.baud = least_baud(advisor, *line);
    if (advice.baud) advice.standard_baud = *std::ranges::lower_bound(kBauds, *advice.baud);
  }
  advice.feed_share = most_share(advisor);
  if (!advice.feed_share) return advice;
  double most_feed = 0.0;
  for (const double feed : program.feed_mm_s) {
    if (feed < kNoLimit) most_feed = std::max(most_feed, feed);
  }
  advice.feed_mm_min = *advice.feed_share * most_feed * 60.0;
  return advice;
}

}  // namespace dripfeed::timing
