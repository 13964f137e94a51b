// The receiver's rules: what is ignored, what is appended, what is a duplicate, what is refused and by which code.
#include "protocol/modbus/receiver.h"

#include <algorithm>

namespace dripfeed::modbus {

Receiver::Receiver(TextSink& sink, std::uint16_t boot_counter, const ReceiverMemory& memory)
    : sink_(&sink), memory_(memory) {
  status_.boot_counter = boot_counter;
  if (memory_.session == 0 || memory_.aborted) {
    status_.state = ReceiverState::idle;
  } else {
    status_.state = memory_.ack_seq == 0 ? ReceiverState::ready : ReceiverState::running;
  }
  publish();
}

void Receiver::written(std::size_t first, std::span<const std::uint16_t> registers) {
  for (std::size_t i = 0; i < registers.size() && first + i < mailbox_.size(); ++i) mailbox_[first + i] = registers[i];
  look();
  publish();
}

// A write that is not complete (no magic, no commit word, impossible length) is not there yet and is passed over in
// silence; a complete one that is damaged is refused, so that the host does not wait for its time-out.
void Receiver::look() {
  const auto complete = decode(mailbox_, decoded_);
  const Message& message = decoded_.message;
  if (!complete) {
    const bool ours = memory_.session != 0 && message.session == memory_.session;
    if (complete.error() == MailboxFault::crc && ours) reject(Nak::crc, message.seq);
    return;
  }
  if (message.session == 0) return;
  if (message.command == MailboxCommand::open) return open(message);
  if (message.session != memory_.session) return;
  if (message.command == MailboxCommand::data || message.command == MailboxCommand::eof) return take(decoded_);
  control(message);
}

// OPEN is idempotent: the same session again changes nothing, or a repeated write would drop what was appended since.
void Receiver::open(const Message& message) {
  if (message.session == memory_.session) return;
  memory_ = {.session = message.session};
  sink_->clear();
  status_.state = ReceiverState::ready;
  status_.nak = Nak::none;
  status_.nak_seq = 0;
  status_.reason = 0;
  status_.consumed = 0;
}

void Receiver::take(const Decoded& decoded) {
  const Message& message = decoded.message;
  if (message.seq == memory_.ack_seq) {
    if (decoded.crc != memory_.last_crc) reject(Nak::conflict, message.seq);
    return;
  }
  const bool closed = memory_.complete || memory_.aborted || status_.state == ReceiverState::error;
  const bool is_data = message.command == MailboxCommand::data;
  if (message.seq != successor(memory_.ack_seq)) return reject(Nak::sequence, message.seq);
  if (closed) return reject(Nak::closed, message.seq);
  if (is_data == message.payload.empty()) return reject(Nak::length, message.seq);
  if (message.offset != memory_.appended) return reject(Nak::offset, message.seq);
  append(decoded);
}

// Text first, then the acknowledgement; the two are one step for whoever reads the status image or keeps the memory.
void Receiver::append(const Decoded& decoded) {
  const Message& message = decoded.message;
  if (message.command == MailboxCommand::data) {
    if (status_.free_blocks == 0 || !sink_->append(message.payload)) return reject(Nak::full, message.seq);
    --status_.free_blocks;
    memory_.appended += static_cast<std::uint32_t>(message.payload.size());
    memory_.text_crc = crc32(memory_.text_crc, message.payload);
  } else {
    memory_.complete = true;
  }
  memory_.ack_seq = message.seq;
  memory_.last_crc = decoded.crc;
  status_.nak = Nak::none;
  status_.nak_seq = 0;
  if (status_.state == ReceiverState::ready) status_.state = ReceiverState::running;
}

void Receiver::control(const Message& message) {
  const bool open = status_.state == ReceiverState::ready || status_.state == ReceiverState::running;
  if (message.command == MailboxCommand::hold) {
    if (open) status_.state = ReceiverState::held;
  } else if (message.command == MailboxCommand::abort) {
    memory_.aborted = true;
    status_.state = ReceiverState::idle;
  } else if (status_.state == ReceiverState::held) {
    status_.state = memory_.ack_seq == 0 ? ReceiverState::ready : ReceiverState::running;
  }
}

void Receiver::reject(Nak nak, std::uint16_t seq) {
  status_.nak = nak;
  status_.nak_seq = seq;
}

void Receiver::set_free_blocks(std::uint16_t blocks) {
  status_.free_blocks = blocks;
  publish();
}

void Receiver::set_consumed(std::uint32_t bytes) {
  status_.consumed = std::min(bytes, memory_.appended);
  publish();
}

void Receiver::beat() {
  ++status_.heartbeat;
  publish();
}

void Receiver::fail(std::uint16_t reason) {
  status_.state = ReceiverState::error;
  status_.reason = reason;
  publish();
}

void Receiver::publish() {
  status_.session = memory_.session;
  status_.ack_seq = memory_.ack_seq;
  status_.appended = memory_.appended;
  status_.text_crc = memory_.text_crc;
  const bool all_taken = memory_.complete && status_.consumed == memory_.appended;
  if (all_taken && status_.state == ReceiverState::running) status_.state = ReceiverState::done;
  encode(status_, image_);
}

}  // namespace dripfeed::modbus
