// Curves are drawn by points that stand closer at their ends, where a circle's y = f(x) is steep.
#include "dialects/family/drawing.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "dialects/curves/height_field.h"
#include "dialects/family/evaluate.h"
#include "dialects/family/geometry.h"

namespace dripfeed::family {

namespace {

using curves::Range;

constexpr int kSteps = 96;          // of a curve
constexpr int kSectionSteps = 240;  // of a section through surfaces
constexpr int kMostFigures = 400;   // of a counter

bool is_finite(DrawnPoint point) { return std::isfinite(point.across_mm) && std::isfinite(point.up_mm); }

// n from 0 to kSteps: from low to high.
double spread(Range range, int n) {
  const double middle = 0.5 * (range.low + range.high);
  return middle - 0.5 * range.width() * std::cos(std::numbers::pi * n / kSteps);
}

std::vector<DrawnPoint> rectangle(Range across, Range up) {
  return {
      {across.low, up.low}, {across.high, up.low}, {across.high, up.high}, {across.low, up.high}, {across.low, up.low}};
}

class Draughtsman {
 public:
  explicit Draughtsman(const BoundFamily& bound)
      : bound_(bound), values_(bound.values), geometry_(family::geometry(bound)) {}

  std::vector<DrawnView> draw() {
    for (const OutlineShape& shape : bound_.family->outlines) outline(shape);
    for (const DimensionShape& shape : bound_.family->dimensions) dimension(shape);
    return std::move(views_);
  }

 private:
  // With stock and nominal, when it is named for the first time.
  DrawnView& view(std::string_view axes) {
    if (const auto known = std::ranges::find(views_, axes, &DrawnView::axes); known != views_.end()) return *known;
    DrawnView& out = views_.emplace_back();
    out.axes = axes;
    if (geometry_.stock) std::visit([&](const auto& stock) { add_stock(out, stock); }, *geometry_.stock);
    if (axes == "zx") profile(out);
    if (axes == "xy") regions(out);
    if (axes == "xz" || axes == "yz") section(out);
    return out;
  }

  static void line(DrawnView& out, DrawnOf of, std::vector<DrawnPoint> points) {
    if (points.size() > 1 && std::ranges::all_of(points, is_finite)) out.lines.push_back({of, std::move(points)});
  }

  static void add_stock(DrawnView& out, const CylinderStock& stock) {
    for (const double diameter : {stock.diameter_mm, stock.bore_mm}) {
      const Range across{-0.5 * diameter, 0.5 * diameter};
      if (diameter <= 0.0) continue;
      if (out.axes == "xy") {
        out.circles.push_back({DrawnOf::stock, {}, diameter});
      } else if (out.axes == "zx") {
        line(out, DrawnOf::stock, rectangle(stock.z_mm, across));
      } else {
        line(out, DrawnOf::stock, rectangle(across, stock.z_mm));
      }
    }
  }

  static void add_stock(DrawnView& out, const BoxStock& stock) {
    const Range across = out.axes.starts_with('x') ? stock.x_mm : stock.y_mm;
    if (out.axes != "zx") line(out, DrawnOf::stock, rectangle(across, out.axes == "xy" ? stock.y_mm : stock.z_mm));
  }

  void profile(DrawnView& out) const {
    for (const curves::ProfilePiece& piece : geometry_.nominal.pieces) {
      for (const double side : {1.0, -1.0}) {
        std::vector<DrawnPoint> points;
        for (int n = 0; n <= kSteps; ++n) {
          const double z = spread(piece.curve.z, n);
          points.push_back({z, side * piece.curve.at(z).x});
        }
        line(out, DrawnOf::nominal, std::move(points));
      }
    }
  }

  void regions(DrawnView& out) const {
    for (const curves::HeightField& field : geometry_.surfaces) {
      std::vector<DrawnPoint> lower, upper;
      for (int n = 0; n <= kSteps; ++n) {
        const double x = spread(field.x, n);
        const Range y = field.y(x);
        if (!(y.low <= y.high)) continue;
        lower.push_back({x, y.low});
        upper.push_back({x, y.high});
      }
      if (lower.empty()) continue;
      lower.insert(lower.end(), upper.rbegin(), upper.rend());
      lower.push_back(lower.front());
      line(out, DrawnOf::nominal, std::move(lower));
    }
    for (const PlaneCurve& one : geometry_.curves) {
      std::vector<DrawnPoint> points;
      for (int n = 0; n <= 2 * kSteps; ++n) {
        const curves::Point at = one.curve.at(one.curve.t.low + one.curve.t.width() * n / (2 * kSteps)).point;
        points.push_back({at.z, at.x});
      }
      line(out, DrawnOf::nominal, std::move(points));
    }
  }

