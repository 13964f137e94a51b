// The contour is taken in heights and lengths: a height is how far a place lies towards where the passes begin, a
// length how far it lies back along a pass, both on the radius.
#include "dialects/family/contour_check.h"

#include <cmath>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "dialects/family/evaluate.h"
#include "dialects/text/number.h"

namespace dripfeed::family {

namespace {

using ir::ExpressionId;

constexpr double kEven_mm = 0.002;  // as far as numbers of a drawing are rounded
constexpr double kMostPasses = 10'000.0;

struct Place {
  double height = 0.0;
  double length = 0.0;
};

class Check {
 public:
  Check(const BoundFamily& bound, std::span<const std::uint8_t> known, const RoughContour& contour)
      : family_(*bound.family),
        contour_(contour),
        values_(bound.values.begin(), bound.values.end()),
        known_(known.begin(), known.end()) {}

  std::optional<ContourFault> fault() {
    for (const ExpressionId one :
         {contour_.x, contour_.z, contour_.depth, contour_.retract, contour_.allowance_x, contour_.allowance_z})
      if (!is_known(one)) return open(contour_.span);
    const Place begin = place(value(contour_.x), value(contour_.z));
    const double aside = contour_.allowance_x == ExpressionId::none ? 0.0 : value(contour_.allowance_x);
    const double along = contour_.allowance_z == ExpressionId::none ? 0.0 : value(contour_.allowance_z);
    if (!(value(contour_.depth) > 0.0)) return of_head("the depth of cut of 'rough' is above 0");
    if (!(value(contour_.retract) > 0.0)) return of_head("the retract of 'rough' is above 0");
    if (!(aside >= 0.0 && along >= 0.0)) return of_head("the allowances of 'rough' are not below 0");
    std::optional<Place> last;
    std::optional<Place> first;
    for (const RoughContour::Item& one : contour_.items) {
      if (one.when != ExpressionId::none && value(one.when) == 0.0) continue;
      if (one.target != ir::SymbolId::none) {
        if (!is_known(one.value)) return open(one.span);
        values_[static_cast<std::size_t>(one.target)] = value(one.value);
        known_[static_cast<std::size_t>(one.target)] = 1;
        continue;
      }
      for (const ExpressionId id : {one.x, one.z, one.i, one.k, one.radius})
        if (!is_known(id)) return open(one.span);
      const Place at = place(value(one.x), value(one.z));
      if (!std::isfinite(at.height) || !std::isfinite(at.length)) return ContourFault{one.span, "has no place here"};
      if (last)
        if (std::optional<ContourFault> found = fault_between(*last, at, one)) return found;
      if (!first) first = at;
      last = at;
    }
    return first ? fault_of_ends(begin, *first, *last, contour_.is_facing ? along : aside,
                                 contour_.is_facing ? aside : along)
                 : std::nullopt;
  }

 private:
  [[nodiscard]] bool is_known(ExpressionId id) const {
    return id == ExpressionId::none || !names_unknown(family_.arena, id, known_);
  }
  [[nodiscard]] double value(ExpressionId id) const { return evaluate(family_.arena, id, values_).value; }
  [[nodiscard]] double x_on_radius(double x) const { return family_.x_is_diameter ? x / 2.0 : x; }
  [[nodiscard]] Place place(double x, double z) const { return turned(x_on_radius(x), z); }
  [[nodiscard]] Place turned(double x, double z) const {
    const double outward = contour_.is_inside ? -x : x;
    return contour_.is_facing ? Place{z, outward} : Place{outward, z};
  }

  [[nodiscard]] std::optional<ContourFault> of_head(std::string text) const {
    return ContourFault{contour_.span, std::move(text)};
  }
  static std::optional<ContourFault> open(text::Span span) {
    return ContourFault{
        span,
        "a contour is checked before the program runs: 'rough' and its contour depend on parameters only, "
        "and on what follows from them"};
  }

