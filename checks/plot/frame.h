// The rectangle of a plot in pixels, and the conversion from values to it.
#pragma once

#include "checks/plot/plot.h"

namespace dripfeed::plot {

struct Span {
  double low = 0.0;
  double high = 0.0;
};

class Frame {
 public:
  // Fits all that is drawn into `size`, margins for texts left free.
  Frame(const Plot& plot, Size size);

  [[nodiscard]] double x_px(double x) const { return left_ + (x - x_.low) / (x_.high - x_.low) * (right_ - left_); }
  [[nodiscard]] double y_px(double y) const { return bottom_ - (y - y_.low) / (y_.high - y_.low) * (bottom_ - top_); }
  [[nodiscard]] Span x() const { return x_; }
  [[nodiscard]] Span y() const { return y_; }
  [[nodiscard]] double left() const { return left_; }
  [[nodiscard]] double right() const { return right_; }
  [[nodiscard]] double top() const { return top_; }
  [[nodiscard]] double bottom() const { return bottom_; }

 private:
  void keep_scale();

  Span x_;
  Span y_;
  double left_ = 0.0;
  double right_ = 0.0;
  double top_ = 0.0;
  double bottom_ = 0.0;
};

}  // namespace dripfeed::plot
