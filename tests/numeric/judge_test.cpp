// Predictions against a machine that shares no code with them: it steps motion in 1 ms, and its accelerations and block
// times are not those of the profile. Two programs calibrate, six others are predicted.
#include <cmath>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "checks/timing/machine_fit.h"
#include "checks/timing/timing.h"
#include "dialects/compile/dialect/dialect.h"
#include "dialects/compile/dialect/execute.h"
#include "dialects/text/number.h"
#include "server/simulator/stepped_control.h"

namespace dripfeed {
namespace {

std::string number(double value) { return text::format_fixed(value, 3); }

// A program of straight moves: points, one a block.
class Program {
 public:
  explicit Program(double feed) : text_("%\nO1\nG21 G90 G94\nG0 X0. Y0. Z0.\n"), feed_(feed) {}
  Program& to(double x, double y, double z = 0) {
    text_ += fmt::format("{}X{} Y{} Z{}{}\n", first_ ? "G1 " : "", number(x), number(y), number(z),
                         first_ ? " F" + number(feed_) : "");
    first_ = false;
    return *this;
  }
  Program& rapid(double x, double y) {
    text_ += fmt::format("G0 X{} Y{}\n", number(x), number(y));
    first_ = true;
    return *this;
  }
  Program& dwell(int ms) {
    text_ += fmt::format("G4 P{}\n", ms);
    return *this;
  }
  [[nodiscard]] std::string text() const { return text_ + "M30\n%\n"; }

 private:
  std::string text_;
  double feed_;
  bool first_ = true;
};

std::string spiral(double feed, int count, double step) {
  Program program(feed);
  for (int i = 1; i <= count; ++i) {
    const double angle = 40.0 * std::sqrt(static_cast<double>(i) / count);
    const double radius = step * angle;
    program.to(radius * std::cos(angle), radius * std::sin(angle));
  }
  return program.text();
}
std::string zigzag(double feed, int count, double width) {
  Program program(feed);
  for (int i = 1; i <= count; ++i) program.to(i % 2 == 0 ? 0 : width, 0.5 * i, i % 3 == 0 ? -1 : 0);
  return program.text();
}
std::string wave(double feed, int count, double step) {
  Program program(feed);
  for (int i = 1; i <= count; ++i) program.to(step * i, 8 * std::sin(0.05 * i), 2 * std::sin(0.11 * i));
  return program.text();
}
std::string pockets(double feed) {
  Program program(feed);
  for (int k = 0; k < 12; ++k) {
    program.rapid(30 * k, 0).to(30 * k, 0, -2).dwell(100);
    for (int i = 0; i < 130; ++i) program.to(30 * k + 8 * std::cos(0.1 * i), 8 * std::sin(0.1 * i), -2);
    program.to(30 * k, 0, 2);
  }
  return program.text();
}

struct Shop {
  checks::Machine machine;
  ir::CostModel cost;
  double baud = 0;  // 0: memory

