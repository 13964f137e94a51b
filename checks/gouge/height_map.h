// Stock that is milled from above: a height at each point of a grid in the x-y plane, and what the nominal asks for
// there. A place knows its height exactly; between places nothing is known, so what is narrower than the step may pass
// unseen, and nothing that is not there is ever reported.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "checks/gouge/removal.h"
#include "checks/gouge/sweep.h"
#include "checks/machine.h"
#include "checks/plot/plot.h"
#include "dialects/curves/height_field.h"
#include "dialects/curves/point.h"

namespace dripfeed::gouge {

// A box, or a bar that stands around the z axis of the work offset.
struct Blank {
  curves::Range x;
  curves::Range y;
  curves::Range z;
  double diameter_mm = 0.0;  // of a bar, within x and y; 0: a box
  double bore_mm = 0.0;
};

// How deep, and where.
struct Depth {
  double mm = 0.0;  // 0: nowhere
  double x = 0.0;
  double y = 0.0;
};

class HeightMap {
 public:
  static constexpr std::size_t kMostPlaces = 1U << 18U;

  // `step`: between places, mm; grown where there would be more than kMostPlaces; 0: as many as that.
  HeightMap(const Blank& blank, double step);
  // The finished part as the nominal has it, for want of a blank: no material elsewhere.
  HeightMap(std::span<const curves::HeightField> nominal, double step);

  // How far the nominal lies below must be known before cuts are judged. Sideways the lowest within the tolerance
  // counts, so that a wall has its tolerance, too.
  void set_nominal(std::span<const curves::HeightField> nominal);

  struct Touch {
    Depth stock;    // deepest place below what is left, deeper than `slack`
    Depth nominal;  // the same below the nominal
  };
  [[nodiscard]] Touch touch(const Cutter& cutter, const Point3& from, const Point3& to, double slack) const;
  // How deep the shank or holder enters what is left while the cutter is led along the line, deeper than `slack`: ahead
  // of the cutter, with the map as it is before cut().
  [[nodiscard]] Depth touch_ahead(const Cutter& cutter, const checks::HolderStep& step, const Point3& from,
                                  const Point3& to, double slack) const;
  // Takes away what the cutter passes. Deepest place below the nominal by more than its tolerance that was newly cut;
  // the depth is from the nominal.
  Depth cut(const Cutter& cutter, const Point3& from, const Point3& to);

  // The same of a full circle at the height of `start` around a center, by a flat cutter. It writes no log.
  Depth cut_circle(const Cutter& cutter, const Point3& start, double center_x, double center_y);

  // touch_ahead() of a flat cutter and what its cut leaves, in one: along a level line, or around a full circle at the
  // height of `start`. With the map as it is before the cut.
  [[nodiscard]] Depth touch_level(const Cutter& cutter, const checks::HolderStep& step, const Point3& from,
                                  const Point3& to, double slack) const;
  [[nodiscard]] Depth touch_around(const Cutter& cutter, const checks::HolderStep& step, const Point3& start,
                                   double center_x, double center_y, double slack) const;

  // From now on `log`, which must outlive this, gets what the cuts take away, by place(row, column).
  void log_to(RemovalLog* log) { log_ = log; }
  // Rows lie along x; the first one is the lowest in y.
  struct Grid {
    std::size_t columns = 0;
    std::size_t rows = 0;
    double x_low = 0.0;
    double y_low = 0.0;
    double bottom = 0.0;  // of the material
    // By place, in the middle of a cell; -infinity: no material, no nominal.
    std::vector<double> heights;
    std::vector<double> nominal;  // the surface itself; empty: none is known
    std::vector<float> tolerances;
  };
  [[nodiscard]] Grid grid() const;

  // -infinity where there is no material.
  [[nodiscard]] double height(double x, double y) const;
  [[nodiscard]] double step_mm() const { return step_; }
  // No place was ever higher.
  [[nodiscard]] double top_mm() const { return top_; }
  // At most `columns` columns, the lowest of the places that fall into a cell.
  [[nodiscard]] plot::Map picture(std::size_t columns) const;

 private:
  void lay_out(curves::Range x, curves::Range y, double step);
  [[nodiscard]] double x_at(std::size_t column) const { return x_.low + (static_cast<double>(column) + 0.5) * step_; }
  [[nodiscard]] double y_at(std::size_t row) const { return y_.low + (static_cast<double>(row) + 0.5) * step_; }
  [[nodiscard]] bool falls_off(const std::vector<double>& z, std::size_t row, std::size_t column, double below) const;
  // Of a row or a column; first > last: there are none.
  struct Places {
    std::ptrdiff_t first = 0;
    std::ptrdiff_t last = -1;
  };
  // Those whose middle lies between two ends; the first of `count` begins at `origin`.
  [[nodiscard]] Places places(double low, double high, double origin, std::size_t count) const;
  [[nodiscard]] Places columns_of(const Sweep::Row& row) const { return places(row.low, row.high, x_.low, columns_); }
  [[nodiscard]] Places rows_of(double low, double high) const { return places(low, high, y_.low, rows_); }
  // Whether the place was higher than z; it is not any more. `deepest` is that below the nominal.
  bool lower(std::size_t place, double x, double y, double z, Depth& deepest);
  // Calls visit(place, x, y, z) for the places that are passed and might lie lower than `top`.
  template <class Visit>
  void pass(const Sweep& sweep, bool goes_on, Visit&& visit) const;
  struct Disk;  // of a shank or holder, seen from above
  void touch_some(const Disk& disk, std::size_t row, Places columns, Depth& deepest) const;
  // Calls visit(row, columns) for what lies between two circles.
  template <class Visit>
  void pass_ring(double center_x, double center_y, double inner, double outer, Visit&& visit) const;

  curves::Range x_;
  curves::Range y_;
  double step_ = 0.0;
  double top_ = 0.0;     // no place is higher
  double bottom_ = 0.0;  // of the material
  std::size_t columns_ = 0;
  std::size_t rows_ = 0;
  std::vector<double> heights_;
  std::vector<double> nominal_;  // -infinity: none; empty: none at all
  std::vector<double> surface_;  // the same, without regard to tolerances
  RemovalLog* log_ = nullptr;
  std::vector<float> tolerances_;  // mm
  struct LastCut {
    Cutter cutter;
    Point3 at;  // where it ended
  };
  std::optional<LastCut> last_cut_;  // where it was flat and level
};

}  // namespace dripfeed::gouge
