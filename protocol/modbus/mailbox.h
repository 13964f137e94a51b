// The two register images of the block mailbox, their encoding and decoding, and the CRC that ties them together.
// Who writes which and when is sender's and receiver's work; getting registers over a wire is the driver's.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <expected>
#include <span>
#include <string_view>

namespace dripfeed::modbus {

// H, the mailbox: host to receiver, one FC16 or FC23 write (FC23 takes 121 registers at most).
inline constexpr std::size_t kMailboxHeader = 10;
inline constexpr std::size_t kMailboxRegisters = 121;
inline constexpr std::size_t kMaxPayload = (kMailboxRegisters - kMailboxHeader - 1) * 2;  // bytes
using Mailbox = std::array<std::uint16_t, kMailboxRegisters>;

// G, the status: receiver to host, one FC3 or FC23 read.
inline constexpr std::size_t kStatusRegisters = 19;
using StatusImage = std::array<std::uint16_t, kStatusRegisters>;

// First register of both images: "DF" and the version of the map; also proves the byte order.
inline constexpr std::uint16_t kMailboxMagic = 0xDF01;

enum class MailboxCommand : std::uint16_t { idle = 0, open = 1, data = 2, eof = 3, abort = 4, hold = 5 };
enum class ReceiverState : std::uint16_t { boot = 0, idle = 1, ready = 2, running = 3, held = 4, done = 5, error = 6 };
enum class Nak : std::uint16_t {
  none = 0,
  crc = 1,       // magic, session and commit word fit, the CRC does not: write it again
  sequence = 2,  // neither the next block nor the last one
  length = 3,    // more bytes than a mailbox holds, or none in a data block
  offset = 4,    // the block's offset is not the number of bytes appended
  conflict = 5,  // the last block's number again, with other contents
  full = 6,      // no free block, or the text could not be stored: write it again later
  closed = 7,    // the session is over (EOF taken, or aborted)
};
std::string_view name(MailboxCommand command);
std::string_view name(ReceiverState state);
std::string_view name(Nak nak);

// A message in the mailbox. payload: at most kMaxPayload bytes, data blocks only.
struct Message {
  std::uint32_t session = 0;
  MailboxCommand command = MailboxCommand::idle;
  std::uint16_t seq = 1;     // 1..65535; data and eof count on, the others repeat the last one (1 before the first)
  std::uint32_t offset = 0;  // text bytes before the payload; for eof the length of the text
  std::span<const std::byte> payload{};
};

// Encodes into the mailbox; returns how many registers are to be written, the commit word being the last of them.
std::size_t encode(const Message& message, Mailbox& out);

// A message as taken from the registers, with its payload copied.
struct Decoded {
  Message message;  // payload points into bytes
  std::uint32_t crc = 0;
  std::array<std::byte, kMaxPayload> bytes{};
  Decoded() = default;
  Decoded(const Decoded&) = delete;
  Decoded& operator=(const Decoded&) = delete;
};

enum class MailboxFault : std::uint8_t {
  blank,        // magic or version is not ours, or the sequence number is 0
  length,       // the byte length cannot be
  uncommitted,  // the commit word is not the sequence number: the write is not complete
  crc,          // complete, but damaged
  command,      // an unknown command with a right CRC
};

// Reads a message from the whole mailbox. Only the registers that its length implies are looked at.
std::expected<void, MailboxFault> decode(const Mailbox& registers, Decoded& out);

struct Status {
  std::uint32_t session = 0;
  ReceiverState state = ReceiverState::boot;
  std::uint16_t ack_seq = 0;  // the last block appended; 0 before the first
  Nak nak = Nak::none;
  std::uint16_t nak_seq = 0;
  std::uint16_t free_blocks = 0;  // credit
  std::uint32_t consumed = 0;     // bytes that the interpreter took
  std::uint16_t boot_counter = 0;
  std::uint16_t heartbeat = 0;
  std::uint16_t reason = 0;    // the receiver's own word on state error
  std::uint32_t appended = 0;  // bytes of text appended in this session
  std::uint32_t text_crc = 0;  // CRC-32 of these bytes
  friend bool operator==(const Status&, const Status&) = default;
};

void encode(const Status& status, StatusImage& out);

enum class StatusFault : std::uint8_t {
  length,   // fewer registers than an image has
  foreign,  // another magic or version, swapped bytes, or 32-bit values with the low word first
  garbled,  // the check sum does not fit: read while being written; read again
};
std::expected<Status, StatusFault> decode_status(std::span<const std::uint16_t> registers);

// CRC-32 (IEEE 802.3, reflected), continued from crc: crc32(0, "123456789") = CBF43926.
std::uint32_t crc32(std::uint32_t crc, std::span<const std::byte> bytes);
// The same over registers, high byte first.
std::uint32_t crc32(std::uint32_t crc, std::span<const std::uint16_t> registers);

// The number after seq: 65535 is followed by 1.
constexpr std::uint16_t successor(std::uint16_t seq) {
  return seq == 0xFFFF ? std::uint16_t{1} : static_cast<std::uint16_t>(seq + 1);
}

}  // namespace dripfeed::modbus
