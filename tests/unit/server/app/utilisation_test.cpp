// Days of use: clipped at midnight, of what the store knows alone. The days are those of Berlin, where one of October
// has 25 hours.
#include "server/app/jobs/utilisation.h"

#include <cstdlib>
#include <ctime>

#include "tests/unit/server/app/whole_shop.h"

namespace dripfeed::app::test {
namespace {

using store::JobState;

constexpr std::int64_t kHour_ms = 3600 * 1000;
constexpr std::int64_t kMidnight_ms = 1'729'893'600'000;  // 2024-10-26 00:00 in Berlin

class UtilisationTest : public ShopTest {
 protected:
  UtilisationTest() {
    ::setenv("TZ", "Europe/Berlin", 1);
    ::tzset();
    shop_.add_machine(kLathe);
    release_ = release_text(shop_.store, kLathe, program(3));
  }
  ~UtilisationTest() override {
    ::unsetenv("TZ");
    ::tzset();
  }
  store::Id feed(std::int64_t from_ms, std::uint64_t clocked) {
    store::Jobs& jobs = shop_.store.jobs();
    const store::Id job = must(jobs.add({.release = release_.id, .bytes_total = 100}, {"anna", from_ms})).id;
    must(jobs.move(job, {.to = JobState::armed}, {"olga", from_ms}));
    must(jobs.move(job, {.to = JobState::feeding}, {"line", from_ms}));
    const store::NewLedgerRow row{.job = job, .counts = {clocked, clocked, 0, clocked}};
    must(shop_.store.ledger().append(std::span(&row, 1), from_ms + 1000));
    return job;
  }
  void end(store::Id job, JobState to, std::int64_t at_ms, std::optional<std::int64_t> held_ms) {
    if (to == JobState::done) must(shop_.store.jobs().move(job, {.to = JobState::draining}, {"line", at_ms}));
    must(shop_.store.jobs().move(job, {.to = to, .held_ms = held_ms}, {"line", at_ms}));
  }
  std::vector<DayOfUse> days(std::uint32_t count, std::int64_t now_ms) {
    return must(utilisation(shop_.store, kLathe, count, now_ms));
  }

  Shop shop_{database()};
  store::Release release_;
};

TEST_F(UtilisationTest, JobsAreClippedToTheirDays) {
  end(feed(kMidnight_ms + kHour_ms, 50), JobState::done, kMidnight_ms + 2 * kHour_ms, 60'000);
  end(feed(kMidnight_ms + 23 * kHour_ms, 70), JobState::failed, kMidnight_ms + 25 * kHour_ms, 0);
  must(shop_.store.jobs().move(
      must(shop_.store.jobs().add({.release = release_.id}, {"anna", kMidnight_ms + 26 * kHour_ms})).id,
      {.to = JobState::cancelled}, {"olga", kMidnight_ms + 26 * kHour_ms}));
  const auto found = days(3, kMidnight_ms + 50 * kHour_ms);  // 01:00 of the 28th
  ASSERT_EQ(found.size(), 3U);
  EXPECT_EQ(found[0].day, "2024-10-26");
  EXPECT_EQ(found[0].from_ms, kMidnight_ms);
  EXPECT_EQ(found[0].to_ms, kMidnight_ms + 24 * kHour_ms);
  EXPECT_EQ(found[1].to_ms - found[1].from_ms, 25 * kHour_ms) << "the clock is set back";
  EXPECT_EQ(found[2].day, "2024-10-28");
  EXPECT_EQ(found[0].feeding_s, 7200.0);
  EXPECT_EQ(found[0].held_s, 60.0);
  EXPECT_EQ(found[0].jobs_done, 1U);
  EXPECT_EQ(found[0].jobs_failed, 0U);
  EXPECT_EQ(found[0].bytes, 50U);
  EXPECT_EQ(found[1].feeding_s, 3600.0);
  EXPECT_EQ(found[1].held_s, 0.0);
  EXPECT_EQ(found[1].jobs_failed, 1U);
  EXPECT_EQ(found[1].jobs_cancelled, 1U);
  EXPECT_EQ(found[1].bytes, 70U);
  EXPECT_EQ(found[2].feeding_s, 0.0);
  EXPECT_EQ(found[2].held_s, 0.0);
}

TEST_F(UtilisationTest, WhatIsNotKnownIsNotGuessed) {
  end(feed(kMidnight_ms + 22 * kHour_ms, 10), JobState::done, kMidnight_ms + 25 * kHour_ms, 5'000);
  end(feed(kMidnight_ms + 30 * kHour_ms, 10), JobState::done, kMidnight_ms + 31 * kHour_ms, std::nullopt);
  const store::Id broken = feed(kMidnight_ms + 50 * kHour_ms, 30);  // with the server, which came back hours later
  must(shop_.store.jobs().interrupt_unfinished({"dripfeed", kMidnight_ms + 60 * kHour_ms}));
  auto found = days(3, kMidnight_ms + 61 * kHour_ms);
  EXPECT_FALSE(found[0].held_s) << "nobody knows on which of two days it held";
  EXPECT_FALSE(found[1].held_s);
  EXPECT_EQ(found[2].feeding_s, 1.0) << "to the last row of its ledger";
  EXPECT_FALSE(found[2].held_s);
  EXPECT_EQ(found[2].jobs_failed, 1U);
  must(shop_.store.jobs().confirm_reset(kLathe, "RESET pressed", by("olga")));
  feed(kMidnight_ms + 70 * kHour_ms, 5);
  found = days(1, kMidnight_ms + 71 * kHour_ms);
  EXPECT_EQ(found.at(0).feeding_s, 3601.0) << "it is on";
  EXPECT_EQ(found[0].bytes, 35U);
  EXPECT_EQ(shop_.job(broken).reason_id, "server_stopped");
  EXPECT_EQ(refusal(utilisation(shop_.store, "nobody", 7, 0)).code, ErrorCode::not_found);
}

}  // namespace
}  // namespace dripfeed::app::test
