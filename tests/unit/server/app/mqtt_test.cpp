// Topics: what people call their machines and areas, as levels.
#include "server/app/mqtt.h"

#include <gtest/gtest.h>

#include "server/app/out/topics.h"

namespace dripfeed::app {
namespace {

TEST(Mqtt, NamesAndPrefixesAreLevelsOfTopics) {
  EXPECT_EQ(topic_level("mill 3"), "mill 3");
  EXPECT_EQ(topic_level("a/b+c#d%e$\n"), "a%2Fb%2Bc%23d%25e%24%0A");
  EXPECT_EQ(why_no_prefix("plant/hall-2"), "");
  for (const char* const bad : {"", "/a", "a/", "a//b", "a/+", "#", "$SYS", "a\nb"})
    EXPECT_NE(why_no_prefix(bad), "") << bad;
}

}  // namespace
}  // namespace dripfeed::app
