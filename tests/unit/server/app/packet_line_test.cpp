// A line that sends in packets, over a link without a system, in virtual time, with a packet receiver at the other end.
#include "server/app/lines/packet_line.h"

#include <chrono>

#include <gtest/gtest.h>

#include "protocol/packet/packet.h"
#include "server/app/lines/lines.h"
#include "tests/support/fake_links.h"
#include "tests/unit/server/app/feeding.h"

namespace dripfeed::app {
namespace {

using namespace std::chrono_literals;
using namespace test;
using dripfeed::test::FakeLinkThread;

constexpr const char* kXmodemUrl = "pty:/machine/mill?protocol=xmodem&baud=19200";

// A machine that reads XMODEM and may be full.
class ReadingPeer final : public dripfeed::test::Peer, private packet::Sink {
 public:
  explicit ReadingPeer(packet::Protocol protocol) : receiver_(*packet::Receiver::make({.protocol = protocol}, *this)) {}
  void start(feed::Time now) { ASSERT_TRUE(receiver_.start(now)); }
  void receive(std::span<const std::byte> bytes, feed::Time now) override { receiver_.receive(bytes, now); }
  void tick(feed::Time now) override { receiver_.tick(now); }
  std::vector<std::byte> take_out(feed::Time now) override {
    const auto out = receiver_.pending_out();
    std::vector<std::byte> bytes(out.begin(), out.end());
    receiver_.mark_sent(bytes.size(), now);
    return bytes;
  }
  [[nodiscard]] std::optional<feed::Time> deadline() const override {
    const bool got_room = receiver_.state() == packet::ReceiveState::full && space > 0;
    if (got_room || !receiver_.pending_out().empty()) return feed::Time(0);  // at once
    return receiver_.deadline();
  }

  std::size_t space = 1U << 20;
  std::string text;

 private:
  std::size_t room() const noexcept override { return space; }
  void append(std::span<const std::byte> bytes) noexcept override {
    for (const std::byte byte : bytes) text += static_cast<char>(byte);
  }
  packet::Receiver receiver_;
};

class PacketLineTest : public ::testing::Test {
 protected:
  void open(const char* url = kXmodemUrl) {
    auto made = make_line(line_settings(url), links_, nullptr, [this] { ++changes_; });
    ASSERT_TRUE(made) << made.error().text;
    line_ = std::move(*made);
    links_.cable(url).peer = &peer_;
    links_.run_posted();
  }
  void arm(std::uint64_t reserve = feed::kNoReserve) {
    const auto armed = line_->arm(order_of(1, text_, reserve));
    ASSERT_TRUE(armed) << armed.error();
  }
  // The far end's bytes are taken when time passes.
  void pass(feed::Time span) {
    for (feed::Time end = links_.now() + span; links_.now() < end;) links_.advance(10ms);
  }
  [[nodiscard]] LineReport report() const { return line_->report(); }