  [[nodiscard]] timing::Report predict(const std::string& text, const timing::MachineFactors& factors = {}) const {
    const compile::Dialect& dialect = *compile::find_dialect("fanuc");
    const ir::Control control = dialect.control(ir::MachineKind::mill, ir::GSystem::a);
    const text::Source source("program", text);
    const auto read = dialect.read(source, control);
    timing::Settings settings{.machine = machine, .cost = cost};
    for (auto& axis : settings.machine.axes) axis.acceleration_mm_s2 *= factors.acceleration;
    settings.cost.block_ms *= factors.compute;
    if (baud > 0) {
      settings.line = timing::Line{.baud = baud, .bits_per_char = 11, .latency_s = 0.005};
      std::uint32_t length = 0;
      for (const char c : text) {
        ++length;
        if (c == '\n') settings.line_bytes.push_back(std::exchange(length, 0));
      }
    }
    timing::Timing timing(settings);
    EXPECT_EQ(compile::execute(read.program, control, nullptr, timing, {}).ended, interpreter::Ended::end);
    return timing.finish();
  }
};

Shop nominal(double baud) {
  Shop shop;
  for (const ir::Axis axis : {ir::Axis::x, ir::Axis::y, ir::Axis::z})
    shop.machine.axes.push_back({.axis = axis, .rapid_mm_min = 18000, .acceleration_mm_s2 = 1500});
  shop.machine.timing.sample_time_ms = 4;
  shop.machine.timing.look_ahead_blocks = 50;
  shop.machine.buffer = {2048, 0};
  shop.cost = {.block_ms = 2.0, .origin = "a test"};
  shop.baud = baud;
  return shop;
}

simulator::SteppedSettings truth(double baud, double acceleration_factor, double block_factor) {
  simulator::SteppedSettings settings;
  settings.acceleration_mm_s2.fill(1500 * acceleration_factor);
  settings.rapid_mm_min.fill(18000);
  settings.corner_ms = 4;
  settings.block_ms = 2.0 * block_factor;
  settings.look_ahead = 50;
  settings.buffer_bytes = 2048;
  if (baud > 0) {
    settings.char_ms = 11e3 / baud;
    settings.first_char_ms = 5;
  }
  return settings;
}

// What waiting for blocks cost the judge: against the same machine that has the program in its memory and computes in
// no time.
double lost_s(const std::string& text, const simulator::SteppedSettings& settings,
              const simulator::SteppedReport& ran) {
  simulator::SteppedSettings memory = settings;
  memory.char_ms = 0;
  memory.block_ms = 0;
  const auto free = simulator::run_stepped(text, memory);
  return (ran.cycle_s - ran.first_move_s) - (free.cycle_s - free.first_move_s);
}

struct Case {
  const char* name;
  std::string text;
  double baud;
};

std::vector<Case> cases() {
  return {{"fine spiral, 115200", spiral(6000, 2000, 0.15), 115200},
          {"wave, 9600", wave(2400, 700, 0.4), 9600},
          {"spiral, 19200", spiral(3000, 1500, 0.4), 19200},
          {"pockets, 38400", pockets(1800), 38400},
          {"pockets, 4800", pockets(1800), 4800},
          {"long moves, 9600", zigzag(4000, 150, 30), 9600}};
}

TEST(Judge, PredictionsAreWithin5PercentOnceCalibrated) {
  double worst_before = 0;
  for (const auto& [acceleration, block] : {std::pair{0.8, 1.2}, std::pair{1.2, 0.8}, std::pair{0.85, 1.15}}) {
    const std::string slow_blocks = spiral(6000, 1500, 0.2);  // computing limits it
    const std::string corners = zigzag(5000, 200, 6);         // acceleration limits it
    std::vector<timing::MeasuredRun> runs;
    for (const std::string& text : {slow_blocks, corners}) {
      const auto measured = simulator::run_stepped(text, truth(0, acceleration, block));
      ASSERT_EQ(measured.fault, "");
      runs.push_back(
          {measured.cycle_s, [text](const timing::MachineFactors& f) { return nominal(0).predict(text, f).cycle_s; }});
    }
    const auto fit = timing::fit_machine(runs);
    ASSERT_TRUE(fit) << fit.error();
    fmt::print("true acceleration x{}, block time x{}; fitted x{}, x{}\n", text::format_fixed(acceleration, 2),
               text::format_fixed(block, 2), text::format_fixed(fit->factors.acceleration, 3),
               text::format_fixed(fit->factors.compute, 3));
    int starved = 0;
    for (const Case& one : cases()) {
      const auto settings = truth(one.baud, acceleration, block);
      const auto judged = simulator::run_stepped(one.text, settings);
      ASSERT_EQ(judged.fault, "") << one.name;
      const double judged_lost = lost_s(one.text, settings, judged);
      const auto before = nominal(one.baud).predict(one.text);
      const auto after = nominal(one.baud).predict(one.text, fit->factors);
      const auto share = [&](double value, double of) { return 100 * (value - of) / judged.cycle_s; };
      worst_before = std::max(worst_before, std::fabs(before.cycle_s - judged.cycle_s) / judged.cycle_s);
      starved += judged_lost > 0.05 * judged.cycle_s ? 1 : 0;
      fmt::print(
          "  {:<18} cycle {:>7} s: before {:>5} %, after {:>5} %; lost {:>6} s: {:>5} %, {:>5} %; first late at {:>6} "
          "s, told {:>6} s\n",
          one.name, text::format_fixed(judged.cycle_s, 2), text::format_fixed(share(before.cycle_s, judged.cycle_s), 1),
          text::format_fixed(share(after.cycle_s, judged.cycle_s), 1), text::format_fixed(judged_lost, 2),
          text::format_fixed(share(before.stall_s, judged_lost), 1),
          text::format_fixed(share(after.stall_s, judged_lost), 1), text::format_fixed(judged.first_late_s, 2),
          text::format_fixed(after.first_stall_at_s, 2));
      EXPECT_NEAR(after.cycle_s, judged.cycle_s, 0.05 * judged.cycle_s) << one.name;
      EXPECT_NEAR(after.stall_s, judged_lost, 0.05 * judged.cycle_s) << one.name;
      if (judged_lost > 0.05 * judged.cycle_s) {
        EXPECT_NEAR(after.first_stall_at_s, judged.first_late_s, 0.05 * judged.cycle_s) << one.name;
        EXPECT_NEAR(after.stall_s, judged_lost, 0.05 * judged_lost) << one.name;
      }
    }
    EXPECT_NEAR(fit->factors.acceleration, acceleration, 0.08);
    EXPECT_NEAR(fit->factors.compute, block, 0.05);
    EXPECT_GE(starved, 3);
  }
  EXPECT_GT(worst_before, 0.05);  // otherwise there was nothing to calibrate
}

TEST(Judge, TheAdviceCuresAStarvedProgram) {
  const std::string text = wave(2400, 700, 0.4);
  Shop shop = nominal(9600);
  const auto starved = simulator::run_stepped(text, truth(9600, 1, 1));
  const double lost = lost_s(text, truth(9600, 1, 1), starved);
  ASSERT_GT(lost, 0.2 * starved.cycle_s);
  double baud = 9600;
  while (shop.predict(text).stall_s > 0.001 * shop.predict(text).motion_s) shop.baud = baud *= 1.05;
  const auto cured = simulator::run_stepped(text, truth(baud, 1, 1));
  fmt::print("at 9600 baud {} s are lost; at {} baud {} s\n", text::format_fixed(lost, 2), text::format_fixed(baud, 0),
             text::format_fixed(lost_s(text, truth(baud, 1, 1), cured), 2));
  EXPECT_LT(lost_s(text, truth(baud, 1, 1), cured), 0.01 * cured.cycle_s);
}

}  // namespace
}  // namespace dripfeed
