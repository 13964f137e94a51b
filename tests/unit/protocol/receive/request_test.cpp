// The grammar of requests: what is one, what is an ordinary program, and what may be named.
#include "protocol/receive/request.h"

#include <gtest/gtest.h>

namespace dripfeed::receive {
namespace {

struct Case {
  std::string_view text;
  std::string_view verb;
  std::string_view argument;
};

TEST(Request, HasAVerbInTheFirstComment) {
  const Case cases[] = {
      {"%\nO9999 (LOAD 1234)\n%\n", "load", "1234"},
      {"%\nO9999\nN0010 (PRG=1234)\n%\n", "load", "1234"},
      {"%\n:9999\n( get  shaft-7 )\n%\n", "load", "SHAFT-7"},
      {"%\nO09999(L O A D 42)\n%\n", "load", "42"},
      {"%\nO9999(DNC O42)\n%\n", "drip", "O42"},
      {"%\nO9999(DRIP=O42)\n%\n", "drip", "O42"},
      {"%\nO9999(DIR)\n%\n", "dir", ""},
      {"%\nO9999(DIR O1*)\n%\n", "dir", "O1*"},
      {"%\nO9999(SAVE SHAFT)\nG0\n%\n", "save", "SHAFT"},
      {"%\nO9999(CANCEL)\n%\n", "cancel", ""},
      {"%\nO9999(STATUS)\n%\n", "status", ""},
      {"%\nO9999(RESTART 42 N500)\n%\n", "restart", "42N500"},
      {"%\nO9999(PARTS 5)\n%\n", "parts", "5"},
      {"%\nO9999(PARTS=    12)\n%\n", "parts", "12"},
      {"%\nO9999(SCRAP 1)\n%\n", "scrap", "1"},
      {"%_N_9999_MPF\n;$PATH=/_N_MPF_DIR\n;LOAD SHAFT\nM30\n", "load", "SHAFT"},
  };
  for (const Case& one : cases) {
    const auto found = find_request(one.text, {});
    ASSERT_TRUE(found) << one.text;
    EXPECT_EQ(name(found->verb), one.verb) << one.text;
    EXPECT_EQ(found->argument, one.argument) << one.text;
    EXPECT_TRUE(found->legal) << one.text;
  }
}

TEST(Request, AnythingElseIsAProgram) {
  EXPECT_FALSE(find_request("%\nO1234(LOAD 42)\n%\n", {})) << "another number";
  EXPECT_FALSE(find_request("%\nO9999\nG0X1\nM30\n%\n", {})) << "no comment";
  EXPECT_FALSE(find_request("%\nO9999(MY PROGRAM)\nG0X1\nM30\n%\n", {})) << "no verb";
  EXPECT_FALSE(find_request("%\nO9999\nG0\nG0\nG0\nG0\n(LOAD 42)\n%\n", {})) << "after the lines that are looked at";
  for (const char* comment : {"PARTS FOR VALVES", "PARTS", "PARTS 5 OF 9", "PARTS -5", "SCRAP 1.5"}) {
    EXPECT_FALSE(find_request(std::string("%\n(") + comment + ")\nM30\n%\n", {.program_number = 0})) << comment;
  }
  EXPECT_FALSE(find_request("%\n(LOAD 42)\n%\n", {})) << "no number at all";
  EXPECT_TRUE(find_request("%\n(LOAD 42)\n%\n", {.program_number = 0}));
  EXPECT_TRUE(find_request("%_N_DRIPFEED_MPF\n;DIR\n", {.marker = "DRIPFEED"}));
  EXPECT_FALSE(find_request("%\nO9999(DIR)\n%\n", {.marker = "DRIPFEED"}));
}

TEST(Request, NamesLeadNowhereElse) {
  for (const char* argument : {"../PASSWD", "A/B", "A\\B", "A..B", "", "*", "Ü", "A%00"}) {
    const auto found = find_request(std::string("%\nO9999\n(LOAD ") + argument + ")\n%\n", {});
    ASSERT_TRUE(found) << argument;
    EXPECT_FALSE(found->legal) << argument;
  }
  EXPECT_FALSE(find_request("%\nO9999(LOAD " + std::string(33, 'A') + ")\n%\n", {})->legal);
}

TEST(FitsMask, KnowsStarsAndQuestionMarks) {
  EXPECT_TRUE(fits_mask("O1234", "o1*"));
  EXPECT_TRUE(fits_mask("O1234", "*34"));
  EXPECT_TRUE(fits_mask("O1234", "O?2*4"));
  EXPECT_TRUE(fits_mask("", "*"));
  EXPECT_FALSE(fits_mask("O1234", "O2*"));
  EXPECT_FALSE(fits_mask("O1234", "O123"));
  EXPECT_FALSE(fits_mask("", "?"));
}

}  // namespace
}  // namespace dripfeed::receive
