// Bytes that wait for the socket: one buffer with a named limit, filled with whole commands or data only.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "protocol/telnet/codes.h"

namespace dripfeed::telnet {

class Output {
 public:
  static constexpr std::size_t kBytes = 1024;
  // Left free by data, so that an answer of the protocol always has room.
  static constexpr std::size_t kForCommands = 512;

  void negotiate(Verb verb, std::uint8_t option);
  // IAC SB option code parameters IAC SE, FF doubled.
  void subnegotiate(std::uint8_t option, std::uint8_t code, std::span<const std::uint8_t> parameters);
  // How many of them fit. Without BINARY a CR goes out as CR NUL (RFC 854).
  std::size_t data(std::span<const std::byte> bytes, bool binary);

  [[nodiscard]] std::span<const std::byte> pending() const { return std::span(bytes_).subspan(begin_, end_ - begin_); }
  void mark_sent(std::size_t count);
  // Commands that found no room: the peer reads nothing.
  [[nodiscard]] std::uint64_t lost() const { return lost_; }

 private:
  [[nodiscard]] std::size_t room() const { return kBytes - end_; }
  void put(std::uint8_t byte) { bytes_[end_++] = static_cast<std::byte>(byte); }
  bool make_room(std::size_t count);

  std::array<std::byte, kBytes> bytes_{};
  std::size_t begin_ = 0;
  std::size_t end_ = 0;
  std::uint64_t lost_ = 0;
};

}  // namespace dripfeed::telnet
