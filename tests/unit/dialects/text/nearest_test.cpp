// Which word a misspelled one means: few changes count, many do not.
#include "dialects/text/nearest.h"

#include <array>
#include <string_view>

#include <gtest/gtest.h>

namespace dripfeed::text {
namespace {

TEST(EditDistance, CountsLettersThatArePutInLeftOutOrReplaced) {
  EXPECT_EQ(edit_distance("peck", "peck"), 0U);
  EXPECT_EQ(edit_distance("peck", "pecks"), 1U);
  EXPECT_EQ(edit_distance("peck", "eck"), 1U);
  EXPECT_EQ(edit_distance("peck", "pack"), 1U);
  EXPECT_EQ(edit_distance("", "abc"), 3U);
}

TEST(NearestOf, TakesTheFewestChangesAndNothingThatIsFar) {
  constexpr auto kWords = std::to_array<std::string_view>({"missing-end", "missing-bracket", "no-feed"});
  EXPECT_EQ(nearest_of("mising-end", kWords), "missing-end");
  EXPECT_EQ(nearest_of("no-fed", kWords), "no-feed");
  EXPECT_EQ(nearest_of("elephant", kWords), "");
}

}  // namespace
}  // namespace dripfeed::text
