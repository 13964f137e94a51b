// The receiving side of the block mailbox under writes of any kind: whole messages, repeated, out of step, of other
// sessions, torn, damaged in one register. Whatever comes, the text it holds is the beginning of the sender's.
#include <algorithm>
#include <array>
#include <optional>
#include <string>

#include "protocol/modbus/modbus.h"
#include "tests/fuzz/target.h"

using namespace dripfeed;
using modbus::MailboxCommand;

namespace {

class Text final : public modbus::TextSink {
 public:
  void clear() noexcept override { text.clear(); }
  bool append(std::span<const std::byte> bytes) noexcept override {
    if (full) return false;
    for (const std::byte byte : bytes) text.push_back(static_cast<char>(byte));
    return true;
  }
  std::string text;
  bool full = false;
};

std::string whole_text() {
  std::string text = "%\nO1\n";
  for (int i = 0; i < 90; ++i) text += "G1X" + std::to_string(i) + ".\n";
  return text + "M30\n%\n";
}

class Bus {
 public:
  explicit Bus(fuzz::Choices& choices) : choices_(choices), receiver_(std::in_place, sink_, std::uint16_t{1}) {}

  void run() {
    for (int steps = 0; !choices_.done() && steps < 1000; ++steps) {
      step();
      require_status();
    }
  }

 private:
  void step() {
    switch (choices_.below(8)) {
      case 0: receiver_->set_free_blocks(static_cast<std::uint16_t>(choices_.below(5))); break;
      case 1: receiver_->set_consumed(choices_.word()); break;
      case 2: receiver_->beat(); break;
      case 3: sink_.full = choices_.flag(); break;
      case 4:
        if (choices_.below(16) == 15) receiver_->fail(static_cast<std::uint16_t>(choices_.byte()));
        break;
      case 5: restart(); break;
      case 6: write(control_message()); break;
      default: write(data_message()); break;
    }
  }

  // What was kept with the text comes back after a restart.
  void restart() {
    const modbus::ReceiverMemory memory = receiver_->memory();
    const auto boots = static_cast<std::uint16_t>(receiver_->status().boot_counter + 1);
    receiver_.emplace(sink_, boots, memory);
  }

  modbus::Message control_message() {
    constexpr std::array kCommands = {MailboxCommand::open, MailboxCommand::idle, MailboxCommand::abort,
                                      MailboxCommand::hold};
    return {.session = choices_.below(3),
            .command = kCommands[choices_.below(4)],
            .seq = static_cast<std::uint16_t>(1 + choices_.below(3)),
            .offset = choices_.byte()};
  }

  // Mostly the next block; at times an earlier or later one, or one with a wrong offset. Its bytes are those of the
  // text at its offset.
  modbus::Message data_message() {
    const modbus::ReceiverMemory& memory = receiver_->memory();
    const std::uint32_t kind = choices_.below(8);
    const bool end = choices_.below(16) == 15;
    modbus::Message message{.session = memory.session,
                            .command = end ? MailboxCommand::eof : MailboxCommand::data,
                            .seq = modbus::successor(memory.ack_seq),
                            .offset = memory.appended};
    if (kind == 5) message.seq = static_cast<std::uint16_t>(1 + choices_.below(8));
    if (kind == 6) message.offset = choices_.word();
    if (kind == 7) message.session = choices_.below(3);
    const std::size_t from = std::min<std::size_t>(message.offset, text_.size());
    const std::size_t count = end ? 0 : std::min<std::size_t>(choices_.byte(), modbus::kMaxPayload);
    message.payload = std::as_bytes(std::span(text_).subspan(from, std::min(count, text_.size() - from)));
    return message;
  }

  void write(const modbus::Message& message) {
    modbus::Mailbox mailbox{};
    const std::size_t used = modbus::encode(message, mailbox);
    fuzz::require(used <= mailbox.size(), "a message fits into the mailbox");
    require_same(message, mailbox);
    const std::span<const std::uint16_t> registers(mailbox.data(), used);
    switch (choices_.below(6)) {
      case 0: {  // one register is damaged; a CRC sees that
        const std::size_t at = choices_.below(static_cast<std::uint32_t>(used));
        mailbox[at] = static_cast<std::uint16_t>(mailbox[at] ^ (1 + choices_.below(255)));
        return receiver_->written(0, registers);
      }
      case 1: return receiver_->written(0, registers.first(choices_.below(static_cast<std::uint32_t>(used))));
      case 2: {
        const std::size_t first = choices_.below(static_cast<std::uint32_t>(used));
        return receiver_->written(first, registers.subspan(first));
      }
      case 3: receiver_->written(0, registers); break;  // and once more
      default: break;
    }
    receiver_->written(0, registers);
  }

  static void require_same(const modbus::Message& message, const modbus::Mailbox& mailbox) {
    modbus::Decoded decoded;
    const auto taken = modbus::decode(mailbox, decoded);
    fuzz::require(taken.has_value(), "an encoded message decodes");
    const modbus::Message& back = decoded.message;
    fuzz::require(back.session == message.session && back.command == message.command && back.seq == message.seq &&
                      back.offset == message.offset && std::ranges::equal(back.payload, message.payload),
                  "a decoded message is the one that was encoded");
  }

  void require_status() const {
    const modbus::Status& status = receiver_->status();
    fuzz::require(text_.starts_with(sink_.text), "the text held is the beginning of the sender's");
    fuzz::require(status.appended == sink_.text.size(), "every byte appended is told");
    fuzz::require(status.text_crc == modbus::crc32(0, std::as_bytes(std::span(sink_.text))),
                  "the check sum is that of the text held");
    fuzz::require(status.consumed <= status.appended, "no more is taken than was appended");
    const auto read = modbus::decode_status(receiver_->status_image());
    fuzz::require(read && *read == status, "the status image reads back as the status");
  }

  fuzz::Choices& choices_;
  std::string text_ = whole_text();
  Text sink_;
  std::optional<modbus::Receiver> receiver_;
};

}  // namespace

namespace {

// The machine's words and a doorbell's answer from any registers: what is taken reads back as it was.
void read_words(const std::uint8_t* data, std::size_t size) {
  modbus::MachineImage image{modbus::kMachineMagic};
  for (std::size_t i = 0; i < size && i / 2 + 1 < image.size(); ++i)
    image[i / 2 + 1] = static_cast<std::uint16_t>(image[i / 2 + 1] << 8U | data[i]);
  static_cast<void>(modbus::decode_machine(image));
  static_cast<void>(modbus::answered_bell(image));
  const std::uint32_t crc = modbus::crc32(0, std::span<const std::uint16_t>(image).first(12));
  image[12] = static_cast<std::uint16_t>(crc >> 16U);
  image[13] = static_cast<std::uint16_t>(crc & 0xFFFFU);
  const auto words = modbus::decode_machine(image);
  fuzz::require(words.has_value(), "words with a right check sum are taken");
  modbus::MachineImage back{};
  modbus::encode(*words, back);
  if (image[1] <= static_cast<std::uint16_t>(modbus::MachineState::manual))
    fuzz::require(back == image, "words are written as they were read");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::Choices choices(data, size);
  Bus(choices).run();
  read_words(data, size);
  return 0;
}
