// How findings are kept, and how the words of the checks become one.
#include "checks/verdict.h"

#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace dripfeed::checks {
namespace {

using text::DiagnosticId;

TEST(FindingList, KeepsTheFirstCountsAllAndKnowsTheWorst) {
  FindingList list;
  int made = 0;
  for (int i = 1; i <= 100; ++i) {
    const double value = i == 50 ? -7.0 : 1.0;
    list.add(DiagnosticId::feed_too_high, {0, static_cast<std::uint32_t>(i), 0}, value, 0.5, [&] {
      ++made;
      return std::vector<std::string>{std::to_string(i), "0.5"};
    });
  }
  list.add(DiagnosticId::tool_missing, {0, 7, 0}, 3, 0, [] { return std::vector<std::string>{"3"}; });
  EXPECT_EQ(list.count(DiagnosticId::feed_too_high), 100U);
  EXPECT_EQ(list.kept().size(), FindingList::kKept + 1);
  EXPECT_EQ(list.kind(DiagnosticId::feed_too_high)->worst.place.line, 50U);
  EXPECT_EQ(made, 21);
  EXPECT_EQ(list.kept()[0].text, "the feed is 1 mm/min, the machine's highest is 0.5");
  EXPECT_EQ(list.kept()[0].severity, text::Severity::error);
  EXPECT_EQ(list.count(DiagnosticId::travel_exceeded), 0U);
  EXPECT_EQ(list.kind(DiagnosticId::travel_exceeded), nullptr);
  EXPECT_TRUE(list.has(text::Severity::warning));
  EXPECT_FALSE(list.has(text::Severity::note));
}

TEST(NotCheckedList, SaysEachThingOnce) {
  NotCheckedList list;
  list.add("one", 3);
  list.add("two");
  list.add("one", 9);
  ASSERT_EQ(list.list().size(), 2U);
  EXPECT_EQ(list.list()[0].line, 3U);
}

TEST(Verdict, FailureOutranksUnknownAndThatAWarning) {
  EXPECT_EQ(combine({}), Verdict::pass);
  EXPECT_EQ(combine({Verdict::pass, Verdict::warn}), Verdict::warn);
  EXPECT_EQ(combine({Verdict::unknown, Verdict::warn}), Verdict::unknown);
  EXPECT_EQ(combine({Verdict::unknown, Verdict::fail, Verdict::pass}), Verdict::fail);
  EXPECT_EQ(name_of(Verdict::unknown), "unknown");
}

TEST(Verdict, ComesFromDiagnosticsFindingsAndUnknownEffects) {
  CheckReport report;
  EXPECT_EQ(verdict_of(report), Verdict::pass);
  report.diagnostics.push_back(text::make_diagnostic(DiagnosticId::unreachable, {}));
  EXPECT_EQ(verdict_of(report), Verdict::warn);
  report.has_unknown_effects = true;
  EXPECT_EQ(verdict_of(report), Verdict::unknown);
  report.gouge.emplace();
  EXPECT_EQ(verdict_of(report), Verdict::unknown);
  report.gouge->findings.add(DiagnosticId::rapid_into_stock, {}, 1, 0,
                             [] { return std::vector<std::string>{"1", "2"}; });
  EXPECT_EQ(verdict_of(report), Verdict::fail);
}

TEST(Verdict, ListsWhatNoCheckLookedAt) {
  CheckReport report;
  report.envelope.emplace();
  report.envelope->not_checked.add("travel");
  report.not_checked.add("accuracy");
  const auto all = not_checked_of(report);
  ASSERT_EQ(all.size(), 2U);
  EXPECT_EQ(all[0].text, "travel");
  EXPECT_EQ(all[1].text, "accuracy");
}

}  // namespace
}  // namespace dripfeed::checks
