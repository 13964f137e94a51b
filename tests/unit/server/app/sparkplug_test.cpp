// The numbers and topics of a node of Sparkplug, and what a host sees of a machine.
#include "server/app/sparkplug.h"

#include <algorithm>

#include <gtest/gtest.h>

namespace dripfeed::app {
namespace {

class SparkplugNodeTest : public ::testing::Test {
 protected:
  SparkplugPayload written_;
  SparkplugNode node_{"hall", "dnc", 254, [this](const SparkplugPayload& payload) {
                        written_ = payload;
                        return std::string("bytes");
                      }};
};

TEST_F(SparkplugNodeTest, ASessionHasTheNumberOfItsWill) {
  const BrokerMessage will = node_.next_will(7);
  EXPECT_EQ(will.topic, "spBv1.0/hall/NDEATH/dnc");
  EXPECT_EQ(will.qos, 1);
  EXPECT_FALSE(written_.seq) << "a death has no place in the order";
  const auto of_will = written_.metrics;
  EXPECT_EQ(of_will.at(0), (SparkplugMetric{"bdSeq", SparkplugType::whole, std::int64_t{255}}));
  node_.birth("dripfeed", 8);
  EXPECT_EQ(written_.metrics.at(0), of_will.at(0));
  node_.next_will(9);
  EXPECT_EQ(node_.session(), 0) << "after 255";
}

TEST_F(SparkplugNodeTest, AMessageTakesItsPlaceOnceItIsSent) {
  const BrokerMessage birth = node_.birth("dripfeed", 8);
  EXPECT_EQ(birth.topic, "spBv1.0/hall/NBIRTH/dnc");
  EXPECT_EQ(birth.qos, 0);
  EXPECT_EQ(written_.seq, 0);
  node_.sent();
  for (int i = 0; i < 2; ++i) {
    const BrokerMessage device = node_.of_device("DBIRTH", "mill/3", {}, 8);
    EXPECT_EQ(device.topic, "spBv1.0/hall/DBIRTH/dnc/mill%2F3");
    EXPECT_EQ(written_.seq, 1) << "it was not sent";
  }
  for (int i = 0; i < 255; ++i) node_.sent();
  static_cast<void>(node_.of_device("DDATA", "mill", {}, 8));
  EXPECT_EQ(written_.seq, 0) << "after 255";
}

TEST(Sparkplug, IdsAreOneLevelOfATopic) {
  EXPECT_EQ(why_no_sparkplug_id("hall 2"), "");
  for (const char* const bad : {"", "a/b", "+", "#", "a\nb", "50%"}) EXPECT_NE(why_no_sparkplug_id(bad), "") << bad;
}

TEST(Sparkplug, WhatIsNotKnownHasNoValue) {
  const auto metric = [](const MachineStatus& status, std::string_view name) {
    const auto metrics = sparkplug_metrics(status);
    const auto found = std::ranges::find(metrics, name, &SparkplugMetric::name);
    return found == metrics.end() ? SparkplugValue("no such metric") : found->value;
  };
  const SparkplugValue none;
  MachineStatus status;
  EXPECT_EQ(metric(status, "Line/State"), SparkplugValue("disconnected"));
  EXPECT_EQ(metric(status, "Line/Needs Confirmation"), SparkplugValue(false));
  for (const char* const name :
       {"Job/Id", "Job/Program", "Job/End", "Job/Known To Line", "Job/Bytes Confirmed", "Control/State"})
    EXPECT_EQ(metric(status, name), none) << name;
  status.is_certain = false;
  EXPECT_EQ(metric(status, "Line/Needs Confirmation"), none) << "the store could not say";
  status.needs_confirmation.emplace();
  EXPECT_EQ(metric(status, "Line/Needs Confirmation"), SparkplugValue(true));
  status.report.machine = MachineReport{.state = "running", .program = 42, .line = 0, .alarm = 0};
  EXPECT_EQ(metric(status, "Control/Program"), SparkplugValue(std::int64_t{42}));
  EXPECT_EQ(metric(status, "Control/Line"), none);
}

}  // namespace
}  // namespace dripfeed::app
