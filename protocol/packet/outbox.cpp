// Where blocks end is kept next to the bytes, so that a cancel and a torn line know it.
#include "protocol/packet/outbox.h"

#include <algorithm>

namespace dripfeed::packet {

using tape_code::FillStatus;

void Outbox::begin(const tape_code::WireFormat& format, tape_code::TextSource& source, std::uint64_t text_bytes) {
  encoder_.emplace(format, source, text_bytes);
  status_ = FillStatus::more;
  size_ = 0;
  framed_ = 0;
  accepted_ = 0;
  ends_before_ = true;
}

FillStatus Outbox::fill() {
  while (size_ < bytes_.size() && (status_ == FillStatus::more || status_ == FillStatus::not_ready)) {
    const auto filled = encoder_->fill(std::span(bytes_).subspan(size_), std::span(ends_).subspan(size_));
    size_ += filled.count;
    status_ = filled.status;
    if (status_ == FillStatus::not_ready) break;
  }
  return status_;
}

void Outbox::frame(std::size_t size, bool to_block_end) {
  framed_ = std::min(size, size_);
  if (!to_block_end) return;
  const auto end = std::ranges::find_if(ends_.begin(), ends_.begin() + static_cast<std::ptrdiff_t>(framed_),
                                        [](std::uint8_t ends) { return ends != 0; });
  const auto index = static_cast<std::size_t>(end - ends_.begin());
  if (index < framed_) framed_ = index + 1;
}

void Outbox::accept() {
  if (framed_ == 0) return;
  ends_before_ = block_ended_before();
  std::ranges::copy(std::span(bytes_).subspan(framed_, size_ - framed_), bytes_.begin());
  std::ranges::copy(std::span(ends_).subspan(framed_, size_ - framed_), ends_.begin());
  size_ -= framed_;
  accepted_ += framed_;
  framed_ = 0;
}

bool Outbox::block_ended_before() const {
  if (framed_ == 0) return ends_before_;
  return ends_[framed_ - 1] != 0 || (complete() && framed_ == size_);
}

std::optional<tape_code::WirePosition> Outbox::locate(std::uint64_t offset) const {
  return encoder_ ? encoder_->locate(offset) : std::nullopt;
}

}  // namespace dripfeed::packet
