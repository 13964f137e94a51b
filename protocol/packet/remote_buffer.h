// FANUC remote buffer, protocol A: the messages, the host's rules, and the buffer's own for simulators and tests. The
// buffer talks, the host answers; one message at a time. Source: B-63322EN, remote buffer.
//
// Not spoken: parameters in SET (the buffer keeps those of the control, and so never enters expansion A, whose packets
// are not spoken either), CLB, RDI and SDO. With ISO code the sum is that of the characters with their parity, which
// the manual leaves open.
//
//   sum of all that follows, two hex digits | three letters | data | ETX or CR
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "protocol/packet/receive_rules.h"
#include "protocol/packet/send_rules.h"

namespace dripfeed::packet {

namespace remote_buffer {

inline constexpr std::uint8_t kEtx = 0x03;
inline constexpr std::uint8_t kCr = 0x0D;
inline constexpr std::size_t kHead = 5;  // sum and letters

enum class Command : std::uint8_t {
  syn,
  rdy,
  rst,
  ars,
  alm,
  aal,
  sat,
  set,
  gtd,
  dat,
  wat,
  eod,
  clb,
  rdi,
  sdi,
  sdo,
  rty
};

// How messages look on this line. With ISO code the letters carry their parity, and the sum is that of the coded bytes.
struct Form {
  std::uint8_t end = kEtx;
  tape_code::EighthBit eighth_bit = tape_code::EighthBit::data;
};
Form form_of(const Settings& settings);

// Writes a message; its length.
std::size_t compose(const Form& form, Command command, std::span<const std::byte> data, std::span<std::byte> out);

struct Message {
  Command command = Command::syn;
  std::span<const std::byte> data{};
};

// Gathers bytes up to the end of a message.
class Reader {
 public:
  enum class Found : std::uint8_t { nothing, message, damaged };
  explicit Reader(const Form& form) : form_(form) {}
  Found put(std::uint8_t byte);
  // The message that was found last. Valid until the next byte.
  const Message& message() const { return message_; }
  bool is_inside() const { return size_ > 0; }
  void forget() { size_ = 0; }

 private:
  Form form_;
  std::array<std::byte, kHead + kMaxPayload + 1> bytes_{};
  std::size_t size_ = 0;
  bool overlong_ = false;
  Message message_;
};

}  // namespace remote_buffer

class RemoteBufferSendRules final : public SendRules {
 public:
  explicit RemoteBufferSendRules(const Settings& settings);

  void link_up() override;
  void begin(const Announcement&) override {}
  Heard hear(std::uint8_t byte, State state) override;
  Heard late(State) override { return {Signal::broken, Cause::no_answer}; }
  Patience patience(State state) const override;
  std::size_t frame_size(std::size_t available, bool complete) const override;
  std::size_t compose(std::span<const std::byte> payload, std::span<std::byte> out) override;
  std::size_t close(std::span<std::byte> out) override;
  std::size_t part(std::span<std::byte> out) override;
  std::size_t reply(std::span<std::byte> out) override;
  std::size_t nothing_now(std::span<std::byte> out) override;
  void accepted() override {}
  bool is_pulled() const override { return true; }

 private:
  Heard hear_message(State state);
  Heard hear_repeat(State state);
  std::size_t say(remote_buffer::Command command, std::span<std::byte> out);

  Settings settings_;
  remote_buffer::Form form_;
  remote_buffer::Reader reader_;
  std::optional<remote_buffer::Command> reply_{};
  remote_buffer::Command last_ =
      remote_buffer::Command::syn;  // the last message, where it was none of the sender's frames
  bool last_is_frame_ = false;
};

class RemoteBufferReceiveRules final : public ReceiveRules {
 public:
  explicit RemoteBufferReceiveRules(const Settings& settings);

  void begin() override;
  Received hear(std::uint8_t byte, ReceiveState state) override;
  std::optional<Time> silence(ReceiveState state) const override;
  std::uint32_t attempts(ReceiveState state) const override;
  std::size_t usual_payload() const override { return settings_.payload; }
  std::span<const std::byte> payload() const override { return reader_.message().data; }
  std::size_t invite(std::span<std::byte> out) override;
  std::size_t acknowledge(std::span<std::byte> out) override;
  std::size_t refuse(std::span<std::byte> out) override;
  std::size_t finish(std::span<std::byte> out) override;
  std::size_t cancel(std::span<std::byte> out) override;

 private:
  // What is due when nothing comes: repeating the last message, asking again, or nothing more.
  enum class Due : std::uint8_t { answer, ask, ask_now, last_again, repeat };

  Received hear_message();
  std::size_t say(remote_buffer::Command command, std::span<std::byte> out);

  Settings settings_;
  remote_buffer::Form form_;
  remote_buffer::Reader reader_;
  remote_buffer::Command last_ = remote_buffer::Command::syn;
  bool ready_ = false;        // the host said RDY
  bool awaits_text_ = false;  // GTD is not answered yet
  Due due_ = Due::answer;
};

}  // namespace dripfeed::packet
