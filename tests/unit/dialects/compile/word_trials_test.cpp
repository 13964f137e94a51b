// What becomes of a word in a translation, found by translating: words that every control has, one that a control alone
// has, and one that no small program can use. The trials themselves are programs that the control accepts.
#include "dialects/compile/trial/word_trials.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "dialects/compile/dialect/word_index.h"

namespace dripfeed::compile {
namespace {

ir::Control mill_of(const char* name) { return find_dialect(name)->control(ir::MachineKind::mill, ir::GSystem::a); }

TrialResult tried(const char* from, const char* word, const char* to) {
  const Dialect& dialect = *find_dialect(from);
  const WordIndex words(language_of(dialect, mill_of(from)));
  const DialectWord* found = words.find(word);
  EXPECT_NE(found, nullptr) << word;
  return found == nullptr ? TrialResult::not_tried : WordTrials(dialect, mill_of(from)).of(*found, mill_of(to));
}

TEST(WordTrials, WordsOfEveryControlAreTranslated) {
  for (const char* word : {"G00", "G01", "G02", "G04", "G17", "G41", "G54", "G81"})
    EXPECT_EQ(tried("fanuc", word, "sinumerik-840d"), TrialResult::translated) << word;
  for (const char* word : {"G0", "G2", "G4", "G41", "CYCLE81", "ENDIF", "SIN"})
    EXPECT_EQ(tried("sinumerik-840d", word, "fanuc"), TrialResult::translated) << word;
}

TEST(WordTrials, WhatTheOtherControlLacksIsRefused) {
  EXPECT_EQ(tried("fanuc", "G05", "sinumerik-840d"), TrialResult::refused);
  EXPECT_EQ(tried("sinumerik-840d", "GEOAX", "fanuc"), TrialResult::refused);
}

TEST(WordTrials, ProgramsHoldTheWordAndAreAcceptedByItsControl) {
  const Dialect& dialect = *find_dialect("fanuc");
  const WordTrials trials(dialect, mill_of("fanuc"));
  const WordIndex words(language_of(dialect, mill_of("fanuc")));
  for (const char* word : {"G02", "G43", "G81", "SIN", "WHILE"}) {
    const auto programs = trials.programs(*words.find(word));
    ASSERT_FALSE(programs.empty()) << word;
    EXPECT_LE(programs.size(), WordTrials::kPrograms);
    for (const std::string& text : programs) {
      EXPECT_NE(text.find(word), std::string::npos) << text;
      const text::Source source("trial", text);
      const ir::ReadResult read = dialect.read(source, mill_of("fanuc"));
      EXPECT_FALSE(text::has_error(dialect.validate(read.program, mill_of("fanuc"), ir::Delivery::memory))) << text;
    }
  }
}

// A word in a program that its control refuses is no trial: nothing is claimed of it.
TEST(WordTrials, AWordThatNoShapeFitsIsNotTried) {
  const Dialect& dialect = *find_dialect("fanuc");
  const DialectWord unknown = {.spelling = "G999", .sort = ir::WordSort::code, .about = "none"};
  EXPECT_TRUE(WordTrials(dialect, mill_of("fanuc")).programs(unknown).empty());
  EXPECT_EQ(WordTrials(dialect, mill_of("fanuc")).of(unknown, mill_of("haas")), TrialResult::not_tried);
}

}  // namespace
}  // namespace dripfeed::compile
