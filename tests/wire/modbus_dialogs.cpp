// Every dialog of tests/wire/modbus, and every cell of the sender's table that can be taken is taken by one of them.
#include <gtest/gtest.h>

#include "tests/wire/modbus_player.h"

namespace dripfeed::wire {
namespace {

using modbus::SenderInput;
using modbus::SenderState;

TEST(ModbusDialogs, Play) {
  const std::vector<Dialog> dialogs = load_dialogs("modbus");
  ASSERT_FALSE(dialogs.empty());
  for (const Dialog& dialog : dialogs) EXPECT_EQ(ModbusPlayer(nullptr).play(dialog), "") << dialog.name;
}

TEST(ModbusDialogs, TakeEveryCellOfTheTable) {
  std::set<SenderCellTaken> cells;
  for (const Dialog& dialog : load_dialogs("modbus")) ModbusPlayer(&cells).play(dialog);
  for (std::size_t state = 0; state < modbus::kSenderStates; ++state) {
    for (std::size_t input = 0; input < modbus::kSenderInputs; ++input) {
      const SenderCellTaken one{static_cast<SenderState>(state), static_cast<SenderInput>(input)};
      const bool never = modbus::cell(one.first, one.second).action == modbus::SenderAction::never;
      EXPECT_EQ(cells.contains(one), !never)
          << name(one.first) << " + " << name(one.second) << (never ? " must never be" : " is not taken");
    }
  }
}

}  // namespace
}  // namespace dripfeed::wire
