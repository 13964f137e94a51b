// Sentences are found again with what they name; the longer of two, none by a part of it.
#include "server/json/sentences.h"

#include <set>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace dripfeed::json {
namespace {

using ::testing::ElementsAre;
using ::testing::Pair;

TEST(Sentences, AreFoundWithTheirValues) {
  const auto found = sentence_of("machine lathe was changed after verdict 17: check the text for it again");
  ASSERT_TRUE(found);
  EXPECT_EQ(found->id, "changed_after_verdict");
  EXPECT_THAT(found->values, ElementsAre(Pair("machine", "lathe"), Pair("verdict", "17")));
}

TEST(Sentences, KeepASentenceInAnother) {
  const auto found = sentence_of("lathe cannot be armed: the disk is full");
  ASSERT_TRUE(found);
  EXPECT_EQ(found->id, "cannot_arm");
  EXPECT_THAT(found->values, ElementsAre(Pair("machine", "lathe"), Pair("why", "the disk is full")));
  const auto inner = sentence_of(found->values[1].second);
  ASSERT_TRUE(inner);
  EXPECT_EQ(inner->id, "store_disk_full");
}

TEST(Sentences, HaveWhatTheStoreAdds) {
  const auto found = sentence_of("it does not exist (machine mill)");
  ASSERT_TRUE(found);
  EXPECT_EQ(found->id, "store_not_found");
  EXPECT_THAT(found->values, ElementsAre(Pair("detail", "machine mill")));
}

TEST(Sentences, DistinguishALongEndFromAShortOne) {
  const std::string reached =
      "link_lost: between wire byte 100 and 120 of 900 may have reached the control (line 5 to 6)";
  const auto whole = sentence_of(reached);
  ASSERT_TRUE(whole);
  EXPECT_EQ(whole->id, "reached_lines");
  const std::string broken = reached + "; a block is torn: reset the control and confirm it";
  const auto torn = sentence_of(broken);
  ASSERT_TRUE(torn);
  EXPECT_EQ(torn->id, "reached_torn_lines");
  EXPECT_THAT(torn->values, ElementsAre(Pair("cause", "link_lost"), Pair("from", "100"), Pair("to", "120"),
                                        Pair("total", "900"), Pair("first", "5"), Pair("last", "6")));
}

TEST(Sentences, OfOthersHaveNone) {
  EXPECT_FALSE(sentence_of(""));
  EXPECT_FALSE(sentence_of("No such file or directory"));
  EXPECT_FALSE(sentence_of("the disk is full of cats"));
  EXPECT_FALSE(sentence_of("lathe cannot be armed: "));
}

TEST(Sentences, HaveIdsOfTheirOwn) {
  const auto ids = sentence_ids();
  EXPECT_GT(ids.size(), 90U);
  EXPECT_EQ(std::set(ids.begin(), ids.end()).size(), ids.size());
}

}  // namespace
}  // namespace dripfeed::json
