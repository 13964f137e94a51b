// The plan is two sweeps over squares of speed, in which a piece of length L and acceleration a changes the square by
// at most 2·a·L.
//
//   speed²
//     |     ______________ limit of the piece            backward: b[i] = min(limit[i], b[i+1] + 2aL)
//     |    /.            .\                              forward:  v[i+1] = min(b[i+1], v[i] + 2aL)
//     |   / .            . \      ___ ...
//     |  /  .            .  \____/                       The time of a piece is that of the trapezoid (or triangle)
//     +-----+------------+-----------> path              between v[i] and v[i+1] under its own limit.
//         corner       corner
//
// The backward sweep needs the path's end, which a stream does not have. So it is done twice from the last kept piece:
// once as if the path ended there at rest (low2), once as if it went on without limit (high2). The truth lies between.
// Going back, the two meet at the first junction whose own limit is below both, and from there on they are equal bit
// for bit: everything before that junction is certain, and is given out. Where they never meet (a path that needs more
// than the kept pieces to stop), more is kept. So the plan does not depend on the chunk.
//
// A control that sees only n pieces ahead must be able to stop within them: the square at i is at most the sum of 2aL
// over the pieces i .. i+n-1. That is one more limit of the junction, from differences of the running sum.
#include "checks/timing/planner.h"

#include <algorithm>
#include <cmath>

namespace dripfeed::timing {

namespace {

double change(const PlannedPiece& piece) { return 2.0 * piece.acceleration * piece.length; }

double duration(const PlannedPiece& piece, double start2, double end2) {
  const double peak2 = std::min(piece.speed2, std::max({start2, end2, 0.5 * (start2 + end2 + change(piece))}));
  const double peak = std::sqrt(peak2);
  const double start = std::sqrt(start2);
  const double end = std::sqrt(end2);
  const double ramps = ((peak2 - start2) + (peak2 - end2)) / (2.0 * piece.acceleration);
  return (2.0 * peak - start - end) / piece.acceleration + std::max(0.0, piece.length - ramps) / peak;
}

}  // namespace

Planner::Planner(PlanSink& sink, std::size_t look_ahead, std::size_t chunk)
    : sink_(sink), look_ahead_(look_ahead), chunk_(std::max<std::size_t>(chunk, 2)), wanted_(chunk_) {
  pieces_.reserve(chunk_);
}

void Planner::append(const PlannedPiece& piece) {
  if (!(piece.start2 > 0.0)) {
    finish();
  } else if (pieces_.size() >= wanted_) {
    settle();
  }
  pieces_.push_back({piece, sum_, 0.0, 0.0});
  sum_ += change(piece);
}

void Planner::finish() {
  if (!pieces_.empty()) {
    look_back(true);
    give(pieces_.size(), 0.0);
  }
  sum_ = 0.0;
  speed2_ = 0.0;
  wanted_ = chunk_;
}

// Highest square at the start of a kept piece by its own limits. `ends`: the path ends at rest after the last one.
double Planner::limit_of(std::size_t index, bool ends) const {
  const Kept& kept = pieces_[index];
  double limit = std::min(kept.piece.start2, kept.piece.speed2);
  if (index > 0) limit = std::min(limit, pieces_[index - 1].piece.speed2);
  if (look_ahead_ == 0) return limit;
  const std::size_t stop = index + look_ahead_;
  if (stop < pieces_.size()) return std::min(limit, pieces_[stop].stop_sum - kept.stop_sum);
  return ends || stop == pieces_.size() ? std::min(limit, sum_ - kept.stop_sum) : limit;
}

void Planner::look_back(bool ends) {
  double low = 0.0;
  double high = ends ? 0.0 : pieces_.back().piece.speed2;
  for (std::size_t i = pieces_.size(); i-- > 0;) {
    Kept& kept = pieces_[i];
    low = std::min(limit_of(i, true), low + change(kept.piece));
    high = ends ? low : std::min(limit_of(i, false), high + change(kept.piece));
    kept.low2 = low;
    kept.high2 = high;
  }
}

// Gives out the first `count` pieces; the junction after them is at most `end2_of_last`.
void Planner::give(std::size_t count, double end2_of_last) {
  for (std::size_t i = 0; i < count; ++i) {
    const PlannedPiece& piece = pieces_[i].piece;
    const double allowed = i + 1 < count ? pieces_[i + 1].low2 : end2_of_last;
    const double end2 = std::min(allowed, speed2_ + change(piece));
    sink_.planned(duration(piece, speed2_, end2), std::sqrt(speed2_), std::sqrt(end2));
    speed2_ = end2;
  }
  pieces_.erase(pieces_.begin(), pieces_.begin() + static_cast<std::ptrdiff_t>(count));
}

void Planner::settle() {
  look_back(false);
  std::size_t certain = pieces_.size();
  while (certain > 0 && pieces_[certain - 1].low2 != pieces_[certain - 1].high2) --certain;
  // `certain` junctions are known: those at the starts of pieces 0 .. certain-1, so all pieces but the last of these.
  const std::size_t count = certain > 0 ? certain - 1 : 0;
  if (count > 0) give(count, pieces_[count].low2);
  // Seldom less than half: otherwise the sweeps would be repeated over the same pieces too often.
  wanted_ = std::max(chunk_, 2 * pieces_.size());
}

}  // namespace dripfeed::timing
