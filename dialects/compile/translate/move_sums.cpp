// Weights, so that two moves that change places, or values of two, do not add up to the same.
#include "dialects/compile/translate/move_sums.h"

#include <algorithm>
#include <cmath>

namespace dripfeed::compile {

namespace {

constexpr std::uint64_t kWeights = 7;

bool near_sum(double a, double b) { return std::abs(a - b) <= 1e-6 * (1.0 + std::abs(a) * 1e-3); }

}  // namespace

void MoveSums::consume(std::span<const ir::Motion> motions) {
  for (const ir::Motion& m : motions)
    if (m.place.program == 0 && ir::is_move(m.kind)) add(m);
}

bool MoveSums::same_reach(const Reach& a, const Reach& b) {
  return std::ranges::equal(a.low, b.low, near_sum) && std::ranges::equal(a.high, b.high, near_sum) &&
         std::ranges::equal(a.end, b.end, near_sum);
}

bool MoveSums::same_piece(const Piece& a, const Piece& b) {
  return a.stretch == b.stretch && a.number == b.number && a.moves == b.moves && a.kinds == b.kinds &&
         std::ranges::equal(a.ends, b.ends, near_sum) && std::ranges::equal(a.centers, b.centers, near_sum) &&
         near_sum(a.feeds, b.feeds) && near_sum(a.speeds, b.speeds);
}

bool MoveSums::same(const MoveSums& other) const {
  const auto leads_alike = [](const auto& a, const auto& b) {
    return a.first == b.first && same_reach(a.second, b.second);
  };
  return std::ranges::equal(outside_, other.outside_, leads_alike) &&
         std::ranges::equal(pieces_, other.pieces_, same_piece);
}

void MoveSums::add(const ir::Motion& m) {
  const std::uint32_t line = m.place.line;
  while (at_ > 0 && line < stretches_[at_].line) --at_;
  while (at_ + 1 < stretches_.size() && line >= stretches_[at_ + 1].line) ++at_;
  const ir::PlainStretch& stretch = stretches_[at_];
  if (line < stretch.line || line - stretch.line >= stretch.line_count) return add_outside(line, m);
  const std::uint32_t number = (line - stretch.line) / kLinesOfAPiece;
  if (pieces_.empty() || pieces_.back().stretch != at_ || pieces_.back().number != number)
    pieces_.push_back({.stretch = at_, .number = number});
  Piece& piece = pieces_.back();
  ++piece.moves;
  const std::uint64_t times = 1 + piece.moves % kWeights;
  const auto weight = static_cast<double>(times);
  piece.kinds += times * (static_cast<std::uint64_t>(m.kind) * 64 + static_cast<std::uint64_t>(m.comp) * 8 +
                          static_cast<std::uint64_t>(m.feed_mode));
  for (std::size_t axis = 0; axis < ir::kAxisCount; ++axis)
    if ((m.axes_commanded >> axis & 1U) != 0) piece.ends[axis] += weight * m.end[axis];
  if (m.kind == ir::MotionKind::arc_cw || m.kind == ir::MotionKind::arc_ccw)
    for (std::size_t i = 0; i < piece.centers.size(); ++i) piece.centers[i] += weight * m.center[i];
  if (m.kind != ir::MotionKind::rapid) piece.feeds += weight * m.feed;
  piece.speeds += weight * m.spindle_rpm;
}

void MoveSums::add_outside(std::uint32_t line, const ir::Motion& m) {
  if (origins_ != nullptr) line = line <= origins_->size() ? (*origins_)[line - 1] : 0;
  Reach& reach = outside_.try_emplace(line, Reach{.low = m.end, .high = m.end}).first->second;
  for (std::size_t axis = 0; axis < ir::kAxisCount; ++axis) {
    reach.low[axis] = std::min(reach.low[axis], m.end[axis]);
    reach.high[axis] = std::max(reach.high[axis], m.end[axis]);
  }
  reach.end = m.end;
}

}  // namespace dripfeed::compile
