// Comments in a translation: they stay next to their lines, and nothing in them becomes code of the other control.
#include <string>

#include <gtest/gtest.h>

#include "tests/unit/dialects/compile/harness.h"

namespace dripfeed::compile::test {
namespace {

std::string text_of(const std::string& text, const std::string& from, const std::string& to) {
  const ConvertResult result = translated(text, from, to);
  EXPECT_FALSE(text::has_error(result.diagnostics)) << messages_of(result.diagnostics, text::Source("program", text));
  return result.text;
}

constexpr std::string_view kHead = "G71 G17 G90 G94 G0\n";

TEST(Comments, StayNextToTheirLines) {
  const std::string to = text_of("%\nO1 (TITLE)\n(ROUGH THE FACE)\nG21 G17 G90 G94\nG00 X1. (FIRST)\n(LAST)\nM30\n%\n",
                                 "fanuc", "sinumerik-840d");
  EXPECT_TRUE(to.contains("; TITLE\n; ROUGH THE FACE\n")) << to;
  EXPECT_TRUE(to.contains("X1. ; FIRST\n; LAST\nM30\n") || to.contains("X1 ; FIRST\n; LAST\nM30\n")) << to;
}

TEST(Comments, OfSeveralWordsOfALineAreJoined) {
  const std::string to = text_of("G21 G17 G90 G94\nG00 (A) X1. (B)\nM30\n", "fanuc", "sinumerik-840d");
  EXPECT_TRUE(to.contains("; A B\n")) << to;
}

TEST(Comments, BracketsAndTapeMarksBecomeHarmless) {
  const std::string text = std::string(kHead) + "X1 ; side (A) of (B) 50% deep; G0 X500\nM30\n";
  for (const std::string name : {"fanuc", "mazak", "mitsubishi-m80"}) {
    const ConvertResult result = translated(text, "sinumerik-840d", name);
    EXPECT_TRUE(result.text.contains("(SIDE [A] OF [B] 50  DEEP, G0 X500)")) << result.text;
    // The lost character is reported, and that is not an error.
    ASSERT_EQ(result.diagnostics.size(), 1U);
    EXPECT_EQ(result.diagnostics[0].severity, text::Severity::note);
    const Played played = run_text(result.text, control(name, ir::MachineKind::mill));
    EXPECT_EQ(moves_of(played.motions).size(), 1U);
    EXPECT_NEAR(moves_of(played.motions)[0].end[0], 1.0, 1e-9);
  }
}

TEST(Comments, OfOtherAlphabetsAreReportedAndDropped) {
  const std::string text = std::string(kHead) +
                           "X1 ; Fl\xC3\xA4"
                           "che\nM30\n";
  const ConvertResult result = translated(text, "sinumerik-840d", "fanuc");
  EXPECT_TRUE(result.text.contains("(FL  CHE)")) << result.text;
  ASSERT_EQ(result.diagnostics.size(), 1U);
  EXPECT_EQ(result.diagnostics[0].severity, text::Severity::note);
  EXPECT_EQ(result.diagnostics[0].span.in(text),
            "; Fl\xC3\xA4"
            "che");
}

TEST(Comments, AreNoTextOfAnAlarm) {
  const std::string text = "R1=1\nIF R1==1\nSETAL(65003) ; not its text\nENDIF\nM30\n";
  const std::string to = text_of(text, "sinumerik-840d", "fanuc");
  EXPECT_TRUE(to.contains("(NOT ITS TEXT)\n")) << to;
  EXPECT_FALSE(to.contains("#3000=3(")) << to;
  EXPECT_FALSE(to.contains("#3000=3 (")) << to;
}

TEST(Comments, ThatAreATextStayThatTextAlone) {
  const std::string to = text_of("#1=1\nIF[#1EQ1]THEN #3000=5(TOO LONG)\nM30\n", "fanuc", "sinumerik-840d");
  EXPECT_TRUE(to.contains("SETAL(65005,\"TOO LONG\")")) << to;
  EXPECT_FALSE(to.contains(";")) << to;
}

TEST(Comments, FramingIsNone) {
  const std::string to =
      text_of("%_N_PART_MPF\n;$PATH=/_N_MPF_DIR\n" + std::string(kHead) + "X1\nM30\n", "sinumerik-840d", "fanuc");
  EXPECT_FALSE(to.contains("PATH")) << to;
}

TEST(Comments, LongOnesAreCutAtABlank) {
  std::string words;
  for (int i = 0; i < 60; ++i) words += "word" + std::to_string(i) + " ";
  const std::string to = text_of(std::string(kHead) + "; " + words + "\nX1\nM30\n", "sinumerik-840d", "mazak");
  for (std::size_t begin = 0; begin < to.size();) {
    const std::size_t end = to.find('\n', begin);
    EXPECT_LE(end - begin, 124U);
    begin = end + 1;
  }
  EXPECT_TRUE(to.contains("WORD0 ")) << to;
  EXPECT_TRUE(to.contains("WORD59)")) << to;
}

TEST(Comments, GiveOriginLines) {
  const ConvertResult result = translated("G21 G17 G90 G94\n(A)\nG00 X1.\n(B)\nM30\n", "fanuc", "sinumerik-840d");
  std::size_t lines = 0;
  for (const char c : result.text) lines += c == '\n' ? 1 : 0;
  ASSERT_EQ(result.origin_lines.size(), lines);
}

}  // namespace
}  // namespace dripfeed::compile::test
