// See the header for the proof.
#include "dialects/curves/gap.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace dripfeed::curves {

namespace {

constexpr std::size_t kMostParts = 4096;
// Finer than this no one asks. A curve that lies on the circle of an arc comes to it slowly: with the cube of the
// parts.
constexpr double kExact_mm = 1e-8;
constexpr double kExactOfArc_mm = 1e-6;

double largest(Range a) { return std::max(std::fabs(a.low), std::fabs(a.high)); }

Range sum(Range a, Range b) { return {a.low + b.low, a.high + b.high}; }
Range scaled(double k, Range a) { return k >= 0.0 ? Range{k * a.low, k * a.high} : Range{k * a.high, k * a.low}; }
Range product(Range a, Range b) {
  const auto [low, high] = std::minmax({a.low * b.low, a.low * b.high, a.high * b.low, a.high * b.high});
  return {low, high};
}

// The gap and its second derivative for one kind of path.
class Gap {
 public:
  Gap(const ParametricCurve& curve, const PathPiece& piece) : curve_(curve) {
    if (const auto* segment = std::get_if<Segment>(&piece)) {
      const Point along = segment->direction();
      normal_ = {-along.x, along.z};
      from_ = segment->a;
      fine_ = segment->length() > 0.0;
    } else {
      const auto& arc = std::get<Arc>(piece);
      center_ = arc.center;
      radius_ = arc.radius;
      // To the left of a counterclockwise arc is its inside.
      sign_ = arc.sweep > 0.0 ? -1.0 : 1.0;
      fine_ = arc.radius > 0.0 && arc.sweep != 0.0;
    }
  }
  [[nodiscard]] bool fine() const { return fine_; }
  [[nodiscard]] double at(double t) const {
    const Point point = curve_.at(t).point;
    return radius_ > 0.0 ? sign_ * (distance(point, center_) - radius_) : dot(normal_, point - from_);
  }
  // How far g can leave its values at the ends between them; infinite where that is not known. A long program has many
  // short chords, and of most of them it is enough to know little: no more is asked for what is below `fine_mm`.
  [[nodiscard]] double bulge(double low, double high, double fine_mm) const {
    const double share = (high - low) * (high - low) / 8.0;
    if (curve_.wide_second_derivatives) {
      const double wide = share * second(curve_.wide_second_derivatives(low, high), low, high);
      if (wide <= fine_mm) return wide;
    }
    return share * second(curve_.second_derivatives(low, high), low, high);
  }

 private:
  // Of |g''| between two places, given all second derivatives of the curve there.
  [[nodiscard]] double second(const Box& box, double low, double high) const {
    if (radius_ == 0.0) return largest(sum(scaled(normal_.z, box.z), scaled(normal_.x, box.x)));
    return second_of_circle(box, low, high);
  }
  // The direction from the centre turns by at most the angle under which the part is seen.
  [[nodiscard]] double second_of_circle(const Box& box, double low, double high) const {
    const double half = 0.5 * (high - low);
    const ParametricPoint middle = curve_.at(low + half);
    const Range by{-half, half};
    const Range d_z = sum({middle.derivative.z, middle.derivative.z}, product(by, box.z));
    const Range d_x = sum({middle.derivative.x, middle.derivative.x}, product(by, box.x));
    const double reach = half * std::hypot(largest(d_z), largest(d_x));
    const Point away = middle.point - center_;
    const double rho = norm(away);
    if (!(rho > 2.0 * reach)) return std::numeric_limits<double>::infinity();
    const Point u = unit(away);
    const double turn = reach / (rho - reach);  // >= the angle's sine
    const Range u_z{u.z - turn, u.z + turn};
    const Range u_x{u.x - turn, u.x + turn};
    const Range across = sum(product(u_z, d_x), scaled(-1.0, product(u_x, d_z)));
    const double least =
        across.low > 0.0 || across.high < 0.0 ? std::min(std::fabs(across.low), std::fabs(across.high)) : 0.0;
    const Range bend{least * least / (rho + reach), largest(across) * largest(across) / (rho - reach)};
    return largest(sum(bend, sum(product(u_z, box.z), product(u_x, box.x))));
  }

  const ParametricCurve& curve_;
  Point normal_;
  Point from_;
  Point center_;
  double radius_ = 0.0;
  double sign_ = 1.0;
  bool fine_ = false;
};

struct Part {
  double low = 0.0;
  double high = 0.0;
  double gap_low = 0.0;
  double gap_high = 0.0;
  Range bound;
};

// Few parts are the rule: they lie on the stack, only more of them ask for memory.
class PartList {
 public:
  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] const Part& operator[](std::size_t i) const {
    return i < few_.size() ? few_[i] : more_[i - few_.size()];
  }
  void push_back(const Part& part) {
    if (size_ < few_.size()) {
      few_[size_] = part;
    } else {
      more_.push_back(part);
    }
    ++size_;
  }

 private:
  std::array<Part, 64> few_;
  std::vector<Part> more_;
  std::size_t size_ = 0;
};

}  // namespace

std::optional<Range> gap_range(const ParametricCurve& curve, Range t, const PathPiece& piece, double relative) {
  const Gap gap(curve, piece);
  if (!gap.fine() || !curve.second_derivatives || !(t.low <= t.high)) return std::nullopt;
  Range known{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  const auto include = [&known](double value) {
    known = {std::min(known.low, value), std::max(known.high, value)};
    return value;
  };
  const double exact_mm = std::holds_alternative<Arc>(piece) ? kExactOfArc_mm : kExact_mm;
  const auto bounded = [&](Part part) {
    const double more = part.high > part.low ? gap.bulge(part.low, part.high, exact_mm) : 0.0;
    part.bound = {std::min(part.gap_low, part.gap_high) - more, std::max(part.gap_low, part.gap_high) + more};
    return part;
  };
  PartList open;
  double before = t.low;
  double gap_before = include(gap.at(t.low));
  const auto add_to = [&](double here) {
    const double gap_here = include(gap.at(here));
    open.push_back(bounded({before, here, gap_before, gap_here, {}}));
    before = here;
    gap_before = gap_here;
  };
  for (const double place : curve.breaks) {
    if (place > t.low && place < t.high) add_to(place);
  }
  add_to(t.high);

  // What the parts say before they are halved holds, too.
  Range at_once = open[0].bound;
  for (std::size_t i = 1; i < open.size(); ++i) {
    at_once = {std::min(at_once.low, open[i].bound.low), std::max(at_once.high, open[i].bound.high)};
  }
  Range proved = known;
  for (std::size_t next = 0; next < open.size(); ++next) {  // all of one width before the narrower ones
    const Part part = open[next];
    const double allowed = exact_mm + relative * largest(known);
    const bool done = part.bound.low >= known.low - allowed && part.bound.high <= known.high + allowed;
    const double middle = 0.5 * (part.low + part.high);
    const bool last = open.size() >= kMostParts || !(middle > part.low && middle < part.high);
    if (last && !std::isfinite(part.bound.width())) return std::nullopt;
    if (done || last) {
      proved = {std::min(proved.low, part.bound.low), std::max(proved.high, part.bound.high)};
      continue;
    }
    const double gap_middle = include(gap.at(middle));
    open.push_back(bounded({part.low, middle, part.gap_low, gap_middle, {}}));
    open.push_back(bounded({middle, part.high, gap_middle, part.gap_high, {}}));
  }
  return Range{std::max(proved.low, at_once.low), std::min(proved.high, at_once.high)};
}

}  // namespace dripfeed::curves
