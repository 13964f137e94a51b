// As in S.-H. Suh and others, "Theory and Design of CNC Systems", and as small open controls do it: entry speeds are
// optimal up to a mark that moves on, so that most sweeps are short; a junction's speed comes from a small arc of
// deviation that fits the corner.
#include "tests/bench/ring_planner.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace dripfeed::bench {

namespace {

struct Block {
  float entry2 = 0, most_entry2 = 0, acceleration = 0, millimeters = 0, feed = 0, junction2 = 0;
};

class Ring {
 public:
  Ring(std::size_t size, float acceleration) : blocks_(size), acceleration_(acceleration) {}

  void add(const std::array<float, 3>& delta, float feed) {
    if (count_ == blocks_.size()) drop();
    Block& block = blocks_[at(count_)];
    const float length = std::sqrt(delta[0] * delta[0] + delta[1] * delta[1] + delta[2] * delta[2]);
    const float inverse = 1.0F / length;
    std::array<float, 3> unit{};
    float share = 0;
    float cosine = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      unit[axis] = delta[axis] * inverse;
      share = std::max(share, std::fabs(unit[axis]));
      cosine -= before_[axis] * unit[axis];
    }
    block.millimeters = length;
    block.acceleration = acceleration_ / share;
    block.feed = feed;
    block.junction2 = count_ == 0 ? 0.0F : junction2(cosine, block.acceleration);
    block.most_entry2 = std::min({block.junction2, feed * feed, feed_before_ * feed_before_});
    before_ = unit;
    feed_before_ = feed;
    ++count_;
    recalculate();
  }
  void finish() {
    while (count_ > 0) drop();
  }
  [[nodiscard]] double sum() const { return sum_; }

 private:
  [[nodiscard]] std::size_t at(std::size_t i) const {
    const std::size_t place = first_ + i;
    return place < blocks_.size() ? place : place - blocks_.size();
  }
  float junction2(float cosine, float acceleration) const {
    constexpr float kDeviation_mm = 0.01F;
    if (cosine > 0.999999F) return 0.0F;
    if (cosine < -0.999999F) return 1e12F;
    const float half_sine = std::sqrt(0.5F * (1.0F - cosine));
    return acceleration * kDeviation_mm * half_sine / (1.0F - half_sine);
  }
  void drop() {
    sum_ += static_cast<double>(std::sqrt(blocks_[first_].entry2));
    first_ = at(1);
    --count_;
    if (planned_ > 0) --planned_;
  }
  void recalculate() {
    std::size_t i = count_ - 1;
    if (i == planned_) return;
    Block* current = &blocks_[at(i)];
    current->entry2 = std::min(current->most_entry2, 2 * current->acceleration * current->millimeters);
    while (--i > planned_) {
      Block* next = current;
      current = &blocks_[at(i)];
      if (current->entry2 == current->most_entry2) continue;
      const float reach2 = next->entry2 + 2 * current->acceleration * current->millimeters;
      current->entry2 = std::min(reach2, current->most_entry2);
    }
    for (i = planned_; i + 1 < count_; ++i) {
      Block& one = blocks_[at(i)];
      Block& next = blocks_[at(i + 1)];
      if (one.entry2 < next.entry2) {
        const float reach2 = one.entry2 + 2 * one.acceleration * one.millimeters;
        if (reach2 < next.entry2) {
          next.entry2 = reach2;
          planned_ = i + 1;
        }
      }
      if (next.entry2 == next.most_entry2) planned_ = i + 1;
    }
  }

  std::vector<Block> blocks_;
  float acceleration_;
  std::size_t first_ = 0, count_ = 0, planned_ = 0;
  std::array<float, 3> before_{};
  float feed_before_ = 0;
  double sum_ = 0;
};

}  // namespace

double plan_in_ring(const timing::LinePath& path, double acceleration, std::size_t ring_size) {
  Ring ring(ring_size, static_cast<float>(acceleration));
  for (std::size_t i = 0; i < path.size(); ++i) {
    std::array<float, 3> delta{};
    for (std::size_t axis = 0; axis < 3; ++axis)
      delta[axis] = static_cast<float>(path.points[axis][i + 1] - path.points[axis][i]);
    ring.add(delta, static_cast<float>(path.feed[i]));
  }
  ring.finish();
  return ring.sum();
}

}  // namespace dripfeed::bench
