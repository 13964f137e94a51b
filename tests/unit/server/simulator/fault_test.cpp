// The faults on purpose: each by its name, repeatable by its numbers and seed, and with the alarm that a control has
// for it.
#include "server/simulator/fault.h"

#include <bit>
#include <string>

#include <gtest/gtest.h>

#include "server/simulator/simulated_control.h"
#include "server/simulator/uart.h"

namespace dripfeed::simulator {
namespace {

constexpr Time_ns kSecond = 1'000'000'000;

std::vector<std::byte> even(std::string_view text) {
  std::vector<std::byte> wire;
  for (const char c : text) {
    const auto code = static_cast<unsigned>(c) & 0x7FU;
    wire.push_back(static_cast<std::byte>(code | ((static_cast<unsigned>(std::popcount(code)) & 1U) << 7U)));
  }
  return wire;
}

std::string hex(const std::vector<std::byte>& bytes) {
  constexpr std::string_view kDigits = "0123456789ABCDEF";
  std::string text;
  for (const std::byte byte : bytes) {
    const auto value = std::to_integer<unsigned>(byte);
    text += kDigits[value >> 4U];
    text += kDigits[value & 15U];
  }
  return text;
}

TEST(Fault, EachNameIsReadAndNoOther) {
  for (const FaultRow& row : fault_table()) {
    const auto fault = parse_fault(std::string(row.name) + "=12");
    ASSERT_TRUE(fault) << row.name;
    EXPECT_EQ(fault->kind, row.kind);
    EXPECT_EQ(fault->number, 12U);
  }
  for (const std::string_view wrong : {"", "cut", "cut=", "cut=x", "cut=-1", "cut=1.5", "rust=1"}) {
    const auto fault = parse_fault(wrong);
    ASSERT_FALSE(fault) << wrong;
    EXPECT_NE(fault.error().find("late-xoff=N"), std::string::npos) << "all names are shown";
  }
}

TEST(Fault, TheLineLosesFlipsAndIsRepeatable) {
  const std::vector<std::byte> text = even("ABCDEF");
  const auto sent = [&](Faults faults, std::uint32_t seed) {
    LineFaults line(std::move(faults), seed);
    std::vector<std::byte> bytes = text;
    line.to_control(bytes);
    return hex(bytes);
  };
  EXPECT_EQ(sent({}, 1), hex(text));
  EXPECT_EQ(sent({{FaultKind::lose, 3}}, 1), hex(even("ABDEF")));
  EXPECT_EQ(sent({{FaultKind::parity, 1}}, 1), "C1" + hex(even("BCDEF")));
  const std::string flipped = sent({{FaultKind::flip, 2}}, 5);
  EXPECT_NE(flipped, hex(text));
  EXPECT_EQ(flipped, sent({{FaultKind::flip, 2}}, 5)) << "the same seed, the same bit";
  EXPECT_EQ(sent({{FaultKind::noise, 1'000'000}}, 5).size(), 12U);
  EXPECT_NE(sent({{FaultKind::noise, 1'000'000}}, 5), hex(text));
  LineFaults line({{FaultKind::lose_out, 2}}, 1);
  std::vector<std::byte> out = even("XYZ");
  line.to_host(out);
  EXPECT_EQ(hex(out), hex(even("XZ")));
}

TEST(Fault, UartsHaveTheirDelays) {
  EXPECT_EQ(find_uart("16550")->chars, 4U);
  EXPECT_EQ(find_uart("ftdi")->fixed_ns, 16'000'000);
  EXPECT_EQ(find_uart("device-server")->fixed_ns, 2'000'000);
  EXPECT_EQ(find_uart("ideal")->chars, 0U);
  EXPECT_EQ(find_uart("8250").error(), "uart \"8250\" is none of: 16550 ftdi device-server ideal");
}

// A control with one fault, fed character by character at line speed.
class FaultyControl : public ::testing::Test {
 protected:
  static ControlSettings settings() {
    ControlSettings s;
    s.framing = tape_code::parse_framing("7E2").value();
    s.buffer_bytes = 100;
    s.stop_free_bytes = 30;
    s.go_free_bytes = 60;
    return s;
  }
  void make(Faults faults, ControlSettings s = settings()) {
    s.faults = std::move(faults);
    control_ = std::make_unique<SimulatedControl>(s, [](std::uint8_t) {});
    control_->start(now_);
    char_ns_ = static_cast<Time_ns>(11e9 / 9600 / (1.0 + s.clock_ppm * 1e-6));
    pass(kSecond);
    out_.clear();
  }
  void pass(Time_ns span) {
    const Time_ns until = now_ + span;
    while (const auto next = control_->deadline()) {
      if (*next > until) break;
      now_ = std::max(*next, now_);
      look();
    }
    now_ = until;
    look();
  }
  void look() {
    control_->tick(now_);
    for (const std::byte byte : control_->take_out(now_)) out_.push_back(byte);
  }
  void feed(std::string_view text) {
    for (const std::byte byte : even(text)) {
      control_->receive({&byte, 1}, now_, now_);
      pass(char_ns_);
    }
  }
  [[nodiscard]] std::string alarm() const { return control_->report().alarm; }

