// Rows of the grid lie along x, so that what a cutter passes in a row is one stretch of memory.
#include "checks/gouge/height_map.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include "dialects/curves/surface_column.h"

namespace dripfeed::gouge {

namespace {

constexpr double kNothing = -std::numeric_limits<double>::infinity();
constexpr int kRegionSamples = 64;

// std::floor without a call, of what an integer holds.
std::ptrdiff_t floor_of(double value) {
  const auto whole = static_cast<std::ptrdiff_t>(value);
  return static_cast<double>(whole) > value ? whole - 1 : whole;
}

// The hull of all regions.
void hull(std::span<const curves::HeightField> nominal, curves::Range& x, curves::Range& y) {
  bool first = true;
  for (const curves::HeightField& field : nominal) {
    for (int i = 0; i <= kRegionSamples; ++i) {
      const double at = field.x.low + field.x.width() * i / kRegionSamples;
      const curves::Range here = field.y(at);
      if (!(here.low <= here.high)) continue;
      x = first ? curves::Range{at, at} : curves::Range{std::min(x.low, at), std::max(x.high, at)};
      y = first ? here : curves::Range{std::min(y.low, here.low), std::max(y.high, here.high)};
      first = false;
    }
  }
}

}  // namespace

void HeightMap::lay_out(curves::Range x, curves::Range y, double step) {
  x_ = x;
  y_ = y;
  const double least = std::sqrt(x.width() * y.width() / static_cast<double>(kMostPlaces));
  // A strip is bounded by its length alone.
  const double longest = 4.0 * std::max(x.width(), y.width()) / static_cast<double>(kMostPlaces);
  step_ = std::max({step, least, longest, 1e-6});
  columns_ = std::max<std::size_t>(1, static_cast<std::size_t>(x.width() / step_));
  rows_ = std::max<std::size_t>(1, static_cast<std::size_t>(y.width() / step_));
  heights_.assign(columns_ * rows_, kNothing);
}

HeightMap::HeightMap(const Blank& blank, double step) : top_(blank.z.high), bottom_(blank.z.low) {
  lay_out(blank.x, blank.y, step);
  for (std::size_t row = 0; row < rows_; ++row) {
    for (std::size_t column = 0; column < columns_; ++column) {
      const double away = 2.0 * std::hypot(x_at(column), y_at(row));
      const bool inside = blank.diameter_mm <= 0.0 || (away <= blank.diameter_mm && away >= blank.bore_mm);
      if (inside) heights_[row * columns_ + column] = blank.z.high;
    }
  }
}

HeightMap::HeightMap(std::span<const curves::HeightField> nominal, double step) {
  curves::Range x;
  curves::Range y;
  hull(nominal, x, y);
  lay_out(x, y, step);
  top_ = kNothing;
  bottom_ = kNothing;
  for (std::size_t row = 0; row < rows_; ++row) {
    for (std::size_t column = 0; column < columns_; ++column) {
      const auto place = curves::surface_at(nominal, x_at(column), y_at(row));
      if (!place) continue;
      heights_[row * columns_ + column] = place->z;
      top_ = std::max(top_, place->z);
    }
  }
  set_nominal(nominal);
}

void HeightMap::set_nominal(std::span<const curves::HeightField> nominal) {
  static constexpr std::array<std::array<double, 2>, 8> kAround = {
      {{1, 0}, {-1, 0}, {0, 1}, {0, -1}, {0.7, 0.7}, {0.7, -0.7}, {-0.7, 0.7}, {-0.7, -0.7}}};
  std::vector<double> own(heights_.size(), kNothing);
  tolerances_.assign(heights_.size(), 0.0F);
  for (std::size_t column = 0; column < columns_; ++column) {
    const curves::SurfaceColumn surface(nominal, x_at(column));
    for (std::size_t row = 0; row < rows_; ++row) {
      const auto place = surface.at(y_at(row));
      if (!place) continue;
      own[row * columns_ + column] = place->z;
      tolerances_[row * columns_ + column] = static_cast<float>(place->tolerance);
    }
  }
  surface_ = own;
  nominal_ = own;
  for (std::size_t row = 0; row < rows_; ++row) {
    for (std::size_t column = 0; column < columns_; ++column) {
      const std::size_t here = row * columns_ + column;
      const auto tolerance = static_cast<double>(tolerances_[here]);
      if (own[here] == kNothing || !falls_off(own, row, column, own[here] - tolerance)) continue;
      for (const auto& [dx, dy] : kAround) {
        const auto near = curves::surface_at(nominal, x_at(column) + dx * tolerance, y_at(row) + dy * tolerance);
        if (near) nominal_[here] = std::min(nominal_[here], near->z);
      }
    }
  }
}

// Whether a neighbour lies lower than that: only there is something to be found sideways.
bool HeightMap::falls_off(const std::vector<double>& z, std::size_t row, std::size_t column, double below) const {
  for (std::size_t r = row == 0 ? 0 : row - 1; r <= std::min(row + 1, rows_ - 1); ++r) {
    for (std::size_t c = column == 0 ? 0 : column - 1; c <= std::min(column + 1, columns_ - 1); ++c) {
      if (z[r * columns_ + c] < below) return true;
    }
  }
  return false;
}

HeightMap::Places HeightMap::places(double low, double high, double origin, std::size_t count) const {
  const auto most = static_cast<double>(count);
  const double first = std::clamp((low - origin) / step_ - 0.5, -1.0, most);
  const double last = std::clamp((high - origin) / step_ - 0.5, -1.0, most);
  return {.first = std::max<std::ptrdiff_t>(0, -floor_of(-first)),
          .last = std::min(floor_of(last), static_cast<std::ptrdiff_t>(count) - 1)};
}

// `goes_on`: what lies under the cutter where the move starts is left out.
template <class Visit>
void HeightMap::pass(const Sweep& sweep, bool goes_on, Visit&& visit) const {
  const Places rows = rows_of(sweep.y_low(), sweep.y_high());
  const bool same = sweep.is_flat_and_level();
  for (std::ptrdiff_t row = rows.first; row <= rows.last; ++row) {
    const auto r = static_cast<std::size_t>(row);
    const double y = y_at(r);
    const auto stretch = sweep.row(y);
    if (!stretch) continue;
    const Places all = columns_of(*stretch);
    const auto visit_some = [&](std::ptrdiff_t first, std::ptrdiff_t last) {
      for (std::ptrdiff_t c = first; c <= last; ++c) {
        const auto column = static_cast<std::size_t>(c);
        const double x = x_at(column);
        visit(r * columns_ + column, x, y, same ? sweep.z_low() : sweep.lowest(x, y));
      }
    };
    const std::optional<Sweep::Row> start = goes_on ? sweep.start_row(y) : std::nullopt;
    const Places done = start ? columns_of(*start) : Places{};
    if (done.first > done.last) {
      visit_some(all.first, all.last);
    } else {
      visit_some(all.first, std::min(all.last, done.first - 1));
      visit_some(std::max(all.first, done.last + 1), all.last);
    }
  }
}

HeightMap::Touch HeightMap::touch(const Cutter& cutter, const Point3& from, const Point3& to, double slack) const {
  Touch deepest;
  if (std::min(from.z, to.z) + slack >= top_) return deepest;
  // A cutter smaller on all sides, its tip higher: what it touches is entered by more than the slack.
  const Sweep sweep(cutter.shrunk(slack), {from.x, from.y, from.z + slack}, {to.x, to.y, to.z + slack});
  pass(sweep, false, [&](std::size_t place, double x, double y, double z) {
    const double depth = heights_[place] - z;
    if (!(depth > 0.0)) return;
    if (depth + slack > deepest.stock.mm) deepest.stock = {depth + slack, x, y};
    if (nominal_.empty()) return;
    const double below = nominal_[place] - z + slack;
    if (below > std::max(slack, static_cast<double>(tolerances_[place])) && below > deepest.nominal.mm) {
      deepest.nominal = {below, x, y};
    }
  });
  return deepest;
}

Depth HeightMap::touch_ahead(const Cutter& cutter, const checks::HolderStep& step, const Point3& from, const Point3& to,
                             double slack) const {
  Depth deepest;
  const double above = step.from_mm + slack;
  if (std::min(from.z, to.z) + above >= top_) return deepest;
  const Sweep wide(Cutter{0.5 * step.diameter_mm, 0.0}.shrunk(slack), {from.x, from.y, from.z + above},
                   {to.x, to.y, to.z + above});
  const Sweep narrow(cutter, from, to);
  pass(wide, false, [&](std::size_t place, double x, double y, double) {
    const double most = heights_[place] - wide.z_low();
    if (!(most > 0.0) || most + slack <= deepest.mm) return;
    const std::optional<double> cut_at = narrow.share_until(x, y);
    if (cut_at && wide.share_until(x, y).value_or(0.0) >= *cut_at) return;  // the cutter is there first
    const double depth = heights_[place] - wide.lowest_before(x, y, cut_at.value_or(1.0));
    if (depth > 0.0 && depth + slack > deepest.mm) deepest = {depth + slack, x, y};
  });
  return deepest;
}

bool HeightMap::lower(std::size_t place, double x, double y, double z, Depth& deepest) {
  if (!(z < heights_[place])) return false;
  heights_[place] = z <= bottom_ ? kNothing : z;
  if (nominal_.empty()) return true;
  const double below = nominal_[place] - z;
  if (below > static_cast<double>(tolerances_[place]) && below > deepest.mm) deepest = {below, x, y};
  return true;
}

Depth HeightMap::cut(const Cutter& cutter, const Point3& from, const Point3& to) {
  Depth deepest;
  if (std::min(from.z, to.z) >= top_) return deepest;
  const Sweep sweep(cutter, from, to);
  // A chord of an arc goes on from the one before: what that one cut at this height is not cut again.
  const bool even = sweep.is_flat_and_level();
  const bool goes_on =
      even && sweep.z_low() == from.z && last_cut_ && last_cut_->at == from && last_cut_->cutter == cutter;
  last_cut_ = even ? std::optional(LastCut{cutter, to}) : std::nullopt;
  pass(sweep, goes_on, [&](std::size_t place, double x, double y, double z) {
    if (lower(place, x, y, z, deepest) && log_ != nullptr) log_->take(place, heights_[place], sweep.share_before(x, y));
  });
  return deepest;
}

template <class Visit>
void HeightMap::pass_ring(double center_x, double center_y, double inner, double outer, Visit&& visit) const {
  const Places rows = rows_of(center_y - outer, center_y + outer);
  for (std::ptrdiff_t row = rows.first; row <= rows.last; ++row) {
    const auto r = static_cast<std::size_t>(row);
    const double away = y_at(r) - center_y;
    const double half = std::sqrt(std::max(0.0, outer * outer - away * away));
    if (std::fabs(away) >= inner) {
      visit(r, columns_of({center_x - half, center_x + half}));
      continue;
    }
    const double gap = std::sqrt(inner * inner - away * away);
    visit(r, columns_of({center_x - half, center_x - gap}));
    visit(r, columns_of({center_x + gap, center_x + half}));
  }
}

// A ring: what lies nearer to the center than its inner edge stays.
Depth HeightMap::cut_circle(const Cutter& cutter, const Point3& start, double center_x, double center_y) {
  Depth deepest;
  if (start.z >= top_) return deepest;
  const double radius = std::hypot(start.x - center_x, start.y - center_y);
  pass_ring(center_x, center_y, std::max(0.0, radius - cutter.radius), radius + cutter.radius,
            [&](std::size_t row, Places columns) {
              for (std::ptrdiff_t c = columns.first; c <= columns.last; ++c) {
                const auto column = static_cast<std::size_t>(c);
                lower(row * columns_ + column, x_at(column), y_at(row), start.z, deepest);
              }
            });
  last_cut_ = LastCut{cutter, start};
  return deepest;
}

// A disk wider than the cutter around the same axis is over each place before the cutter is, except where the cutter
// stands first; a smaller one never is.
struct HeightMap::Disk {
  Disk(const Cutter& cutter_, const checks::HolderStep& step, const Point3& start_, double slack_)
      : cutter(cutter_),
        start(start_),
        slack(slack_),
        radius(0.5 * step.diameter_mm - slack_),
        z(start_.z + step.from_mm + slack_) {}
  [[nodiscard]] bool may_touch(double top) const { return z < top && radius > cutter.radius; }

