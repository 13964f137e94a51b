// Every dialog of tests/wire/packet, played whole, byte by byte and at random splits; and every cell of both tables
// that can be taken is taken by one of them.
#include <gtest/gtest.h>

#include "tests/wire/packet_player.h"

namespace dripfeed::wire {
namespace {

const std::vector<Dialog>& dialogs() {
  static const std::vector<Dialog> all = load_dialogs("packet");
  return all;
}

TEST(PacketDialogs, PlayWhole) {
  ASSERT_FALSE(dialogs().empty());
  for (const Dialog& dialog : dialogs())
    EXPECT_EQ(PacketPlayer(Splits::whole, 0, nullptr).play(dialog), "") << dialog.name;
}

TEST(PacketDialogs, PlayByteByByte) {
  for (const Dialog& dialog : dialogs())
    EXPECT_EQ(PacketPlayer(Splits::single_bytes, 0, nullptr).play(dialog), "") << dialog.name;
}

TEST(PacketDialogs, PlayAtRandomSplits) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    for (const Dialog& dialog : dialogs())
      EXPECT_EQ(PacketPlayer(Splits::random, seed, nullptr).play(dialog), "") << dialog.name << " seed " << seed;
  }
}

TEST(PacketDialogs, TakeEveryCellOfTheSendersTable) {
  PacketCells cells;
  for (const Dialog& dialog : dialogs()) PacketPlayer(Splits::whole, 0, &cells).play(dialog);
  for (std::size_t state = 0; state < packet::kStates; ++state) {
    for (std::size_t input = 0; input < packet::kInputs; ++input) {
      const std::pair one{static_cast<packet::State>(state), static_cast<packet::Input>(input)};
      const bool never = packet::cell(one.first, one.second).action == packet::Action::never;
      EXPECT_EQ(cells.sender.contains(one), !never)
          << name(one.first) << " + " << name(one.second) << (never ? " must never be" : " is not taken");
    }
  }
}

TEST(PacketDialogs, TakeEveryCellOfTheReceiversTable) {
  PacketCells cells;
  for (const Dialog& dialog : dialogs()) PacketPlayer(Splits::whole, 0, &cells).play(dialog);
  for (std::size_t state = 0; state < packet::kReceiveStates; ++state) {
    for (std::size_t input = 0; input < packet::kReceiveInputs; ++input) {
      const std::pair one{static_cast<packet::ReceiveState>(state), static_cast<packet::ReceiveInput>(input)};
      const bool never = packet::cell(one.first, one.second).action == packet::ReceiveAction::never;
      EXPECT_EQ(cells.receiver.contains(one), !never)
          << name(one.first) << " + " << name(one.second) << (never ? " must never be" : " is not taken");
    }
  }
}

}  // namespace
}  // namespace dripfeed::wire
