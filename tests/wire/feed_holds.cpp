// Ten thousand holds at each rate and each kind of receiver: what came in after the control's stop, as a histogram,
// and how much of the line was used while nothing held it.
#include <algorithm>
#include <array>
#include <iostream>
#include <string>

#include <gtest/gtest.h>

#include "tests/wire/line_cases.h"

namespace dripfeed::wire {
namespace {

constexpr std::uint64_t kHolds = 10'000;

// Where the control's stop sign passes, and what its delay is at the most.
struct Receiver {
  const char* name;
  std::int64_t in_chars;  // of the receiver's time-out
  Time in_fixed;
  Time out;
  bool blind;
  double least_use;
};
constexpr std::array<Receiver, 4> kReceivers{{
    {"16550", 4, 0us, 0us, false, 0.99},
    {"ftdi", 0, 16ms, 1ms, false, 0.99},
    {"device server", 4, 2ms, 1ms, true, 0.97},
    {"ideal", 0, 0us, 0us, false, 0.99},
}};

struct Rate {
  std::uint32_t baud;
  const char* framing;
};
constexpr std::array<Rate, 3> kRates{{{9600, "7E2"}, {38'400, "8N1"}, {115'200, "8N1"}}};
constexpr Time kWakeDelay = 1ms;  // the links' grid

LineModel model_for(const Rate& rate, const Receiver& receiver) {
  LineModel model;
  feed::Settings& settings = model.settings;
  settings.framing = tape_code::parse_framing(rate.framing).value();
  settings.baud = rate.baud;
  settings.wire.eighth_bit = eighth_bit(settings.framing, tape_code::Code::ascii, tape_code::ParityBy::software);
  settings.blind = receiver.blind;
  const Time one(static_cast<std::int64_t>(settings.framing.bits_per_char() * 1e9 / rate.baud));
  model.max_in_delay = receiver.in_chars * one + receiver.in_fixed;
  model.max_out_delay = receiver.out;
  model.max_wake_delay = kWakeDelay;
  const Time delay = model.max_in_delay + model.max_out_delay;
  settings.latency_chars = 1 + feed::latency_in_chars(delay, settings.framing, rate.baud);
  // Half of what may lie below must last over a late wake.
  settings.unsent = std::max(4U, 2 * (1 + feed::latency_in_chars(kWakeDelay, settings.framing, rate.baud)));
  settings.overrun_budget = settings.unsent + settings.latency_chars;
  model.high_most = 120;
  model.true_rate = receiver.blind ? 0.995 : 1.0;
  return model;
}

class FeedHolds : public testing::Test {
 protected:
  static void expect_all_within(const LineModel& model, const std::string& where, double least_use) {
    std::array<std::uint64_t, 512> histogram{};
    std::uint64_t holds = 0;
    std::uint64_t worst = 0;
    double use = 1.0;
    for (unsigned seed = 1; holds < kHolds; ++seed) {
      std::mt19937 random(seed);
      const std::string text = random_program(random, 600);
      VirtualLine line(model, text, seed);
      line.run(3600s);
      // A control that drops its RTS with the last character is not distinguished from one that holds before it.
      const bool shut = model.by_lines && line.feed().stall() == feed::Stall::cts_off;
      ASSERT_TRUE(line.feed().state() == feed::State::done || shut) << where << " seed " << seed;
      worst = std::max(worst, line.worst_after_dc3);
      use = std::min(use, line.line_use());
      for (std::size_t i = 0; i < histogram.size(); ++i) {
        histogram[i] += line.after_dc3[i];
        holds += line.after_dc3[i];
      }
    }
    std::string shown;
    for (std::uint64_t i = 0; i <= worst; ++i) shown += " " + std::to_string(histogram[i]);
    std::cout << where << ": " << holds << " holds, budget " << model.settings.overrun_budget << ", after the stop 0.."
              << worst << ":" << shown << "; line use at least " << static_cast<int>(use * 1000) << " of 1000\n";
    EXPECT_LE(worst, model.settings.overrun_budget) << where;
    EXPECT_GE(worst * 10, std::uint64_t{7} * model.settings.overrun_budget) << where << ": the budget was not tried";
    EXPECT_GE(use, least_use) << where;
  }
};

TEST_F(FeedHolds, ByDc3StayInTheBudgetAtEachRate) {
  for (const Rate& rate : kRates) {
    for (const Receiver& receiver : kReceivers) {
      expect_all_within(model_for(rate, receiver), std::to_string(rate.baud) + " " + receiver.name, receiver.least_use);
    }
  }
}

TEST_F(FeedHolds, ByCtsStayInTheBudgetAtEachRate) {
  for (const Rate& rate : kRates) {
    LineModel model = by_lines(model_for(rate, kReceivers[0]));
    model.max_in_delay = 2ms;  // the driver's look at CTS
    model.settings.latency_chars = feed::latency_in_chars(2ms, model.settings.framing, rate.baud);
    model.settings.overrun_budget = model.settings.unsent + model.settings.latency_chars + 1;
    // What was on the line when CTS dropped counts as unsent: each hold costs up to the look's 2 ms.
    expect_all_within(model, std::to_string(rate.baud) + " CTS", 0.75);
  }
}

}  // namespace
}  // namespace dripfeed::wire
