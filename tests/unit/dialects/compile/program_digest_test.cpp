// Names, comments, words and calls of a text, without running it.
#include "dialects/compile/dialect/program_digest.h"

#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "dialects/compile/dialect/dialect.h"

namespace dripfeed::compile {
namespace {

ProgramDigest digest(const std::string& text, const std::string& dialect = "fanuc") {
  const Dialect* of = find_dialect(dialect);
  const text::Source source("program", text);
  return digest_of(of->read(source, of->infer_control(source)));
}

std::string calls(const ProgramDigest& of) {
  std::string out;
  for (const DigestCall& one : of.calls) out += fmt::format("{}{}:{}", out.empty() ? "" : " ", one.name, one.line);
  return out;
}

TEST(ProgramDigest, WordsStandApart) {
  const ProgramDigest found = digest("%\nO0012(PUMP)\nN10G01X-12.5Y#100(CUT)\nT0505M06\nM30\n%\n");
  EXPECT_EQ(found.words, "O0012\nN10 G01 X-12.5 Y#100\nT0505 M06\nM30\n");
  EXPECT_EQ(found.comments, "(PUMP)\n(CUT)\n");
  EXPECT_EQ(found.names, std::vector<std::string>{"O0012"});
  EXPECT_EQ(found.not_read, "");
  EXPECT_FALSE(found.is_cut);
}

TEST(ProgramDigest, CallsAreThoseOfTheReader) {
  EXPECT_EQ(calls(digest("O1\nM98P0042\nG65P9010A1.\nM98P42\n(M98P7)\nM30\n")), "O42:2 O9010:3");
  EXPECT_EQ(digest("O1\n#1=5\nM98P#1\nM30\n").computed_calls, 1U);
  EXPECT_EQ(calls(digest("GROOVE(1,2)\nL0100\nCYCLE83(1,2,3,4)\nM30\n", "sinumerik-840d")), "GROOVE:1 L0100:2");
}

TEST(ProgramDigest, AFaultIsReported) { EXPECT_TRUE(digest("O1\nM98P[1\nM30\n").not_read.starts_with("line 2: ")); }

TEST(ProgramDigest, OfALongTextTheMovesAreLeftOut) {
  std::string text = "O1\n";
  for (int i = 0; i < 20'000; ++i) text += fmt::format("G01X{}.5Y{}.5\n", i % 900, i % 700);
  text += "T0707M06\nM98P77\nM30\n";
  const ProgramDigest found = digest(text);
  EXPECT_TRUE(found.is_cut);
  EXPECT_LT(found.words.size(), std::size_t{70'000});
  EXPECT_NE(found.words.find("T0707"), std::string::npos) << "what is not a move is kept";
  EXPECT_EQ(calls(found), "O77:20003");
}

TEST(ProgramDigest, NamesAreOneByAllTheirForms) {
  EXPECT_EQ(call_key("O0012"), "O12");
  EXPECT_EQ(call_key("12"), "O12");
  EXPECT_EQ(call_key("o0012.nc"), "O12");
  EXPECT_EQ(call_key("O0000"), "O0");
  EXPECT_EQ(call_key("groove.spf"), "GROOVE");
  EXPECT_EQ(call_key("/_N_WKS_DIR/_N_X_WPD/_N_GROOVE_SPF"), "GROOVE");
  EXPECT_NE(call_key("L0100"), call_key("L100"));
  EXPECT_EQ(call_key("PART.17.LEFT"), "PART.17");
  EXPECT_EQ(call_key("O"), "O");
}

TEST(ProgramDigest, AnyBytesBecomeUtf8) {
  EXPECT_EQ(as_utf8("Geh\xE4use"), "Geh\xC3\xA4use");
  EXPECT_EQ(as_utf8("Geh\xC3\xA4use"), "Geh\xC3\xA4use");
  EXPECT_EQ(as_utf8(std::string_view("a\0b", 3)), "ab");
  EXPECT_EQ(as_utf8("\xC3"), "\xC3\x83") << "half a character is none";
  EXPECT_EQ(as_utf8("\xED\xA0\x80"), "\xC3\xAD\xC2\xA0\xC2\x80") << "a surrogate is none";
}

}  // namespace
}  // namespace dripfeed::compile
