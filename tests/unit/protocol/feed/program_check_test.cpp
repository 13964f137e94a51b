// Texts that may be drip-fed and texts that may not, whole and character by character.
#include "protocol/feed/program_check.h"

#include <string>

#include <gtest/gtest.h>

namespace dripfeed::feed {
namespace {

std::expected<ProgramFacts, ProgramRefusal> check(const std::string& text,
                                                  const ProgramSyntax& syntax = kParenthesesSyntax) {
  ProgramCheck whole(syntax);
  whole.append(text);
  const auto result = whole.finish();
  // The same in pieces of one character.
  ProgramCheck pieces(syntax);
  for (const char& c : text) pieces.append({&c, 1});
  const auto again = pieces.finish();
  EXPECT_EQ(result.has_value(), again.has_value());
  if (!result && !again) {
    EXPECT_EQ(result.error().fault, again.error().fault);
  }
  return result;
}

ProgramFault fault(const std::string& text, const ProgramSyntax& syntax = kParenthesesSyntax) {
  const auto result = check(text, syntax);
  EXPECT_FALSE(result) << text;
  return result ? ProgramFault::empty : result.error().fault;
}

TEST(ProgramCheck, CountsAWholeProgram) {
  const auto facts = check("%\nO1\nG1X1\nM30\n%\n");
  ASSERT_TRUE(facts);
  EXPECT_EQ(facts->text_bytes(), 16U);
  EXPECT_EQ(facts->eobs(), 5U);
  EXPECT_EQ(facts->program_bytes(), 15U);
  EXPECT_EQ(facts->program_eobs(), 4U);
  const auto bare = check("%\nM30\n%");
  ASSERT_TRUE(bare);
  EXPECT_EQ(bare->program_bytes(), bare->text_bytes());
}

TEST(ProgramCheck, TakesEveryEndOfAProgram) {
  for (const char* end : {"M30", "M02", "M2", "M030", "m30", "N100M30", "N100 M30", "G0X0M30", "M5 M30", "M30 (END)",
                          "M 30", "M30M9", "M30\n(LAST WORDS)\n\nN99\n", "G28Z0.M30"}) {
    EXPECT_TRUE(check("%\nO1\n" + std::string(end) + "\n%\n")) << end;
  }
}

TEST(ProgramCheck, RefusesWhatDoesNotEndAProgram) {
  for (const char* end : {"M99", "M3", "M300", "M30.1", "M2=3", "M1=30", "(M30)", "/M30", "/N1M30", "G0 /M30", "M",
                          "M30\nG0Z-1", "XM30", "N30", "G30"}) {
    EXPECT_EQ(fault("%\nO1\n" + std::string(end) + "\n%\n"), ProgramFault::no_end_code) << end;
  }
  EXPECT_EQ(fault("%M30\n%\n"), ProgramFault::no_end_code);  // the first block is skipped by the reader
}

TEST(ProgramCheck, PercentHasItsPlaces) {
  EXPECT_EQ(fault(""), ProgramFault::empty);
  EXPECT_EQ(fault("\n\n"), ProgramFault::empty);
  EXPECT_EQ(fault("O1\nM30\n%\n"), ProgramFault::no_start_percent);
  EXPECT_EQ(fault("%\nO1\nM30\n"), ProgramFault::no_final_percent);
  EXPECT_EQ(fault("%\n"), ProgramFault::no_final_percent);
  EXPECT_EQ(fault("%\n(50% DONE)\nM30\n%\n"), ProgramFault::percent_in_comment);
  EXPECT_EQ(fault("%\nG1\n%\nM30\n%\n"), ProgramFault::text_after_percent);
  EXPECT_EQ(fault("%\nM30\n%\n\n%\n"), ProgramFault::percent_inside);
  EXPECT_EQ(fault("%\nM30%\n"), ProgramFault::percent_not_block_start);
  EXPECT_EQ(fault("%\nM30\n %\n"), ProgramFault::percent_not_block_start);
  EXPECT_EQ(fault("%%"), ProgramFault::percent_not_block_start);
  EXPECT_EQ(fault("%\nM30\n%\nG1"), ProgramFault::text_after_percent);
  EXPECT_EQ(fault("%\nM30\n%;"), ProgramFault::text_after_percent);
  EXPECT_EQ(fault("%\n(NOT CLOSED\nM30\n%\n"), ProgramFault::comment_open);
  EXPECT_TRUE(check("\n\n%\nM30\n%\n\n\n"));
}

TEST(ProgramCheck, NamesThePlace) {
  const auto result = check("%\nO1\nG1(A % B)\nM30\n%\n");
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().line, 3U);
  EXPECT_EQ(result.error().column, 6U);
}

TEST(ProgramCheck, SemicolonCommentsAndStrings) {
  EXPECT_TRUE(check("%_N_A_MPF\nG1 X1 ; (\nM30\n%\n", kSemicolonSyntax));
  EXPECT_TRUE(check("%\nMSG(\"; M99\")\nM17 ; end\n%\n", kSemicolonSyntax));
  EXPECT_EQ(fault("%\nG1 ; M30\n%\n", kSemicolonSyntax), ProgramFault::no_end_code);
  EXPECT_EQ(fault("%\nMSG(\"M30\")\n%\n", kSemicolonSyntax), ProgramFault::no_end_code);
  EXPECT_EQ(fault("%\nVAM30\n%\n", kSemicolonSyntax), ProgramFault::no_end_code);
  EXPECT_EQ(fault("%\nM30A\n%\n", kSemicolonSyntax), ProgramFault::no_end_code);
  EXPECT_EQ(fault("%\nMSG(\"50%\")\nM30\n%\n", kSemicolonSyntax), ProgramFault::percent_in_comment);
  EXPECT_EQ(fault("%\nG1 ; 50%\nM30\n%\n", kSemicolonSyntax), ProgramFault::percent_in_comment);
  EXPECT_EQ(fault("%\nM17\n%\n"), ProgramFault::no_end_code);
}

TEST(ProgramCheck, AMemoryLoadNeedsNoEndCode) {
  ProgramSyntax syntax = kParenthesesSyntax;
  syntax.end_code = false;
  EXPECT_TRUE(check("%\nO1\nG1\nM99\n%\n", syntax));
  syntax.start_percent = syntax.final_percent = false;
  const auto facts = check("G1\nM99\n", syntax);
  ASSERT_TRUE(facts);
  EXPECT_EQ(facts->program_bytes(), 7U);
  EXPECT_EQ(fault("G1\nM99", syntax), ProgramFault::no_final_eob);
}

TEST(ProgramCheck, EveryFaultHasAText) {
  for (int fault = 0; fault <= static_cast<int>(ProgramFault::comment_open); ++fault) {
    EXPECT_FALSE(message(static_cast<ProgramFault>(fault)).empty());
  }
}

}  // namespace
}  // namespace dripfeed::feed
