// A line on which a control punches in packets, over a link without a system, in virtual time, with a packet sender at
// the other end.
#include "server/app/lines/packet_receive_line.h"

#include <chrono>

#include <gtest/gtest.h>

#include "protocol/packet/packet.h"
#include "protocol/receive/transfer.h"
#include "server/app/lines/lines.h"
#include "tests/support/fake_links.h"
#include "tests/unit/server/app/feeding.h"

namespace dripfeed::app {
namespace {

using namespace std::chrono_literals;
using namespace test;
using dripfeed::test::FakeLinkThread;

// A control that punches one text.
class PunchingPeer final : public dripfeed::test::Peer {
 public:
  PunchingPeer(packet::Protocol protocol, const std::string& text)
      : sender_(*packet::Sender::make({.protocol = protocol, .yields_on_collision = false})),
        text_(text),
        source_(text_) {}
  void punch(feed::Time now) {
    sender_.link(true, now);
    ASSERT_TRUE(sender_.arm({.facts = facts_of(text_), .source = &source_, .reserve = feed::kNoReserve}, now, "O42"));
  }
  void receive(std::span<const std::byte> bytes, feed::Time now) override { sender_.receive(bytes, now); }
  void tick(feed::Time now) override { sender_.tick(now); }
  std::vector<std::byte> take_out(feed::Time now) override {
    const auto out = sender_.pending_out();
    std::vector<std::byte> bytes(out.begin(), out.end());
    sender_.mark_sent(bytes.size(), now);
    return bytes;
  }
  [[nodiscard]] std::optional<feed::Time> deadline() const override {
    if (!sender_.pending_out().empty()) return feed::Time(0);  // at once
    return sender_.deadline();
  }
  [[nodiscard]] packet::State state() const { return sender_.state(); }
  [[nodiscard]] packet::Cause cause() const { return sender_.end_cause(); }

 private:
  packet::Sender sender_;
  std::string text_;
  tape_code::SpanSource source_;
};

std::string url_of(packet::Protocol protocol) {
  return "pty:/machine/mill?protocol=" + std::string(packet::name(protocol)) + "&baud=19200";
}

struct Rig {
  explicit Rig(packet::Protocol protocol) : url(url_of(protocol)), peer(protocol, text) {
    auto made = make_receiving_line(line_settings(url.c_str()), links, nullptr, [] {});
    EXPECT_TRUE(made) << made.error().text;
    line = std::move(*made);
    links.cable(url).peer = &peer;
    links.run_posted();
  }
  void pass(feed::Time span) {
    for (const feed::Time end = links.now() + span; links.now() < end;) links.advance(10ms);
  }
  // What was asked before the control punches is asked again, some seconds later.
  void pass_until_inside() {
    for (int i = 0; i < 2000 && line->report().state != LineState::receiving; ++i) links.advance(10ms);
    pass(300ms);
  }
  std::string url;
  std::string text = program(200);
  FakeLinkThread links;
  PunchingPeer peer;
  std::unique_ptr<Line> line;
};

TEST(PacketReceiveLine, TakesOneTextOfEachProtocolAsItWasPunched) {
  for (std::size_t i = 0; i < packet::kProtocols; ++i) {
    const auto protocol = static_cast<packet::Protocol>(i);
    Rig rig(protocol);
    EXPECT_EQ(rig.line->report().state, LineState::idle) << name(protocol);
    EXPECT_EQ(rig.line->report().stall, "waiting for the sender");
    rig.peer.punch(rig.links.now());
    rig.pass(60s);
    EXPECT_EQ(rig.peer.state(), packet::State::done) << name(protocol);
    auto receptions = rig.line->take_receptions();
    ASSERT_EQ(receptions.size(), 1U) << name(protocol);
    const auto transfer = receive::judge(receptions[0].raw, receptions[0].ending, receptions[0].settings);
    EXPECT_EQ(transfer.fault, receive::Fault::none) << name(protocol);
    EXPECT_EQ(transfer.text, rig.text) << name(protocol);
    EXPECT_EQ(rig.line->report().state, LineState::idle) << name(protocol);
  }
}

TEST(PacketReceiveLine, ALostLinkIsABrokenReceptionByName) {
  Rig rig(packet::Protocol::xmodem);
  rig.peer.punch(rig.links.now());
  rig.pass_until_inside();
  EXPECT_EQ(rig.line->report().state, LineState::receiving);
  rig.links.lose(rig.url);
  const auto receptions = rig.line->take_receptions();
  ASSERT_EQ(receptions.size(), 1U);
  EXPECT_EQ(receptions[0].ending.by, receive::EndedBy::link_lost);
  EXPECT_EQ(rig.line->report().cause, "link lost");
}

TEST(PacketReceiveLine, AnAbortInformsTheSenderAndKeepsWhatCame) {
  Rig rig(packet::Protocol::ymodem);
  rig.peer.punch(rig.links.now());
  rig.pass_until_inside();
  rig.pass(1500ms);
  EXPECT_FALSE(rig.line->command(feed::Command::cancel));
  EXPECT_FALSE(rig.line->arm(order_of(1, rig.text)));
  ASSERT_TRUE(rig.line->command(feed::Command::abort));
  rig.pass(1s);
  EXPECT_EQ(rig.peer.cause(), packet::Cause::peer_cancelled);
  EXPECT_EQ(rig.line->report().cause, "person");
  const auto receptions = rig.line->take_receptions();
  ASSERT_EQ(receptions.size(), 1U);
  EXPECT_NE(receive::judge(receptions[0].raw, receptions[0].ending, receptions[0].settings).fault,
            receive::Fault::none);
}

TEST(PacketReceiveLine, ASenderThatTakesLeaveBeforeItsTextIsWaitedForAgain) {
  Rig rig(packet::Protocol::xmodem_crc);
  rig.links.receive(rig.url, "\x18\x18");
  EXPECT_TRUE(rig.line->take_receptions().empty());
  rig.pass(2s);
  rig.peer.punch(rig.links.now());
  rig.pass(30s);
  EXPECT_EQ(rig.line->take_receptions().size(), 1U);
}

TEST(PacketReceiveLine, SettingsThatCannotBeKeptAreASentence) {
  FakeLinkThread links;
  const auto line = make_packet_receive_line(line_settings("pty:/m?protocol=xmodem&framing=7E2"), links, [] {});
  ASSERT_FALSE(line);
  EXPECT_NE(line.error().find("8 data bits"), std::string::npos);
}

}  // namespace
}  // namespace dripfeed::app
