// Answers as programs, and how two texts differ.
#include "server/app/receive/answers.h"

#include <gtest/gtest.h>

#include "server/app/base/text_difference.h"

namespace dripfeed::app {
namespace {

machine::Profile profile_of(const char* dialect, const char* set) {
  machine::Profile profile;
  profile.control.dialect = dialect;
  profile.line.character_set = set;
  return profile;
}

TEST(Answers, AreProgramsOfComments) {
  EXPECT_EQ(answer_program(profile_of("fanuc", "fanuc-iso"), {"Not found 1234"}), "%\nO9999(NOT FOUND 1234)\nM30\n%\n");
  EXPECT_EQ(answer_program(profile_of("sinumerik-840d", "sinumerik"), {"NOT FOUND X"}),
            "%_N_DRIPFEED_MPF\n;$PATH=/_N_MPF_DIR\n;NOT FOUND X\nM30\n");
}

TEST(Answers, HoldNoSignThatAControlWouldTakeForAnother) {
  const std::string text = answer_program(profile_of("fanuc", "iso-core"), {"a)b(c%d;e\nf_g!"});
  EXPECT_EQ(text, "%\nO9999(A.B.C.D.E.F.G.)\nM30\n%\n");
}

TEST(Answers, HoldNoCharacterThatTheCodeOfTheLineDoesNotHave) {
  machine::Profile profile = profile_of("fanuc", "ascii");
  profile.line.code = tape_code::Code::eia;
  profile.line.receive.answer_number = 17;
  EXPECT_EQ(answer_program(profile, {"a=b #1"}), "%\nO0017(A.B .1)\nM30\n%\n");
}

TEST(Answers, KeepTheBlockLength) {
  machine::Profile profile = profile_of("fanuc", "fanuc-iso");
  profile.control.block_length_bytes = 32;
  const std::string text = answer_program(profile, {std::string(200, 'A') + " " + std::string(20, 'B')});
  std::size_t begin = 0;
  while (begin < text.size()) {
    const std::size_t end = text.find('\n', begin);
    EXPECT_LE(end - begin, 32U);
    begin = end + 1;
  }
}

TEST(Answers, MayBeFed) {
  for (const char* dialect : {"fanuc", "mazak", "mitsubishi-m80", "sinumerik-840d"}) {
    const machine::Profile profile = profile_of(dialect, "ascii");
    feed::ProgramCheck check(answer_syntax(profile));
    check.append(answer_program(profile, {"3 PROGRAMS", "O1 LOAD"}));
    EXPECT_TRUE(check.finish()) << dialect;
  }
}

TEST(TextDifference, LeavesOutEobsLeaderAndPercents) {
  EXPECT_FALSE(first_difference("%\nO1\nG0X1.\nM30\n%\n", "%\r\nO1\r\nG0X1.\r\n\r\nM30\r\n%"));
  EXPECT_FALSE(first_difference("%\nO1\n%\n", std::string("\0\0\0%\nO1\n%\n\0", 12)));
}

TEST(TextDifference, NamesTheFirstPlace) {
  const auto found = first_difference("%\nO1\nG0X1.5\nM30\n%\n", "%\nO1\nG0X1.4\nM30\n%\n");
  ASSERT_TRUE(found);
  EXPECT_EQ(found->line, 3U);
  EXPECT_EQ(found->column, 6U);
  EXPECT_EQ(sentence_of(*found), "line 3, column 6: expected \"5\", found \"4\"");
  const auto format = first_difference("%\nX1.\n%\n", "%\nX1.0\n%\n");
  ASSERT_TRUE(format) << "number formats count";
  EXPECT_EQ(format->column, 4U);
  EXPECT_EQ(first_difference("%\nO1\nM30\n%\n", "%\nO1\n%\n")->line, 3U);
  EXPECT_EQ(first_difference("%\nO1\n%\n", "%\nO1\nM30\n%\n")->line, 3U);
}

}  // namespace
}  // namespace dripfeed::app
