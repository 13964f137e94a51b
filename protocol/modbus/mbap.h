// One connection of a Modbus TCP server: bytes to requests, answers to bytes. Strict, because a stream
// that is out of step stays so: a header that cannot be, or one that stays unfinished, ends the connection.
// Requests that come at once are all answered, in order. No socket here. Source: Modbus Messaging on TCP/IP 1.0b,
// section 3.
#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "protocol/modbus/register_server.h"
#include "protocol/modbus/sender.h"

namespace dripfeed::modbus {

// A frame: transaction (2), protocol 0 (2), length of what follows (2), unit (1), PDU.
inline constexpr std::size_t kMbapHeader = 7;
inline constexpr std::size_t kMaxAdu = kMbapHeader + kMaxPdu;
// A request that is begun must be whole after this time.
inline constexpr Time kRequestAtMost = std::chrono::seconds(1);
// A client that asks nothing for so long is let go.
inline constexpr Time kIdleAtMost = std::chrono::minutes(10);

enum class MbapEnd : std::uint8_t {
  none,
  protocol,    // a protocol identifier that is not Modbus
  length,      // a length that no request has
  unfinished,  // half a request, then silence
  idle,
};

// Driver: receive() what came and keep what it did not take; send pending_out() and mark_sent(); after each call look
// at ended(); tick() at deadline(). Never allocates.
class MbapConnection {
 public:
  MbapConnection(RegisterView& view, Time now) : view_(&view), heard_at_(now) {}

  // How many of the bytes were taken: fewer than given only while the answers before them are not sent.
  std::size_t receive(std::span<const std::byte> bytes, Time now);
  std::span<const std::byte> pending_out() const { return std::span(out_).subspan(sent_, filled_ - sent_); }
  void mark_sent(std::size_t count);
  Time deadline() const { return heard_at_ + (gathered_ > 0 ? kRequestAtMost : kIdleAtMost); }
  void tick(Time now);
  // What ended it; the driver sends what is pending and closes.
  MbapEnd ended() const { return end_; }
  std::uint64_t requests() const { return requests_; }

 private:
  std::size_t wanted() const;
  void take_header();
  void take_request();

  RegisterView* view_;
  Time heard_at_;  // the first byte of the request that is begun, or the last of the one before
  std::array<std::uint8_t, kMaxAdu> in_{};
  std::size_t gathered_ = 0;
  std::array<std::byte, 4 * kMaxAdu> out_{};
  std::size_t filled_ = 0;
  std::size_t sent_ = 0;
  std::uint64_t requests_ = 0;
  MbapEnd end_ = MbapEnd::none;
};

}  // namespace dripfeed::modbus
