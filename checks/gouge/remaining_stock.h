// The outside of a turned bar as it is left by the cuts so far: a radius at equal steps along z. A step knows its
// height exactly; between two places nothing is known, so what is narrower than the step may pass unseen, and nothing
// that is not there is ever reported.
#pragma once

#include <cstddef>
#include <vector>

#include "checks/gouge/removal.h"
#include "dialects/curves/nose.h"
#include "dialects/curves/path.h"
#include "dialects/curves/point.h"

namespace dripfeed::gouge {

struct Touch {
  double depth_mm = 0.0;  // 0: none
  double z_mm = 0.0;
};

class RemainingStock {
 public:
  // A bar of `radius` over `z`; at most kMostPlaces places, the step grows beyond.
  RemainingStock(double radius, curves::Range z, double step);

  // The deepest place at which the nose, led along the path of its tip, would enter what is left by more than `slack`
  // mm.
  [[nodiscard]] Touch touch(const curves::Nose& nose, const curves::PathPiece& tip_path, double slack) const;
  // Takes away what the nose passes.
  void cut(const curves::Nose& nose, const curves::PathPiece& tip_path);
  // From now on `log`, which must outlive this, gets what the cuts take away, by place from the lowest z on.
  void log_to(RemovalLog* log) { log_ = log; }
  [[nodiscard]] const std::vector<double>& radii() const { return heights_; }
  [[nodiscard]] double z_low() const { return z_.low; }
  [[nodiscard]] double step_mm() const { return step_; }
  // Radius left at z, the lower of its two neighbours between places; 0 beyond the bar's ends.
  [[nodiscard]] double height(double z) const;
  // At most `most` points from end to end, of several places the lowest.
  [[nodiscard]] std::vector<curves::Point> outline(std::size_t most) const;

 private:
  static constexpr std::size_t kMostPlaces = 65536;

  [[nodiscard]] double z_at(std::size_t place) const { return z_.low + static_cast<double>(place) * step_; }
  // Calls visit(place, x) for the places that a nose with its centre on the segment passes, x its lowest there.
  template <class Visit>
  void pass(double radius, const curves::Segment& centers, Visit&& visit) const;

  curves::Range z_;
  double step_ = 0.0;
  std::vector<double> heights_;
  RemovalLog* log_ = nullptr;
};

}  // namespace dripfeed::gouge
