// XMODEM with sum, with CRC, and with blocks of 1024: the characters, the form of a packet, the sender's and the
// receiver's rules. Sources: W. Christensen's protocol and C. Forsberg's "XMODEM/YMODEM protocol reference" (1988).
//
//   SOH or STX | number | 255 - number | 128 or 1024 bytes | sum, or CRC high and low
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "protocol/packet/receive_rules.h"
#include "protocol/packet/send_rules.h"

namespace dripfeed::packet {

namespace xmodem {
inline constexpr std::uint8_t kSoh = 0x01;
inline constexpr std::uint8_t kStx = 0x02;
inline constexpr std::uint8_t kEot = 0x04;
inline constexpr std::uint8_t kAck = 0x06;
inline constexpr std::uint8_t kNak = 0x15;
inline constexpr std::uint8_t kCan = 0x18;
inline constexpr std::uint8_t kSub = 0x1A;
inline constexpr std::uint8_t kWantCrc = 'C';
inline constexpr std::size_t kShort = 128;
inline constexpr std::size_t kLong = 1024;
inline constexpr std::size_t kHead = 3;
// One CAN is noise, two are a word; this many leave no doubt.
inline constexpr std::size_t kCansSent = 8;
}  // namespace xmodem

class XmodemSendRules final : public SendRules {
 public:
  explicit XmodemSendRules(const Settings& settings) : settings_(settings) {}

  void begin() override;
  Heard hear(std::uint8_t byte, State state) override;
  Heard late(State state) override;
  Patience patience(State state) const override;
  std::size_t frame_size(std::size_t available, bool complete) const override;
  std::size_t compose(std::span<const std::byte> payload, std::span<std::byte> out) override;
  std::size_t close(std::span<std::byte> out) override;
  std::size_t part(std::span<std::byte> out) override;
  void accepted() override;

 private:
  Heard hear_start(std::uint8_t byte);
  Heard hear_answer(std::uint8_t byte);

  Settings settings_;
  bool crc_ = false;
  std::uint8_t number_ = 1;
  bool first_ = true;           // no block was accepted yet
  std::uint32_t cans_ = 0;      // in a row
  std::uint32_t restarts_ = 0;  // C where none is due
};

class XmodemReceiveRules final : public ReceiveRules {
 public:
  explicit XmodemReceiveRules(const Settings& settings) : settings_(settings) {}

  void begin() override;
  std::size_t invite(std::span<std::byte> out) override;
  Received hear(std::uint8_t byte, ReceiveState state) override;
  std::optional<Time> silence(ReceiveState state) const override;
  std::uint32_t attempts(ReceiveState state) const override;
  std::size_t usual_payload() const override {
    return settings_.protocol == Protocol::xmodem_1k ? xmodem::kLong : xmodem::kShort;
  }
  std::span<const std::byte> payload() const override;
  std::size_t acknowledge(std::span<std::byte> out) override;
  std::size_t refuse(std::span<std::byte> out) override;
  std::size_t cancel(std::span<std::byte> out) override;

 private:
  Received judge();

  Settings settings_;
  std::array<std::byte, xmodem::kHead + xmodem::kLong + 2> frame_{};
  std::size_t have_ = 0;
  std::size_t size_ = 0;  // of the data
  bool crc_ = false;
  std::uint32_t invitations_ = 0;
  std::uint8_t expected_ = 1;
  bool first_ = true;
  bool header_ = false;  // the last frame was the header of YMODEM
  bool ended_ = false;   // the end was told once
  std::uint32_t cans_ = 0;
};

}  // namespace dripfeed::packet
