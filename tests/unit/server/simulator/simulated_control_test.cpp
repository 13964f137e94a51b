// The simulated control, the judge of all feeds, in virtual time: what it holds, counts, runs and refuses. Figures are
// counted here by hand, character by character.
#include "server/simulator/simulated_control.h"

#include <bit>
#include <chrono>
#include <string>

#include <gtest/gtest.h>

namespace dripfeed::simulator {
namespace {

constexpr Time_ns kSecond = 1'000'000'000;
constexpr Time_ns kChar = kSecond * 11 / 9600;  // 7E2 at 9600 baud, truncated as by the control
constexpr std::byte kDc1{0x11};
constexpr std::byte kDc3{0x93};

std::vector<std::byte> even(std::string_view text) {
  std::vector<std::byte> wire;
  for (const char c : text) {
    const auto code = static_cast<unsigned>(c) & 0x7FU;
    wire.push_back(static_cast<std::byte>(code | ((static_cast<unsigned>(std::popcount(code)) & 1U) << 7U)));
  }
  return wire;
}

class SimulatedControlTest : public ::testing::Test {
 protected:
  static ControlSettings settings() {
    ControlSettings s;
    s.framing = tape_code::parse_framing("7E2").value();
    s.buffer_bytes = 100;
    s.stop_free_bytes = 30;
    s.go_free_bytes = 60;
    return s;
  }
  void make(const ControlSettings& s) {
    control_ = std::make_unique<SimulatedControl>(
        s, [this](std::uint8_t byte) { recorded_ += static_cast<char>(byte & 0x7FU); });
    control_->start(now_);
  }
  // One write of the host.
  void give(std::string_view text) { control_->receive(even(text), now_, now_); }
  void pass(Time_ns span) {
    const Time_ns until = now_ + span;
    for (;;) {
      const auto next = control_->deadline();
      if (!next || *next > until) break;
      now_ = std::max(*next, now_);
      control_->tick(now_);
      for (const std::byte byte : control_->take_out(now_)) out_.push_back(byte);
    }
    now_ = until;
    control_->tick(now_);
    for (const std::byte byte : control_->take_out(now_)) out_.push_back(byte);
  }
  // Character by character at line speed.
  void feed(std::string_view text) {
    for (const char c : text) {
      give(std::string_view(&c, 1));
      pass(kChar);
    }
  }
  [[nodiscard]] ControlReport report() const { return control_->report(); }

