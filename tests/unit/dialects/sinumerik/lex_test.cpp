// The lexer: what splits where, and that tokens tile any bytes.
#include "dialects/sinumerik/reader/lex.h"

#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "dialects/sinumerik/sinumerik.h"

namespace dripfeed::sinumerik {
namespace {

using ir::TokenKind;

// "a:G n:0 …": the first letter of each kind and the text, blanks left out.
std::string shape_of(std::string_view text) {
  static constexpr std::string_view kLetters = "wec%/anvN\"si";
  std::vector<ir::Token> tokens;
  lex(text, tokens);
  std::string out;
  for (const ir::Token& t : tokens) {
    if (t.kind == TokenKind::white) continue;
    if (!out.empty()) out += ' ';
    out += kLetters[static_cast<std::size_t>(t.kind)];
    out += ':';
    out += t.span.in(text);
  }
  return out;
}

void expect_tiling(const std::string& text) {
  std::vector<ir::Token> tokens;
  lex(text, tokens);
  std::uint32_t at = 0;
  for (const ir::Token& t : tokens) {
    ASSERT_EQ(t.span.begin, at);
    ASSERT_GT(t.span.end, t.span.begin);
    at = t.span.end;
  }
  ASSERT_EQ(at, text.size());
}

TEST(Lex, WordsNeedNoBlanks) {
  EXPECT_EQ(shape_of("G0G90X=R24Y=R25"), "a:G n:0 a:G n:90 a:X s:= v:R24 a:Y s:= v:R25");
  EXPECT_EQ(shape_of("G3I=R106*(-1)J0.0Z-.5"), "a:G n:3 a:I s:= v:R106 s:* s:( s:- n:1 s:) a:J n:0.0 a:Z s:- n:.5");
  EXPECT_EQ(shape_of("N10MSG(\"x;y\");end"), "a:N n:10 N:MSG s:( \":\"x;y\" s:) c:;end");
}

TEST(Lex, DigitsBelongToTheAddressBeforeEquals) {
  EXPECT_EQ(shape_of("X1=5 S2 = 800 X1"), "a:X1 s:= n:5 a:S2 s:= n:800 a:X n:1");
  EXPECT_EQ(shape_of("$AA_IW[X1]"), "v:$AA_IW s:[ a:X1 s:]");
  EXPECT_EQ(shape_of("IF R1==5"), "N:IF v:R1 s:== n:5");
}

TEST(Lex, NumbersHaveExponentsAndBases) {
  EXPECT_EQ(shape_of("X=-.1EX-3Y2"), "a:X s:= s:- n:.1EX-3 a:Y n:2");
  EXPECT_EQ(shape_of("R1='H0FF'+'B101'"), "v:R1 s:= n:'H0FF' s:+ n:'B101'");
}

TEST(Lex, HeadsOfLines) {
  EXPECT_EQ(shape_of("%_N_SHAFT_MPF\n;$PATH=/_N_MPF_DIR\n/2 N10 X1"),
            "%:%_N_SHAFT_MPF e:\n c:;$PATH=/_N_MPF_DIR e:\n /:/2 a:N n:10 a:X n:1");
  EXPECT_EQ(shape_of("R1=R2/R3"), "v:R1 s:= v:R2 s:/ v:R3");
}

TEST(Lex, BlanksAreWhatTheControlTakesForBlanks) {
  std::vector<ir::Token> tokens;
  const std::string text = std::string("\xEF\xBB\xBFG0\0& \tX1\r\n", 14);
  lex(text, tokens);
  EXPECT_EQ(shape_of(text), "a:G n:0 a:X n:1 e:\r\n");
}

TEST(Lex, TokensTileRandomBytes) {
  std::mt19937 random(20231121);
  std::uniform_int_distribution<int> byte(0, 255);
  std::uniform_int_distribution<std::size_t> length(0, 200);
  for (int round = 0; round < 2000; ++round) {
    std::string text(length(random), '\0');
    for (char& c : text) c = static_cast<char>(byte(random));
    expect_tiling(text);
    const text::Source source("random", text);
    const ir::ReadResult read = sinumerik::read(source, control(ir::MachineKind::mill));
    ASSERT_EQ(ir::print_same(read.program), text);
  }
}

// Random words of the language reach deeper than random bytes: everything must come to its end and be checked.
TEST(Lex, AnyOrderOfWordsIsReadToItsEnd) {
  static constexpr std::string_view kPieces[] = {
      "IF ",  "GOTOF ", "R1",     "=",      "(",     ")",       "[",      "]",      ",",     "\n",           "X",
      "10",   ".5",     "\"t\"",  "DEF ",   "REAL ", "A",       "PROC ",  "N",      "NAME ", "CASE ",        "OF ",
      "NOT ", "AND ",   "==",     "<<",     "-",     ";c\n",    "G1 ",    "M30 ",   "L1",    "$P_EP",        "%",
      "/",    ":",      "WHILE ", "ENDIF ", "FOR ",  "TO ",     "SET(",   "REP(",   "AC(",   "MSG(",         "WHEN ",
      "T=",   "EX-3",   "'",      "SIN(",   "AX[",   "REPEAT ", "UNTIL ", "ELSE\n", "M1=",   "\xE5\x8F\x82", "PO[X]="};
  std::mt19937 random(7);
  std::uniform_int_distribution<std::size_t> pick(0, std::size(kPieces) - 1);
  for (int round = 0; round < 3000; ++round) {
    std::string text;
    for (int i = 0; i < 40; ++i) text += kPieces[pick(random)];
    const text::Source source("words", text);
    const ir::Control c = infer_control(source);
    const ir::ReadResult read = sinumerik::read(source, c);
    ASSERT_EQ(ir::print_same(read.program), text);
    (void)validate(read.program, c, ir::Delivery::drip);
    (void)print(sinumerik::raise(read.program, c, c).program, c);
  }
}

TEST(Lex, EveryTruncationOfAProgramTiles) {
  const std::string text =
      "%_N_A_MPF\r\nN10 G1 X=AC(10) T=\"A B\" ;\xE4\xB8\xAD\xB2\xCE\r\nIF (R1<>'H0F') AND (R2<=1EX-2) GOTOF "
      "ENDE\nENDE: M30";
  for (std::size_t size = 0; size <= text.size(); ++size) expect_tiling(text.substr(0, size));
}

// GB18030 text has bytes that are letters of ASCII; in comments and strings they mean nothing.
TEST(Lex, ForeignEncodingsInCommentsAndStringsAreQuiet) {
  const text::Source source(
      "gb", "G17 G710 G90 G94\nMSG(\"\xB2\xCE\xCA\xFD\xD0\xB4\") ;\xC4\xA5\xCF\xF7\x81\x30\x81\x30\nM30\n");
  const ir::Control c = control(ir::MachineKind::mill);
  EXPECT_TRUE(sinumerik::read(source, c).diagnostics.empty());
}

}  // namespace
}  // namespace dripfeed::sinumerik