  Time_ns now_ = kSecond;
  Time_ns char_ns_ = 0;
  std::unique_ptr<SimulatedControl> control_;
  std::vector<std::byte> out_;
};

constexpr std::string_view kProgram = "%\nO1\nG1X1.\nG1X2.\nM30\n%";

TEST_F(FaultyControl, ResetAndAlarmAreReportedAfterADc3) {
  make({{FaultKind::reset, 10}});
  feed(kProgram);
  EXPECT_EQ(hex(out_), "9396");
  EXPECT_EQ(control_->state(), ControlState::waiting);
  EXPECT_EQ(control_->report().bytes_run, 3U) << "the block that was broken off is not run";
  make({{FaultKind::alarm, 10}});
  feed(kProgram);
  EXPECT_EQ(hex(out_), "9395");
  EXPECT_EQ(control_->state(), ControlState::alarm);
}

TEST_F(FaultyControl, AlarmsHaveTheirNumbers) {
  make({{FaultKind::baud, 4800}});
  feed(kProgram);
  EXPECT_EQ(alarm(), "085 COMMUNICATION ERROR");
  EXPECT_GT(control_->report().framing_errors, 0U);
  make({{FaultKind::baud, 9600}});
  feed(kProgram);
  EXPECT_EQ(alarm(), "") << "its own rate is no fault";
  make({{FaultKind::dsr, 8}});
  EXPECT_TRUE(control_->lines().dsr);
  feed(kProgram);
  EXPECT_FALSE(control_->lines().dsr);
  EXPECT_EQ(alarm(), "086 DR SIGNAL OFF");
  make({{FaultKind::overrun, 8}});
  feed(kProgram);
  EXPECT_EQ(alarm(), "087 BUFFER OVERFLOW");
  make({{FaultKind::tv, 1}});
  feed("%\nG1X1.\n");
  EXPECT_EQ(alarm(), "") << "six characters";
  feed("G1X12.\n");
  EXPECT_EQ(alarm(), "002 TV PARITY") << "seven";
}

TEST_F(FaultyControl, ASilentOneRunsAndSaysNothingMore) {
  make({{FaultKind::silent, 9}});
  feed(kProgram);
  pass(10 * kSecond);
  EXPECT_TRUE(out_.empty());
  EXPECT_EQ(control_->state(), ControlState::reading);
  EXPECT_FALSE(control_->finished());
  EXPECT_EQ(control_->report().bytes, kProgram.size());
}

TEST_F(FaultyControl, ALateXoffOverrunsASoundHost) {
  for (const std::uint64_t late : {0U, 20U}) {
    make({{FaultKind::late_xoff, late}});
    feed("%\nG4P10000\n");
    std::string fill(60, ' ');
    feed(fill + "\n");
    for (int i = 0; i < 60 && out_.empty(); ++i) feed(" ");
    EXPECT_EQ(alarm(), late == 0 ? "" : "087 BUFFER OVERFLOW") << late;
  }
}

TEST_F(FaultyControl, ShowsItsRtsInsteadOfDcCodes) {
  ControlSettings s = settings();
  s.uses_dc = false;
  s.drives_rts = true;
  make({}, s);
  EXPECT_TRUE(control_->lines().cts) << "on since the start";
  feed("%\nG4P10000\n");
  feed(std::string(75, ' ') + "\n");
  EXPECT_EQ(control_->state(), ControlState::held);
  EXPECT_FALSE(control_->lines().cts);
  pass(20 * kSecond);
  EXPECT_TRUE(control_->lines().cts);
  EXPECT_TRUE(out_.empty());
}

TEST_F(FaultyControl, TheBufferLevelIsReported) {
  make({});
  feed("%\nG4P10000\n");
  feed(std::string(70, ' ') + "\n");
  const auto report = control_->report();
  EXPECT_EQ(report.buffer_max, 71U);
  pass(20 * kSecond);
  feed("G4\nG4\n");
  pass(kSecond);
  EXPECT_EQ(control_->report().buffer_min, 3U) << "a block alone in the buffer";
}

TEST_F(FaultyControl, AClockThatIsFastTakesLessTime) {
  ControlSettings s = settings();
  s.clock_ppm = 20'000;
  make({}, s);
  const auto byte = even("%").front();
  control_->receive({&byte, 1}, now_, now_);
  const auto next = control_->deadline();
  pass(0);
  EXPECT_EQ(control_->report().bytes, 1U) << "it was idle before, so it is there at once";
  control_->receive({&byte, 1}, now_, now_);
  ASSERT_TRUE(control_->deadline());
  EXPECT_NEAR(static_cast<double>(*control_->deadline() - now_), 11e9 / 9600 / 1.02, 2.0) << (next ? *next : 0);
}

}  // namespace
}  // namespace dripfeed::simulator
