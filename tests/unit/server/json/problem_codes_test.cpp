// Codes of problems: one by the sentence, one by a sentence inside it, the plain one of a status for all others.
#include "server/json/problem_codes.h"

#include <algorithm>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "server/json/sentences.h"

namespace dripfeed::json {
namespace {

TEST(ProblemCodes, ComeFromTheSentenceOrTheStatus) {
  EXPECT_EQ(
      problem_code({app::ErrorCode::refused, "the newest verdict of the text does not clear it (verdict 3)", {}}).code,
      "verdict_not_passed");
  EXPECT_EQ(problem_code({app::ErrorCode::refused, "lathe cannot be armed: a job is on the line", {}}).code,
            "machine_busy");
  EXPECT_EQ(problem_code({app::ErrorCode::refused, "no sentence of the table", {}}).code, "refused");
  EXPECT_EQ(problem_code({app::ErrorCode::exists, "part P is there", {}}).code, "exists");
  EXPECT_EQ(problem_code(413, "the body is too long for this path").code, "too_large");
  EXPECT_EQ(problem_code(503, "too many requests of this kind are waiting: send this one again").code, "overloaded");
}

// A full disk that made a request fail inside the server is not one that is asked for again.
TEST(ProblemCodes, HaveTheStatusOfTheAnswer) {
  EXPECT_EQ(problem_code(500, "the disk is full").code, "internal");
  EXPECT_EQ(problem_code(599, "whatever").code, "internal");
  for (unsigned status = 400; status < 600; ++status) {
    const ProblemCode& found = problem_code(status, "");
    EXPECT_TRUE(found.status == status || found.code == "internal") << status;
  }
}

TEST(ProblemCodes, NameSentencesThatAreThereOnce) {
  const auto known = sentence_ids();
  std::set<std::string_view> codes;
  std::set<std::string> used;
  unsigned status = 0;
  for (const ProblemCode& row : problem_codes()) {
    EXPECT_TRUE(codes.insert(row.code).second) << row.code;
    EXPECT_GE(row.status, status) << row.code << " stands out of order";
    status = row.status;
    std::string_view words = row.sentences;
    while (!words.empty()) {
      const std::size_t end = words.find(' ');
      const std::string_view id = words.substr(0, end);
      EXPECT_TRUE(std::ranges::count(known, id) == 1) << id;
      EXPECT_TRUE(used.emplace(id).second) << id << " has two codes";
      words.remove_prefix(end == std::string_view::npos ? words.size() : end + 1);
    }
  }
}

TEST(ProblemCodes, SayWhenToAskAgain) {
  for (const ProblemCode& row : problem_codes())
    EXPECT_EQ(row.retry_s != 0, row.status == 429 || row.status == 503) << row.code;
}

}  // namespace
}  // namespace dripfeed::json
