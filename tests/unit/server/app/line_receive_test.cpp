// A line that receives while nothing is fed, and answers: what a control punches is taken whole, what comes during a
// feed stops the feed as ever, and an answer goes out only when the control asks.
#include <chrono>

#include <gtest/gtest.h>

#include "protocol/receive/transfer.h"
#include "protocol/tape_code/parity.h"
#include "server/app/lines/feed_line.h"
#include "tests/support/fake_links.h"
#include "tests/unit/server/app/feeding.h"

namespace dripfeed::app {
namespace {

using namespace std::chrono_literals;
using namespace test;
using dripfeed::test::FakeLinkThread;

std::string on_wire(std::string_view text) {
  std::string wire;
  for (const char c : text) {
    wire += static_cast<char>(tape_code::with_parity(static_cast<std::uint8_t>(c), tape_code::EighthBit::even));
  }
  return wire;
}

class LineReceiveTest : public ::testing::Test {
 protected:
  void open(const machine::LineSettings& settings = line_settings()) {
    auto made = make_feed_line(settings, links_, [this] { ++changes_; });
    ASSERT_TRUE(made) << made.error();
    line_ = std::move(*made);
    links_.run_posted();
  }
  void answer(const std::string& text, feed::Time expires = 600s) {
    const auto armed =
        line_->answer({.facts = facts_of(text), .source = std::make_shared<OwnedText>(text), .expires_after = expires});
    ASSERT_TRUE(armed) << armed.error();
  }
  std::vector<receive::Transfer> received() {
    std::vector<receive::Transfer> all;
    for (const Reception& one : line_->take_receptions()) {
      all.push_back(receive::judge(one.raw, one.ending, one.settings));
    }
    return all;
  }
  [[nodiscard]] std::string written() { return text_of(links_.cable(kUrl).written); }
  [[nodiscard]] LineReport report() const { return line_->report(); }

