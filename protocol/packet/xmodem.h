// XMODEM with sum, with CRC, with blocks of 1024, and YMODEM: the characters, the form of a packet, the sender's and
// the receiver's rules. Sources: W. Christensen's protocol and C. Forsberg's "XMODEM/YMODEM protocol reference" (1988).
//
//   SOH or STX | number | 255 - number | 128 or 1024 bytes | sum, or CRC high and low
//
// YMODEM, one file in the batch; block 0 holds: name NUL length SP time SP mode, filled up with NUL:
//
//   <- C   block 0 ->   <- ACK C   blocks 1, 2, ... as of XMODEM, EOT ->   <- ACK C   block 0 without a name ->   <-
//   ACK
//
// Not spoken: YMODEM-g, which acknowledges nothing.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
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
inline constexpr std::size_t kMaxName = 64;
// One CAN is noise, two are a word; this many leave no doubt.
inline constexpr std::size_t kCansSent = 8;
}  // namespace xmodem

class XmodemSendRules final : public SendRules {
 public:
  explicit XmodemSendRules(const Settings& settings) : settings_(settings) {}

  void begin(const Announcement& announcement) override;
  Heard hear(std::uint8_t byte, State state) override;
  Heard late(State state) override;
  Patience patience(State state) const override;
  std::size_t frame_size(std::size_t available, bool complete) const override;
  std::size_t call(std::span<std::byte> out) override;
  std::size_t compose(std::span<const std::byte> payload, std::span<std::byte> out) override;
  std::size_t close(std::span<std::byte> out) override;
  std::size_t part(std::span<std::byte> out) override;
  std::size_t abort(std::span<std::byte> out) override { return part(out); }
  void sent() override { answerable_ = true; }
  void accepted() override;

 private:
  // Where a batch of YMODEM is. XMODEM has its blocks only.
  enum class Part : std::uint8_t {
    header,
    header_taken,  // the receiver is to ask for the first block
    blocks,        // the end of the file included
    file_taken,    // the receiver is to ask for another file
    batch_end,     // a header without a name
  };

  Heard hear_header(std::uint8_t byte);
  Heard hear_end(std::uint8_t byte);
  std::size_t header(std::span<std::byte> out, bool of_file) const;
  std::size_t seal(std::uint8_t number, std::size_t size, std::span<std::byte> out) const;
  Heard hear_start(std::uint8_t byte);
  Heard hear_answer(std::uint8_t byte);

  Settings settings_;
  bool crc_ = false;
  std::uint8_t number_ = 1;
  bool first_ = true;           // no block was accepted yet
  std::uint32_t cans_ = 0;      // in a row
  std::uint32_t restarts_ = 0;  // C where none is due
  Part part_ = Part::blocks;
  bool answerable_ = false;      // what is in transit has left
  std::uint32_t farewells_ = 0;  // how often the batch's end was sent
  std::array<char, xmodem::kMaxName> name_{};
  std::size_t name_size_ = 0;
  std::uint64_t bytes_ = 0;
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
    return settings_.protocol == Protocol::xmodem_1k || is_batch() ? xmodem::kLong : xmodem::kShort;
  }
  std::span<const std::byte> payload() const override;
  std::size_t acknowledge(std::span<std::byte> out) override;
  std::size_t refuse(std::span<std::byte> out) override;
  bool is_whole() const override { return file_over_; }
  std::size_t cancel(std::span<std::byte> out) override;

 private:
  bool is_batch() const { return settings_.protocol == Protocol::ymodem; }
  Received hear_end();
  Received judge();
  Received judge_header();

  Settings settings_;
  std::array<std::byte, xmodem::kHead + xmodem::kLong + 2> frame_{};
  std::size_t have_ = 0;
  std::size_t size_ = 0;  // of the data
  bool crc_ = false;
  std::uint32_t invitations_ = 0;
  std::uint8_t expected_ = 1;
  bool first_ = true;
  bool ended_ = false;                   // the end was sent once
  bool asks_again_ = false;              // after its acknowledgement the sender waits to be asked
  bool headed_ = false;                  // YMODEM: the header came
  bool file_over_ = false;               // YMODEM: the end of the file was acknowledged, the end of the batch is due
  std::size_t kept_ = 0;                 // of the block: what the length of the header leaves
  std::optional<std::uint64_t> left_{};  // of that length
  std::uint32_t cans_ = 0;
};

}  // namespace dripfeed::packet
