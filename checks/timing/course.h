// When which line of a program begins: so few points that they are kept with a verdict, whatever the program's length.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace dripfeed::timing {

struct CoursePoint {
  std::uint32_t line = 0;
  double start_s = 0.0;
};

// Takes the first row of each line. When it is full every second point goes, and from then on half as many are taken.
class Course {
 public:
  static constexpr std::size_t kMost = 256;

  // All at once: what a timing asks for does not grow with the program.
  Course() { points_.reserve(kMost); }

  void add(std::uint32_t line, double start_s) {
    if (!is_forward_ || line == 0 || line == last_line_) return;
    if (line < last_line_) return give_up();  // a line runs again: no line has one time
    last_line_ = line;
    if (seen_++ % stride_ != 0) return;
    if (points_.size() == kMost) thin_out();
    points_.push_back({line, start_s});
  }

  // Another program's lines come in between.
  void give_up() {
    is_forward_ = false;
    points_ = {};
  }

  // Empty where lines run more than once.
  [[nodiscard]] const std::vector<CoursePoint>& points() const { return points_; }

 private:
  void thin_out() {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < points_.size(); i += 2) points_[kept++] = points_[i];
    points_.resize(kept);
    stride_ *= 2;
  }

  std::vector<CoursePoint> points_;
  std::uint32_t last_line_ = 0;
  std::size_t seen_ = 0;
  std::size_t stride_ = 1;
  bool is_forward_ = true;
};

}  // namespace dripfeed::timing
