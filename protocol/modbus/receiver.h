// The receiving side of the block mailbox: what a PLC (or a simulated one) does with the registers. Each block is
// appended exactly once, in order, or not at all; the status image says what was appended.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "protocol/modbus/mailbox.h"

namespace dripfeed::modbus {

// Where the text goes. append() takes all of the bytes or none.
class TextSink {
 public:
  virtual ~TextSink() = default;
  virtual void clear() noexcept = 0;  // a new session begins
  virtual bool append(std::span<const std::byte> bytes) noexcept = 0;
};

// What must be kept together with the text over a restart, or not at all.
struct ReceiverMemory {
  std::uint32_t session = 0;
  std::uint16_t ack_seq = 0;
  std::uint32_t last_crc = 0;  // CRC of the last message appended, to know it again
  std::uint32_t appended = 0;
  std::uint32_t text_crc = 0;
  bool complete = false;  // EOF was taken
  bool aborted = false;
};

class Receiver {
 public:
  // boot_counter: one more than at the last start. memory: what was kept with the text; blank if nothing was.
  Receiver(TextSink& sink, std::uint16_t boot_counter, const ReceiverMemory& memory = {});

  // A write request put these registers at `first` of the mailbox (any part of it, torn writes included). Looks at the
  // mailbox afterwards. Registers beyond the mailbox are ignored.
  void written(std::size_t first, std::span<const std::uint16_t> registers);
  // The status registers as they stand.
  const StatusImage& status_image() const { return image_; }
  const Status& status() const { return status_; }
  const ReceiverMemory& memory() const { return memory_; }

  // Set by the application: credit, progress, life sign, its own error (stops the session) and the end of the run.
  void set_free_blocks(std::uint16_t blocks);
  void set_consumed(std::uint32_t bytes);
  void beat();
  void fail(std::uint16_t reason);

 private:
  void look();
  void open(const Message& message);
  void take(const Decoded& decoded);
  void append(const Decoded& decoded);
  void control(const Message& message);
  void reject(Nak nak, std::uint16_t seq);
  void publish();

  TextSink* sink_;
  ReceiverMemory memory_;
  Mailbox mailbox_{};
  Decoded decoded_;
  Status status_;
  StatusImage image_{};
};

}  // namespace dripfeed::modbus