  FakeLinkThread links_;
  ReadingPeer peer_{packet::Protocol::xmodem};
  int changes_ = 0;
  const std::string text_ = program(20);
  std::unique_ptr<Line> line_;
};

TEST_F(PacketLineTest, SendsAllAndKnowsThatItWasTaken) {
  open();
  EXPECT_TRUE(report().confirms);
  arm();
  EXPECT_EQ(report().state, LineState::armed);
  EXPECT_EQ(report().stall, "waiting for the receiver's start");
  peer_.start(links_.now());
  pass(5s);
  EXPECT_EQ(report().end, JobEnd::done);
  EXPECT_EQ(report().confirmed, text_.size());
  EXPECT_EQ(report().total, text_.size());
  EXPECT_EQ(report().known.from, text_.size());
  ASSERT_GE(peer_.text.size(), text_.size());
  EXPECT_EQ(peer_.text.substr(0, text_.size()), text_);
}

TEST_F(PacketLineTest, AMachineThatIsFullHoldsTheLineByNameAndWithoutLimit) {
  open();
  arm();
  peer_.start(links_.now());
  pass(20ms);
  peer_.space = 0;
  pass(2s);
  EXPECT_EQ(report().state, LineState::held);
  EXPECT_EQ(report().stall, "waiting for ACK");
  pass(1h);
  EXPECT_EQ(report().state, LineState::held);
  EXPECT_GT(report().hold_s, 3500.0);
  peer_.space = 1U << 20;
  pass(10s);
  EXPECT_EQ(report().end, JobEnd::done);
  EXPECT_EQ(report().holds, 1U);
}

TEST_F(PacketLineTest, ALostLinkInsideABlockTearsTheLine) {
  open();
  arm();
  peer_.start(links_.now());
  pass(120ms);
  ASSERT_GT(report().confirmed, 0U);
  ASSERT_NE(text_[report().confirmed - 1], '\n');
  links_.lose(kXmodemUrl);
  EXPECT_EQ(report().state, LineState::torn);
  EXPECT_EQ(report().end, JobEnd::failed);
  EXPECT_EQ(report().cause, "link lost");
  EXPECT_EQ(report().link_error, "the cable is cut");
  EXPECT_GT(report().known.from_line, 1U);
  const std::size_t written = links_.cable(kXmodemUrl).written.size();
  pass(10s);
  EXPECT_EQ(links_.cable(kXmodemUrl).written.size(), written);
  EXPECT_FALSE(line_->arm(order_of(2, text_)));
  ASSERT_TRUE(line_->command(feed::Command::confirm_reset));
  EXPECT_EQ(report().state, LineState::idle);
}

TEST_F(PacketLineTest, NothingGoesBeyondTheLedgersWindow) {
  open();
  arm(200);
  peer_.start(links_.now());
  pass(5s);
  EXPECT_EQ(report().stall, "waiting for ledger");
  EXPECT_EQ(report().handed, 128U);
  line_->extend_reserve(1, 10'000);
  pass(5s);
  EXPECT_EQ(report().end, JobEnd::done);
}

TEST_F(PacketLineTest, AStopWaitsBetweenTwoPacketsAndAStartWithoutAJobIsCounted) {
  open();
  peer_.start(links_.now());
  pass(1s);
  EXPECT_EQ(report().unarmed_starts, 1U);
  EXPECT_EQ(links_.cable(kXmodemUrl).written, "");
  arm();
  pass(9100ms);
  ASSERT_TRUE(line_->command(feed::Command::stop));
  pass(1min);
  EXPECT_EQ(report().state, LineState::held);
  EXPECT_EQ(report().stall, "stopped");
  EXPECT_TRUE(report().stop_wanted);
  ASSERT_TRUE(line_->command(feed::Command::resume));
  pass(10s);
  EXPECT_EQ(report().end, JobEnd::done);
}

// A partner of 3964R that calls when it is called, sends its own telegram, and then reads.
class CallingPeer final : public dripfeed::test::Peer, private packet::Sink {
 public:
  void receive(std::span<const std::byte> bytes, feed::Time now) override {
    for (const std::byte byte : bytes) take(byte, now);
  }
  void tick(feed::Time now) override { receiver_.tick(now); }
  std::vector<std::byte> take_out(feed::Time now) override {
    if (!out_.empty()) return std::exchange(out_, {});
    const auto out = receiver_.pending_out();
    std::vector<std::byte> bytes(out.begin(), out.end());
    receiver_.mark_sent(bytes.size(), now);
    return bytes;
  }
  [[nodiscard]] std::optional<feed::Time> deadline() const override {
    if (!out_.empty() || !receiver_.pending_out().empty()) return feed::Time(0);
    return receiver_.deadline();
  }
  std::string text;

 private:
  void send_text(std::string_view bytes) {
    for (const char c : bytes) out_.push_back(static_cast<std::byte>(c));
  }
  void take(std::byte byte, feed::Time now) {
    if (step_ == 2) return receiver_.receive({&byte, 1}, now);
    if (++step_ == 1) return send_text("\x02");
    // E ^ 1 ^ 2 ^ LF ^ DLE ^ ETX
    send_text("E12\n\x10\x03\x5F");
    receiver_.link(true, now);
    static_cast<void>(receiver_.start(now));
  }
  [[nodiscard]] std::size_t room() const noexcept override { return 1U << 20; }
  void append(std::span<const std::byte> bytes) noexcept override {
    for (const std::byte byte : bytes) text += static_cast<char>(byte);
  }
  int step_ = 0;
  std::vector<std::byte> out_;
  packet::Receiver receiver_ = *packet::Receiver::make({.protocol = packet::Protocol::s3964r}, *this);
};

TEST(PacketLines, ATelegramThatThePartnerSentFirstIsAReception) {
  constexpr const char* kUrl = "pty:/machine/mill?protocol=3964r&baud=19200";
  FakeLinkThread links;
  CallingPeer peer;
  auto made = make_line(line_settings(kUrl), links, nullptr, [] {});
  ASSERT_TRUE(made) << made.error().text;
  links.cable(kUrl).peer = &peer;
  links.run_posted();
  const std::string text = program(20);
  ASSERT_TRUE((*made)->arm(order_of(1, text, feed::kNoReserve)));
  for (int i = 0; i < 500; ++i) links.advance(10ms);
  EXPECT_EQ((*made)->report().end, JobEnd::done);
  EXPECT_EQ((*made)->report().received, 1U);
  EXPECT_EQ(peer.text, text);
  const auto receptions = (*made)->take_receptions();
  ASSERT_EQ(receptions.size(), 1U);
  std::string came;
  for (const std::byte byte : receptions.front().raw) came += static_cast<char>(byte);
  EXPECT_EQ(came, "E12\n");
  EXPECT_TRUE((*made)->take_receptions().empty());
}

TEST(PacketLines, SettingsThatCannotBeKeptAreASentence) {
  FakeLinkThread links;
  const auto made = make_line(line_settings("pty:/x?protocol=xmodem&framing=7E2"), links, nullptr, [] {});
  ASSERT_FALSE(made);
  EXPECT_EQ(made.error().code, ErrorCode::invalid);
  EXPECT_NE(made.error().text.find("8 data bits"), std::string::npos) << made.error().text;
}

}  // namespace
}  // namespace dripfeed::app
