// What is kept, how long, and how much of it.
#include "server/http/kept_answers.h"

#include <string>

#include <gtest/gtest.h>

namespace dripfeed::http {
namespace {

Response with_body(std::string body) {
  Response response;
  response.body = std::move(body);
  response.headers.emplace_back("ETag", "\"3\"");
  return response;
}

TEST(KeptAnswers, AnAnswerIsGivenAgainWholeToTheSameTargetAndVersionOnly) {
  KeptAnswers kept;
  kept.keep(5, "/a?x=1", with_body("one"));
  const auto again = kept.find(5, "/a?x=1");
  ASSERT_TRUE(again);
  EXPECT_EQ(again->body, "one");
  EXPECT_EQ(again->headers, with_body("").headers);
  EXPECT_FALSE(kept.find(5, "/a?x=2"));
  EXPECT_FALSE(kept.find(6, "/a?x=1"));
  EXPECT_FALSE(kept.find(5, "/a?x=1")) << "an older version brings nothing back";
}

TEST(KeptAnswers, AnAnswerOfAnotherVersionDropsTheOnesBefore) {
  KeptAnswers kept;
  kept.keep(5, "/a", with_body("old"));
  kept.keep(6, "/b", with_body("new"));
  EXPECT_FALSE(kept.find(6, "/a"));
  EXPECT_EQ(kept.find(6, "/b").value().body, "new");
}

TEST(KeptAnswers, WhatIsRefusedLongOrStreamedIsNotKept) {
  KeptAnswers kept;
  Response refused = with_body("no");
  refused.status = 404;
  kept.keep(1, "/refused", refused);
  kept.keep(1, "/long", with_body(std::string(KeptAnswers::kLongest_bytes + 1, 'x')));
  Response streamed = with_body("");
  streamed.source = [](std::span<char>) { return 0; };
  kept.keep(1, "/streamed", streamed);
  for (const char* target : {"/refused", "/long", "/streamed"}) EXPECT_FALSE(kept.find(1, target)) << target;
}

TEST(KeptAnswers, OnlySoMuchIsKept) {
  KeptAnswers kept;
  const std::string body(KeptAnswers::kLongest_bytes, 'x');
  const std::size_t count = 2 * KeptAnswers::kAll_bytes / KeptAnswers::kLongest_bytes;
  std::size_t found = 0;
  for (std::size_t i = 0; i < count; ++i) kept.keep(1, std::to_string(i), with_body(body));
  for (std::size_t i = 0; i < count; ++i) found += kept.find(1, std::to_string(i)) ? 1U : 0U;
  EXPECT_GT(found, 0U);
  EXPECT_LT(found * KeptAnswers::kLongest_bytes, KeptAnswers::kAll_bytes);
  kept.keep(2, "next", with_body(body));
  EXPECT_TRUE(kept.find(2, "next")) << "there is room again";
}

}  // namespace
}  // namespace dripfeed::http
