// A line that feeds, over a link without a system, in virtual time: nothing goes out before DC1, after a loss, beyond
// the reserve, or on a torn line.
#include "server/app/lines/feed_line.h"

#include <chrono>

#include <gtest/gtest.h>

#include "tests/support/fake_links.h"
#include "tests/unit/server/app/feeding.h"

namespace dripfeed::app {
namespace {

using namespace std::chrono_literals;
using namespace test;
using dripfeed::test::FakeLinkThread;

class FeedLineTest : public ::testing::Test {
 protected:
  void open(const machine::LineSettings& settings = line_settings()) {
    auto made = make_feed_line(settings, links_, [this] { ++changes_; });
    ASSERT_TRUE(made) << made.error();
    line_ = std::move(*made);
    links_.run_posted();
  }
  void arm(std::uint64_t job, const std::string& text, std::uint64_t reserve = feed::kNoReserve) {
    const auto armed = line_->arm(order_of(job, text, reserve));
    ASSERT_TRUE(armed) << armed.error();
  }
  // Armed, started and inside the block of the given number of characters.
  void feed_into_a_block(std::size_t at_least = 20) {
    open();
    arm(1, text_);
    links_.receive(kUrl, kDc1);
    while (written().size() < at_least || written().back() == '\n') links_.advance(1ms);
    ASSERT_LT(written().size(), text_.size());
  }
  [[nodiscard]] std::string written() { return text_of(links_.cable(kUrl).written); }
  [[nodiscard]] LineReport report() const { return line_->report(); }

