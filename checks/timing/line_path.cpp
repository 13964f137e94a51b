// Each limit along the path is the smallest of limit[axis] / |direction[axis]|: the reciprocal of the largest
// |direction| / limit, so that a move costs one division a limit. In stretches that stay in the cache, one loop a
// figure, without a branch.
#include "checks/timing/line_path.h"

#include <algorithm>
#include <cmath>

namespace dripfeed::timing {

namespace {

constexpr std::size_t kStretch = 512;
using Directions = std::array<std::array<double, kStretch + 1>, 3>;  // [axis][1 + move]; [axis][0]: the move before

struct Reciprocals {
  std::array<double, 3> feed, acceleration, corner;
};
Reciprocals reciprocals_of(const AxisRates& rates) {
  Reciprocals r{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    r.feed[axis] = 1.0 / rates.feed[axis];
    r.acceleration[axis] = 1.0 / rates.acceleration[axis];
    r.corner[axis] = rates.sample_s > 0.0 ? r.acceleration[axis] / rates.sample_s : 0.0;
  }
  return r;
}

double larger(double a, double b) { return a > b ? a : b; }

void stretch_directions(const LinePath& path, std::size_t begin, std::size_t count, Directions& u, double* length) {
  const double* x = path.points[0].data() + begin;
  const double* y = path.points[1].data() + begin;
  const double* z = path.points[2].data() + begin;
  for (std::size_t i = 0; i < count; ++i) {
    const double dx = x[i + 1] - x[i];
    const double dy = y[i + 1] - y[i];
    const double dz = z[i + 1] - z[i];
    const double l = std::sqrt(dx * dx + dy * dy + dz * dz);
    const double inverse = 1.0 / l;
    length[i] = l;
    u[0][i + 1] = dx * inverse;
    u[1][i + 1] = dy * inverse;
    u[2][i + 1] = dz * inverse;
  }
}

void stretch_limits(const LinePath& path, const Reciprocals& r, double feed_limit, std::size_t begin, std::size_t count,
                    const Directions& u, PieceArrays& pieces) {
  constexpr double kLeast = 1.0 / kNoLimit;
  const double* feed = path.feed.data() + begin;
  double* speed2 = pieces.speed2.data() + begin;
  double* start2 = pieces.start2.data() + begin;
  double* acceleration = pieces.acceleration.data() + begin;
  for (std::size_t i = 0; i < count; ++i) {
    double feed_most = kLeast;
    double acceleration_most = kLeast;
    double corner_most = kLeast;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double share = std::fabs(u[axis][i + 1]);
      feed_most = larger(share * r.feed[axis], feed_most);
      acceleration_most = larger(share * r.acceleration[axis], acceleration_most);
      corner_most = larger(std::fabs(u[axis][i + 1] - u[axis][i]) * r.corner[axis], corner_most);
    }
    const double most = feed[i] < feed_limit ? feed[i] : feed_limit;
    const double speed = most * feed_most < 1.0 ? most : 1.0 / feed_most;
    speed2[i] = speed * speed;
    acceleration[i] = 1.0 / acceleration_most;
    const double corner = 1.0 / larger(corner_most, 1e-7);  // its square stays below "no limit"
    start2[i] = corner * corner;
  }
}

}  // namespace

void line_pieces(const LinePath& path, const AxisRates& rates, Range range, PieceArrays& pieces) {
  const Reciprocals r = reciprocals_of(rates);
  Directions u;
  std::array<double, 1> before{};
  if (range.begin > 0 && range.begin < range.end) {
    stretch_directions(path, range.begin - 1, 1, u, before.data());
    for (auto& axis : u) axis[0] = axis[1];
  } else {
    for (auto& axis : u) axis[0] = 0.0;
  }
  for (std::size_t begin = range.begin; begin < range.end; begin += kStretch) {
    const std::size_t count = std::min(kStretch, range.end - begin);
    stretch_directions(path, begin, count, u, pieces.length.data() + begin);
    stretch_limits(path, r, rates.feed_limit, begin, count, u, pieces);
    for (auto& axis : u) axis[0] = axis[count];
  }
  if (range.begin == 0 && range.end > 0) pieces.start2[0] = 0.0;
}

}  // namespace dripfeed::timing
