// The ring of transitions: order, resuming, what is too old, and progress that only counts in its newest form.
#include "server/app/out/events.h"

#include <string>
#include <thread>

#include <gtest/gtest.h>

namespace dripfeed::app {
namespace {

Event alarm(std::string text) {
  return {.id = 0,
          .kind = EventKind::alarm,
          .machine = "lathe",
          .job = {},
          .verdict = 0,
          .outcome = {},
          .text = std::move(text)};
}

TEST(Events, GivesWhatIsNewerInOrder) {
  Events events;
  EXPECT_EQ(events.last_id(), 0U);
  EXPECT_FALSE(events.since(0).reset);
  EXPECT_TRUE(events.since(0).events.empty());
  for (int i = 1; i <= 5; ++i) events.publish(alarm("a" + std::to_string(i)));
  const Events::Batch batch = events.since(2);
  ASSERT_EQ(batch.events.size(), 3U);
  EXPECT_FALSE(batch.reset);
  EXPECT_EQ(batch.last, 5U);
  EXPECT_EQ(batch.events.front().id, 3U);
  EXPECT_EQ(batch.events.front().text, "a3");
  EXPECT_EQ(batch.events.back().text, "a5");
  EXPECT_TRUE(events.since(5).events.empty());
}

TEST(Events, WhatIsHeldGoesOutWithItsReleaseOrNever) {
  Events events;
  {
    Events::Hold undone(events);
    events.publish(alarm("never was"));
  }
  {
    Events::Hold outer(events);
    events.publish(alarm("a1"));
    {
      Events::Hold inner(events);
      events.publish(alarm("a2"));
      inner.release();
      events.publish(alarm("a3"));
    }
    std::jthread([&] { events.publish(alarm("of another thread")); }).join();
    EXPECT_EQ(events.last_id(), 1U) << "held events went out";
    outer.release();
    events.publish(alarm("a4"));
  }
  std::string texts;
  for (const Event& event : events.since(0).events) texts += event.text + ",";
  EXPECT_EQ(texts, "of another thread,a1,a2,a3,a4,");
}

TEST(Events, ReportsWhenTheRingNoLongerHoldsAll) {
  Events events;
  for (std::size_t i = 0; i < Events::kRing; ++i) events.publish(alarm(""));
  EXPECT_FALSE(events.since(0).reset) << "just as many as fit";
  EXPECT_EQ(events.since(0).events.size(), Events::kRing);
  events.publish(alarm(""));
  EXPECT_TRUE(events.since(0).reset);
  EXPECT_TRUE(events.since(0).events.empty());
  EXPECT_EQ(events.since(0).last, Events::kRing + 1);
  EXPECT_FALSE(events.since(1).reset);
  EXPECT_EQ(events.since(1).events.size(), Events::kRing);
}

TEST(Events, AnIdThatWasNeverGivenMeansReload) {
  Events events;
  events.publish(alarm(""));
  EXPECT_FALSE(events.since(1).reset);
  EXPECT_TRUE(events.since(2).reset);
  EXPECT_TRUE(events.since(UINT64_MAX).reset);
}

TEST(Events, AnIdOfTheServerBeforeMeansReload) {
  Events events(1'700'000'000'000);
  EXPECT_TRUE(events.since(17).reset);
  EXPECT_FALSE(events.since(events.last_id()).reset);
  events.publish(alarm("new"));
  EXPECT_TRUE(events.since(17).reset);
  EXPECT_TRUE(events.since(1'699'999'999'998).reset);
  EXPECT_EQ(events.since(1'699'999'999'999).events.size(), 1U);
}

TEST(Events, WakesWatchersUntilTheyGo) {
  Events events;
  int woken = 0;
  const Events::Watch watch = events.watch([&] { ++woken; });
  events.publish(alarm(""));
  EXPECT_EQ(woken, 1);
  LineReport report;
  report.handed = 10;
  events.progress("lathe", report);
  EXPECT_EQ(woken, 2);
  events.progress("lathe", report);
  EXPECT_EQ(woken, 2) << "nothing changed";
  report.handed = 11;
  events.progress("lathe", report);
  EXPECT_EQ(woken, 3);
  events.unwatch(watch);
  events.publish(alarm(""));
  EXPECT_EQ(woken, 3);
  ASSERT_EQ(events.snapshot().size(), 1U);
  EXPECT_EQ(events.snapshot().front().machine, "lathe");
  EXPECT_EQ(events.snapshot().front().report.handed, 11U);
  EXPECT_EQ(events.last_id(), 2U) << "progress is not a part of the ring";
}

}  // namespace
}  // namespace dripfeed::app