  FakeLinkThread links_;
  int changes_ = 0;
  const std::string text_ = program(20);
  std::unique_ptr<Line> line_;
};

TEST_F(LineReceiveTest, TakesAPunchOfAnIdleLine) {
  open();
  links_.receive(kUrl, "\x12");
  EXPECT_EQ(report().state, LineState::receiving);
  links_.receive(kUrl, on_wire("%\nO7\nM30\n%\n"));
  EXPECT_EQ(report().received, 0U);
  links_.receive(kUrl, "\x14");
  EXPECT_EQ(report().state, LineState::idle);
  EXPECT_EQ(report().received, 1U);
  const auto got = received();
  ASSERT_EQ(got.size(), 1U);
  EXPECT_EQ(got[0].fault, receive::Fault::none);
  EXPECT_EQ(got[0].text, "%\nO7\nM30\n%\n");
  EXPECT_TRUE(received().empty());
  EXPECT_EQ(written(), "");
}

TEST_F(LineReceiveTest, ATornPunchEndsByQuietTimeAndALostLink) {
  open();
  links_.receive(kUrl, on_wire("%\nO7\nG0"));
  links_.advance(10s);
  links_.receive(kUrl, on_wire("%\nO8\n"));
  links_.lose(kUrl);
  const auto got = received();
  ASSERT_EQ(got.size(), 2U);
  EXPECT_EQ(got[0].fault, receive::Fault::no_end);
  EXPECT_EQ(got[1].fault, receive::Fault::link_lost);
}

TEST_F(LineReceiveTest, NothingIsArmedWhileTheControlPunches) {
  open();
  links_.receive(kUrl, on_wire("%\nO7\n"));
  EXPECT_FALSE(line_->arm(order_of(1, text_)));
  EXPECT_EQ(report().state, LineState::receiving);
  links_.advance(10s);
  EXPECT_TRUE(line_->arm(order_of(1, text_)));
}

TEST_F(LineReceiveTest, APunchDisarmsAJobAndIsTakenWhole) {
  open();
  ASSERT_TRUE(line_->arm(order_of(1, text_)));
  links_.receive(kUrl, on_wire("%\nO7\nM30\n%\n"));
  links_.advance(1s);
  EXPECT_EQ(report().end, JobEnd::disarmed);
  const auto got = received();
  ASSERT_EQ(got.size(), 1U);
  EXPECT_EQ(got[0].text, "%\nO7\nM30\n%\n");
  EXPECT_EQ(written(), "");
}

TEST_F(LineReceiveTest, WhatComesDuringAFeedStopsItAsEver) {
  open();
  ASSERT_TRUE(line_->arm(order_of(1, text_)));
  links_.receive(kUrl, kDc1);
  while (written().size() < 20 || written().back() == '\n') links_.advance(1ms);
  links_.receive(kUrl, on_wire("%"));
  EXPECT_EQ(report().state, LineState::torn);
  const std::string before = written();
  links_.receive(kUrl, on_wire("\nO7\nM30\n%\n"));
  links_.receive(kUrl, kDc1);
  links_.advance(30s);
  EXPECT_EQ(written(), before);
}

TEST_F(LineReceiveTest, Dc1DuringAPunchStartsNothing) {
  open();
  links_.receive(kUrl, on_wire("%\nO7\n"));
  links_.receive(kUrl, kDc1);
  EXPECT_EQ(report().unarmed_starts, 1U);
  const auto got = received();
  ASSERT_EQ(got.size(), 1U);
  EXPECT_EQ(got[0].fault, receive::Fault::interrupted);
  EXPECT_EQ(written(), "");
}

TEST_F(LineReceiveTest, AnAnswerWaitsForDc1AndLeavesTheLastJobAsItWas) {
  open();
  ASSERT_TRUE(line_->arm(order_of(4, text_)));
  links_.receive(kUrl, kDc1);
  links_.advance(1500us * text_.size());
  links_.receive(kUrl, kDc3);
  ASSERT_EQ(report().end, JobEnd::done);
  const LineReport before = report();
  const std::string answer_text = "%\nO9999(NOT FOUND 12)\nM30\n%\n";
  answer(answer_text);
  EXPECT_EQ(report().state, LineState::answering);
  links_.advance(60s);
  EXPECT_EQ(written(), text_);
  links_.receive(kUrl, kDc1);
  links_.advance(5s);
  EXPECT_EQ(written(), text_) << "nothing leaves before the books have the answer";
  EXPECT_EQ(report().answer.stage, AnswerStage::sending);
  EXPECT_EQ(report().answer.total, answer_text.size());
  line_->answer_booked(7);
  links_.advance(5s);
  EXPECT_EQ(written(), text_) << "another one was booked";
  line_->answer_booked(1);
  links_.advance(5s);
  EXPECT_EQ(written(), text_ + answer_text);
  EXPECT_EQ(report().answer.stage, AnswerStage::whole);
  EXPECT_EQ(report().state, LineState::idle);
  EXPECT_EQ(report().end, JobEnd::done);
  EXPECT_EQ(report().job, 4U);
  EXPECT_EQ(report().handed, before.handed);
  EXPECT_EQ(report().answer.serial, 1U);
}

TEST_F(LineReceiveTest, AnAnswerExpires) {
  open();
  answer("%\nO9999(DIR)\nM30\n%\n", 600s);
  links_.advance(601s);
  EXPECT_EQ(report().state, LineState::idle);
  links_.receive(kUrl, kDc1);
  links_.advance(10s);
  EXPECT_EQ(written(), "");
  EXPECT_EQ(report().unarmed_starts, 1U);
}

TEST_F(LineReceiveTest, ANewAnswerTakesThePlaceOfOneThatWaitsAndAPersonsJobOfBoth) {
  open();
  answer("%\nO9999(OLD)\nM30\n%\n");
  answer("%\nO9999(NEW)\nM30\n%\n");
  links_.receive(kUrl, kDc1);
  line_->answer_booked(2);
  links_.advance(100ms);
  links_.advance(10s);
  EXPECT_EQ(written(), "%\nO9999(NEW)\nM30\n%\n");
  answer("%\nO9999(LAST)\nM30\n%\n");
  ASSERT_TRUE(line_->arm(order_of(2, text_)));
  links_.receive(kUrl, kDc1);
  links_.advance(1500us * text_.size());
  EXPECT_EQ(written(), "%\nO9999(NEW)\nM30\n%\n" + text_);
}

TEST_F(LineReceiveTest, AnAnswerDoesNotTakeTheLineFromAJob) {
  open();
  ASSERT_TRUE(line_->arm(order_of(1, text_)));
  EXPECT_FALSE(line_->answer({.facts = facts_of(text_), .source = std::make_shared<OwnedText>(text_)}));
  EXPECT_EQ(report().state, LineState::armed);
}

TEST_F(LineReceiveTest, HoldsTheControlWhileNoOneTakesWhatCame) {
  machine::LineSettings settings = line_settings();
  settings.receive.hold = receive::Hold::dc3;
  open(settings);
  for (int i = 0; i < 8; ++i) links_.receive(kUrl, "\x12" + on_wire("%\nO7\n%\n") + "\x14");
  EXPECT_EQ(links_.cable(kUrl).written, "");
  links_.receive(kUrl, "\x12" + on_wire("%\nO8\n"));
  EXPECT_EQ(links_.cable(kUrl).written, "\x93");
  links_.advance(60s);
  EXPECT_EQ(report().state, LineState::receiving) << "quiet time stands still";
  EXPECT_EQ(report().stall, "holding the control: what it sent before is not taken yet");
  EXPECT_EQ(received().size(), 8U);
  links_.run_posted();
  EXPECT_EQ(links_.cable(kUrl).written, "\x93\x11") << "without a further character";
  EXPECT_EQ(report().stall, "");
  links_.receive(kUrl, on_wire("M30\n%\n") + "\x14");
  EXPECT_EQ(received().size(), 1U);
}

TEST_F(LineReceiveTest, HoldsTheControlByItsOwnCharactersOrByRts) {
  machine::LineSettings settings = line_settings();
  settings.receive.hold = receive::Hold::dc3;
  settings.xon = 0x05;
  settings.xoff = 0x06;
  open(settings);
  for (int i = 0; i < 8; ++i) links_.receive(kUrl, "\x12" + on_wire("%\nO7\n%\n") + "\x14");
  links_.receive(kUrl, "\x12" + on_wire("%\nO8\n"));
  EXPECT_EQ(links_.cable(kUrl).written, "\x06");
  received();
  links_.run_posted();
  EXPECT_EQ(text_of(links_.cable(kUrl).written), "\x06\x05");

  constexpr const char* kSerial = "serial:/dev/ttyS0";
  settings = line_settings(kSerial);
  settings.receive.hold = receive::Hold::rts;
  open(settings);
  for (int i = 0; i < 8; ++i) links_.receive(kSerial, "\x12" + on_wire("%\nO7\n%\n") + "\x14");
  EXPECT_EQ(links_.cable(kSerial).rts, std::nullopt);
  links_.receive(kSerial, "\x12" + on_wire("%\nO8\n"));
  EXPECT_EQ(links_.cable(kSerial).rts, false);
  received();
  links_.run_posted();
  EXPECT_EQ(links_.cable(kSerial).rts, true);
  EXPECT_EQ(links_.cable(kSerial).written, "");
  // A new link begins with RTS on.
  links_.receive(kSerial, on_wire("M30\n%\n") + "\x14");
  received();
  for (int i = 0; i < 8; ++i) links_.receive(kSerial, "\x12" + on_wire("%\nO7\n%\n") + "\x14");
  links_.receive(kSerial, "\x12" + on_wire("%\nO8\n"));
  EXPECT_EQ(links_.cable(kSerial).rts, false);
  links_.lose(kSerial);
  links_.cable(kSerial).rts.reset();
  links_.advance(6s);
  EXPECT_NE(links_.cable(kSerial).rts, false);
}

TEST_F(LineReceiveTest, ALineThatWouldLoseTheThreesOfEiaIsRefused) {
  machine::LineSettings settings = line_settings();
  settings.code = tape_code::Code::eia;
  settings.framing = {.data_bits = 8, .parity = tape_code::Parity::none, .stop_bits = 1};
  settings.xoff_by = feed::XoffBy::kernel;
  settings.start = feed::Start::at_once;
  const auto made = make_feed_line(settings, links_, [] {});
  ASSERT_FALSE(made);
  EXPECT_NE(made.error().find("the digit 3"), std::string::npos) << made.error();
  settings.receive.enabled = false;
  EXPECT_TRUE(make_feed_line(settings, links_, [] {}));
}

}  // namespace
}  // namespace dripfeed::app