  Time_ns now_ = kSecond;
  std::unique_ptr<SimulatedControl> control_;
  std::string recorded_;
  std::vector<std::byte> out_;
};

TEST(MakeControl, KnowsEachProtocolThatItNamesAndNoOther) {
  for (const std::string_view protocol : control_protocols()) {
    ControlSettings settings;
    settings.protocol = protocol;
    const auto control = make_control(settings, [](std::uint8_t) {});
    ASSERT_TRUE(control) << protocol;
    EXPECT_EQ((*control)->report().bytes, 0U) << protocol;
  }
  ControlSettings settings;
  settings.protocol = "kermit";
  const auto control = make_control(settings, [](std::uint8_t) {});
  ASSERT_FALSE(control);
  EXPECT_NE(control.error().find("\"kermit\"; known are dc"), std::string::npos) << control.error();
}

TEST_F(SimulatedControlTest, AsksWithDc1AndEndsWithDc3) {
  make(settings());
  EXPECT_EQ(control_->state(), ControlState::reading);
  pass(4 * kChar);
  EXPECT_TRUE(out_.empty()) << "a DC1 has its own time on the line";
  pass(2 * kChar);
  EXPECT_EQ(out_, std::vector{kDc1});
  const std::string text = "%\nO1\nG0X1.\nM30\n%";
  feed(text);
  pass(kSecond);
  EXPECT_EQ(out_, (std::vector{kDc1, kDc3}));
  EXPECT_EQ(report().state, ControlState::ended);
  EXPECT_TRUE(control_->finished());
  EXPECT_EQ(recorded_, text) << "every byte, in its order";
  EXPECT_EQ(report().bytes, text.size());
  EXPECT_EQ(report().blocks_run, 3U);
  EXPECT_EQ(report().bytes_run, text.size() - 3) << "without the two '%' and the label skip's EOB";
  EXPECT_FALSE(report().unfinished_block);
  EXPECT_EQ(report().alarm, "");
}

// Blocks that run for long fill the buffer: at less than 30 free of 100 the control says DC3.
TEST_F(SimulatedControlTest, SaysDc3AtItsHighWaterMarkAndDc1AtItsLowOne) {
  make(settings());
  pass(kSecond);
  out_.clear();
  feed("%\nG4P10000\n");  // ten seconds
  std::string fill;
  for (int i = 0; i < 7; ++i) fill += "(456789)G4\n";  // 11 each
  feed(std::string_view(fill).substr(0, 70));
  EXPECT_EQ(control_->state(), ControlState::reading) << "30 are free";
  feed(std::string_view(fill).substr(70, 1));
  EXPECT_EQ(control_->state(), ControlState::held);
  EXPECT_EQ(report().holds, 1U);
  EXPECT_TRUE(out_.empty());
  pass(4 * kChar);
  EXPECT_EQ(out_, std::vector{kDc3}) << "five characters of latency";
  feed("(45)\n");
  pass(20 * kSecond);
  EXPECT_EQ(control_->state(), ControlState::reading);
  EXPECT_EQ(out_, (std::vector{kDc3, kDc1}));
  EXPECT_EQ(report().after_dc3_max, 5U);
  EXPECT_EQ(report().after_dc3[5], 1U);
}

TEST_F(SimulatedControlTest, CountsWhatComesAfterItsOwnDc3AndAlarmsBeyondTen) {
  for (const int late : {0, 1, 10, 11}) {
    SCOPED_TRACE(late);
    out_.clear();
    make(settings());
    feed("%\nG4P10000\n");
    feed(std::string(71, 'X'));
    ASSERT_EQ(control_->state(), ControlState::held);
    feed(std::string(static_cast<std::size_t>(late), 'Y'));
    pass(late > 10 ? 0 : 20 * kChar);  // the DC3 has left by now
    EXPECT_EQ(report().after_dc3_max, static_cast<std::uint64_t>(late));
    EXPECT_EQ(control_->state(), late > 10 ? ControlState::alarm : ControlState::held);
    EXPECT_EQ(report().alarm, late > 10 ? "087 BUFFER OVERFLOW" : "");
  }
}

// A host that writes a burst is judged as its UART would be: one character after the other.
TEST_F(SimulatedControlTest, WhatArrivesBeforeALateDc3LeavesDoesNotCount) {
  make(settings());
  pass(kSecond);
  feed("%\n" + std::string(71, 'X'));  // 29 of 100 free: DC3, due to leave five characters later
  const std::size_t before = out_.size();
  for (int i = 0; i < 14; ++i) {  // the driver sleeps over its DC3
    now_ += kChar;
    give("Y");
  }
  EXPECT_EQ(out_.size(), before);
  for (const std::byte byte : control_->take_out(now_)) out_.push_back(byte);  // nine characters late
  ASSERT_EQ(out_.back(), kDc3);
  EXPECT_EQ(report().after_dc3_max, 5U);
  for (int i = 0; i < 6; ++i) {
    EXPECT_EQ(report().alarm, "");
    now_ += kChar;
    give("Y");
  }
  EXPECT_EQ(report().after_dc3_max, 11U);
  EXPECT_EQ(report().alarm, "087 BUFFER OVERFLOW");
}

// 30 characters are free when it decides to stop. A driver that sleeps over them lets in more, and the host is not to
// blame for that.
TEST_F(SimulatedControlTest, WhatALateDc3LetsInDoesNotFillTheBuffer) {
  make(settings());
  pass(kSecond);
  feed("%\n" + std::string(71, 'X'));
  for (int i = 0; i < 60; ++i) {
    now_ += kChar;
    give("Y");
  }
  EXPECT_EQ(report().alarm, "");
  ASSERT_EQ(control_->take_out(now_).size(), 1U);
  control_->left_late(20 * kChar);  // ... and it was kept from writing it
  for (int i = 0; i < 20; ++i) {
    now_ += kChar;
    give("Z");
  }
  EXPECT_EQ(report().alarm, "");
  feed(std::string(11, 'Y'));
  EXPECT_EQ(report().after_dc3_max, 11U);
  EXPECT_EQ(report().alarm, "087 BUFFER OVERFLOW") << "from there on the host is";
}

TEST_F(SimulatedControlTest, ABurstArrivesAtLineSpeed) {
  make(settings());
  give("%\n(345678)\n");
  EXPECT_EQ(report().bytes, 1U);
  pass(10 * kChar - 1);
  EXPECT_EQ(report().bytes, 10U);
  pass(kSecond);
  EXPECT_EQ(report().bytes, 11U);
  EXPECT_NEAR(report().line_use, 1.0, 0.1);
}

TEST_F(SimulatedControlTest, ABufferThatRunsOverIsAnAlarmAndEndsTheReading) {
  ControlSettings s = settings();
  s.overrun_budget = 1000;
  make(s);
  feed("%\nG4P10000\n");
  feed(std::string(101, 'X'));
  EXPECT_EQ(report().alarm, "087 BUFFER OVERFLOW");
  const auto run = report().blocks_run;
  feed("\nG0X1.\n%");
  pass(100 * kSecond);
  EXPECT_EQ(report().blocks_run, run) << "nothing runs after an alarm";
  EXPECT_EQ(report().state, ControlState::alarm);
  EXPECT_EQ(report().bytes, recorded_.size()) << "bytes are recorded all the same";
}

TEST_F(SimulatedControlTest, WrongParityIsAnAlarm) {
  make(settings());
  feed("%\nG0");
  const std::byte wrong{static_cast<std::uint8_t>('X') ^
                        (std::popcount(static_cast<unsigned>('X')) % 2 == 0 ? 0x80U : 0U)};
  control_->receive(std::span(&wrong, 1), now_, now_);
  pass(kChar);
  EXPECT_EQ(report().parity_errors, 1U);
  EXPECT_EQ(report().alarm, "001 TH PARITY");
  EXPECT_TRUE(report().unfinished_block);
  control_->reset();
  EXPECT_EQ(control_->state(), ControlState::waiting);
  control_->start(now_);
  EXPECT_EQ(control_->state(), ControlState::reading) << "after RESET it reads again";
}

TEST_F(SimulatedControlTest, AnUnfinishedBlockIsNeverRun) {
  make(settings());
  feed("%\nG0X1.\nG0X2.");
  pass(1000 * kSecond);
  EXPECT_EQ(report().blocks_run, 1U);
  EXPECT_EQ(report().bytes_run, 6U);
  EXPECT_TRUE(report().unfinished_block);
  EXPECT_FALSE(control_->finished());
  control_->reset();
  EXPECT_FALSE(report().unfinished_block) << "RESET drops it";
  control_->start(now_);
  feed("5\n%\nG0X3.\n%");
  pass(kSecond);
  EXPECT_EQ(report().blocks_run, 2U) << "what came before the new '%' is leader";
}

TEST_F(SimulatedControlTest, NothingIsReadBeforeItAskedAndAfterTheEnd) {
  control_ = std::make_unique<SimulatedControl>(settings(), [this](std::uint8_t) { recorded_ += '.'; });
  feed("%\nG0X1.\n%");
  EXPECT_EQ(report().blocks_run, 0U);
  EXPECT_EQ(recorded_.size(), 9U);
  control_->start(now_);
  feed("%\nG0X1.\n%G0X2.\nG0X3.\n");
  pass(kSecond);
  EXPECT_EQ(report().blocks_run, 1U);
}

TEST_F(SimulatedControlTest, ALoopIsNoBlockForATape) {
  make(settings());
  feed("%\nWHILE[#1LT3]DO1\nG0X1.\n");
  pass(kSecond);
  EXPECT_EQ(report().alarm, "123 CAN NOT USE MACRO COMMAND IN DNC");
  EXPECT_EQ(report().blocks_run, 0U);
}

TEST_F(SimulatedControlTest, RunningDryIsAStallWithItsTime) {
  make(settings());
  feed("%\nG4P1000\n");
  pass(3 * kSecond);
  feed("G4P1000\n");
  pass(3 * kSecond);
  EXPECT_EQ(report().stalls, 1U);
  EXPECT_NEAR(report().stall_s, 2.0, 0.02);
}

TEST_F(SimulatedControlTest, LineUseLeavesHoldsOut) {
  make(settings());
  feed("%\nG4P5000\n(" + std::string(68, 'A') + ")\n");
  ASSERT_EQ(control_->state(), ControlState::held);
  pass(20 * kSecond);
  ASSERT_EQ(control_->state(), ControlState::reading);
  feed("G0X1.\n%");
  EXPECT_GT(report().line_use, 0.0);
  EXPECT_LE(report().line_use, 1.0);
}

// EIA: odd holes, EOB 80h, ER 0Bh; a blank is leader and nothing else.
TEST_F(SimulatedControlTest, ReadsEia) {
  ControlSettings s = settings();
  s.framing = tape_code::parse_framing("8N2").value();
  s.code = tape_code::Code::eia;
  constexpr std::array<std::uint8_t, 14> kTape = {0x00, 0x00, 0x0B, 0x80, 0x46, 0x13, 0x80,   // ER, O3
                                                  0x54, 0x13, 0x20, 0x80, 0x0B, 0x80, 0x00};  // M30, ER
  for (const bool blank_inside : {false, true}) {
    make(s);
    for (std::size_t i = 0; i < kTape.size(); ++i) {
      const std::byte byte{blank_inside && i == 8 ? std::uint8_t{0} : kTape[i]};
      control_->receive({&byte, 1}, now_, now_);
      pass(kChar);
    }
    pass(kSecond);
    EXPECT_EQ(control_->report().alarm, blank_inside ? "001 TH PARITY" : "");
    EXPECT_EQ(control_->state(), blank_inside ? ControlState::alarm : ControlState::ended);
    EXPECT_EQ(control_->report().blocks_run, blank_inside ? 1U : 2U);
  }
}

}  // namespace
}  // namespace dripfeed::simulator
