// Siemens 3964 and 3964R: the characters, the form of a block, the sender's and the receiver's rules. The numbered
// blocks are ours: both sides must know of them. Sources: the manuals of CP 340 and CP 440.
//
//   STX ->   <- DLE   text with each DLE doubled, DLE ETX, exclusive or of all since STX (3964R) ->   <- DLE
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "protocol/packet/receive_rules.h"
#include "protocol/packet/send_rules.h"

namespace dripfeed::packet {

namespace s3964 {
inline constexpr std::uint8_t kStx = 0x02;
inline constexpr std::uint8_t kEtx = 0x03;
inline constexpr std::uint8_t kDle = 0x10;
inline constexpr std::uint8_t kNak = 0x15;
inline constexpr std::size_t kNumberBytes = 2;
}  // namespace s3964

class S3964ReceiveRules final : public ReceiveRules {
 public:
  explicit S3964ReceiveRules(const Settings& settings) : settings_(settings) {}

  void begin() override;
  Received hear(std::uint8_t byte, ReceiveState state) override;
  std::optional<Time> silence(ReceiveState state) const override;
  std::uint32_t attempts(ReceiveState) const override { return 0; }  // giving up is the sender's
  std::size_t usual_payload() const override { return settings_.payload; }
  std::span<const std::byte> payload() const override;
  std::size_t invite(std::span<std::byte>) override { return 0; }
  std::size_t begin_frame(std::span<std::byte> out) override;
  std::size_t acknowledge(std::span<std::byte> out) override;
  std::size_t refuse(std::span<std::byte> out) override;
  std::size_t finish(std::span<std::byte>) override { return 0; }
  std::size_t cancel(std::span<std::byte>) override { return 0; }
  std::size_t reply(std::span<std::byte> out) override;
  bool acknowledges_at_once() const override { return true; }

 private:
  enum class Part : std::uint8_t { text, after_dle, check };

  Received hear_frame(std::uint8_t byte);
  Received keep(std::uint8_t byte);
  Received judge();

  Settings settings_;
  std::array<std::byte, kMaxPayload + s3964::kNumberBytes> text_{};
  std::size_t size_ = 0;
  Part part_ = Part::text;
  std::uint8_t xor_ = 0;
  std::uint16_t expected_ = 1;
  bool first_ = true;
  bool refuses_ = false;
};

// Where both call at once, the side without priority receives the other's block first, whole, and then calls again. A
// call that comes when this side has not called is refused: nothing here would use the text.
class S3964SendRules final : public SendRules {
 public:
  explicit S3964SendRules(const Settings& settings);

  void link_up() override { owed_.reset(); }
  void begin(const Announcement& announcement) override;
  Heard hear(std::uint8_t byte, State state) override;
  Heard late(State state) override;
  Patience patience(State state) const override;
  std::size_t frame_size(std::size_t available, bool complete) const override;
  std::size_t call(std::span<std::byte> out) override;
  std::size_t compose(std::span<const std::byte> payload, std::span<std::byte> out) override;
  std::size_t reply(std::span<std::byte> out) override;
  void accepted() override { ++number_; }
  bool starts_itself() const override { return true; }
  std::span<const std::byte> telegram() const override;
  void take_telegram() override { has_telegram_ = false; }

 private:
  Heard hear_call(std::uint8_t byte);
  Heard hear_telegram(std::uint8_t byte);

  Settings settings_;
  std::uint16_t number_ = 1;
  std::int64_t pauses_ = 0;             // in a row, of a receiver that is not ready
  bool not_ready_ = false;              // the last call was answered so
  std::optional<std::uint8_t> owed_{};  // DLE or NAK, to what the partner sent
  S3964ReceiveRules partner_;           // reads its telegram
  bool spoiled_ = false;                // its telegram is; the rest runs out
  bool has_telegram_ = false;
};

}  // namespace dripfeed::packet
