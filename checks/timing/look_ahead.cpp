// In parallel: the path is cut into one part a thread. The backward sweep of a part needs the square at its end, which
// the part after it has not got yet. So each is swept as if it went on without limit, and then settled from the last
// part to the first with the true square: at the first junction whose own limit is below both, speculation and truth
// are equal bit for bit, and so they are at all before it (a rest is such a junction, too). The same forward.
//
//   thread 0   |<-- b, from no limit --|     |-- v, seconds -->|
//   thread 1   |<-- b, from rest ------|     |-- v, seconds -->|
//                                      settle                  settle
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
// Pieces whose seconds are summed by themselves: parts begin where one does, so that the sum is the same for any parts.
constexpr std::size_t kSummed = 64;
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
    plan_.reswept = 0;
    plan_.speed2.back() = 0.0;
    sums_s_.resize((pieces.size() + kSummed - 1) / kSummed);
  }

  void run() {
    const auto count = static_cast<std::ptrdiff_t>(parts_.size());
    std::barrier prepared(count, [this]() noexcept {
      if (blocks_ > 0) change_sums(pieces_, sums_);
    });
    std::barrier limited(count, [this]() noexcept { resweep_backward(); });
    const auto work = [&](const Range& part) {
      if (prepare_) prepare_(part);
      prepared.arrive_and_wait();
      look_back(part);
      limited.arrive_and_wait();
      go_ahead(part);
    };
    std::vector<std::jthread> others;
    for (const Range& part : std::span(parts_).subspan(1)) others.emplace_back([&work, &part] { work(part); });
    work(parts_.front());
    others.clear();  // joins
    resweep_forward();
    plan_.total_s = 0.0;
    for (const double sum_s : sums_s_) plan_.total_s += sum_s;
  }

 private:
  static std::vector<Range> parts_of(std::size_t size, const LookAhead& look_ahead) {
    const std::size_t grain = std::max<std::size_t>(look_ahead.grain, 1);
    const std::size_t grains = size / grain;
    const std::size_t count = std::clamp<std::size_t>(look_ahead.threads, 1, std::max<std::size_t>(grains, 1));
    std::vector<Range> parts(count);
    const auto border = [&](std::size_t k) { return k == count ? size : size * k / count / kSummed * kSummed; };
    for (std::size_t k = 0; k < count; ++k) parts[k] = {border(k), border(k + 1)};
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

  // Speeds, and the seconds that come of them. The last piece of a part is wrong as long as the part after it is.
  void go_ahead(const Range& part) {
    for (std::size_t begin = part.begin; begin < part.end; begin += kStretch) {
      const std::size_t end = std::min(begin + kStretch, part.end);
      sweep_ahead(pieces_, {begin, std::min(end + 1, part.end)}, plan_.speed2.data());
      take_time({begin, end});
    }
  }
  // Of whole sums: `range` begins where one does, and ends so or with the path.
  void take_time(const Range& range) {
    durations(pieces_, range, plan_.speed2.data(), plan_.duration_s.data());
    for (std::size_t i = range.begin; i < range.end; i += kSummed)
      sums_s_[i / kSummed] = sum_of(std::span(plan_.duration_s).subspan(i, std::min(kSummed, range.end - i)));
  }

  void resweep_backward() {
    for (std::size_t k = parts_.size() - 1; k-- > 0;) {
      plan_.reswept += resweep_back(pieces_, parts_[k], plan_.speed2[parts_[k].end], plan_.speed2.data());
    }
  }
  void resweep_forward() {
    for (std::size_t k = 1; k < parts_.size(); ++k) {
      const std::size_t i = parts_[k].begin;
      if (i == 0 || i == parts_[k].end) continue;
      const double first = std::min(plan_.speed2[i], plan_.speed2[i - 1] + change2(pieces_, i - 1));
      const std::size_t changed = resweep_ahead(pieces_, parts_[k], first, plan_.speed2.data());
      plan_.reswept += changed;
      const std::size_t last = std::min(i + changed + 1, pieces_.size());
      take_time({(i - 1) / kSummed * kSummed, std::min((last + kSummed - 1) / kSummed * kSummed, pieces_.size())});
    }
  }

  // Eight sums side by side.
  static double sum_of(std::span<const double> values) {
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
  std::vector<double> sums_;    // change_sums
  std::vector<double> sums_s_;  // of the seconds of kSummed pieces each
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
