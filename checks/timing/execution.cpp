// The forward sweep of the look-ahead once more, made while blocks arrive. The plan p knows the whole path; a control
// that knows the pieces up to k only must be able to stop at their end, and that adds one limit to a junction i:
//
//   v[i]² <= min(p[i]², sum of 2aL over the pieces i .. k)        (exact, because minimum distributes over addition)
//
// How many are known is looked at when a piece begins, and again at the moment at which it would have to brake: what
// came meanwhile may spare it that.
#include "checks/timing/execution.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "checks/timing/sweep.h"

namespace dripfeed::timing {

void Execution::restart(const SupplySettings& settings) {
  Supply supply = std::move(supply_);
  supply.restart(settings);
  *this = Execution(std::move(supply));
}

// Counts the rows that are ready; true when there were more.
bool Execution::learn(const Rows& rows, double now_s) {
  const std::size_t before = known_rows_;
  for (; known_rows_ < supply_.count() && supply_.ready_s(known_rows_) <= now_s; ++known_rows_) {
    if (rows[known_rows_].is_piece) ++known_pieces_;
  }
  return known_rows_ != before;
}

Limiter Execution::limiter_of(std::size_t row) const {
  return row < supply_.count() ? supply_.reason(row) : Limiter::buffer;
}

void Execution::run_piece(const Window& window, Ran& how) {
  const PieceArrays& p = window.pieces;
  const std::size_t i = piece_;
  const Piece piece = p.at(i);
  const double free2 = std::min(window.speed2[i + 1], speed2_ + change2(p, i));
  how.piece = i;
  how.start2 = speed2_;
  // The rule where everything comes in time: as planned, to the last bit.
  if (speed2_ == window.speed2[i] && free2 == window.speed2[i + 1] &&
      free2 <= window.sums[std::max(known_pieces_, i + 1)] - window.sums[i + 1]) {
    how.duration_s = window.duration_s[i];
    how.end2 = speed2_ = free2;
    return;
  }
  for (;;) {
    const std::size_t known = std::max(known_pieces_, i + 1);
    const double end2 = std::min(free2, window.sums[known] - window.sums[i + 1]);
    const Trapezoid shape = trapezoid_of(piece, speed2_, end2);
    how.duration_s = shape.duration_s;
    const bool is_limited = end2 < free2;
    if (is_limited && learn(window.rows, how.start_s + shape.duration_s - shape.brake_s)) continue;
    if (is_limited) {
      how.lost_s = shape.duration_s - trapezoid_of(piece, speed2_, free2).duration_s;
      if (how.waited_s <= kStall_s && how.lost_s > kStall_s) {
        how.limiter = limiter_of(known_rows_);
        how.late_row = std::min(known_rows_, window.rows.size() - 1);
      }
    }
    how.end2 = speed2_ = end2;
    return;
  }
}

void Execution::count_buffered(const Rows& rows, Ran& how) {
  for (; arrived_rows_ < supply_.count() && supply_.arrived_s(arrived_rows_) <= how.start_s; ++arrived_rows_) {
    if (!rows[arrived_rows_].is_new) continue;
    arrived_bytes_ += rows[arrived_rows_].bytes;
    ++arrived_blocks_;
  }
  if (rows[row_].is_new) {
    arrived_bytes_ -= rows[row_].bytes;
    --arrived_blocks_;
  }
  how.buffered_bytes = arrived_bytes_;
  how.buffered_blocks = arrived_blocks_;
}

std::size_t Execution::run(const Window& window, RanSink& sink) {
  const Rows& rows = window.rows;
  const std::size_t first = row_;
  Ran how;
  for (; row_ < rows.size(); ++row_) {
    const Row& row = rows[row_];
    supply_.let_in(rows);
    // What comes after the window may be in the buffer by now, and what ends after it is not certain.
    if (!window.is_last) {
      if (supply_.has_limit() && supply_.count() == rows.size()) break;
      if (row.is_piece && piece_ + 1 > window.certain) break;
    }
    // Field by field: to clear the whole costs more than the rest of this loop.
    how.row = row_;
    how.start_s = std::max(end_s_, supply_.ready_s(row_));
    how.waited_s = moved_ ? how.start_s - end_s_ : 0.0;
    how.start2 = how.end2 = how.lost_s = 0.0;
    how.limiter = Limiter::motion;
    if (how.waited_s > kStall_s) {
      how.limiter = limiter_of(row_);
      how.late_row = row_;
    }
    if (row.is_new) {
      supply_.start_block(how.start_s);
      supply_.let_in(rows);
    }
    learn(rows, how.start_s);
    count_buffered(rows, how);
    if (row.is_piece) {
      run_piece(window, how);
      ++piece_;
    } else {
      how.duration_s = row.event_s;
    }
    end_s_ = how.start_s + how.duration_s;
    moved_ = moved_ || how.duration_s > 0.0;
    how.all_arrived = window.is_last && arrived_rows_ == rows.size();
    if (!sink.ran(row, how)) break;
  }
  return row_ - first;
}

void Execution::drop_front(std::size_t rows, std::size_t pieces) {
  supply_.drop_front(rows);
  row_ -= rows;
  piece_ -= pieces;
  known_rows_ -= rows;
  known_pieces_ -= pieces;
  arrived_rows_ -= rows;
}

}  // namespace dripfeed::timing
