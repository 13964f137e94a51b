// One step a block, in order: the starts of all blocks before it are known when its room is looked for.
//
//   line     |--k--|--k+1--|                a block occupies the buffer from its first byte until it begins to move
//   compute        |-k-|   |-k+1-|
//   motion   ...k-1----|--k----|..|-k+1--   ..: the stall
#include "checks/timing/feeder.h"

#include <algorithm>

namespace dripfeed::timing {

Feeder::Feeder(checks::BufferSize buffer, double char_s, double latency_s)
    : buffer_(buffer), char_s_(char_s), line_s_(latency_s) {
  if (char_s_ <= 0.0) buffer_.bytes = 0;  // bytes count on the line only
}

void Feeder::make_room(std::uint64_t bytes) {
  const auto is_full = [&] {
    return (buffer_.blocks > 0 && buffered_.size() >= buffer_.blocks) ||
           (buffer_.bytes > 0 && buffered_bytes_ + bytes > buffer_.bytes);
  };
  while (!buffered_.empty() && is_full()) {
    room_s_ = std::max(room_s_, buffered_.front().start_s);
    buffered_bytes_ -= buffered_.front().bytes;
    buffered_.pop_front();
  }
}

double Feeder::feed(const FedBlock& block) {
  // A block without bytes takes a place all the same, or the list would have no bound.
  const std::uint64_t bytes = std::max<std::uint64_t>(block.bytes, 1);
  if (block.is_new) {
    make_room(bytes);
    if (char_s_ > 0.0) line_s_ = std::max(line_s_, room_s_) + static_cast<double>(block.bytes) * char_s_;
  }
  const double arrived_s = char_s_ > 0.0 ? line_s_ : room_s_;
  ready_s_ = std::max(arrived_s, ready_s_) + block.compute_s;
  const double start_s = std::max(end_s_, ready_s_);
  const double waited_s = moved_ ? start_s - end_s_ : 0.0;
  if (block.is_new && (buffer_.blocks > 0 || buffer_.bytes > 0)) {
    buffered_.push_back({start_s, bytes});
    buffered_bytes_ += bytes;
  }
  end_s_ = start_s + block.motion_s;
  moved_ = moved_ || block.motion_s > 0.0;
  return waited_s;
}

}  // namespace dripfeed::timing
