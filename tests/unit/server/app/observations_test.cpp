// What a collector learns of a line: what is known, and for all else that it is not.
#include "server/app/out/observations.h"

#include <gtest/gtest.h>

namespace dripfeed::app {
namespace {

const Observed& at(const ObservedItems& items, DataItem item) { return items[static_cast<std::size_t>(item)]; }

TEST(Observations, AFeedIsNoExecution) {
  LineReport report;
  report.state = LineState::feeding;
  report.job = 7;
  report.handed = 100;
  const ObservedItems items = observed_of(report);
  EXPECT_EQ(at(items, DataItem::availability).value, "AVAILABLE");
  EXPECT_EQ(at(items, DataItem::line_state).value, "feeding");
  for (const DataItem unknown :
       {DataItem::execution, DataItem::mode, DataItem::program, DataItem::line, DataItem::system})
    EXPECT_EQ(at(items, unknown).value, kUnavailable);
  EXPECT_EQ(at(items, DataItem::communications).value, "Normal");
}

TEST(Observations, AMachinesOwnWordsAreTaken) {
  LineReport report;
  report.state = LineState::held;
  report.machine = MachineReport{.state = "running", .program = 42, .line = 17, .alarm = 0};
  ObservedItems items = observed_of(report);
  EXPECT_EQ(at(items, DataItem::execution).value, "ACTIVE");
  EXPECT_EQ(at(items, DataItem::mode).value, "AUTOMATIC");
  EXPECT_EQ(at(items, DataItem::program).value, "42");
  EXPECT_EQ(at(items, DataItem::line).value, "17");
  EXPECT_EQ(at(items, DataItem::system).value, "Normal");
  report.machine = MachineReport{.state = "alarm", .program = 0, .line = 0, .alarm = 1010};
  items = observed_of(report);
  EXPECT_EQ(at(items, DataItem::execution).value, kUnavailable);
  EXPECT_EQ(at(items, DataItem::program).value, kUnavailable);
  EXPECT_EQ(at(items, DataItem::system).value, "Fault");
  EXPECT_EQ(at(items, DataItem::system).code, "1010");
  report.machine = MachineReport{.state = "unknown"};
  for (const DataItem unknown : {DataItem::execution, DataItem::mode, DataItem::system})
    EXPECT_EQ(at(observed_of(report), unknown).value, kUnavailable);
}

TEST(Observations, ATornBlockIsAWarningAndALostLinkAFault) {
  LineReport report;
  report.state = LineState::torn;
  EXPECT_EQ(at(observed_of(report), DataItem::communications).value, "Warning");
  report = {};
  EXPECT_EQ(at(observed_of(report), DataItem::availability).value, kUnavailable);
  EXPECT_EQ(at(observed_of(report), DataItem::communications).value, kUnavailable);
  report.link_error = "connection refused";
  EXPECT_EQ(at(observed_of(report), DataItem::communications).value, "Fault");
  EXPECT_EQ(at(observed_of(report), DataItem::communications).text, "connection refused");
}

}  // namespace
}  // namespace dripfeed::app
