// Seeded scenarios in virtual time: punches by the controls' methods over lines that split, lose, flip and cut.
// Whatever happens, what is called whole is the text that was punched.
#include <gtest/gtest.h>

#include "protocol/tape_code/code_table.h"
#include "protocol/tape_code/parity.h"
#include "tests/wire/receive_player.h"

namespace dripfeed::wire {
namespace {

using receive::Time;

struct Scenario {
  std::string text;
  std::vector<std::byte> wire;
};

std::string program(std::mt19937& random) {
  std::string text = "%\nO" + std::to_string(1 + random() % 9998) + "\n";
  for (std::size_t i = 0, blocks = 1 + random() % 60; i < blocks; ++i) {
    text += "N" + std::to_string(i) + "G1X" + std::to_string(random() % 1000) + ".Z-" + std::to_string(random() % 90) +
            ".5\n";
  }
  return text + "M30\n%\n";
}

Scenario punch(std::mt19937& random) {
  Scenario scenario{.text = program(random), .wire = {}};
  const auto put = [&](std::uint8_t byte) { scenario.wire.push_back(static_cast<std::byte>(byte)); };
  const bool signs = random() % 2 == 0;
  if (signs) put(0x12);
  for (std::size_t i = random() % 40; i > 0; --i) put(0x00);
  for (const char c : scenario.text) {
    if (c == '\n' && random() % 2 == 0) put(0x8D);
    put(tape_code::with_parity(static_cast<std::uint8_t>(c), tape_code::EighthBit::even));
  }
  for (std::size_t i = random() % 40; i > 0; --i) put(0x00);
  if (signs) put(0x14);
  return scenario;
}

// The same punch in a code that the line does not know of.
Scenario punch_in(std::mt19937& random, receive::TextCode code) {
  Scenario scenario{.text = program(random), .wire = {}};
  const bool eia = code == receive::TextCode::eia;
  const auto eighth = code == receive::TextCode::iso ? tape_code::EighthBit::even : tape_code::EighthBit::data;
  const tape_code::EncodeTable table(eighth, eia ? std::optional(tape_code::EiaSpecials{}) : std::nullopt);
  const auto put = [&](std::uint8_t byte) { scenario.wire.push_back(static_cast<std::byte>(byte)); };
  const bool signs = random() % 2 == 0;
  if (signs) put(0x12);
  for (std::size_t i = random() % 40; i > 0; --i) put(0x00);
  for (const char c : scenario.text) put(table.code(c));
  for (std::size_t i = random() % 40; i > 0; --i) put(0x00);
  if (signs) put(0x14);
  return scenario;
}

// Gives the bytes in pieces with pauses that no quiet time reaches, then silence.
std::deque<ReceiveDriver::Got> receive_all(std::mt19937& random, std::span<const std::byte> wire,
                                           const receive::Settings& settings = {}) {
  ReceiveDriver driver(settings);
  Time now{1'000'000'000};
  while (!wire.empty()) {
    const std::size_t size = std::min<std::size_t>(wire.size(), 1 + random() % 700);
    driver.give(wire.first(size), now);
    wire = wire.subspan(size);
    now += std::chrono::milliseconds(random() % 400);
    driver.receiver.tick(now);
    driver.take();
  }
  driver.receiver.tick(now + std::chrono::seconds(30));
  driver.take();
  EXPECT_EQ(driver.receiver.state(), receive::State::idle);
  return driver.got;
}

TEST(ReceiveScenarios, AWholePunchIsItsTextHoweverItIsSplit) {
  for (unsigned seed = 1; seed <= 300; ++seed) {
    std::mt19937 random(seed);
    const Scenario scenario = punch(random);
    const auto got = receive_all(random, scenario.wire);
    ASSERT_EQ(got.size(), 1U) << seed;
    EXPECT_EQ(got[0].transfer.fault, receive::Fault::none) << seed;
    EXPECT_EQ(got[0].transfer.text, scenario.text) << seed;
  }
}

TEST(ReceiveScenarios, TheCodeIsFoundHoweverThePunchIsSplit) {
  using receive::TextCode;
  for (const auto line : {tape_code::EighthBit::even, tape_code::EighthBit::data}) {
    const receive::Settings settings{.eighth_bit = line, .find_code = true, .end_character = 0x04};
    for (unsigned seed = 1; seed <= 300; ++seed) {
      std::mt19937 random(seed);
      const auto code = static_cast<TextCode>(seed % 3);
      const Scenario scenario = punch_in(random, code);
      const auto got = receive_all(random, scenario.wire, settings);
      ASSERT_EQ(got.size(), 1U) << seed;
      EXPECT_EQ(got[0].transfer.code, code) << seed;
      EXPECT_EQ(got[0].transfer.fault, receive::Fault::none) << seed;
      EXPECT_EQ(got[0].transfer.text, scenario.text) << seed;
    }
  }
}

// A reading that was damaged may be quarantined or lost, never taken for a program that was not punched.
TEST(ReceiveScenarios, ACutPunchIsNeverWhole) {
  for (unsigned seed = 1; seed <= 600; ++seed) {
    std::mt19937 random(seed);
    Scenario scenario = punch(random);
    // The last '%' is in the last quarter of a whole punch: cut before it.
    const auto last = std::find(scenario.wire.rbegin(), scenario.wire.rend(), std::byte{0xA5});
    const auto before = static_cast<std::size_t>(scenario.wire.rend() - last) - 1;
    scenario.wire.resize(random() % before);
    for (const auto& got : receive_all(random, scenario.wire)) {
      EXPECT_NE(got.transfer.fault, receive::Fault::none) << seed << "\n" << got.transfer.text;
    }
  }
}

TEST(ReceiveScenarios, AFlippedBitIsSeen) {
  for (unsigned seed = 1; seed <= 600; ++seed) {
    std::mt19937 random(seed);
    Scenario scenario = punch(random);
    std::byte& byte = scenario.wire[random() % scenario.wire.size()];
    byte ^= static_cast<std::byte>(1U << (random() % 8));
    for (const auto& got : receive_all(random, scenario.wire)) {
      if (got.transfer.fault != receive::Fault::none) continue;
      // Whole in spite of it: a flip in leader, trailer or a sign outside the text.
      EXPECT_EQ(got.transfer.text, scenario.text) << seed;
    }
  }
}

// Lost characters inside the text cannot be seen without a checksum; the end and the beginning can.
TEST(ReceiveScenarios, ALostEndOrBeginningIsSeen) {
  for (unsigned seed = 1; seed <= 300; ++seed) {
    std::mt19937 random(seed);
    Scenario scenario = punch(random);
    const auto percent =
        seed % 2 == 0 ? std::find(scenario.wire.begin(), scenario.wire.end(), std::byte{0xA5})
                      : std::prev(std::find(scenario.wire.rbegin(), scenario.wire.rend(), std::byte{0xA5}).base());
    scenario.wire.erase(percent);
    for (const auto& got : receive_all(random, scenario.wire)) {
      EXPECT_NE(got.transfer.fault, receive::Fault::none) << seed << "\n" << got.transfer.text;
    }
  }
}

}  // namespace
}  // namespace dripfeed::wire
