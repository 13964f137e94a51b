// What limits how fast a program runs, stretch by stretch.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

namespace dripfeed::timing {

// What the machine was as slow as: its own motion, the control's computing, the line, or a buffer that holds too few
// blocks to see far enough ahead.
enum class Limiter : std::uint8_t { motion, compute, line, buffer };
inline constexpr std::size_t kLimiters = 4;

constexpr std::string_view name_of(Limiter limiter) {
  constexpr std::array<std::string_view, kLimiters> kNames = {"motion", "compute", "line", "buffer"};
  return kNames[static_cast<std::size_t>(limiter)];
}

struct Stretch {
  Limiter limiter = Limiter::motion;
  std::uint32_t first_line = 0;
  std::uint32_t last_line = 0;
  double start_s = 0.0;
  double duration_s = 0.0;
};

// Rows in their order to stretches. What is shorter than kShortest_s is reported as part of the stretch before it; the
// sums count it as what it is.
class StretchList {
 public:
  static constexpr double kShortest_s = 0.25;
  static constexpr std::size_t kMost = 200;

  void add(Limiter limiter, std::uint32_t line, double start_s, double duration_s) {
    sums_s_[static_cast<std::size_t>(limiter)] += duration_s;
    if (list_.empty() && count_ == 0) {
      open_ = {limiter, line, line, start_s, duration_s};
      count_ = 1;
      return;
    }
    if (limiter == open_.limiter) {
      if (next_.duration_s > 0.0) absorb();
      extend(open_, line, duration_s);
      return;
    }
    if (!(next_.duration_s > 0.0) || next_.limiter != limiter) {
      if (next_.duration_s > 0.0) absorb();
      next_ = {limiter, line, line, start_s, 0.0};
    }
    extend(next_, line, duration_s);
    if (next_.duration_s < kShortest_s) return;
    if (list_.size() < kMost) list_.push_back(open_);
    ++count_;
    open_ = next_;
    next_ = {};
  }
  void finish() {
    if (count_ == 0) return;
    if (next_.duration_s > 0.0) absorb();
    if (list_.size() < kMost) list_.push_back(open_);
  }

  [[nodiscard]] const std::vector<Stretch>& list() const { return list_; }
  [[nodiscard]] std::size_t count() const { return count_; }  // also those beyond kMost
  [[nodiscard]] const std::array<double, kLimiters>& sums_s() const { return sums_s_; }

 private:
  static void extend(Stretch& stretch, std::uint32_t line, double duration_s) {
    stretch.last_line = line;
    stretch.duration_s += duration_s;
  }
  void absorb() {
    extend(open_, next_.last_line, next_.duration_s);
    next_ = {};
  }

  std::vector<Stretch> list_;
  std::array<double, kLimiters> sums_s_{};
  Stretch open_;
  Stretch next_;  // of another limiter, still short; 0 s: none
  std::size_t count_ = 0;
};

}  // namespace dripfeed::timing