  Cutter cutter;
  Point3 start;
  double slack;
  double radius;
  double z;
};

void HeightMap::touch_some(const Disk& disk, std::size_t row, Places columns, Depth& deepest) const {
  const double* const heights = heights_.data() + row * columns_;
  const double y = y_at(row);
  double limit = disk.z + std::max(0.0, deepest.mm - disk.slack);
  for (std::ptrdiff_t c = columns.first; c <= columns.last; ++c) {
    if (!(heights[c] > limit)) continue;
    const double x = x_at(static_cast<std::size_t>(c));
    if (std::hypot(x - disk.start.x, y - disk.start.y) <= disk.cutter.radius) continue;
    limit = heights[c];
    deepest = {limit - disk.z + disk.slack, x, y};
  }
}

Depth HeightMap::touch_level(const Cutter& cutter, const checks::HolderStep& step, const Point3& from, const Point3& to,
                             double slack) const {
  Depth deepest;
  const Disk disk(cutter, step, from, slack);
  if (!disk.may_touch(top_)) return deepest;
  const Sweep wide(Cutter{disk.radius, 0.0}, from, to);
  const Places rows = rows_of(wide.y_low(), wide.y_high());
  for (std::ptrdiff_t row = rows.first; row <= rows.last; ++row) {
    const auto r = static_cast<std::size_t>(row);
    if (const auto stretch = wide.row(y_at(r))) touch_some(disk, r, columns_of(*stretch), deepest);
  }
  return deepest;
}

Depth HeightMap::touch_around(const Cutter& cutter, const checks::HolderStep& step, const Point3& start,
                              double center_x, double center_y, double slack) const {
  Depth deepest;
  const Disk disk(cutter, step, start, slack);
  if (!disk.may_touch(top_)) return deepest;
  const double radius = std::hypot(start.x - center_x, start.y - center_y);
  pass_ring(center_x, center_y, std::max(0.0, radius - disk.radius), radius + disk.radius,
            [&](std::size_t row, Places columns) { touch_some(disk, row, columns, deepest); });
  return deepest;
}

HeightMap::Grid HeightMap::grid() const {
  return {.columns = columns_,
          .rows = rows_,
          .x_low = x_.low,
          .y_low = y_.low,
          .bottom = bottom_,
          .heights = heights_,
          .nominal = surface_,
          .tolerances = tolerances_};
}

double HeightMap::height(double x, double y) const {
  const double column = std::floor((x - x_.low) / step_);
  const double row = std::floor((y - y_.low) / step_);
  if (!(column >= 0.0 && row >= 0.0)) return kNothing;
  if (column >= static_cast<double>(columns_) || row >= static_cast<double>(rows_)) return kNothing;
  return heights_[static_cast<std::size_t>(row) * columns_ + static_cast<std::size_t>(column)];
}

plot::Map HeightMap::picture(std::size_t columns) const {
  const std::size_t by = std::max<std::size_t>(1, (columns_ + columns - 1) / columns);
  plot::Map map;
  map.columns = (columns_ + by - 1) / by;
  map.rows = (rows_ + by - 1) / by;
  map.x_low = x_.low;
  map.y_low = y_.low;
  map.x_high = x_.low + static_cast<double>(map.columns * by) * step_;
  map.y_high = y_.low + static_cast<double>(map.rows * by) * step_;
  map.values.assign(map.columns * map.rows, std::numeric_limits<double>::infinity());
  for (std::size_t row = 0; row < rows_; ++row) {
    for (std::size_t column = 0; column < columns_; ++column) {
      double& cell = map.values[row / by * map.columns + column / by];
      cell = std::min(cell, heights_[row * columns_ + column]);
    }
  }
  return map;
}

}  // namespace dripfeed::gouge
