// A text laid out again is the same program, or it is refused.
#include "server/app/library/rewriting.h"

#include <gtest/gtest.h>

#include "tests/unit/server/app/whole_shop.h"

namespace dripfeed::app {
namespace {

Rewritten rewritten(const std::string& text, Rewriting how, const std::string& dialect = "fanuc") {
  auto done = rewrite_text({.of = {.dialect = dialect, .text = text}, .how = how}, test::PlainDocuments());
  return done ? std::move(*done) : Rewritten{};
}

std::string text_of(const std::string& text, Rewriting how, const std::string& dialect = "fanuc") {
  Rewritten done = rewritten(text, how, dialect);
  return done.refused.empty() ? done.text : "refused: " + done.refused.front().text;
}

TEST(Rewriting, BlanksGoWhereWordsNeedNone) {
  EXPECT_EQ(text_of("%\nO1 (A B)\nN10 G1 X10. Y-5. F100\n#100 = #101 + 1\nIF [#1 EQ 2] GOTO 10\nM30\n%\n",
                    Rewriting::remove_blanks),
            "%\nO1(A B)\nN10G1X10.Y-5.F100\n#100=#101+1\nIF[#1EQ2]GOTO10\nM30\n%\n");
  EXPECT_EQ(text_of("  G0 X1.  \r\n\r\nM30\r\n", Rewriting::remove_blanks), "G0X1.\r\n\r\nM30\r\n");
}

TEST(Rewriting, ABlankStaysWhereASiemensNameIsReadByIt) {
  const std::string text =
      "START: G1 X=R1 Y2 Z3\nDEF REAL DEPTH = 5\nIF DEPTH > 3 GOTOF START ; A  B\nMSG(\"A  B\")\nM30\n";
  EXPECT_EQ(text_of(text, Rewriting::remove_blanks, "sinumerik-840d"),
            "START: G1 X=R1 Y2Z3\nDEF REAL DEPTH=5\nIF DEPTH>3 GOTOF START; A  B\nMSG(\"A  B\")\nM30\n");
}

TEST(Rewriting, BlanksComeBetweenWords) {
  EXPECT_EQ(text_of("N10G1X10.Y[#1+2]Z5.(DEEP)\nIF[#1EQ2]GOTO10\n#100=#101+1\nM30\n", Rewriting::add_blanks),
            "N10 G1 X10. Y[#1+2] Z5. (DEEP)\nIF[#1EQ2] GOTO10\n#100=#101+1\nM30\n");
}

TEST(Rewriting, WhatIsWrittenOutKeepsItsBlanks) {
  const std::string text = "POPEN\nDPRNT[X #100[53] Y #101[53]]\nPCLOS\nM30\n";
  EXPECT_EQ(text_of(text, Rewriting::remove_blanks), text);
}

TEST(Rewriting, CapitalsMendAndLeaveCommentsAndStrings) {
  EXPECT_EQ(text_of("g1 x10. (small)\nif[#1eq2]goto10\nN10m30\n", Rewriting::upper_case),
            "G1 X10. (small)\nIF[#1EQ2]GOTO10\nN10M30\n");
  EXPECT_EQ(text_of("g1 x10 ; small\nmsg(\"small\")\nm30\n", Rewriting::upper_case, "sinumerik-840d"),
            "G1 X10 ; small\nMSG(\"small\")\nM30\n");
}

TEST(Rewriting, SmallLettersOnlyWhereTheControlTakesThem) {
  EXPECT_EQ(text_of("G1 X10 ; BIG\nIF R1>5 GOTOF END\nEND: M30\n", Rewriting::lower_case, "sinumerik-840d"),
            "g1 x10 ; BIG\nif r1>5 gotof end\nend: m30\n");
  const Rewritten fanuc = rewritten("O1\nG1 X10.\nM30\n", Rewriting::lower_case);
  ASSERT_EQ(fanuc.refused.size(), 1U);
  EXPECT_EQ(fanuc.text, "");
  EXPECT_GT(fanuc.refused.front().line, 0U);
}

TEST(Rewriting, ALineWithAnErrorIsNotLaidOut) {
  const Rewritten done = rewritten("G0 X1.\nG1 X[1.\nM30\n", Rewriting::remove_blanks);
  ASSERT_EQ(done.refused.size(), 1U);
  EXPECT_EQ(done.refused.front().line, 2U);
}

TEST(Rewriting, NumbersFollow) {
  const auto done = rewrite_text({.of = {.dialect = "fanuc", .text = "N1 G0 X1.\nGOTO 1\nM30\n"},
                                  .how = Rewriting::renumber,
                                  .numbering = compile::Numbering::all,
                                  .first = 100,
                                  .step = 5},
                                 test::PlainDocuments());
  ASSERT_TRUE(done);
  EXPECT_EQ(done->text, "N100 G0 X1.\nN105 GOTO 100\nN110 M30\n");
  EXPECT_EQ(done->numbers, 3U);
  EXPECT_EQ(done->references, 1U);
}

}  // namespace
}  // namespace dripfeed::app
