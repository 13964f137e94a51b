// Answers of a system that is asked before an arming: one form allows, some refuse, all else says nothing.
#include <gtest/gtest.h>

#include "server/json/cloud_events.h"

namespace dripfeed::json {
namespace {

using Kind = app::HookAnswer::Kind;

TEST(ArmingHook, OneAnswerAllows) {
  EXPECT_EQ(read_hook_answer(200, R"({"allow": true})").kind, Kind::allowed);
  EXPECT_EQ(read_hook_answer(200, R"({"allow": true, "reason": "all is well"})").kind, Kind::allowed);
}

TEST(ArmingHook, ARefusalHasItsWords) {
  const auto why = [](std::uint32_t status, std::string_view body) {
    const app::HookAnswer answer = read_hook_answer(status, body);
    EXPECT_EQ(answer.kind, Kind::refused) << status << ' ' << body;
    return answer.why;
  };
  EXPECT_EQ(why(200, R"({"allow": false, "reason": "no material"})"), "no material");
  EXPECT_EQ(why(200, R"({"allow": false})"), "it gives no reason");
  EXPECT_EQ(why(409, R"({"detail": "blocked"})"), "blocked");
  EXPECT_EQ(why(409, R"({"allow": true, "detail": "blocked"})"), "blocked") << "its status says more";
  EXPECT_EQ(why(403, ""), "it gives no reason");
  EXPECT_EQ(why(422, R"({"detail": 5, "reason": ["x"]})"), "it gives no reason");
  EXPECT_EQ(why(409, R"({"reason": "bell \u0007"})"), "it gives no reason") << "not printable";
  EXPECT_EQ(why(409, "{\"reason\": \"" + std::string(300, 'x') + "\"}"), std::string(200, 'x'));
  EXPECT_EQ(why(409, "{\"reason\": \"" + std::string(199, 'x') + "ä\"}"), std::string(199, 'x')) << "no half character";
}

TEST(ArmingHook, AllElseIsNoAnswer) {
  for (const char* const body :
       {"", "yes", "true", "{}", R"({"allow": "true"})", R"({"allow": 1})", R"([{"allow": true}])"})
    EXPECT_EQ(read_hook_answer(200, body).kind, Kind::none) << body;
  for (const std::uint32_t status : {201U, 204U, 302U, 400U, 401U, 404U, 429U, 500U, 503U})
    EXPECT_EQ(read_hook_answer(status, R"({"allow": true})").kind, Kind::none) << status;
}

}  // namespace
}  // namespace dripfeed::json