  // Through the middle of the stock, or through 0 where it is a box around it or none is given.
  void section(DrawnView& out) const {
    if (geometry_.surfaces.empty()) return;
    const bool along_x = out.axes == "xz";
    double other = 0.0;
    Range span = geometry_.surfaces.front().x;
    if (const auto* box = geometry_.stock ? std::get_if<BoxStock>(&*geometry_.stock) : nullptr) {
      const Range across = along_x ? box->y_mm : box->x_mm;
      other = 0.5 * (across.low + across.high);
      span = along_x ? box->x_mm : box->y_mm;
    }
    std::vector<double> places;
    for (int n = 0; n <= kSectionSteps; ++n) places.push_back(span.low + span.width() * n / kSectionSteps);
    // A wall stands upright: one place on each side of it.
    for (const curves::HeightField& field : geometry_.surfaces) {
      const Range ends = along_x ? field.x : field.y(other);
      const double hair = 1e-6 * std::max(span.width(), 1.0);
      for (const double end : {ends.low, ends.high}) places.insert(places.end(), {end - hair, end + hair});
    }
    std::ranges::sort(places);
    std::vector<DrawnPoint> points;
    for (const double place : places) {
      const auto found = along_x ? curves::surface_at(geometry_.surfaces, place, other)
                                 : curves::surface_at(geometry_.surfaces, other, place);
      if (found && std::isfinite(found->z)) points.push_back({place, found->z});
    }
    line(out, DrawnOf::nominal, std::move(points));
  }

  double value_of(ir::ExpressionId id) const { return evaluate(bound_.family->arena, id, values_).value; }

  DrawnPoint place(const DrawnPlace& place, std::string_view axes) const {
    const bool halves = axes == "zx" && bound_.family->x_is_diameter;
    return {value_of(place.across), value_of(place.up) * (halves ? 0.5 : 1.0)};
  }

  void outline(const OutlineShape& shape) {
    DrawnView& out = view(shape.axes);
    if (shape.counter == ir::SymbolId::none) return figure(out, shape);
    const double low = value_of(shape.counts.low);
    const double count = std::floor(value_of(shape.counts.high) - low + 1e-9);
    for (int n = 0; n <= count && n < kMostFigures; ++n) {
      values_[static_cast<std::size_t>(shape.counter)] = low + n;
      figure(out, shape);
    }
  }

  void figure(DrawnView& out, const OutlineShape& shape) const {
    std::vector<DrawnPoint> points;
    points.reserve(shape.places.size() + 1);
    for (const DrawnPlace& one : shape.places) points.push_back(place(one, shape.axes));
    if (shape.diameter != ir::ExpressionId::none) {
      const double diameter = value_of(shape.diameter);
      if (is_finite(points.front()) && std::isfinite(diameter))
        out.circles.push_back({DrawnOf::outline, points.front(), diameter});
      return;
    }
    if (shape.is_closed) points.push_back(points.front());
    line(out, DrawnOf::outline, std::move(points));
  }

  void dimension(const DimensionShape& shape) {
    const Parameter& parameter = bound_.family->parameters[shape.parameter];
    DrawnDimension out{.parameter = parameter.name,
                       .kind = shape.kind,
                       .value = format_value(parameter, values_[static_cast<std::size_t>(parameter.symbol)]),
                       .from = place(shape.from, shape.axes),
                       .to = place(shape.to, shape.axes)};
    if (shape.kind == DimensionKind::angle) out.at = place(shape.at, shape.axes);
    if (is_finite(out.from) && is_finite(out.to) && is_finite(out.at))
      view(shape.axes).dimensions.push_back(std::move(out));
  }

  const BoundFamily& bound_;
  std::vector<double> values_;  // with that of a counter
  Geometry geometry_;
  std::vector<DrawnView> views_;
};

}  // namespace

std::vector<DrawnView> drawing(const BoundFamily& bound) { return Draughtsman(bound).draw(); }

}  // namespace dripfeed::family
