// Register images against the map in modbus.h, their CRC, and what is damaged or not complete.
#include "protocol/modbus/mailbox.h"

#include <algorithm>
#include <random>
#include <string>

#include <gtest/gtest.h>

namespace dripfeed::modbus {
namespace {

std::span<const std::byte> bytes(const std::string& text) { return std::as_bytes(std::span(text)); }

TEST(Crc32, HasItsPublishedCheckValue) {
  const std::string digits = "123456789";
  EXPECT_EQ(crc32(0, bytes(digits)), 0xCBF43926U);
  EXPECT_EQ(crc32(crc32(0, bytes(digits).first(4)), bytes(digits).subspan(4)), 0xCBF43926U);
  const std::array<std::uint16_t, 2> registers{0x3132, 0x3334};
  EXPECT_EQ(crc32(0, registers), crc32(0, bytes(digits).first(4)));
}

// Oracle: the register map written in modbus.h, register by register.
TEST(Mailbox, HasTheRegistersOfTheMap) {
  const std::string text = "ABC";
  Mailbox mailbox{};
  const Message message{.session = 0x12345678,
                        .command = MailboxCommand::data,
                        .seq = 0x0102,
                        .offset = 0xAABBCCDD,
                        .payload = bytes(text)};
  ASSERT_EQ(encode(message, mailbox), 13U);
  EXPECT_EQ(mailbox[0], 0xDF01);
  EXPECT_EQ(mailbox[1], 0x1234);
  EXPECT_EQ(mailbox[2], 0x5678);
  EXPECT_EQ(mailbox[3], 2);
  EXPECT_EQ(mailbox[4], 0x0102);
  EXPECT_EQ(mailbox[5], 3);
  EXPECT_EQ(mailbox[8], 0xAABB);
  EXPECT_EQ(mailbox[9], 0xCCDD);
  EXPECT_EQ(mailbox[10], 0x4142);
  EXPECT_EQ(mailbox[11], 0x4300);
  EXPECT_EQ(mailbox[12], 0x0102);
  // The CRC, computed here over the bytes it covers.
  const std::string covered(
      "\xDF\x01\x12\x34\x56\x78\x00\x02\x01\x02\x00\x03\xAA\xBB\xCC\xDD"
      "ABC\0",
      20);
  EXPECT_EQ((std::uint32_t{mailbox[6]} << 16U) | mailbox[7], crc32(0, bytes(covered)));
}

TEST(Mailbox, ReadsBackWhatWasWritten) {
  std::mt19937 random(3);
  for (std::size_t length = 0; length <= kMaxPayload; ++length) {
    std::string text;
    for (std::size_t i = 0; i < length; ++i) text += static_cast<char>(random());
    const Message message{.session = static_cast<std::uint32_t>(random()),
                          .command = static_cast<MailboxCommand>(random() % 6),
                          .seq = static_cast<std::uint16_t>(1 + random() % 0xFFFF),
                          .offset = static_cast<std::uint32_t>(random()),
                          .payload = bytes(text)};
    Mailbox mailbox{};
    EXPECT_LE(encode(message, mailbox), kMailboxRegisters);
    Decoded decoded;
    ASSERT_TRUE(decode(mailbox, decoded));
    EXPECT_EQ(decoded.message.session, message.session);
    EXPECT_EQ(decoded.message.command, message.command);
    EXPECT_EQ(decoded.message.seq, message.seq);
    EXPECT_EQ(decoded.message.offset, message.offset);
    EXPECT_TRUE(std::ranges::equal(decoded.message.payload, message.payload));
  }
}

TEST(Mailbox, EveryFlippedBitIsSeen) {
  const std::string text = "G1X1.234\n";
  Mailbox good{};
  const std::size_t used =
      encode({.session = 9, .command = MailboxCommand::data, .seq = 3, .payload = bytes(text)}, good);
  for (std::size_t at = 0; at < used; ++at) {
    for (unsigned bit = 0; bit < 16; ++bit) {
      Mailbox bad = good;
      bad[at] = static_cast<std::uint16_t>(bad[at] ^ (1U << bit));
      Decoded decoded;
      EXPECT_FALSE(decode(bad, decoded)) << at << " " << bit;
    }
  }
}

// A write of which only the first registers arrived over an older message is never taken for whole.
TEST(Mailbox, AWriteThatIsCutShortIsNotThereYet) {
  const std::string old_text(kMaxPayload, 'A');
  const std::string new_text(kMaxPayload, 'B');
  Mailbox old_one{};
  Mailbox new_one{};
  encode({.session = 9, .command = MailboxCommand::data, .seq = 3, .offset = 0, .payload = bytes(old_text)}, old_one);
  const std::size_t used = encode(
      {.session = 9, .command = MailboxCommand::data, .seq = 4, .offset = 220, .payload = bytes(new_text)}, new_one);
  for (std::size_t count = 1; count < used; ++count) {
    Mailbox mixed = old_one;
    std::copy_n(new_one.begin(), count, mixed.begin());
    Decoded decoded;
    const auto result = decode(mixed, decoded);
    EXPECT_EQ(result.has_value(), mixed == old_one) << count;
    if (!result) {
      EXPECT_TRUE(result.error() == MailboxFault::uncommitted || result.error() == MailboxFault::crc) << count;
    }
  }
}

TEST(Mailbox, NamesWhatIsWrong) {
  Decoded decoded;
  Mailbox mailbox{};
  EXPECT_EQ(decode(mailbox, decoded).error(), MailboxFault::blank);
  encode({.session = 1, .command = MailboxCommand::open, .seq = 1}, mailbox);
  Mailbox other = mailbox;
  other[0] = 0x01DF;  // bytes swapped
  EXPECT_EQ(decode(other, decoded).error(), MailboxFault::blank);
  other = mailbox;
  other[5] = kMaxPayload + 1;
  EXPECT_EQ(decode(other, decoded).error(), MailboxFault::length);
  other = mailbox;
  other[10] = 2;
  EXPECT_EQ(decode(other, decoded).error(), MailboxFault::uncommitted);
  other = mailbox;
  other[3] = 2;
  EXPECT_EQ(decode(other, decoded).error(), MailboxFault::crc);
  encode({.session = 1, .command = static_cast<MailboxCommand>(6), .seq = 1}, mailbox);
  EXPECT_EQ(decode(mailbox, decoded).error(), MailboxFault::command);
}

TEST(Status, ReadsBackWhatWasWrittenAndSeesEveryFlippedBit) {
  const Status status{.session = 0xDEADBEEF,
                      .state = ReceiverState::held,
                      .ack_seq = 65535,
                      .nak = Nak::full,
                      .nak_seq = 1,
                      .free_blocks = 3,
                      .consumed = 70'000,
                      .boot_counter = 9,
                      .heartbeat = 10,
                      .reason = 11,
                      .appended = 80'000,
                      .text_crc = 0x01020304};
  StatusImage image{};
  encode(status, image);
  EXPECT_EQ(image[3], 4);
  EXPECT_EQ(image[4], 65535);
  EXPECT_EQ(image[8], 1);
  EXPECT_EQ(image[9], 70'000 - 65'536);
  EXPECT_EQ(image[15], 0x0102);
  const auto read = decode_status(image);
  ASSERT_TRUE(read);
  EXPECT_EQ(*read, status);
  for (std::size_t at = 0; at < image.size(); ++at) {
    for (unsigned bit = 0; bit < 16; ++bit) {
      StatusImage bad = image;
      bad[at] = static_cast<std::uint16_t>(bad[at] ^ (1U << bit));
      const auto result = decode_status(bad);
      ASSERT_FALSE(result);
      EXPECT_EQ(result.error(), at == 0 ? StatusFault::foreign : StatusFault::garbled);
    }
  }
  EXPECT_EQ(decode_status(std::span(image).first(18)).error(), StatusFault::length);
}

TEST(Seq, TheSuccessorSkipsZero) {
  EXPECT_EQ(successor(0), 1);
  EXPECT_EQ(successor(1), 2);
  EXPECT_EQ(successor(65534), 65535);
  EXPECT_EQ(successor(65535), 1);
}

}  // namespace
}  // namespace dripfeed::modbus
