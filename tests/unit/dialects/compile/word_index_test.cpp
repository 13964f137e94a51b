// A word of a text and the row of the tables that speaks of it.
#include "dialects/compile/dialect/word_index.h"

#include <string>

#include <gtest/gtest.h>

#include "dialects/compile/dialect/dialect.h"

namespace dripfeed::compile {
namespace {

WordIndex index_of(std::string_view dialect) {
  const Dialect* of = find_dialect(dialect);
  return WordIndex(language_of(*of, of->control(ir::MachineKind::mill, ir::GSystem::a)));
}

std::string found(const WordIndex& index, std::string_view written) {
  const DialectWord* word = index.find(written);
  return word == nullptr ? "" : word->spelling;
}

TEST(WordIndex, FindsACodeHoweverItIsWritten) {
  const WordIndex fanuc = index_of("fanuc");
  for (const char* written : {"G2", "g02", "G002"}) EXPECT_EQ(found(fanuc, written), "G02") << written;
  EXPECT_EQ(found(fanuc, "G00"), "G00");
  EXPECT_EQ(found(fanuc, "G0"), "G00");
  EXPECT_EQ(found(fanuc, "goto"), "GOTO");
  EXPECT_EQ(found(index_of("sinumerik-840d"), "cycle83"), "CYCLE83");
  for (const char* none : {"G2.", "X1", "", "#", "#x"}) EXPECT_EQ(found(fanuc, none), "") << none;
}

TEST(WordIndex, FindsANumberedVariableInItsRange) {
  const WordIndex fanuc = index_of("fanuc");
  for (const DialectWord& word : fanuc.words()) {
    if (word.last == 0) continue;
    EXPECT_EQ(found(fanuc, "#" + std::to_string(word.last)), word.spelling);
    EXPECT_NE(found(fanuc, "#" + std::to_string(word.last + 1)), word.spelling);
  }
  EXPECT_EQ(found(fanuc, "#100"), "");
}

// The word at each offset of a text, a point where there is none.
std::string words_at_offsets(std::string_view dialect, const std::string& text) {
  const Dialect* of = find_dialect(dialect);
  const text::Source source("program", text);
  const ir::ReadResult read = of->read(source, of->infer_control(source));
  std::string out;
  for (std::uint32_t at = 0; at <= text.size(); ++at) {
    const auto span = written_word_at(read.program, at);
    out += span ? std::string(span->in(text)) + " " : ". ";
  }
  return out;
}

TEST(WrittenWord, IsAnAddressWithItsNumber) {
  EXPECT_EQ(words_at_offsets("fanuc", "G1X2."), "G1 G1 X2. X2. X2. X2. ");
  EXPECT_EQ(words_at_offsets("fanuc", "(G1) M3"), ". . . . . M3 M3 M3 ");
  EXPECT_EQ(words_at_offsets("fanuc", "X#5041"), "X #5041 #5041 #5041 #5041 #5041 #5041 ");
}

}  // namespace
}  // namespace dripfeed::compile
