// The machine's words: their registers, and the probe that finds out whether a PLC has them.
#include "protocol/modbus/machine_words.h"

#include <gtest/gtest.h>

namespace dripfeed::modbus {
namespace {

constexpr MachineWords kWords{.state = MachineState::alarm,
                              .program = 70'042,
                              .line = 65'537,
                              .alarm = 700'016,
                              .bell = 9,
                              .request = 2,
                              .requested = 131'073};

TEST(MachineWords, ComeBackAsTheyWereWritten) {
  MachineImage image{};
  encode(kWords, image);
  EXPECT_EQ(image[0], 0xDF03);
  EXPECT_EQ(image[2], 1) << "the high word first";
  const auto words = decode_machine(image);
  ASSERT_TRUE(words);
  EXPECT_EQ(*words, kWords);
  EXPECT_EQ(name(words->state), "alarm");
}

TEST(MachineWords, AnyWrongRegisterIsSeen) {
  MachineImage image{};
  encode(kWords, image);
  for (std::size_t i = 0; i < image.size(); ++i) {
    MachineImage wrong = image;
    wrong[i] ^= 0x0100;
    const auto words = decode_machine(wrong);
    ASSERT_FALSE(words) << "register " << i;
    EXPECT_EQ(words.error(), i == 0 ? MachineFault::absent : MachineFault::garbled);
  }
  EXPECT_EQ(decode_machine(MachineImage{}).error(), MachineFault::absent);
  EXPECT_EQ(decode_machine(std::span<const std::uint16_t>(image).first(13)).error(), MachineFault::absent);
}

TEST(MachineWords, AStateOfALaterMapIsUnknown) {
  MachineImage image{};
  encode({.state = static_cast<MachineState>(99), .alarm = 5}, image);
  const auto words = decode_machine(image);
  ASSERT_TRUE(words);
  EXPECT_EQ(words->state, MachineState::unknown);
  EXPECT_EQ(words->alarm, 5U);
}

// How many registers the probe asks for after ten answers or failures.
std::size_t registers_after_ten(WordsProbe& probe, bool answers_long) {
  for (int i = 0; i < 10; ++i) {
    if (probe.registers() == kStatusRegisters || answers_long) {
      probe.answered();
    } else {
      probe.failed();
    }
  }
  return probe.registers();
}

TEST(WordsProbe, FindsOutWhatIsThere) {
  WordsProbe with;
  EXPECT_FALSE(with.proved());
  EXPECT_EQ(registers_after_ten(with, true), kStatusAndMachine);
  EXPECT_TRUE(with.proved());
  WordsProbe without;
  EXPECT_EQ(registers_after_ten(without, false), kStatusRegisters);
  EXPECT_FALSE(without.proved());
  without.ask_again();
  EXPECT_EQ(without.registers(), kStatusAndMachine);
  EXPECT_EQ(registers_after_ten(without, false), kStatusRegisters);
  without.ask_again();
  EXPECT_EQ(registers_after_ten(without, true), kStatusAndMachine) << "they came later";
}

TEST(WordsProbe, FailuresOfAnotherKindHideNothing) {
  WordsProbe probe;
  for (int i = 0; i < 7; ++i) probe.failed();  // no one is there yet
  EXPECT_EQ(registers_after_ten(probe, true), kStatusAndMachine);
  probe.failed();
  EXPECT_EQ(probe.registers(), kStatusAndMachine) << "one lost answer";
  for (int i = 0; i < 6; ++i) probe.failed();
  EXPECT_FALSE(probe.proved());
  EXPECT_EQ(registers_after_ten(probe, false), kStatusRegisters) << "another PLC in its place";
}

}  // namespace
}  // namespace dripfeed::modbus
