// Every dialog of tests/wire/feed, played whole, byte by byte and at random splits; and every row of the feed's
// transition table is taken by one of them.
#include <gtest/gtest.h>

#include "tests/wire/feed_player.h"

namespace dripfeed::wire {
namespace {

class FeedDialogs : public testing::Test {
 protected:
  static const std::vector<Dialog>& dialogs() {
    static const std::vector<Dialog> all = load_dialogs("feed");
    return all;
  }
};

TEST_F(FeedDialogs, PlayWhole) {
  ASSERT_FALSE(dialogs().empty());
  for (const Dialog& dialog : dialogs())
    EXPECT_EQ(FeedPlayer(Splits::whole, 0, nullptr).play(dialog), "") << dialog.name;
}

TEST_F(FeedDialogs, PlayByteByByte) {
  for (const Dialog& dialog : dialogs()) {
    EXPECT_EQ(FeedPlayer(Splits::single_bytes, 0, nullptr).play(dialog), "") << dialog.name;
  }
}

TEST_F(FeedDialogs, PlayAtRandomSplits) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    for (const Dialog& dialog : dialogs()) {
      EXPECT_EQ(FeedPlayer(Splits::random, seed, nullptr).play(dialog), "") << dialog.name << " seed " << seed;
    }
  }
}

TEST_F(FeedDialogs, TakeEveryRowOfTheTable) {
  std::set<std::size_t> rows;
  for (const Dialog& dialog : dialogs()) FeedPlayer(Splits::whole, 0, &rows).play(dialog);
  const auto reactions = feed::reactions();
  for (std::size_t i = 0; i < reactions.size(); ++i) {
    EXPECT_TRUE(rows.contains(i)) << "no dialog takes " << name(reactions[i].from) << " + " << name(reactions[i].input)
                                  << " (" << name(reactions[i].guard) << ")";
  }
  const auto progress = feed::progress();
  for (std::size_t i = 0; i < progress.size(); ++i) {
    EXPECT_TRUE(rows.contains(reactions.size() + i))
        << "no dialog takes " << name(progress[i].from) << " when " << name(progress[i].condition);
  }
}

}  // namespace
}  // namespace dripfeed::wire
