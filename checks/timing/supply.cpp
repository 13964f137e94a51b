// One step a row, in order, as far as the starts that are known make room.
//
//   line     |--k--|--k+1--|                a block occupies the buffer from its first byte until it begins to move
//   compute        |-k-|   |-k+1-|
//   motion   ...k-1----|--k----|..|-k+1--   ..: the stall
#include "checks/timing/supply.h"

#include <algorithm>

namespace dripfeed::timing {

namespace {

// A block without bytes takes a place all the same, or the list would have no bound.
std::uint32_t place_of(const Row& row) { return std::max(row.bytes, 1U); }

}  // namespace

void Supply::restart(const SupplySettings& settings) {
  buffer_ = settings.buffer;
  char_s_ = settings.char_s;
  line_delay_s_ = settings.line_delay_s;
  line_s_ = settings.latency_s;
  if (char_s_ <= 0.0) buffer_.bytes = 0;  // bytes count on the line only
  buffered_.clear();
  buffered_bytes_ = 0;
  blocked_ = false;
  room_s_ = block_s_ = computed_s_ = 0.0;
  ready_s_.clear();
  arrived_s_.clear();
  reasons_.clear();
}

bool Supply::is_full(std::uint64_t bytes) const {
  return (buffer_.blocks > 0 && buffered_.size() >= buffer_.blocks) ||
         (buffer_.bytes > 0 && buffered_bytes_ + bytes > buffer_.bytes);
}

void Supply::let_in(const Rows& rows) {
  for (std::size_t i = ready_s_.size(); i < rows.size(); ++i) {
    const Row& row = rows[i];
    if (row.is_new && has_limit()) {
      // A block that is larger than the buffer passes alone.
      blocked_ = !buffered_.empty() && is_full(place_of(row));
      if (blocked_) return;
      buffered_.push_back(place_of(row));
      buffered_bytes_ += place_of(row);
    }
    const bool wants_room = room_s_ > (char_s_ > 0.0 ? line_s_ : computed_s_);
    if (row.is_new && char_s_ > 0.0) {
      line_s_ = std::max(line_s_, room_s_) + row.bytes * char_s_ + row.lines * line_delay_s_;
      block_s_ = line_s_ - (row.lines > 0 ? line_delay_s_ : 0.0);
    }
    const double arrived_s = char_s_ > 0.0 ? block_s_ : room_s_;
    const Limiter late = wants_room ? Limiter::buffer : Limiter::line;
    reasons_.push_back(arrived_s > computed_s_ ? late : Limiter::compute);
    computed_s_ = std::max(arrived_s, computed_s_) + row.compute_s;
    arrived_s_.push_back(arrived_s);
    ready_s_.push_back(computed_s_);
  }
}

void Supply::start_block(double now_s) {
  if (!has_limit()) return;
  buffered_bytes_ -= buffered_.front();
  buffered_.pop_front();
  if (blocked_) room_s_ = now_s;
}

void Supply::drop_front(std::size_t rows) {
  const auto count = static_cast<std::ptrdiff_t>(rows);
  ready_s_.erase(ready_s_.begin(), ready_s_.begin() + count);
  arrived_s_.erase(arrived_s_.begin(), arrived_s_.begin() + count);
  reasons_.erase(reasons_.begin(), reasons_.begin() + count);
}

}  // namespace dripfeed::timing
