// Register images: encoding, decoding, CRC-32.
#include "protocol/modbus/mailbox.h"

#include <algorithm>

namespace dripfeed::modbus {
namespace {

// Places in H and G; the map is in modbus.h.
constexpr std::size_t kSession = 1;
constexpr std::size_t kCommand = 3;
constexpr std::size_t kSeq = 4;
constexpr std::size_t kLength = 5;
constexpr std::size_t kCrc = 6;
constexpr std::size_t kOffset = 8;
constexpr std::size_t kStatusCrc = 17;

constexpr std::array<std::uint32_t, 256> make_crc_table() {
  std::array<std::uint32_t, 256> table{};
  for (std::uint32_t i = 0; i < table.size(); ++i) {
    std::uint32_t value = i;
    for (int bit = 0; bit < 8; ++bit) value = (value >> 1U) ^ ((value & 1U) != 0 ? 0xEDB88320U : 0U);
    table[i] = value;
  }
  return table;
}
constexpr std::array<std::uint32_t, 256> kCrcTable = make_crc_table();

constexpr std::array<std::string_view, 6> kCommandNames{"idle", "open", "data", "eof", "abort", "hold"};
constexpr std::array<std::string_view, 7> kReceiverStateNames{"boot", "idle", "ready", "running",
                                                              "held", "done", "error"};
constexpr std::array<std::string_view, 8> kNakNames{"none",   "crc",      "sequence", "length",
                                                    "offset", "conflict", "full",     "closed"};

template <std::size_t N>
std::string_view look_up(const std::array<std::string_view, N>& names, std::uint16_t index) {
  return index < N ? names[index] : std::string_view("unknown");
}

std::uint16_t high(std::uint32_t value) { return static_cast<std::uint16_t>(value >> 16U); }
std::uint16_t low(std::uint32_t value) { return static_cast<std::uint16_t>(value & 0xFFFFU); }

void put32(std::span<std::uint16_t> registers, std::size_t at, std::uint32_t value) {
  registers[at] = high(value);
  registers[at + 1] = low(value);
}

std::uint32_t get32(std::span<const std::uint16_t> registers, std::size_t at) {
  return (std::uint32_t{registers[at]} << 16U) | registers[at + 1];
}

std::uint32_t crc_step(std::uint32_t state, std::uint8_t byte) {
  return (state >> 8U) ^ kCrcTable[(state ^ byte) & 0xFFU];
}

std::uint32_t message_crc(const Mailbox& registers, std::size_t payload_registers) {
  const std::span<const std::uint16_t> all(registers);
  std::uint32_t crc = crc32(0, all.first(kCrc));
  crc = crc32(crc, all.subspan(kOffset, 2));
  return crc32(crc, all.subspan(kMailboxHeader, payload_registers));
}

}  // namespace

std::uint32_t crc32(std::uint32_t crc, std::span<const std::byte> bytes) {
  std::uint32_t state = ~crc;
  for (const std::byte byte : bytes) state = crc_step(state, std::to_integer<std::uint8_t>(byte));
  return ~state;
}

std::uint32_t crc32(std::uint32_t crc, std::span<const std::uint16_t> registers) {
  std::uint32_t state = ~crc;
  for (const std::uint16_t value : registers) {
    state = crc_step(state, static_cast<std::uint8_t>(value >> 8U));
    state = crc_step(state, static_cast<std::uint8_t>(value & 0xFFU));
  }
  return ~state;
}

std::size_t encode(const Message& message, Mailbox& out) {
  const std::size_t length = std::min(message.payload.size(), kMaxPayload);
  const std::size_t payload_registers = (length + 1) / 2;
  out.fill(0);
  out[0] = kMailboxMagic;
  put32(out, kSession, message.session);
  out[kCommand] = static_cast<std::uint16_t>(message.command);
  out[kSeq] = message.seq;
  out[kLength] = static_cast<std::uint16_t>(length);
  put32(out, kOffset, message.offset);
  for (std::size_t i = 0; i < length; ++i) {
    const auto byte = std::to_integer<std::uint16_t>(message.payload[i]);
    std::uint16_t& target = out[kMailboxHeader + i / 2];
    target = static_cast<std::uint16_t>(i % 2 == 0 ? byte << 8U : target | byte);
  }
  put32(out, kCrc, message_crc(out, payload_registers));
  out[kMailboxHeader + payload_registers] = message.seq;
  return kMailboxHeader + payload_registers + 1;
}

std::expected<void, MailboxFault> decode(const Mailbox& registers, Decoded& out) {
  if (registers[0] != kMailboxMagic || registers[kSeq] == 0) return std::unexpected(MailboxFault::blank);
  const std::size_t length = registers[kLength];
  if (length > kMaxPayload) return std::unexpected(MailboxFault::length);
  const std::size_t payload_registers = (length + 1) / 2;
  if (registers[kMailboxHeader + payload_registers] != registers[kSeq]) {
    return std::unexpected(MailboxFault::uncommitted);
  }
  out.message = {.session = get32(registers, kSession), .seq = registers[kSeq], .offset = get32(registers, kOffset)};
  out.crc = get32(registers, kCrc);
  if (out.crc != message_crc(registers, payload_registers)) return std::unexpected(MailboxFault::crc);
  if (registers[kCommand] >= kCommandNames.size()) return std::unexpected(MailboxFault::command);
  out.message.command = static_cast<MailboxCommand>(registers[kCommand]);
  for (std::size_t i = 0; i < length; ++i) {
    const std::uint16_t value = registers[kMailboxHeader + i / 2];
    out.bytes[i] = static_cast<std::byte>(i % 2 == 0 ? value >> 8U : value & 0xFFU);
  }
  out.message.payload = std::span(out.bytes).first(length);
  return {};
}

void encode(const Status& status, StatusImage& out) {
  out[0] = kMailboxMagic;
  put32(out, 1, status.session);
  out[3] = static_cast<std::uint16_t>(status.state);
  out[4] = status.ack_seq;
  out[5] = static_cast<std::uint16_t>(status.nak);
  out[6] = status.nak_seq;
  out[7] = status.free_blocks;
  put32(out, 8, status.consumed);
  out[10] = status.boot_counter;
  out[11] = status.heartbeat;
  out[12] = status.reason;
  put32(out, 13, status.appended);
  put32(out, 15, status.text_crc);
  put32(out, kStatusCrc, crc32(0, std::span<const std::uint16_t>(out).first(kStatusCrc)));
}

std::expected<Status, StatusFault> decode_status(std::span<const std::uint16_t> registers) {
  if (registers.size() < kStatusRegisters) return std::unexpected(StatusFault::length);
  if (registers[0] != kMailboxMagic) return std::unexpected(StatusFault::foreign);
  const std::uint32_t crc = crc32(0, registers.first(kStatusCrc));
  if (get32(registers, kStatusCrc) != crc) {
    const std::uint32_t low_word_first = std::uint32_t{registers[kStatusCrc + 1]} << 16U | registers[kStatusCrc];
    return std::unexpected(low_word_first == crc ? StatusFault::foreign : StatusFault::garbled);
  }
  if (registers[3] >= kReceiverStateNames.size() || registers[5] >= kNakNames.size()) {
    return std::unexpected(StatusFault::foreign);
  }
  return Status{.session = get32(registers, 1),
                .state = static_cast<ReceiverState>(registers[3]),
                .ack_seq = registers[4],
                .nak = static_cast<Nak>(registers[5]),
                .nak_seq = registers[6],
                .free_blocks = registers[7],
                .consumed = get32(registers, 8),
                .boot_counter = registers[10],
                .heartbeat = registers[11],
                .reason = registers[12],
                .appended = get32(registers, 13),
                .text_crc = get32(registers, 15)};
}

std::string_view name(MailboxCommand command) { return look_up(kCommandNames, static_cast<std::uint16_t>(command)); }
std::string_view name(ReceiverState state) { return look_up(kReceiverStateNames, static_cast<std::uint16_t>(state)); }
std::string_view name(Nak nak) { return look_up(kNakNames, static_cast<std::uint16_t>(nak)); }

}  // namespace dripfeed::modbus
