// The text of a job while it becomes frames: what is coded and not yet accepted, which part of it is in the present
// frame, and where blocks of the program end in it. Knows nothing of frames' forms.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "protocol/packet/settings.h"
#include "protocol/tape_code/text_source.h"
#include "protocol/tape_code/wire_encoder.h"

namespace dripfeed::packet {

class Outbox {
 public:
  void begin(const tape_code::WireFormat& format, tape_code::TextSource& source, std::uint64_t text_bytes);

  // Codes more text until the box is full or the source has no more for now.
  tape_code::FillStatus fill();
  // Coded and not accepted; at the end of the text nothing follows it.
  std::size_t available() const { return size_; }
  bool complete() const { return status_ == tape_code::FillStatus::end; }
  tape_code::FillStatus status() const { return status_; }

  // Makes a frame of the first `size` bytes, or fewer where `to_block_end` is set and a block ends before.
  void frame(std::size_t size, bool to_block_end);
  std::span<const std::byte> framed() const { return std::span(bytes_).first(framed_); }
  // Offset after the frame.
  std::uint64_t frame_end() const { return accepted_ + framed_; }
  // The peer has the frame.
  void accept();

  std::uint64_t accepted() const { return accepted_; }
  // No block of the program is unfinished here: before the frame, after it.
  bool block_ends_before() const { return ends_before_; }
  bool block_ended_before() const;
  std::optional<tape_code::WirePosition> locate(std::uint64_t offset) const;

 private:
  std::optional<tape_code::WireEncoder> encoder_;
  tape_code::FillStatus status_ = tape_code::FillStatus::end;
  std::array<std::byte, kMaxPayload> bytes_{};
  std::array<std::uint8_t, kMaxPayload> ends_{};
  std::size_t size_ = 0;
  std::size_t framed_ = 0;
  std::uint64_t accepted_ = 0;
  bool ends_before_ = true;
};

}  // namespace dripfeed::packet
