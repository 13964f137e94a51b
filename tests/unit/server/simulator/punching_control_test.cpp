// A control that punches, in virtual time: its signs, its pace, and that it obeys the host's DC3.
#include "server/simulator/punching_control.h"

#include <string>

#include <gtest/gtest.h>

namespace dripfeed::simulator {
namespace {

constexpr Time_ns kMs = 1'000'000;
constexpr Time_ns kChar = 11'000'000'000 / 9600;

ControlSettings settings_of(const std::string& text, const char* protocol = "punch") {
  ControlSettings settings;
  settings.protocol = protocol;
  settings.punches = text;
  return settings;
}

// What it sends until `until`, looked at every millisecond.
std::string run(Control& control, Time_ns& now, Time_ns until) {
  std::string sent;
  for (; now < until; now += kMs) {
    control.tick(now);
    for (const std::byte byte : control.take_out(now)) sent += static_cast<char>(byte);
  }
  return sent;
}

TEST(PunchingControl, PunchesItsTextBetweenItsSigns) {
  PunchingControl control(settings_of("%\nO7\n%\n"), [](std::uint8_t) {});
  Time_ns now = 0;
  control.start(now);
  EXPECT_FALSE(control.finished());
  const std::string sent = run(control, now, 2'000 * kMs);
  EXPECT_EQ(sent.front(), '\x12');
  EXPECT_EQ(sent.back(), '\x14');
  EXPECT_NE(sent.find("\xA5\n\xCF\xB7\n\xA5\n"), std::string::npos) << "even parity";
  EXPECT_TRUE(control.finished());
  EXPECT_EQ(control.state(), ControlState::ended);
}

TEST(PunchingControl, PunchesInEiaAndWithItsOwnEob) {
  ControlSettings eia = settings_of("%\nO35\n%\n");
  eia.code = tape_code::Code::eia;
  eia.eob = tape_code::Eob::cr_lf;
  PunchingControl control(eia, [](std::uint8_t) {});
  Time_ns now = 0;
  control.start(now);
  const std::string sent = run(control, now, 2'000 * kMs);
  EXPECT_NE(sent.find("\x0B\x80\x46\x13\x15\x80\x0B\x80"), std::string::npos) << "EIA has an EOB of its own";
  ControlSettings lines = settings_of("%\nO7\n");
  lines.eob = tape_code::Eob::cr_lf;
  PunchingControl other(lines, [](std::uint8_t) {});
  now = 0;
  other.start(now);
  EXPECT_NE(run(other, now, 2'000 * kMs).find("\xA5\x8D\n\xCF\xB7\x8D\n"), std::string::npos);
}

TEST(PunchingControl, KeepsThePaceOfItsLine) {
  PunchingControl control(settings_of(std::string(1000, 'A')), [](std::uint8_t) {});
  Time_ns now = 0;
  control.start(now);
  run(control, now, 300 * kMs + 500 * kChar);
  EXPECT_NEAR(static_cast<double>(control.punched()), 500.0, 3.0);
}

TEST(PunchingControl, StopsAtDc3AndGoesOnAtDc1) {
  PunchingControl control(settings_of(std::string(1000, 'A')), [](std::uint8_t) {});
  Time_ns now = 0;
  control.start(now);
  run(control, now, 500 * kMs);
  const std::byte dc3{0x93};
  const std::byte dc1{0x11};
  control.receive(std::span(&dc3, 1), now, now);
  const std::uint64_t at_hold = control.punched();
  EXPECT_EQ(run(control, now, 5'000 * kMs), "");
  EXPECT_EQ(control.punched(), at_hold);
  EXPECT_EQ(control.deadline(), std::nullopt);
  control.receive(std::span(&dc1, 1), now, now);
  const std::string rest = run(control, now, 10'000 * kMs);
  EXPECT_EQ(rest.size() + at_hold, 1000U + 42U);
  EXPECT_TRUE(control.finished());
}

TEST(PunchingControl, ReadsTheAnswerAfterwards) {
  std::string read;
  PunchingControl control(settings_of("%\n", "punch-read"),
                          [&](std::uint8_t byte) { read += static_cast<char>(byte); });
  Time_ns now = 0;
  control.start(now);
  const std::string sent = run(control, now, 3'000 * kMs);
  EXPECT_EQ(sent.back(), '\x11') << "it asks with DC1 once it has punched";
  EXPECT_EQ(control.state(), ControlState::reading);
  const std::string answer = "\xA5\nM\x33\x30\n\xA5";
  control.receive(std::as_bytes(std::span(answer)), now, now);
  run(control, now, 4'000 * kMs);
  EXPECT_EQ(read, answer);
  EXPECT_TRUE(control.finished());
}

}  // namespace
}  // namespace dripfeed::simulator
