// The receiver's rules, message by message.
#include "protocol/modbus/receiver.h"

#include <string>

#include <gtest/gtest.h>

namespace dripfeed::modbus {
namespace {

class Kept final : public TextSink {
 public:
  void clear() noexcept override { text.clear(); }
  bool append(std::span<const std::byte> bytes) noexcept override {
    if (refuses) return false;
    for (const std::byte byte : bytes) text += static_cast<char>(byte);
    return true;
  }
  std::string text;
  bool refuses = false;
};

class ReceiverTest : public testing::Test {
 protected:
  ReceiverTest() { receiver.set_free_blocks(10); }

  void give(MailboxCommand command, std::uint16_t seq, const std::string& text = "", std::uint32_t offset = 0,
            std::uint32_t session = 5) {
    Mailbox mailbox{};
    const std::size_t used = encode({.session = session,
                                     .command = command,
                                     .seq = seq,
                                     .offset = offset,
                                     .payload = std::as_bytes(std::span(text))},
                                    mailbox);
    receiver.written(0, std::span<const std::uint16_t>(mailbox).first(used));
  }
  void open() { give(MailboxCommand::open, 1); }
  void data(std::uint16_t seq, const std::string& text, std::uint32_t offset) {
    give(MailboxCommand::data, seq, text, offset);
  }
  const Status& status() { return receiver.status(); }

