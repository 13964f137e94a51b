// The lexer of the '#'-variable controls: kinds of tokens, and that they tile any bytes.
#include "dialects/macro_b/reader/lex.h"

#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "reading.h"

namespace dripfeed::macro_b {
namespace {

std::vector<ir::Token> tokens_of(std::string_view text) {
  std::vector<ir::Token> tokens;
  lex(text, test_grammar(), tokens);
  return tokens;
}

// Token texts joined by '|', blanks left out.
std::string split(std::string_view text) {
  std::string out;
  for (const ir::Token& token : tokens_of(text)) {
    if (token.kind == ir::TokenKind::white) continue;
    if (!out.empty()) out += '|';
    out += token.span.in(text);
  }
  return out;
}

ir::TokenKind kind_of(std::string_view text) { return tokens_of(text).front().kind; }

::testing::AssertionResult tiles(const std::string& text) {
  std::uint32_t at = 0;
  for (const ir::Token& token : tokens_of(text)) {
    if (token.span.begin != at || token.span.empty()) return ::testing::AssertionFailure() << "gap at " << at;
    at = token.span.end;
  }
  return at == text.size() ? ::testing::AssertionSuccess() : ::testing::AssertionFailure() << "ends at " << at;
}

TEST(Lex, SplitsTouchingWordsAndKeywords) {
  EXPECT_EQ(split("N100IF[#20NEFIX[#20]]GOTO700"), "N|100|IF|[|#|20|NE|FIX|[|#|20|]|]|GOTO|700");
  EXPECT_EQ(split("G01XROUND[#1]Y-.5"), "G|01|X|ROUND|[|#|1|]|Y|-|.5");
  EXPECT_EQ(split("WHILE[#1LTABS[#2]]DO1"), "WHILE|[|#|1|LT|ABS|[|#|2|]|]|DO|1");
  EXPECT_EQ(split("IF[#1EQ1]THEN#2=3"), "IF|[|#|1|EQ|1|]|THEN|#|2|=|3");
}

TEST(Lex, TakesTheLongestKeywordAndItsTwoLetterForm) {
  EXPECT_EQ(split("ENDIF"), "ENDIF");
  EXPECT_EQ(split("WH[#1LT2]DO1"), "WH|[|#|1|LT|2|]|DO|1");
  EXPECT_EQ(split("GO10"), "GO|10");
  EXPECT_EQ(split("XR5"), "X|R|5");  // not ROUND: no bracket follows
}

TEST(Lex, KnowsCommentsTextAndNames) {
  EXPECT_EQ(kind_of("(ANY; %[ thing)"), ir::TokenKind::comment);
  EXPECT_EQ(split("(NO END\nX1"), "(NO END|\n|X|1");
  EXPECT_EQ(split("DPRNT[X#100[53] Y]"), "DPRNT|[X#100[53] Y]");
  EXPECT_EQ(split("SETVN101[A,B]"), "SETVN|101|[A,B]");
  EXPECT_EQ(split("M98<SUB-1>L2"), "M|98|<SUB-1>|L|2");
  EXPECT_EQ(split("#1=[#_ABSIO[2]]"), "#|1|=|[|#|_ABSIO|[|2|]|]");
}

TEST(Lex, DistinguishesBlockSkipFromDivision) {
  EXPECT_EQ(kind_of("/N1X1"), ir::TokenKind::skip);
  EXPECT_EQ(split("/2G0\nN5/3X1"), "/2|G|0|\n|N|5|/3|X|1");
  EXPECT_EQ(tokens_of("#1=#2/2")[5].kind, ir::TokenKind::symbol);
}

TEST(Lex, TakesAllFormsOfEob) {
  for (const std::string_view eob : {"\n", "\r", "\r\n", "\n\r\r", ";"}) {
    EXPECT_EQ(tokens_of(eob).size(), 1U);
    EXPECT_EQ(kind_of(eob), ir::TokenKind::eob);
  }
  EXPECT_EQ(tokens_of("%TITLE (X)\nX").front().span.end, 10U);
}

TEST(Lex, KeepsForeignCharactersWhole) {
  const auto tokens = tokens_of(
      "\xD0\x9C"
      "30");
  ASSERT_EQ(tokens.size(), 2U);
  EXPECT_EQ(tokens[0].kind, ir::TokenKind::invalid);
  EXPECT_EQ(tokens[0].span.size(), 2U);
  EXPECT_EQ(tokens_of("\xD0").size(), 1U);
}

TEST(LexProperty, TokensTileAnyBytes) {
  std::mt19937 random(1);
  static constexpr std::string_view kLikely = "GXYZNMOR#[]()=+-*/.,;%0123456789 \n\r<>ABCDEFIKLPQSTUVW:&\xD0\x9C\xFF";
  for (int round = 0; round < 3000; ++round) {
    std::string text(random() % 80, '\0');
    const bool any_byte = round % 3 == 0;
    for (char& c : text) c = any_byte ? static_cast<char>(random() & 0xFFU) : kLikely[random() % kLikely.size()];
    ASSERT_TRUE(tiles(text)) << "round " << round;
    const ir::ReadResult read = read_text(text);
    ASSERT_EQ(ir::print_same(read.program), text);
  }
}

TEST(LexProperty, TokensTileEveryTruncation) {
  const std::string text =
      "%T\nO1(A)\n/2N10G01X[#1+SIN[#2]]Y-#3,R2.(C)\r\nIF[#1EQ#0]GOTO10;WHILE[#1LT2]DO1\n#3000=1(STOP)\nEND1\n"
      "DPRNT[X#1[53]]\nG65P9010A1.\nM98<SUB>\nM30\n%";
  for (std::size_t length = 0; length <= text.size(); ++length) {
    const std::string part = text.substr(0, length);
    ASSERT_TRUE(tiles(part));
    ASSERT_EQ(ir::print_same(read_text(part).program), part);
  }
}

TEST(LexProperty, StatementsCoverAllTokens) {
  const ir::ReadResult read = read_text("%\nO1\nN1 G0 X1.\n#1=2 #3=4\n\n(C)\nM30\n%\n");
  std::uint32_t next = 0;
  for (const ir::Statement& statement : read.program.statements) {
    if (statement.tokens.first == statement.tokens.last) continue;
    EXPECT_EQ(statement.tokens.first, next);
    next = statement.tokens.last;
  }
  EXPECT_EQ(next, read.program.tokens.size());
}

}  // namespace
}  // namespace dripfeed::macro_b
