// What is drawn decides the bounds that the caller left open; an axis gets a little air, and never a width of 0.
#include "checks/plot/frame.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace dripfeed::plot {

namespace {

constexpr double kLeft_px = 84.0;
constexpr double kBottom_px = 52.0;
constexpr double kTop_px = 40.0;
constexpr double kLegend_px = 190.0;
constexpr double kAir = 0.04;  // of the width

struct Extent {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();

  void include(double value) {
    if (!std::isfinite(value)) return;
    low = std::min(low, value);
    high = std::max(high, value);
  }
  void include(const std::optional<double>& value) {
    if (value) include(*value);
  }
};

Span bounds_of(const Axis& axis, const Extent& drawn, double air) {
  Span span{0.0, 1.0};
  if (drawn.low <= drawn.high) {
    const double room = air * (drawn.high - drawn.low);
    span = {drawn.low - room, drawn.high + room};
  }
  if (axis.low && std::isfinite(*axis.low)) span.low = *axis.low;
  if (axis.high && std::isfinite(*axis.high)) span.high = *axis.high;
  // Wide enough that doubles can distinguish both ends.
  const double least = 1e-9 * std::max({1e-3, std::fabs(span.low), std::fabs(span.high)});
  if (!(span.high - span.low > least)) {
    const double middle = 0.5 * span.low + 0.5 * span.high;
    const double half = std::max(0.5, 0.05 * std::fabs(middle));
    span = {middle - half, middle + half};
  }
  if (!std::isfinite(span.high - span.low)) span = {0.0, 1.0};
  return span;
}

}  // namespace

Frame::Frame(const Plot& plot, Size size) {
  Extent x;
  Extent y;
  for (const Series& series : plot.series) {
    for (const Point& point : series.points) {
      if (!std::isfinite(point.x) || !std::isfinite(point.y)) continue;
      x.include(point.x);
      y.include(point.y);
    }
  }
  for (const Area& area : plot.areas) {
    x.include(area.x_low);
    x.include(area.x_high);
    y.include(area.y_low);
    y.include(area.y_high);
  }
  for (const Note& note : plot.notes) {
    x.include(note.at.x);
    y.include(note.at.y);
  }
  if (plot.map) {
    x.include(plot.map->x_low);
    x.include(plot.map->x_high);
    y.include(plot.map->y_low);
    y.include(plot.map->y_high);
  }
  x_ = bounds_of(plot.x, x, plot.equal_scale ? kAir : 0.0);
  y_ = bounds_of(plot.y, y, kAir);
  left_ = kLeft_px;
  right_ = std::max(left_ + 50.0, size.width_px - kLegend_px);
  top_ = kTop_px;
  bottom_ = std::max(top_ + 50.0, size.height_px - kBottom_px);
  if (plot.equal_scale) keep_scale();
}

// The shorter one in pixels per unit decides; the other axis gets more room.
void Frame::keep_scale() {
  const double x_scale = (right_ - left_) / (x_.high - x_.low);
  const double y_scale = (bottom_ - top_) / (y_.high - y_.low);
  const auto widen = [](Span& span, double width) {
    const double middle = 0.5 * (span.low + span.high);
    span = {middle - 0.5 * width, middle + 0.5 * width};
  };
  if (x_scale > y_scale) {
    widen(x_, (right_ - left_) / y_scale);
  } else {
    widen(y_, (bottom_ - top_) / x_scale);
  }
}

}  // namespace dripfeed::plot
