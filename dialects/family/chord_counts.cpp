// The bound of a piece is the largest of its cells, because intervals are the tighter the shorter they are.
#include "dialects/family/chord_counts.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "dialects/family/evaluate.h"
#include "dialects/family/second_derivative.h"
#include "dialects/text/number.h"

namespace dripfeed::family {

namespace {

constexpr int kCells = 32;  // of a piece
constexpr double kMostChords = 1'000'000.0;

// |r''| is at most this over a range of t.
double bend(const BoundFamily& bound, const ChordedCurve& curve, curves::Range t) {
  const Family& family = *bound.family;
  double squares = 0.0;
  for (const StepWord& word : words_of(family, curve)) {
    const curves::Range range = second_derivative(family.arena, word.value, bound.values, curve.parameter, t);
    const double on_radius = word.address == ir::Address::x && family.x_is_diameter ? 0.5 : 1.0;
    const double most = on_radius * std::max(std::abs(range.low), std::abs(range.high));
    squares += most * most;
  }
  return std::sqrt(squares);
}

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
  const double cell = (to - from) / (kCurvePieces * kCells);
  ChordCounts out;
  double sum = 0.0;
  for (int piece = 0; piece < kCurvePieces; ++piece) {
    double most = 0.0;
    for (int i = 0; i < kCells; ++i) {
      const double a = from + cell * (piece * kCells + i);
      const double b = from + cell * (piece * kCells + i + 1);
      most = std::max(most, bend(bound, curve, {std::min(a, b), std::max(a, b)}));
    }
    if (!std::isfinite(most))
      return {{},
              "how far this curve bends cannot be proved: it has a step, a corner or a pole, or may have one; use "
              "'steps' in place of 'within', or cut it in parts"};
    out.by_piece.push_back(std::max(1.0, std::ceil(std::abs(cell * kCells) * std::sqrt(most / (8.0 * error_mm)))));
    sum += out.by_piece.back();
  }
  if (sum > kMostChords) return {{}, "this curve takes more than a million chords for its error"};
  return out;
}

}  // namespace dripfeed::family
