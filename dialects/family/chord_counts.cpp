// A count is guessed from how the curve bends in cells of a piece, and then proved chord by chord; it grows until it
// is.
#include "dialects/family/chord_counts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include <fmt/format.h>

#include "dialects/family/evaluate.h"
#include "dialects/family/range_arithmetic.h"
#include "dialects/family/second_derivative.h"
#include "dialects/text/number.h"

namespace dripfeed::family {

namespace {

constexpr int kCells = 32;  // of a piece
constexpr double kMostChords = 100'000.0;
constexpr double kOfSums = 1.0 + 1e-12;  // rounding of what is not a range
constexpr double kGrowth = 1.03;

// r' and r'' over a range of t, by axis.
class Bend {
 public:
  Bend(const BoundFamily& bound, const ChordedCurve& curve, Range t) {
    const Family& family = *bound.family;
    for (const StepWord& word : words_of(family, curve)) {
      const double on_radius = word.address == ir::Address::x && family.x_is_diameter ? 0.5 : 1.0;
      const DerivativeRanges one = derivatives(family.arena, word.value, bound.values, curve.parameter, t);
      const auto axis = static_cast<std::size_t>(word.address) - static_cast<std::size_t>(ir::Address::x);
      first_[axis] = on_radius * one.first;
      second_[axis] = on_radius * one.second;
    }
  }

  // |r''|, or of it only what lies across the chord: 8/h² times how far the curve lies from it at most.
  [[nodiscard]] double most() const {
    const double all = std::hypot(most_of(second_[0]), most_of(second_[1]), most_of(second_[2]));
    if (!std::isfinite(all)) return kInfinity;
    const double length = std::hypot(least_of(first_[0]), least_of(first_[1]), least_of(first_[2]));
    // Where the curve turns back along its chord, the chord's ends may be nearer than its line is.
    double onward = 0.0;
    for (const Range& one : first_) onward += (one * one).low;
    if (!(length > 0.0) || !(onward > 0.0)) return kOfSums * all;
    double squares = 0.0;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3;
      const double across = most_of(first_[i] * second_[j] - first_[j] * second_[i]);
      squares += across * across;
    }
    const double across = std::sqrt(squares) / length;
    return kOfSums * (across < all ? across : all);  // NaN is not less
  }

 private:
  std::array<Range, 3> first_{};
  std::array<Range, 3> second_{};
};

class Counter {
 public:
  Counter(const BoundFamily& bound, const ChordedCurve& curve, double from, double width, double error_mm)
      : bound_(bound), curve_(curve), from_(from), width_(width), error_mm_(error_mm) {}

  // More than kMostChords where none can be found.
  [[nodiscard]] double count() const {
    double most = 0.0;
    for (int i = 0; i < kCells; ++i) most = std::max(most, bend(i, kCells));
    if (!std::isfinite(most)) return most;
    double chords = std::max(1.0, std::ceil(std::abs(width_) * std::sqrt(most / (8.0 * error_mm_))));
    while (chords <= kMostChords && !holds(chords)) chords = std::ceil(chords * kGrowth);
    return chords;
  }

 private:
  [[nodiscard]] double bend(double part, double parts) const {
    const double a = from_ + width_ * (part / parts);
    const double b = from_ + width_ * ((part + 1.0) / parts);
    return Bend(bound_, curve_, {std::min(a, b), std::max(a, b)}).most();
  }
  [[nodiscard]] bool holds(double chords) const {
    const double step = width_ / chords;
    const auto count = static_cast<int>(chords);
    for (int i = 0; i < count; ++i)
      if (!(step * step / 8.0 * bend(i, chords) <= error_mm_)) return false;
    return true;
  }

  const BoundFamily& bound_;
  const ChordedCurve& curve_;
  double from_;
  double width_;
  double error_mm_;
};

}  // namespace

std::span<const StepWord> words_of(const Family& family, const ChordedCurve& curve) {
  return std::span(family.words).subspan(curve.first_word, curve.word_count);
}

ChordCounts chord_counts(const BoundFamily& bound, const ChordedCurve& curve) {
  const ir::Program& arena = bound.family->arena;
  const double from = evaluate(arena, curve.t.low, bound.values).value;
  const double to = evaluate(arena, curve.t.high, bound.values).value;
  const double error_mm = evaluate(arena, curve.error, bound.values).value;
  if (error_mm <= 0.0) return {{}, fmt::format("the error of a curve is {}", text::format_shortest(error_mm))};
  const double width = (to - from) / kCurvePieces;
  ChordCounts out;
  double sum = 0.0;
  for (int piece = 0; piece < kCurvePieces && sum <= kMostChords; ++piece) {
    out.by_piece.push_back(Counter(bound, curve, from + width * piece, width, error_mm).count());
    if (!std::isfinite(out.by_piece.back()))
      return {{},
              "how far this curve bends cannot be proved: it has a step, a corner or a pole, or may have one; use "
              "'steps' in place of 'within', or cut it in parts"};
    sum += out.by_piece.back();
  }
  if (sum > kMostChords) return {{}, "this curve takes more than 100,000 chords for its error"};
  return out;
}

}  // namespace dripfeed::family
