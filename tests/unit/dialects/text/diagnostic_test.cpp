// The table's rows as users see them, and the printed form with its caret.
#include "dialects/text/diagnostic.h"

#include <algorithm>
#include <cctype>
#include <set>
#include <string>
#include <string_view>

#include <gtest/gtest.h>

#include "dialects/text/excerpt.h"
#include "dialects/text/fold.h"

namespace dripfeed::text {
namespace {

constexpr auto kCount = static_cast<std::size_t>(DiagnosticId::count_);

TEST(DiagnosticTable, NamesAreKebabCaseAndDistinctAndFoundAgain) {
  std::set<std::string_view> seen;
  for (std::size_t i = 0; i < kCount; ++i) {
    const DiagnosticRow& row = row_of(static_cast<DiagnosticId>(i));
    EXPECT_TRUE(std::ranges::all_of(row.name, [](char c) { return c == '-' || (c >= 'a' && c <= 'z'); })) << row.name;
    EXPECT_TRUE(seen.insert(row.name).second) << row.name;
    EXPECT_EQ(find_diagnostic(row.name), &row);
  }
  EXPECT_EQ(find_diagnostic("no-such-thing"), nullptr);
  EXPECT_EQ(find_diagnostic(""), nullptr);
}

TEST(DiagnosticTable, SentencesHaveNoFullStopAndHelpEndsWithOne) {
  for (std::size_t i = 0; i < kCount; ++i) {
    const DiagnosticRow& row = row_of(static_cast<DiagnosticId>(i));
    ASSERT_FALSE(row.text.empty()) << row.name;
    EXPECT_NE(row.text.back(), '.') << row.name;
    EXPECT_FALSE(row.text.front() >= 'A' && row.text.front() <= 'Z') << row.name;
    ASSERT_FALSE(row.help.empty()) << row.name;
    EXPECT_EQ(row.help.back(), '.') << row.name;
  }
}

TEST(MessageOf, PutsArgumentsInOrderAndBearsTooFewAndTooMany) {
  EXPECT_EQ(message_of(make_diagnostic(DiagnosticId::too_many_digits, {}, {"123456789", "9", "8"})),
            "the number 123456789 has 9 digits, the control takes 8");
  EXPECT_EQ(message_of(make_diagnostic(DiagnosticId::unknown_code, {})), "the control has no code ");
  EXPECT_EQ(message_of(make_diagnostic(DiagnosticId::unreachable, {}, {"x"})), "the block is never reached");
  EXPECT_EQ(message_of(make_diagnostic(DiagnosticId::unknown_code, {}, {"{}"})), "the control has no code {}");
}

TEST(FormatDiagnostic, PrintsPlaceSentenceAlarmAndCaret) {
  const Source source("roll.nc", "%\nO0002\nG01 X#106+50.\n");
  Diagnostic diagnostic = make_diagnostic(DiagnosticId::expression_without_brackets, {16, 20}, {"X"});
  diagnostic.alarm = "PS0124";
  EXPECT_EQ(format_diagnostic(diagnostic, source, "Fanuc"),
            "roll.nc:3:9: error[expression-without-brackets]: the expression after X has no brackets (Fanuc PS0124)\n"
            "G01 X#106+50.\n"
            "        ^\n");
}

TEST(FormatDiagnostic, KeepsTabsAndCountsCharactersBeforeTheCaret) {
  const Source source("a", "\tG1(\xC3\xA9) @");
  EXPECT_EQ(format_diagnostic(make_diagnostic(DiagnosticId::invalid_character, {8, 9}, {"@"}), source, ""),
            "a:1:9: error[invalid-character]: the character @ is not one that the control reads\n"
            "\tG1(\xC3\xA9) @\n"
            "\t      ^\n");
}

TEST(FormatDiagnostic, PrintsNotesWithTheirOwnLineAndPlacesAtTheEnd) {
  const Source source("a", "WHILE[1]DO1\nM30");
  Diagnostic diagnostic = make_diagnostic(DiagnosticId::missing_end, {15, 15}, {"WHILE", "END1"});
  diagnostic.notes.push_back({{0, 5}, "it begins here"});
  EXPECT_EQ(format_diagnostic(diagnostic, source, "Fanuc"),
            "a:2:4: error[missing-end]: WHILE has no END1\n"
            "M30\n"
            "   ^\n"
            "a:1:1: note: it begins here\n"
            "WHILE[1]DO1\n"
            "^\n");
}

TEST(FormatDiagnostic, CutsALongLineAroundThePlace) {
  const std::string dull(20'000, 'x');
  const Source source("a", dull + "@" + dull);
  EXPECT_EQ(format_diagnostic(make_diagnostic(DiagnosticId::invalid_character, {20'000, 20'001}, {"@"}), source, ""),
            "a:1:20001: error[invalid-character]: the character @ is not one that the control reads\n..." +
                std::string(106, 'x') + "@" + std::string(53, 'x') + "...\n" + std::string(109, ' ') + "^\n");
}

TEST(Excerpt, IsCutBetweenCharactersAndNeverLonger) {
  for (const std::string_view character : {"x", "\xC3\xA9", "\xE2\x82\xAC", "\xF0\x9F\x94\xA7"}) {
    std::string line;
    while (line.size() < 1000) line += character;
    for (std::size_t at = 0; at <= line.size(); at += character.size()) {
      const Excerpt shown = excerpt_of(line, at);
      std::string_view middle = shown.text;
      if (middle.starts_with("...")) middle.remove_prefix(3);
      if (middle.ends_with("...")) middle.remove_suffix(3);
      ASSERT_LE(middle.size(), kExcerptBytes) << at;
      ASSERT_GE(middle.size(), kExcerptBytes - 3) << at;
      ASSERT_EQ(middle.size() % character.size(), 0U) << "cut inside of a character at " << at;
      ASSERT_TRUE(middle.starts_with(character));
      if (at < line.size()) {
        ASSERT_EQ(std::string_view(shown.text).substr(shown.place, character.size()), character) << at;
      }
    }
  }
}

TEST(MessageOf, QuotesNoMoreOfAWordThanAnExcerpt) {
  const std::string message = message_of(make_diagnostic(DiagnosticId::unknown_code, {}, {std::string(5000, 'G')}));
  EXPECT_EQ(message, "the control has no code " + std::string(kExcerptBytes, 'G') + "...");
}

TEST(DiagnosticFold, ShowsTwentyOfAKindAndCountsTheRest) {
  DiagnosticFold fold;
  Diagnostic one = make_diagnostic(DiagnosticId::unknown_code, {});
  int shown = 0;
  for (int i = 0; i < 137; ++i) shown += fold.shows(one) ? 1 : 0;
  one.severity = Severity::note;
  EXPECT_TRUE(fold.shows(one)) << "another severity is another kind";
  EXPECT_EQ(shown, 20);
  ASSERT_EQ(fold.folded().size(), 1U);
  EXPECT_EQ(format_folded(fold.folded().front(), "a.nc"), "a.nc: error[unknown-code]: 117 more, not shown\n");
}

TEST(HasError, LooksAtSeverityOnly) {
  Diagnostic diagnostic = make_diagnostic(DiagnosticId::unreachable, {});
  EXPECT_FALSE(has_error({}));
  EXPECT_FALSE(has_error({diagnostic}));
  diagnostic.severity = Severity::error;
  EXPECT_TRUE(has_error({make_diagnostic(DiagnosticId::unreachable, {}), diagnostic}));
}

}  // namespace
}  // namespace dripfeed::text
