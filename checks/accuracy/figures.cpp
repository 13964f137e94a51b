// Sums, and a trace of bounded length.
#include "checks/accuracy/figures.h"

#include <algorithm>
#include <cmath>

namespace dripfeed::accuracy {

bool is_profile(const ir::Motion& motion, const std::vector<LineRange>& lines) {
  if (!ir::is_move(motion.kind) || motion.kind == ir::MotionKind::rapid || motion.machine_coordinates) return false;
  if (lines.empty()) return true;
  return motion.place.program == 0 && std::ranges::any_of(lines, [&](const LineRange& range) {
           return range.first <= motion.place.line && motion.place.line <= range.last;
         });
}

void Sums::add(const curves::Deviation& deviation, std::uint32_t line) {
  if (deviation.points == 0) return;
  const bool first = figures_.points == 0;
  figures_.points += deviation.points;
  figures_.length_mm += deviation.length;
  integral_ += deviation.integral;
  integral_square_ += deviation.integral_square;
  if (first || deviation.highest.value > figures_.highest_mm) figures_.highest_mm = deviation.highest.value;
  if (first || deviation.lowest.value < figures_.lowest_mm) figures_.lowest_mm = deviation.lowest.value;
  for (const curves::Extreme& extreme : {deviation.highest, deviation.lowest}) {
    const double size = std::fabs(extreme.value);
    if (figures_.max_line != 0 && size <= figures_.max_mm) continue;
    figures_.max_mm = size;
    figures_.max_signed_mm = extreme.value;
    figures_.max_line = line;
    figures_.max_at = extreme.at;
  }
}

Figures Sums::result() const {
  Figures result = figures_;
  if (result.length_mm > 0.0) {
    result.mean_mm = integral_ / result.length_mm;
    result.rmse_mm = std::sqrt(integral_square_ / result.length_mm);
  }
  return result;
}

void Trace::add(double along_mm, double value_mm) {
  if (pending_ == 0 || std::fabs(value_mm) > std::fabs(best_.value_mm)) best_ = {along_mm, value_mm};
  if (++pending_ < every_) return;
  points_.push_back(best_);
  pending_ = 0;
  if (points_.size() < kMost) return;
  for (std::size_t i = 0; i + 1 < points_.size(); i += 2) {
    const bool first = std::fabs(points_[i].value_mm) >= std::fabs(points_[i + 1].value_mm);
    points_[i / 2] = first ? points_[i] : points_[i + 1];
  }
  points_.resize(kMost / 2);
  every_ *= 2;
}

}  // namespace dripfeed::accuracy