  [[nodiscard]] std::optional<ContourFault> fault_between(const Place& from, const Place& to,
                                                          const RoughContour::Item& item) const {
    if (to.height < from.height - kEven_mm || to.length > from.length + kEven_mm)
      return ContourFault{
          item.span,
          fmt::format("the contour of 'rough' turns back here: it leads {} and {} alone, so that a pass meets "
                      "it once",
                      contour_.is_facing   ? "towards +z"
                      : contour_.is_inside ? "inward"
                                           : "outward",
                      !contour_.is_facing  ? "towards -z"
                      : contour_.is_inside ? "outward"
                                           : "inward")};
    return item.is_arc ? fault_of_arc(from, to, item) : std::nullopt;
  }

  // A quarter of a circle at most, which neither rises above one of its ends nor falls below the other.
  [[nodiscard]] std::optional<ContourFault> fault_of_arc(const Place& from, const Place& to,
                                                         const RoughContour::Item& item) const {
    const bool beyond = item.clockwise != (contour_.is_inside != contour_.is_facing);
    Place center;
    double radius = 0.0;
    if (item.radius != ExpressionId::none) {
      radius = value(item.radius);
      const double dh = to.height - from.height;
      const double dl = to.length - from.length;
      const double chord = std::hypot(dh, dl);
      if (!(radius > 0.0) || !(2.0 * radius >= chord - kEven_mm) || !(chord > 0.0))
        return ContourFault{item.span, "this arc of the contour does not reach its end: its radius is too small"};
      const double w = std::sqrt(std::abs(radius * radius / (chord * chord) - 0.25)) * (beyond ? 1.0 : -1.0);
      center = {from.height + dh / 2.0 - dl * w, from.length + dl / 2.0 + dh * w};
    } else {
      const Place offset = turned(item.i == ExpressionId::none ? 0.0 : value(item.i),
                                  item.k == ExpressionId::none ? 0.0 : value(item.k));
      center = {from.height + offset.height, from.length + offset.length};
      radius = std::hypot(offset.height, offset.length);
      if (std::abs(std::hypot(to.height - center.height, to.length - center.length) - radius) > kEven_mm)
        return ContourFault{item.span, "the ends of this arc of the contour are not equally far from its center"};
    }
    const double side = beyond ? -1.0 : 1.0;
    for (const Place& end : {from, to})
      if (side * (end.height - center.height) < -kEven_mm || side * (end.length - center.length) < -kEven_mm)
        return ContourFault{item.span,
                            "this arc of the contour turns back: make it of quarters of a circle that lead on"};
    return std::nullopt;
  }

  [[nodiscard]] std::optional<ContourFault> fault_of_ends(const Place& begin, const Place& first, const Place& last,
                                                          double up, double back) const {
    const char* axis = contour_.is_facing ? "z" : "x";
    const char* other = contour_.is_facing ? "x" : "z";
    if (!(first.height + up < begin.height))
      return of_head(
          fmt::format("there is nothing to rough: with its allowance the contour's start lies at {} or beyond "
                      "it, where 'rough' begins",
                      axis));
    if (last.height < begin.height - kEven_mm)
      return of_head(
          fmt::format("the contour of 'rough' ends before {}, where the first pass begins: lead its last cut to "
                      "there",
                      axis));
    if (!(first.length + back <= begin.length))
      return of_head(fmt::format("the contour of 'rough' begins beyond {}, where each pass begins", other));
    if ((begin.height - first.height) / value(contour_.depth) > kMostPasses)
      return of_head("'rough' would make more than 10,000 passes");
    return std::nullopt;
  }

  const Family& family_;
  const RoughContour& contour_;
  std::vector<double> values_;
  std::vector<std::uint8_t> known_;
};

}  // namespace

std::optional<ContourFault> fault_of_contour(const BoundFamily& bound, std::span<const std::uint8_t> known,
                                             const RoughContour& contour) {
  return Check(bound, known, contour).fault();
}

}  // namespace dripfeed::family
