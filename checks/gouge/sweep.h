// What a mill sweeps when its tip is led along a straight line: the lowest height that it reaches over a place.
#pragma once

#include <optional>

#include "checks/gouge/cutter.h"

namespace dripfeed::gouge {

struct Point3 {
  double x = 0.0;
  double y = 0.0;
  double z = 0.0;
  friend bool operator==(const Point3&, const Point3&) = default;
};

class Sweep {
 public:
  Sweep(const Cutter& cutter, const Point3& from, const Point3& to);

  // x between which a row at y is passed; nothing when it is not.
  struct Row {
    double low = 0.0;
    double high = 0.0;
  };
  [[nodiscard]] std::optional<Row> row(double y) const;
  // The part of it that the cutter covers before it moves.
  [[nodiscard]] std::optional<Row> start_row(double y) const;
  // The lowest height over (x, y), which the row holds; infinity outside it.
  [[nodiscard]] double lowest(double x, double y) const;

  // As lowest(), of a flat cutter that has covered no more of the line than this share of it.
  [[nodiscard]] double lowest_before(double x, double y, double share) const;

  // How much of the line lies before the cutter reaches the place, 0 to 1; nothing: it never does.
  [[nodiscard]] std::optional<double> share_until(double x, double y) const;
  // The same for a place that it does reach; a plunge takes all of it at its end.
  [[nodiscard]] double share_before(double x, double y) const;

  [[nodiscard]] double y_low() const;
  [[nodiscard]] double y_high() const;
  [[nodiscard]] double z_low() const { return z_low_; }
  // The height is the same everywhere under the cutter: nothing is to be computed a place.
  [[nodiscard]] bool is_flat_and_level() const { return cutter_.corner == 0.0 && (level_ || upright_); }

 private:
  // Of a place: how far it lies along the line from its start, and the square of its distance from the line.
  struct Place {
    double along = 0.0;
    double across_square = 0.0;
  };
  [[nodiscard]] Place seen_from_start(double x, double y) const;
  [[nodiscard]] double lowest_of_round(double along, double across_square) const;

  Cutter cutter_;
  Point3 from_;
  Point3 to_;
  double length_ = 0.0;  // seen from above
  double dir_x_ = 1.0;
  double dir_y_ = 0.0;
  double slope_ = 0.0;  // dz by length
  double z_low_ = 0.0;
  bool upright_ = false;  // no length from above
  bool level_ = false;
};

}  // namespace dripfeed::gouge
