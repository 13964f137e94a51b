// The sender's text: gathering the next block, passing over what the receiver holds already, and finding work.
#include <algorithm>

#include "protocol/modbus/sender.h"

namespace dripfeed::modbus {

using tape_code::SourceStatus;

void Sender::look_for_work() {
  if (hold_wanted_ && at_block_end_) {
    static_cast<void>(react(SenderInput::hold_due));
    return;
  }
  gather();
  if (text_lost_) {
    reason_ = StopReason::text_lost;
    static_cast<void>(react(SenderInput::text_lost));
  } else if (payload_cut_ > 0) {
    const bool reserved = before_.appended + payload_cut_ <= job_.reserve;
    if (reserved && last_.free_blocks > 0) static_cast<void>(react(SenderInput::has_block));
  } else if (before_.appended == job_.text_bytes) {
    static_cast<void>(react(SenderInput::has_end));
  }
}

// Makes sure that the piece has a character.
SourceStatus Sender::next_piece() {
  while (piece_used_ == piece_.size()) {
    const tape_code::TextPiece piece = job_.source->next();
    if (piece.status != SourceStatus::text) return piece.status;
    piece_ = piece.text;
    piece_used_ = 0;
  }
  return SourceStatus::text;
}

// Fills the payload and cuts it after its last LF, so that a block of the mailbox ends with a block of the program
// wherever it can. A line longer than the payload goes in parts.
void Sender::gather() {
  text_not_ready_ = false;
  const std::size_t limit = settings_.max_payload;
  while (payload_size_ < limit && taken_ < job_.text_bytes) {
    const SourceStatus status = next_piece();
    text_not_ready_ = status == SourceStatus::not_ready;
    text_lost_ = status == SourceStatus::end || status == SourceStatus::failed;
    if (text_lost_ || text_not_ready_) break;
    const std::size_t count =
        std::min<std::uint64_t>({limit - payload_size_, piece_.size() - piece_used_, job_.text_bytes - taken_});
    std::transform(piece_.begin() + static_cast<std::ptrdiff_t>(piece_used_),
                   piece_.begin() + static_cast<std::ptrdiff_t>(piece_used_ + count),
                   payload_.begin() + static_cast<std::ptrdiff_t>(payload_size_),
                   [](char c) { return static_cast<std::byte>(c); });
    payload_size_ += count;
    piece_used_ += count;
    taken_ += count;
  }
  const auto begin = payload_.rend() - static_cast<std::ptrdiff_t>(payload_size_);
  const auto last_lf = std::find(begin, payload_.rend(), std::byte{'\n'});
  payload_cut_ = static_cast<std::size_t>(payload_.rend() - last_lf);
  const bool whole = taken_ == job_.text_bytes || (payload_cut_ == 0 && payload_size_ == limit);
  if (whole) payload_cut_ = payload_size_;
}

void Sender::drop_payload(std::size_t count) {
  if (count == 0) return;
  at_block_end_ = payload_[count - 1] == std::byte{'\n'} || before_.appended == job_.text_bytes;
  std::copy(payload_.begin() + static_cast<std::ptrdiff_t>(count),
            payload_.begin() + static_cast<std::ptrdiff_t>(payload_size_), payload_.begin());
  payload_size_ -= count;
  payload_cut_ = 0;
}

// Passes over the text that the receiver says it has, and compares the CRC of it. before_ grows as it goes, so that a
// source that is not ready can be asked again later.
Sender::Skip Sender::skip_confirmed(const Status& status) {
  if (status.appended < before_.appended || status.appended > job_.text_bytes) return Skip::differs;
  while (before_.appended < status.appended) {
    if (payload_size_ == 0) {
      if (taken_ == job_.text_bytes) return Skip::lost;
      const SourceStatus ready = next_piece();
      if (ready == SourceStatus::not_ready) return Skip::pending;
      if (ready != SourceStatus::text) return Skip::lost;
      gather();
    }
    const std::size_t count = std::min<std::size_t>(payload_size_, status.appended - before_.appended);
    before_.text_crc = crc32(before_.text_crc, std::span<const std::byte>(payload_).first(count));
    before_.appended += static_cast<std::uint32_t>(count);
    drop_payload(count);
  }
  return before_.text_crc == status.text_crc ? Skip::done : Skip::differs;
}

}  // namespace dripfeed::modbus
