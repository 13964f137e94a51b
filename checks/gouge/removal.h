// What the cuts of a run take away, place by place with the moment of each, so that the stock can be shown as it was at
// any moment. A moment is whatever the caller counts by: a time, or places along a path.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "dialects/ir/motion.h"

namespace dripfeed::gouge {

// From this moment on the place has this height: of a map the height, of a bar the radius.
struct Removal {
  std::uint32_t place = 0;
  float height_mm = 0.0F;  // -infinity: no material is left
  double moment = 0.0;
};

class RemovalLog {
 public:
  struct Moments {
    double first = 0.0;  // when the motion begins
    double last = 0.0;
  };
  using MomentsOf = std::function<Moments(const ir::Motion&)>;
  static constexpr std::size_t kMostEntries = 600'000;

  // At most so many are kept: beyond, what a place loses within a span of moments counts as lost at once, and the span
  // grows.
  explicit RemovalLog(MomentsOf moments_of, std::size_t most = kMostEntries);

  // A cut along a part of a motion, in shares of it: 0 its start, 1 its end.
  void begin(const ir::Motion& motion, double from, double to);
  // It leaves this height; `share` of the cut lies before.
  void take(std::size_t place, double height_mm, double share);

  // In the order of their moments.
  [[nodiscard]] std::vector<Removal> finish();
  [[nodiscard]] double span() const { return span_; }

 private:
  void thin_out();
  bool joins(std::uint32_t place, float height_mm, double moment);

  MomentsOf moments_of_;
  std::size_t most_;
  double first_ = 0.0;  // of the cut
  double length_ = 0.0;
  double latest_ = 0.0;
  double span_ = 0.0;  // 0: each is kept
  std::vector<Removal> entries_;
  std::vector<std::uint32_t> newest_;  // by place, index of its newest entry and 1; 0: none
};

}  // namespace dripfeed::gouge
