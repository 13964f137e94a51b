// Every dialog of tests/wire/receive, played whole, byte by byte and at random splits; and every row of the table is
// taken by one of them.
#include <gtest/gtest.h>

#include "tests/wire/receive_player.h"

namespace dripfeed::wire {
namespace {

const std::vector<Dialog>& dialogs() {
  static const std::vector<Dialog> all = load_dialogs("receive");
  return all;
}

TEST(ReceiveDialogs, PlayWholeByteByByteAndAtRandomSplits) {
  ASSERT_FALSE(dialogs().empty());
  for (const Dialog& dialog : dialogs()) {
    EXPECT_EQ(ReceivePlayer(Cuts::whole, 0, nullptr).play(dialog), "") << dialog.name;
    EXPECT_EQ(ReceivePlayer(Cuts::single_bytes, 0, nullptr).play(dialog), "") << dialog.name;
    for (unsigned seed = 1; seed <= 20; ++seed) {
      EXPECT_EQ(ReceivePlayer(Cuts::random, seed, nullptr).play(dialog), "") << dialog.name << " seed " << seed;
    }
  }
}

TEST(ReceiveDialogs, TakeEveryRowOfTheTable) {
  std::set<std::size_t> rows;
  for (const Dialog& dialog : dialogs()) ReceivePlayer(Cuts::whole, 0, &rows).play(dialog);
  const auto reactions = receive::reactions();
  for (std::size_t i = 0; i < reactions.size(); ++i) {
    EXPECT_TRUE(rows.contains(i)) << "no dialog takes " << name(reactions[i].from) << " + " << name(reactions[i].input)
                                  << " (" << name(reactions[i].guard) << ")";
  }
  const auto progress = receive::progress();
  for (std::size_t i = 0; i < progress.size(); ++i) {
    EXPECT_TRUE(rows.contains(reactions.size() + i))
        << "no dialog takes " << name(progress[i].from) << " when " << name(progress[i].condition);
  }
}

// One row for each state, input and guard, and no state without an answer.
TEST(ReceiveTable, AnswersEverythingOnce) {
  for (std::size_t s = 0; s < receive::kStates; ++s) {
    for (std::size_t i = 0; i < receive::kInputs; ++i) {
      std::size_t always = 0;
      std::size_t split = 0;
      for (const receive::Reaction& row : receive::reactions()) {
        if (row.from != static_cast<receive::State>(s) || row.input != static_cast<receive::Input>(i)) continue;
        (row.guard == receive::Guard::always ? always : split) += 1;
      }
      EXPECT_TRUE((always == 1 && split == 0) || (always == 0 && split == 2)) << s << " " << i;
    }
  }
}

}  // namespace
}  // namespace dripfeed::wire
