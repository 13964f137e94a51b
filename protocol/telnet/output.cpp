// Bytes that wait for the socket, whole commands at a time.
#include "protocol/telnet/output.h"

#include <algorithm>

namespace dripfeed::telnet {

namespace {
constexpr std::byte kCr{'\r'};
constexpr std::size_t kFrame = 6;  // IAC SB option code … IAC SE
}  // namespace

bool Output::make_room(std::size_t count) {
  if (room() < count && begin_ > 0) {
    std::copy(bytes_.begin() + static_cast<std::ptrdiff_t>(begin_), bytes_.begin() + static_cast<std::ptrdiff_t>(end_),
              bytes_.begin());
    end_ -= begin_;
    begin_ = 0;
  }
  return room() >= count;
}

void Output::negotiate(Verb verb, std::uint8_t option) {
  if (!make_room(3)) {
    ++lost_;
    return;
  }
  put(kIac);
  put(static_cast<std::uint8_t>(verb));
  put(option);
}

void Output::subnegotiate(std::uint8_t option, std::uint8_t code, std::span<const std::uint8_t> parameters) {
  if (!make_room(kFrame + 2 * parameters.size())) {
    ++lost_;
    return;
  }
  put(kIac);
  put(kSubBegin);
  put(option);
  put(code);
  for (const std::uint8_t byte : parameters) {
    put(byte);
    if (byte == kIac) put(kIac);
  }
  put(kIac);
  put(kSubEnd);
}

std::size_t Output::data(std::span<const std::byte> bytes, bool binary) {
  std::size_t taken = 0;
  for (const std::byte byte : bytes) {
    if (!make_room(kForCommands + 2)) break;
    put(static_cast<std::uint8_t>(byte));
    if (byte == std::byte{kIac}) put(kIac);
    if (byte == kCr && !binary) put(0);
    ++taken;
  }
  return taken;
}

void Output::mark_sent(std::size_t count) {
  begin_ += std::min(count, end_ - begin_);
  if (begin_ == end_) begin_ = end_ = 0;
}

}  // namespace dripfeed::telnet
