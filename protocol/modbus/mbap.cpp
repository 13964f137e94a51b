// Gathering of requests and writing of answers.
#include "protocol/modbus/mbap.h"

#include <algorithm>

namespace dripfeed::modbus {
namespace {

constexpr std::size_t kProtocolAt = 2;
constexpr std::size_t kLengthAt = 4;
constexpr std::size_t kUnitAt = 6;
constexpr std::size_t kBeforeUnit = 6;
constexpr std::size_t kShortest = 2;  // unit and function

}  // namespace

// Bytes that the request has as far as it is known: its header, then all of it.
std::size_t MbapConnection::wanted() const {
  if (gathered_ < kBeforeUnit) return kBeforeUnit;
  return kBeforeUnit + in_[kLengthAt] * 256U + in_[kLengthAt + 1];
}

std::size_t MbapConnection::receive(std::span<const std::byte> bytes, Time now) {
  std::size_t taken = 0;
  while (taken < bytes.size() && end_ == MbapEnd::none && filled_ + kMaxAdu <= out_.size()) {
    if (gathered_ == 0) heard_at_ = now;
    const std::size_t count = std::min(wanted() - gathered_, bytes.size() - taken);
    std::transform(bytes.begin() + static_cast<std::ptrdiff_t>(taken),
                   bytes.begin() + static_cast<std::ptrdiff_t>(taken + count),
                   in_.begin() + static_cast<std::ptrdiff_t>(gathered_),
                   [](std::byte byte) { return std::to_integer<std::uint8_t>(byte); });
    gathered_ += count;
    taken += count;
    if (gathered_ == kBeforeUnit) take_header();
    if (end_ == MbapEnd::none && gathered_ > kBeforeUnit && gathered_ == wanted()) {
      take_request();
      heard_at_ = now;
    }
  }
  return taken;
}

void MbapConnection::take_header() {
  const std::size_t length = wanted() - kBeforeUnit;
  if (in_[kProtocolAt] != 0 || in_[kProtocolAt + 1] != 0) {
    end_ = MbapEnd::protocol;
  } else if (length < kShortest || length > kMaxPdu + 1) {
    end_ = MbapEnd::length;
  }
}

void MbapConnection::take_request() {
  ++requests_;
  Pdu pdu{};
  const auto request = std::span<const std::uint8_t>(in_).subspan(kMbapHeader, gathered_ - kMbapHeader);
  const std::size_t length = answer(in_[kUnitAt], request, *view_, pdu);
  const auto put = [&](std::uint8_t byte) { out_[filled_++] = std::byte{byte}; };
  for (std::size_t i = 0; i < kLengthAt; ++i) put(in_[i]);
  put(static_cast<std::uint8_t>((length + 1) >> 8U));
  put(static_cast<std::uint8_t>((length + 1) & 0xFFU));
  put(in_[kUnitAt]);
  for (std::size_t i = 0; i < length; ++i) put(pdu[i]);
  gathered_ = 0;
}

void MbapConnection::mark_sent(std::size_t count) {
  sent_ = std::min(filled_, sent_ + count);
  if (sent_ < filled_) return;
  sent_ = 0;
  filled_ = 0;
}

void MbapConnection::tick(Time now) {
  if (end_ != MbapEnd::none || now < deadline()) return;
  end_ = gathered_ > 0 ? MbapEnd::unfinished : MbapEnd::idle;
}

}  // namespace dripfeed::modbus