  Kept kept;
  Receiver receiver{kept, 3};
};

TEST_F(ReceiverTest, AppendsInOrderOnce) {
  EXPECT_EQ(status().state, ReceiverState::idle);
  EXPECT_EQ(status().boot_counter, 3);
  open();
  EXPECT_EQ(status().state, ReceiverState::ready);
  EXPECT_EQ(status().session, 5U);
  data(1, "AB\n", 0);
  data(1, "AB\n", 0);
  data(2, "CD\n", 3);
  data(2, "CD\n", 3);
  EXPECT_EQ(kept.text, "AB\nCD\n");
  EXPECT_EQ(status().ack_seq, 2);
  EXPECT_EQ(status().appended, 6U);
  EXPECT_EQ(status().text_crc, crc32(0, std::as_bytes(std::span(kept.text))));
  EXPECT_EQ(status().free_blocks, 8);
  EXPECT_EQ(status().nak, Nak::none);
}

TEST_F(ReceiverTest, RefusesByName) {
  open();
  data(2, "CD\n", 0);
  EXPECT_EQ(status().nak, Nak::sequence);
  EXPECT_EQ(status().nak_seq, 2);
  data(1, "", 0);
  EXPECT_EQ(status().nak, Nak::length);
  data(1, "AB\n", 7);
  EXPECT_EQ(status().nak, Nak::offset);
  kept.refuses = true;
  data(1, "AB\n", 0);
  EXPECT_EQ(status().nak, Nak::full);
  kept.refuses = false;
  receiver.set_free_blocks(0);
  data(1, "AB\n", 0);
  EXPECT_EQ(status().nak, Nak::full);
  receiver.set_free_blocks(1);
  EXPECT_EQ(kept.text, "");
  data(1, "AB\n", 0);
  EXPECT_EQ(status().nak, Nak::none);
  data(1, "XY\n", 0);
  EXPECT_EQ(status().nak, Nak::conflict);
  EXPECT_EQ(kept.text, "AB\n");
}

TEST_F(ReceiverTest, ADamagedBlockOfItsSessionIsRefused) {
  open();
  Mailbox mailbox{};
  const std::string text = "AB\n";
  const std::size_t used = encode(
      {.session = 5, .command = MailboxCommand::data, .seq = 1, .payload = std::as_bytes(std::span(text))}, mailbox);
  mailbox[10] ^= 1U;
  receiver.written(0, std::span<const std::uint16_t>(mailbox).first(used));
  EXPECT_EQ(status().nak, Nak::crc);
  EXPECT_EQ(status().nak_seq, 1);
  EXPECT_EQ(kept.text, "");
}

TEST_F(ReceiverTest, OtherSessionsAndUnfinishedWritesAreNotThere) {
  open();
  data(1, "AB\n", 0);
  give(MailboxCommand::data, 2, "CD\n", 3, 6);
  give(MailboxCommand::abort, 1, "", 0, 6);
  give(MailboxCommand::open, 1, "", 0, 0);
  EXPECT_EQ(status().state, ReceiverState::running);
  EXPECT_EQ(status().nak, Nak::none);
  EXPECT_EQ(kept.text, "AB\n");
  const std::array<std::uint16_t, 4> beyond{1, 2, 3, 4};
  receiver.written(kMailboxRegisters - 2, beyond);
  EXPECT_EQ(kept.text, "AB\n");
}

TEST_F(ReceiverTest, OpenAgainChangesNothingButANewSessionClears) {
  open();
  data(1, "AB\n", 0);
  open();
  EXPECT_EQ(kept.text, "AB\n");
  EXPECT_EQ(status().ack_seq, 1);
  give(MailboxCommand::open, 1, "", 0, 6);
  EXPECT_EQ(kept.text, "");
  EXPECT_EQ(status().ack_seq, 0);
  EXPECT_EQ(status().appended, 0U);
}

TEST_F(ReceiverTest, EndsWhenAllIsTaken) {
  open();
  data(1, "AB\n", 0);
  receiver.set_consumed(3);
  EXPECT_EQ(status().state, ReceiverState::running);
  receiver.set_consumed(1);
  give(MailboxCommand::eof, 2, "", 4);
  EXPECT_EQ(status().nak, Nak::offset);
  give(MailboxCommand::eof, 2, "", 3);
  EXPECT_EQ(status().state, ReceiverState::running);
  receiver.set_consumed(100);
  EXPECT_EQ(status().consumed, 3U);
  EXPECT_EQ(status().state, ReceiverState::done);
  data(3, "CD\n", 3);
  EXPECT_EQ(status().nak, Nak::closed);
}

TEST_F(ReceiverTest, HoldsAndAborts) {
  give(MailboxCommand::hold, 1);
  EXPECT_EQ(status().state, ReceiverState::idle);
  open();
  give(MailboxCommand::hold, 1);
  EXPECT_EQ(status().state, ReceiverState::held);
  give(MailboxCommand::idle, 1);
  EXPECT_EQ(status().state, ReceiverState::ready);
  data(1, "AB\n", 0);
  give(MailboxCommand::hold, 1);
  give(MailboxCommand::idle, 1);
  EXPECT_EQ(status().state, ReceiverState::running);
  give(MailboxCommand::abort, 1);
  EXPECT_EQ(status().state, ReceiverState::idle);
  data(2, "CD\n", 3);
  EXPECT_EQ(status().nak, Nak::closed);
  EXPECT_EQ(kept.text, "AB\n");
}

TEST_F(ReceiverTest, ItsOwnErrorClosesTheSession) {
  open();
  receiver.fail(42);
  EXPECT_EQ(status().state, ReceiverState::error);
  EXPECT_EQ(status().reason, 42);
  data(1, "AB\n", 0);
  EXPECT_EQ(status().nak, Nak::closed);
  EXPECT_EQ(decode_status(receiver.status_image())->reason, 42);
}

TEST_F(ReceiverTest, KeepsTheSessionOverARestartWithItsText) {
  open();
  data(1, "AB\n", 0);
  Receiver again(kept, 4, receiver.memory());
  EXPECT_EQ(again.status().session, 5U);
  EXPECT_EQ(again.status().ack_seq, 1);
  EXPECT_EQ(again.status().appended, 3U);
  EXPECT_EQ(again.status().boot_counter, 4);
  EXPECT_EQ(again.status().state, ReceiverState::running);
}

}  // namespace
}  // namespace dripfeed::modbus
