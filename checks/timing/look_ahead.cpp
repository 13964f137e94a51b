// In parallel: the path is cut into one part a thread. The backward sweep of a part needs the square at its end, which
// the part behind it has not got yet. So each is swept as if it went on without limit, and then settled from the last
// part to the first with the true square: at the first junction whose own limit is below both, speculation and truth
// are equal bit for bit, and so they are at all before it (a rest is such a junction, too). The same forward.
//
//   thread 0   |<-- b, from no limit --|     |-- v -->|           |-- seconds --|
//   thread 1   |<-- b, from rest ------|     |-- v -->|           |-- seconds --|
//                                      settle         settle
//
// Where a path is limited by its acceleration alone, nothing meets and settling is a serial sweep: still the same bits,
// and still one addition and one minimum a piece.
#include "checks/timing/look_ahead.h"

#include <algorithm>
#include <array>
#include <barrier>
#include <functional>
#include <span>
#include <thread>
#include <utility>

#include "checks/timing/sweep.h"

namespace dripfeed::timing {

namespace {

// Pieces whose limits stay in the first-level cache until they are swept.
constexpr std::size_t kStretch = 1024;
constexpr double kSpeed2Cap = 1e9;  // no machine comes near: keeps sums exact where an acceleration is not known

class PathPlan {
 public:
  // Makes the pieces of a range; nothing: they are there.
  using Prepare = std::function<void(Range)>;

  PathPlan(const PieceArrays& pieces, const LookAhead& look_ahead, SpeedPlan& plan, Prepare prepare)
      : pieces_(pieces),
        prepare_(std::move(prepare)),
        blocks_(look_ahead.blocks),
        plan_(plan),
        parts_(parts_of(pieces.size(), look_ahead)) {
    plan_.speed2.resize(pieces.size() + 1);
    plan_.duration_s.resize(pieces.size());
    plan_.settled = 0;
    plan_.speed2.back() = 0.0;
  }

  void run() {
    const auto count = static_cast<std::ptrdiff_t>(parts_.size());
    std::barrier prepared(count, [this]() noexcept {
      if (blocks_ > 0) change_sums(pieces_, sums_);
    });
    std::barrier limited(count, [this]() noexcept { settle_backward(); });
    std::barrier planned(count, [this]() noexcept { settle_forward(); });
    const auto work = [&](const Range& part) {
      if (prepare_) prepare_(part);
      prepared.arrive_and_wait();
      look_back(part);
      limited.arrive_and_wait();
      sweep_ahead(pieces_, part, plan_.speed2.data());
      planned.arrive_and_wait();
      durations(pieces_, part, plan_.speed2.data(), plan_.duration_s.data());
    };
    std::vector<std::jthread> others;
    for (const Range& part : std::span(parts_).subspan(1)) others.emplace_back([&work, &part] { work(part); });
    work(parts_.front());
    others.clear();  // joins
    plan_.total_s = sum_of(plan_.duration_s);
  }

 private:
  static std::vector<Range> parts_of(std::size_t size, const LookAhead& look_ahead) {
    const std::size_t grain = std::max<std::size_t>(look_ahead.grain, 1);
    const std::size_t grains = size / grain;
    const std::size_t count = std::clamp<std::size_t>(look_ahead.threads, 1, std::max<std::size_t>(grains, 1));
    std::vector<Range> parts(count);
    for (std::size_t k = 0; k < count; ++k) parts[k] = {size * k / count, size * (k + 1) / count};
    return parts;
  }

  void look_back(const Range& part) {
    double* speed2 = plan_.speed2.data();
    for (std::size_t end = part.end; end > part.begin;) {
      const Range stretch{end - std::min(kStretch, end - part.begin), end};
      const bool is_last = end == pieces_.size();
      junction_limits(pieces_, stretch, speed2);
      if (blocks_ > 0) horizon_limits(sums_.data(), pieces_.size(), blocks_, stretch, speed2);
      sweep_back(pieces_, stretch, is_last ? 0.0 : end == part.end ? kNoLimit : speed2[end], speed2);
      end = stretch.begin;
    }
  }

  void settle_backward() {
    for (std::size_t k = parts_.size() - 1; k-- > 0;) {
      plan_.settled += settle_back(pieces_, parts_[k], plan_.speed2[parts_[k].end], plan_.speed2.data());
    }
  }
  void settle_forward() {
    for (std::size_t k = 1; k < parts_.size(); ++k) {
      const std::size_t i = parts_[k].begin;
      const double first = std::min(plan_.speed2[i], plan_.speed2[i - 1] + change2(pieces_, i - 1));
      plan_.settled += settle_ahead(pieces_, parts_[k], first, plan_.speed2.data());
    }
  }

  // Eight sums side by side: the same for any parts.
  static double sum_of(const std::vector<double>& values) {
    std::array<double, 8> sums{};
    for (std::size_t i = 0; i < values.size(); ++i) sums[i % 8] += values[i];
    double sum = 0.0;
    for (const double one : sums) sum += one;
    return sum;
  }

  const PieceArrays& pieces_;
  Prepare prepare_;
  std::size_t blocks_;
  SpeedPlan& plan_;
  std::vector<Range> parts_;
  std::vector<double> sums_;
};

}  // namespace

void change_sums(const PieceArrays& pieces, std::vector<double>& sums) {
  sums.resize(pieces.size() + 1);
  sums[0] = 0.0;
  for (std::size_t i = 0; i < pieces.size(); ++i) sums[i + 1] = sums[i] + std::min(change2(pieces, i), kSpeed2Cap);
}

void plan_path(const PieceArrays& pieces, const LookAhead& look_ahead, SpeedPlan& plan) {
  PathPlan(pieces, look_ahead, plan, {}).run();
}

void plan_lines(const LinePath& path, const AxisRates& rates, const LookAhead& look_ahead, PieceArrays& pieces,
                SpeedPlan& plan) {
  pieces.resize(path.size());
  PathPlan(pieces, look_ahead, plan, [&](Range range) { line_pieces(path, rates, range, pieces); }).run();
}

}  // namespace dripfeed::timing
