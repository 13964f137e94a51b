// The nose led along a straight piece sweeps a capsule. Its lower edge over z is an arc of the nose at the one end, the
// line that both noses touch, and an arc at the other end:
//
//        . - .                 A place z under the line takes the line, one next to it the nearer end's arc.
//      (   A   )- - _ . - .
//        ' - _ - - _(   B   )  Arcs of the path are taken as chords that lie within 0.0002 mm of them.
//              ' - . ' - '
#include "checks/gouge/remaining_stock.h"

#include <algorithm>
#include <cmath>

namespace dripfeed::gouge {

namespace {

constexpr double kArcError_mm = 2e-4;
constexpr double kUpright_mm = 1e-12;

// Calls visit(segment) for the piece, an arc as chords.
template <class Visit>
void for_segments(const curves::PathPiece& piece, Visit&& visit) {
  if (const auto* segment = std::get_if<curves::Segment>(&piece)) {
    visit(*segment);
    return;
  }
  const auto& arc = std::get<curves::Arc>(piece);
  // A chord over the angle a is r(1 - cos(a/2)) off: about r·a²/8.
  const double angle = std::sqrt(8.0 * kArcError_mm / arc.radius);
  const int chords = std::clamp(static_cast<int>(std::ceil(std::fabs(arc.sweep) / angle)), 1, 100000);
  curves::Point before = arc.at(0.0);
  for (int i = 1; i <= chords; ++i) {
    const curves::Point here = arc.at(static_cast<double>(i) / chords);
    visit(curves::Segment{before, here});
    before = here;
  }
}

// How much of the path lies before z is reached, 0 to 1.
double share_before(const curves::Segment& centers, double z) {
  const double length = centers.b.z - centers.a.z;
  return std::fabs(length) > kUpright_mm ? std::clamp((z - centers.a.z) / length, 0.0, 1.0) : 1.0;
}

// Lower edge of the swept capsule.
class LowerEdge {
 public:
  LowerEdge(double radius, const curves::Segment& centers) : radius_(radius), a_(centers.a), b_(centers.b) {
    if (a_.z > b_.z) std::swap(a_, b_);
    const curves::Point along = curves::unit(b_ - a_);
    offset_ = {radius_ * along.x, -radius_ * along.z};  // a quarter turn to the right of +z: downwards
    upright_ = b_.z - a_.z <= kUpright_mm;
  }
  [[nodiscard]] double low_z() const { return a_.z - radius_; }
  [[nodiscard]] double high_z() const { return b_.z + radius_; }
  [[nodiscard]] double x(double z) const {
    if (upright_) return std::min(of_end(a_, z), of_end(b_, z));
    const double line_z = z - offset_.z;
    if (line_z <= a_.z) return of_end(a_, z);
    if (line_z >= b_.z) return of_end(b_, z);
    return a_.x + (b_.x - a_.x) * ((line_z - a_.z) / (b_.z - a_.z)) + offset_.x;
  }

 private:
  [[nodiscard]] double of_end(curves::Point end, double z) const {
    return end.x - std::sqrt(std::max(0.0, radius_ * radius_ - (z - end.z) * (z - end.z)));
  }
  double radius_;
  curves::Point a_;
  curves::Point b_;
  curves::Point offset_;
  bool upright_ = false;
};

}  // namespace

RemainingStock::RemainingStock(double radius, curves::Range z, double step) : z_(z) {
  const double places = std::ceil(z.width() / step) + 1.0;
  const auto count = static_cast<std::size_t>(std::clamp(places, 2.0, static_cast<double>(kMostPlaces)));
  step_ = z.width() / static_cast<double>(count - 1);
  heights_.assign(count, radius);
}

double RemainingStock::height(double z) const {
  if (!(z_.low < z && z < z_.high)) return 0.0;
  const double place = (z - z_.low) / step_;
  const auto below = std::min(static_cast<std::size_t>(place), heights_.size() - 1);
  const auto above = std::min(static_cast<std::size_t>(std::ceil(place)), heights_.size() - 1);
  return std::min(heights_[below], heights_[above]);
}

std::vector<curves::Point> RemainingStock::outline(std::size_t most) const {
  const std::size_t by = (heights_.size() + most - 1) / most;
  std::vector<curves::Point> points;
  for (std::size_t first = 0; first < heights_.size(); first += by) {
    std::size_t lowest = first;
    for (std::size_t i = first; i < std::min(first + by, heights_.size()); ++i) {
      if (heights_[i] < heights_[lowest]) lowest = i;
    }
    points.push_back({z_at(lowest), heights_[lowest]});
  }
  return points;
}

template <class Visit>
void RemainingStock::pass(double radius, const curves::Segment& centers, Visit&& visit) const {
  const LowerEdge edge(radius, centers);
  const double first = std::ceil((edge.low_z() - z_.low) / step_);
  const double last = std::floor((edge.high_z() - z_.low) / step_);
  const double most = static_cast<double>(heights_.size() - 1);
  if (last < 0.0 || first > most) return;
  const auto end = static_cast<std::size_t>(std::min(last, most));
  for (auto place = static_cast<std::size_t>(std::max(first, 0.0)); place <= end; ++place) {
    visit(place, edge.x(z_at(place)));
  }
}

Touch RemainingStock::touch(const curves::Nose& nose, const curves::PathPiece& tip_path, double slack) const {
  // A nose smaller by the slack, on the same path: what it touches is entered by more than the slack.
  const double radius = std::max(0.0, nose.radius - slack);
  const double shrunk = nose.radius - radius;
  const double missing = slack - shrunk;  // of the slack, for a nose that is smaller than it
  Touch deepest;
  const auto note = [&](double depth, double z) {
    if (depth - missing > 0.0 && depth + shrunk > deepest.depth_mm) deepest = {depth + shrunk, z};
  };
  const auto inside = [&](double z) { return z > z_.low + slack && z < z_.high - slack; };
  for_segments(curves::moved(tip_path, -nose.radius * nose.tip), [&](const curves::Segment& centers) {
    pass(radius, centers, [&](std::size_t place, double x) {
      if (inside(z_at(place))) note(heights_[place] - x, z_at(place));
    });
    for (const curves::Point end : {centers.a, centers.b}) {
      if (inside(end.z)) note(height(end.z) - (end.x - radius), end.z);
    }
  });
  return deepest;
}

void RemainingStock::cut(const curves::Nose& nose, const curves::PathPiece& tip_path) {
  const curves::PathPiece centers_path = curves::moved(tip_path, -nose.radius * nose.tip);
  double segments = 0.0;
  if (log_ != nullptr) for_segments(centers_path, [&](const curves::Segment&) { ++segments; });
  double done = 0.0;
  for_segments(centers_path, [&](const curves::Segment& centers) {
    pass(nose.radius, centers, [&](std::size_t place, double x) {
      if (!(x < heights_[place])) return;
      heights_[place] = x;
      if (log_ != nullptr) log_->take(place, x, (done + share_before(centers, z_at(place))) / segments);
    });
    ++done;
  });
}

}  // namespace dripfeed::gouge
