// The budget rule with its sum, the other refusals, and the time of a character.
#include "protocol/feed/settings.h"

#include <gtest/gtest.h>

namespace dripfeed::feed {
namespace {

using namespace std::chrono_literals;

SettingsFault fault(const Settings& settings) {
  const auto valid = validate(settings);
  EXPECT_FALSE(valid);
  return valid ? SettingsFault::baud : valid.error().fault;
}

TEST(Settings, TheDefaultsKeepTheBudgetOfTen) { EXPECT_TRUE(validate(Settings{})); }

TEST(Settings, TheSumOfTheBudgetIsKeptAndShown) {
  Settings settings;
  settings.unsent = 4;
  settings.latency_chars = 6;
  EXPECT_TRUE(validate(settings));
  settings.latency_chars = 14;
  const auto valid = validate(settings);
  ASSERT_FALSE(valid);
  EXPECT_EQ(valid.error().fault, SettingsFault::budget);
  EXPECT_EQ(message(valid.error()), "4 unsent + 14 latency = 18 characters, more than the overrun budget of 10");
  settings.latency_chars = UINT32_MAX;
  EXPECT_EQ(fault(settings), SettingsFault::budget);
}

TEST(Settings, RefusesTheRestByName) {
  Settings settings;
  settings.baud = 0;
  EXPECT_EQ(fault(settings), SettingsFault::baud);
  settings = {};
  settings.unsent = 0;
  EXPECT_EQ(fault(settings), SettingsFault::unsent);
  settings = {};
  settings.unsent = kMaxUnsent + 1;
  settings.overrun_budget = 1000;
  EXPECT_EQ(fault(settings), SettingsFault::unsent);
  settings = {};
  settings.framing.data_bits = 5;
  EXPECT_EQ(fault(settings), SettingsFault::framing);
  settings = {};
  settings.end = {.dc3 = false};
  EXPECT_EQ(fault(settings), SettingsFault::no_end_sign);
  settings.end = {.dc3 = false, .quiet = 1s};
  EXPECT_TRUE(validate(settings));
  for (const int eot : {0x00, 0x11, 0x13, 0x15, 0x16, 0x84}) {
    settings.end.eot = static_cast<std::uint8_t>(eot);
    EXPECT_EQ(fault(settings), SettingsFault::eot_code) << eot;
  }
  settings.end.eot = 0x1A;
  EXPECT_TRUE(validate(settings));
  settings.wire.trailer_chars = kMaxFillers + 1;
  EXPECT_EQ(fault(settings), SettingsFault::fillers);
}

TEST(Settings, WhatIsSwallowedBelowStartsAndEndsNothing) {
  for (const XoffBy by : {XoffBy::kernel, XoffBy::device}) {
    Settings settings;
    settings.xoff_by = by;
    settings.end = {.dc3 = true, .quiet = 1s};
    EXPECT_EQ(fault(settings), SettingsFault::start_unseen);
    EXPECT_NE(message(validate(settings).error()).find("a start by DC1 would never be seen"), std::string::npos);
    settings.start = Start::at_once;
    EXPECT_TRUE(validate(settings));
    settings.end = {.dc3 = true};
    EXPECT_EQ(fault(settings), SettingsFault::no_end_sign) << "the DC3 at the end is swallowed, too";
  }
}

TEST(Settings, FlowCharactersTriggersAndDelaysHaveTheirLimits) {
  Settings settings;
  settings.flow_characters = {.xon = 0x0E, .xoff = 0x0F};
  EXPECT_TRUE(validate(settings));
  for (const int xoff : {0x0E, 0x00, 0x12, 0x14, 0x15, 0x16, 0x93}) {
    settings.flow_characters.xoff = static_cast<std::uint8_t>(xoff);
    EXPECT_EQ(fault(settings), SettingsFault::flow_characters) << xoff;
  }
  settings = {};
  settings.end.eot = 0x0F;
  settings.flow_characters = {.xon = 0x0E, .xoff = 0x0F};
  EXPECT_EQ(fault(settings), SettingsFault::eot_code);
  settings = {};
  settings.start = Start::on_trigger;
  for (const std::string& text : {std::string(), std::string(33, 'A'), std::string("A\x11"), std::string("\xC3\xA4")}) {
    settings.trigger = text;
    EXPECT_EQ(fault(settings), SettingsFault::trigger) << text;
  }
  settings.trigger = std::string(32, 'A');
  EXPECT_TRUE(validate(settings));
  settings.line_delay = 61s;
  EXPECT_EQ(fault(settings), SettingsFault::delay);
  settings.line_delay = 60s;
  settings.char_delay = -1ns;
  EXPECT_EQ(fault(settings), SettingsFault::delay);
  settings.char_delay = 1s;
  EXPECT_TRUE(validate(settings));
  settings.flow = Flow::dtrdsr;
  EXPECT_TRUE(validate(settings));
  settings.watch_dsr = true;
  EXPECT_EQ(fault(settings), SettingsFault::dsr_twice);
}

TEST(Settings, ADelayMakesACharacterLongerAndLeavesOneBelow) {
  Settings settings;
  settings.char_delay = 5ms;
  EXPECT_EQ(char_time(settings), 1145834ns + 5ms);
  EXPECT_EQ(burst(settings), 1U);
  settings.char_delay = {};
  EXPECT_EQ(burst(settings), settings.unsent);
}

TEST(Settings, TimeOfACharacter) {
  Settings settings;
  EXPECT_EQ(char_time(settings), 1145834ns);  // 11 bits at 9600
  settings.blind = true;
  EXPECT_NEAR(static_cast<double>(char_time(settings).count()), 1145834 / 0.98, 2);
  EXPECT_EQ(latency_in_chars(16ms, settings.framing, 9600), 14U);  // an FTDI's timer
  EXPECT_EQ(latency_in_chars(0ms, settings.framing, 9600), 0U);
  EXPECT_EQ(latency_in_chars(1ns, settings.framing, 9600), 1U);
  EXPECT_EQ(latency_in_chars(24h, settings.framing, 115200), kMaxBudget);
}

}  // namespace
}  // namespace dripfeed::feed
