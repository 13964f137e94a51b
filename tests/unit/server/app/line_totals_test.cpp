// Sums over jobs and over lines that were made again.
#include "server/app/lines/line_totals.h"

#include <gtest/gtest.h>

namespace dripfeed::app {
namespace {

LineReport report_of(std::uint64_t job, std::uint64_t session, std::uint64_t handed, std::uint64_t line = 0) {
  LineReport report;
  report.job = job;
  report.session = session;
  report.handed = handed;
  report.known.to_line = line;
  return report;
}

TEST(LineTotals, AddWhatCameSinceTheLastLook) {
  LineTotals totals;
  totals.look("lathe", report_of(0, 0, 0), 1);
  EXPECT_EQ(totals.all().at("lathe").last_sent_ms, 0);
  totals.look("lathe", report_of(7, 1, 100, 5), 2);
  totals.look("lathe", report_of(7, 1, 100, 5), 3);
  totals.look("lathe", report_of(7, 1, 160, 9), 4);
  totals.look("mill", report_of(8, 1, 5), 5);
  const LineSums sums = totals.all().at("lathe");
  EXPECT_EQ(sums.sent_bytes, 160U);
  EXPECT_EQ(sums.sent_blocks, 8U) << "the ninth is not whole";
  EXPECT_EQ(sums.last_sent_ms, 4);
  EXPECT_EQ(totals.all().at("mill").sent_bytes, 5U);
}

TEST(LineTotals, AnotherJobOrArmingBeginsAtNothing) {
  LineTotals totals;
  totals.look("lathe", report_of(7, 1, 100, 5), 1);
  totals.look("lathe", report_of(8, 2, 120, 6), 2);  // more than the one before had, so only its number says it
  totals.look("lathe", report_of(8, 3, 120, 6), 3);
  EXPECT_EQ(totals.all().at("lathe").sent_bytes, 340U);
  EXPECT_EQ(totals.all().at("lathe").sent_blocks, 14U);
  EXPECT_EQ(totals.all().at("lathe").last_sent_ms, 3);
}

TEST(LineTotals, EachRoundOfAJobBeginsAtItsFirstLine) {
  LineTotals totals;
  totals.look("lathe", report_of(7, 1, 100, 10), 1);
  totals.look("lathe", report_of(7, 1, 140, 4), 2);  // the second round
  EXPECT_EQ(totals.all().at("lathe").sent_blocks, 12U);
  EXPECT_EQ(totals.all().at("lathe").sent_bytes, 140U);
}

TEST(LineTotals, CountsOfTheLineGoOnWhenItIsMadeAgain) {
  LineTotals totals;
  LineReport report;
  report.received = 3;
  report.unarmed_starts = 2;
  report.line_errors.parity = 5;
  totals.look("lathe", report, 1);
  report.received = 1;
  report.unarmed_starts = 0;
  report.line_errors.parity = 6;
  totals.look("lathe", report, 2);
  const LineSums sums = totals.all().at("lathe");
  EXPECT_EQ(sums.receptions, 4U);
  EXPECT_EQ(sums.unarmed_starts, 2U);
  EXPECT_EQ(sums.errors.parity, 6U);
}

TEST(LineTotals, AStallCountsWhenItBegins) {
  LineTotals totals;
  LineReport report;
  for (const std::string_view stall : {"held by DC3", "held by DC3", "", "held by DC3", "CTS off", ""}) {
    report.stall = stall;
    totals.look("lathe", report, 1);
  }
  const LineSums sums = totals.all().at("lathe");
  EXPECT_EQ(sums.stalls.size(), 2U);
  EXPECT_EQ(sums.stalls.at("held by DC3"), 2U);
  EXPECT_EQ(sums.stalls.at("CTS off"), 1U);
}

}  // namespace
}  // namespace dripfeed::app