  FakeLinkThread links_;
  int changes_ = 0;
  const std::string text_ = program(20);
  std::unique_ptr<Line> line_;
};

TEST_F(FeedLineTest, SendsNothingBeforeDc1AndEverythingAfterIt) {
  open();
  EXPECT_EQ(report().state, LineState::idle);
  EXPECT_EQ(report().job, 0U);
  arm(1, text_);
  links_.advance(60s);
  EXPECT_EQ(written(), "");
  EXPECT_EQ(report().state, LineState::armed);
  EXPECT_EQ(report().stall, "waiting for DC1");

  links_.receive(kUrl, kDc1);
  links_.advance(1500us * text_.size());
  EXPECT_EQ(written(), text_);
  EXPECT_EQ(report().state, LineState::draining);
  EXPECT_EQ(report().stall, "waiting for end");
  EXPECT_EQ(report().handed, text_.size());
  links_.receive(kUrl, kDc3);
  EXPECT_EQ(report().state, LineState::idle);
  EXPECT_EQ(report().end, JobEnd::done);
  EXPECT_EQ(report().clocked, text_.size());
  EXPECT_EQ(report().confirmed, 0U);
  EXPECT_FALSE(report().confirms);
  EXPECT_EQ(report().total, text_.size());
  EXPECT_EQ(report().known.from, text_.size());
}

TEST_F(FeedLineTest, Dc1WithNothingArmedSendsNothingAndIsCounted) {
  open();
  links_.receive(kUrl, kDc1);
  links_.receive(kUrl, kDc1);
  links_.advance(1s);
  EXPECT_EQ(written(), "");
  EXPECT_EQ(report().unarmed_starts, 2U);
  EXPECT_EQ(report().state, LineState::idle);
  arm(1, text_);
  links_.advance(1s);
  EXPECT_EQ(written(), "") << "a DC1 from before the arming starts nothing";
}

TEST_F(FeedLineTest, ADc3ThatTheSystemHasNotReportedStopsTheNextWrite) {
  feed_into_a_block();
  links_.cable(kUrl).unread = kDc3;
  const std::string before = written();
  links_.advance(1s);
  EXPECT_EQ(written(), before);
  EXPECT_EQ(report().state, LineState::held);
  links_.cable(kUrl).unread = kDc1;
  links_.advance(1s);
  EXPECT_EQ(written(), before) << "nothing is to be written, so nobody looks; the system tells of it in its time";
  links_.receive(kUrl, kDc1);
  links_.advance(1s);
  EXPECT_GT(written().size(), before.size());
}

TEST_F(FeedLineTest, WhatTheNetworkHasNotConfirmedIsNotClocked) {
  open();
  arm(1, text_);
  links_.receive(kUrl, kDc1);
  links_.cable(kUrl).unconfirmed = 10'000;
  links_.advance(1500us * text_.size());
  EXPECT_EQ(written(), text_);
  EXPECT_EQ(report().clocked, 0U);
  EXPECT_EQ(report().state, LineState::draining);
  links_.cable(kUrl).unconfirmed = 0;
  links_.advance(10ms);
  EXPECT_EQ(report().clocked, text_.size());
}

TEST_F(FeedLineTest, ADownLinkIsNotArmed) {
  links_.cable(kUrl).comes_up = false;
  open();
  EXPECT_EQ(report().state, LineState::disconnected);
  const auto armed = line_->arm(order_of(1, text_));
  ASSERT_FALSE(armed);
  EXPECT_EQ(armed.error(), "the link is down (the line is idle)");
  EXPECT_EQ(report().job, 0U);
}

TEST_F(FeedLineTest, ALossInsideABlockTearsTheLineUntilAPersonConfirms) {
  feed_into_a_block();
  links_.lose(kUrl);
  const std::string torn = written();
  EXPECT_EQ(report().state, LineState::torn);
  EXPECT_EQ(report().end, JobEnd::failed);
  EXPECT_EQ(report().cause, "link_lost");
  EXPECT_EQ(report().link_error, "the cable is cut");
  EXPECT_LE(report().known.from, report().known.to);
  EXPECT_EQ(report().known.to, torn.size());

  links_.advance(10s);  // the link is back
  EXPECT_EQ(links_.cable(kUrl).opened, 2);
  EXPECT_EQ(report().state, LineState::torn);
  links_.receive(kUrl, kDc1);
  links_.advance(10s);
  EXPECT_EQ(written(), torn) << "not a byte, no EOB, no '%'";
  const auto armed = line_->arm(order_of(2, text_));
  ASSERT_FALSE(armed);
  EXPECT_NE(armed.error().find("(the line is torn)"), std::string::npos) << armed.error();
  for (const feed::Command command : {feed::Command::resume, feed::Command::cancel, feed::Command::stop,
                                      feed::Command::resume_as_if_dc1, feed::Command::disarm}) {
    EXPECT_FALSE(line_->command(command));
  }
  EXPECT_EQ(written(), torn);

  ASSERT_TRUE(line_->command(feed::Command::confirm_reset));
  EXPECT_EQ(report().state, LineState::idle);
  links_.receive(kUrl, kDc1);
  links_.advance(1s);
  EXPECT_EQ(written(), torn) << "the confirmation arms nothing";
  arm(2, text_);
  links_.receive(kUrl, kDc1);
  links_.advance(5s);
  EXPECT_EQ(written(), torn + text_);
}

TEST_F(FeedLineTest, ALossWhileArmedDisarms) {
  open();
  arm(1, text_);
  links_.lose(kUrl);
  EXPECT_EQ(report().end, JobEnd::disarmed);
  EXPECT_EQ(report().state, LineState::disconnected);
  links_.advance(10s);
  EXPECT_EQ(report().state, LineState::idle);
  links_.receive(kUrl, kDc1);
  links_.advance(10s);
  EXPECT_EQ(written(), "");
}

TEST_F(FeedLineTest, ResetOfTheControlTearsTheBlock) {
  feed_into_a_block();
  const std::size_t before = written().size();
  links_.receive(kUrl, kSyn);
  EXPECT_EQ(report().state, LineState::torn);
  EXPECT_EQ(report().cause, "syn");
  links_.advance(5s);
  EXPECT_EQ(written().size(), before);
}

TEST_F(FeedLineTest, ALinkThatCannotBeOpenedIsTriedLessAndLessOften) {
  links_.cable(kUrl).refusal = "no such device";
  open();
  EXPECT_EQ(report().state, LineState::disconnected);
  EXPECT_EQ(report().link_error, "no such device");
  int expected = 1;
  for (const auto wait : {500ms, 1000ms, 2000ms, 4000ms, 5000ms, 5000ms}) {
    links_.advance(wait - 1ms);
    EXPECT_EQ(links_.cable(kUrl).opened, expected);
    links_.advance(1ms);
    EXPECT_EQ(links_.cable(kUrl).opened, ++expected);
  }
  links_.cable(kUrl).refusal.clear();
  links_.advance(5s);
  EXPECT_EQ(report().state, LineState::idle);
  EXPECT_EQ(report().link_error, "");
  links_.lose(kUrl);
  links_.advance(500ms);
  EXPECT_EQ(report().state, LineState::idle) << "the wait starts again after a link that was up";
}

TEST_F(FeedLineTest, ADriverThatTakesLittleGetsEveryByteOnce) {
  open();
  links_.cable(kUrl).accept_at_most = 1;
  arm(1, text_);
  links_.receive(kUrl, kDc1);
  for (int i = 0; i < 3000 && written() != text_; ++i) {
    links_.advance(1ms);
    links_.writable(kUrl);
  }
  EXPECT_EQ(written(), text_);
}

TEST_F(FeedLineTest, HandsNothingBeyondTheReserve) {
  open();
  arm(1, text_, 30);
  links_.receive(kUrl, kDc1);
  links_.advance(5s);
  EXPECT_EQ(written(), text_.substr(0, 30));
  EXPECT_EQ(report().stall, "waiting for ledger");
  EXPECT_EQ(report().reserve, 30U);
  line_->extend_reserve(99, 1000);  // of another job
  links_.advance(1s);
  EXPECT_EQ(written().size(), 30U);
  line_->extend_reserve(1, 20);  // never lowers
  line_->extend_reserve(1, 47);
  links_.advance(1s);
  EXPECT_EQ(written(), text_.substr(0, 47));
  EXPECT_EQ(report().reserve, 47U);
  line_->extend_reserve(1, feed::kNoReserve);
  links_.advance(5s);
  EXPECT_EQ(written(), text_);
}

TEST_F(FeedLineTest, NeverMoreUnsentThanTheBudgetAllows) {
  open();
  arm(1, text_);
  links_.receive(kUrl, kDc1);
  const auto start = links_.now();
  const double char_s = report().char_s;
  EXPECT_NEAR(char_s, 11.0 / 9600.0, 1e-6);
  links_.cable(kUrl).before_write = [&](std::size_t total) {
    const double line_time = static_cast<double>((links_.now() - start).count()) * 1e-9;
    const double gone = line_time / char_s;
    EXPECT_LE(static_cast<double>(total) - gone, 4.0 + 1e-6) << "at " << total;
  };
  links_.advance(5s);
  EXPECT_EQ(written(), text_);
  EXPECT_GT(report().line_use, 0.0);
}

TEST_F(FeedLineTest, Dc3HoldsAndDc1GoesOn) {
  feed_into_a_block();
  links_.receive(kUrl, kDc3);
  const std::string held = written();
  links_.advance(3600s);
  EXPECT_EQ(written(), held) << "a hold has no limit";
  EXPECT_EQ(report().state, LineState::held);
  EXPECT_EQ(report().stall, "held by DC3");
  EXPECT_EQ(report().holds, 1U);
  EXPECT_GE(report().hold_s, 3599.0);
  links_.receive(kUrl, kDc1);
  links_.advance(5s);
  EXPECT_EQ(written(), text_);
}

TEST_F(FeedLineTest, APersonStandsInForALostDc1) {
  feed_into_a_block();
  EXPECT_FALSE(line_->command(feed::Command::resume_as_if_dc1)) << "nothing is held";
  links_.receive(kUrl, kDc3);
  EXPECT_FALSE(line_->command(feed::Command::resume));
  ASSERT_TRUE(line_->command(feed::Command::resume_as_if_dc1));
  links_.advance(5s);
  EXPECT_EQ(written(), text_);
}

TEST_F(FeedLineTest, StopAndCancelActAtABlockEnd) {
  feed_into_a_block();
  ASSERT_TRUE(line_->command(feed::Command::stop));
  links_.advance(10s);
  EXPECT_EQ(report().state, LineState::held);
  EXPECT_EQ(report().stall, "stopped");
  EXPECT_EQ(written().back(), '\n');
  const std::size_t stopped = written().size();
  ASSERT_LT(stopped, text_.size());
  ASSERT_TRUE(line_->command(feed::Command::resume));
  while (written().size() < stopped + 3) links_.advance(1ms);
  ASSERT_TRUE(line_->command(feed::Command::cancel));
  links_.advance(10s);
  EXPECT_EQ(report().end, JobEnd::cancelled);
  EXPECT_EQ(report().state, LineState::idle);
  EXPECT_EQ(written().back(), '\n');
  EXPECT_EQ(written(), text_.substr(0, written().size()));
  EXPECT_LT(written().size(), text_.size());
  EXPECT_EQ(written().find('%', 1), std::string::npos) << "no '%' ends what was cancelled";
}

TEST_F(FeedLineTest, AnArmingExpires) {
  open();
  LineOrder order = order_of(1, text_);
  order.expires_after = 10min;
  ASSERT_TRUE(line_->arm(std::move(order)));
  EXPECT_FALSE(line_->arm(order_of(2, text_))) << "one job a line";
  links_.advance(10min - 1ms);
  EXPECT_EQ(report().state, LineState::armed);
  links_.advance(1ms);
  EXPECT_EQ(report().state, LineState::idle);
  EXPECT_EQ(report().end, JobEnd::disarmed);
  EXPECT_EQ(report().cause, "expired");
  links_.receive(kUrl, kDc1);
  links_.advance(1s);
  EXPECT_EQ(written(), "");
}

TEST_F(FeedLineTest, ANewLinkForgetsTheModemLinesOfTheOldOne) {
  machine::LineSettings settings = line_settings();
  settings.watch_cts = true;
  open(settings);
  links_.set_cts(kUrl, false);
  links_.lose(kUrl);
  links_.advance(1s);
  arm(1, text_);
  links_.receive(kUrl, kDc1);
  links_.advance(5s);
  EXPECT_EQ(written(), text_) << report().stall;
}

TEST_F(FeedLineTest, CtsOffDisarmsWhereItIsWatched) {
  machine::LineSettings settings = line_settings();
  settings.watch_cts = true;
  open(settings);
  arm(1, text_);
  links_.set_cts(kUrl, false);
  EXPECT_EQ(report().end, JobEnd::disarmed);
}

TEST_F(FeedLineTest, ReportsEachChangeAndLeavesNothing) {
  open();
  const int before = changes_;
  const std::uint64_t counted = report().changes;
  arm(1, text_);
  EXPECT_GT(changes_, before);
  EXPECT_GT(report().changes, counted);
  line_.reset();
  EXPECT_EQ(links_.cable(kUrl).listener, nullptr);
  links_.advance(10s);
  EXPECT_EQ(written(), "");
}

TEST_F(FeedLineTest, RefusesSettingsThatCannotBeKept) {
  const auto made = make_feed_line(line_settings("pty:/x?unsent=9"), links_, [] {});
  ASSERT_FALSE(made);
  EXPECT_EQ(made.error(), "9 unsent + 5 latency = 14 characters, more than the overrun budget of 10");
}

}  // namespace
}  // namespace dripfeed::app
