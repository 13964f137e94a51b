// Block transfer through the use cases: armed by a person, every byte exactly once whatever is lost, the ledger's
// counts confirmed, and a job that ends leaves the PLC informed.
#include "server/app/lines/modbus_line.h"

#include <algorithm>
#include <chrono>
#include <thread>

#include "tests/unit/server/app/gate.h"
#include "tests/unit/server/app/register_plc.h"
#include "tests/unit/server/app/whole_shop.h"

namespace dripfeed::app {
namespace {

using namespace std::chrono_literals;
using namespace test;
using store::JobState;

constexpr const char* kPlcUrl = "modbus-tcp://plc:502/1";

class ModbusLineTest : public ShopTest {
 protected:
  ModbusLineTest() : shop_(make(), take_plc_seat) { shop_.add_machine("press", kPlcUrl); }

  store::Job arm(const std::string& text) {
    const store::Job job = shop_.add_job("press", text);
    return must(shop_.jobs.arm(job.id, std::nullopt, "olga"));
  }
  // Virtual time passes while the line's thread works, until it is so or too long.
  template <class Condition>
  bool until(const Condition& condition, std::chrono::milliseconds most = 60s) {
    for (std::chrono::milliseconds passed{}; passed < most; passed += 20ms) {
      if (condition()) return true;
      shop_.links.advance(20ms);
      std::this_thread::sleep_for(1ms);
      shop_.round();
    }
    return condition();
  }
  bool comes_to(store::Id job, JobState state) {
    return until([&] { return shop_.state(job) == state; });
  }

  RegisterPlc plc_;
  Shop shop_;

 private:
  std::string make() {
    plcs()[kPlcUrl] = &plc_;
    return database();
  }
};

TEST_F(ModbusLineTest, ArmedTextArrivesOnceAndIsConfirmed) {
  const std::string text = program(200);
  const store::Job queued = shop_.add_job("press", text);
  EXPECT_EQ(queued.bytes_total, text.size());
  until([] { return false; }, 1s);
  EXPECT_EQ(plc_.writes(), 0) << "nothing is armed";
  must(shop_.jobs.arm(queued.id, std::nullopt, "olga"));
  ASSERT_TRUE(comes_to(queued.id, JobState::done)) << shop_.report("press").stall;
  EXPECT_EQ(plc_.text(), text);
  const store::LedgerCounts last = shop_.ledger_of(queued.id).back().counts;
  EXPECT_EQ(last.confirmed, text.size());
  EXPECT_EQ(last.clocked, text.size());
  EXPECT_EQ(last.reserve, text.size());
  EXPECT_TRUE(shop_.report("press").confirms);
  must(shop_.store.ledger().verify(queued.id));

  const store::Job again = must(shop_.jobs.add(queued.release, "anna"));
  must(shop_.jobs.arm(again.id, std::nullopt, "olga"));
  ASSERT_TRUE(comes_to(again.id, JobState::done));
  EXPECT_EQ(plc_.text(), text) << "a new session begins with an empty text";
}

TEST_F(ModbusLineTest, LostCallsLoseAndRepeatNothing) {
  plc_.lose_calls(4);
  const std::string text = program(100);
  const store::Job job = arm(text);
  ASSERT_TRUE(comes_to(job.id, JobState::done)) << shop_.report("press").cause;
  EXPECT_EQ(plc_.text(), text);
}

TEST_F(ModbusLineTest, HandsNothingBeyondItsReserve) {
  const std::string text = program(5000);
  ASSERT_GT(text.size(), kReserveOfBlocks + 20'000);
  plc_.give_credit(false);
  const store::Job job = arm(text);
  shop_.store.watched_ledger().watch([](auto) { return store::Error{store::ErrorCode::busy, ""}; });
  plc_.give_credit(true);
  ASSERT_TRUE(until([&] { return shop_.report("press").stall == "waiting for ledger"; }));
  EXPECT_LE(plc_.text().size(), kReserveOfBlocks);
  until([] { return false; }, 2s);
  EXPECT_LE(plc_.text().size(), kReserveOfBlocks);
  shop_.store.watched_ledger().watch({});
  ASSERT_TRUE(comes_to(job.id, JobState::done));
  EXPECT_EQ(plc_.text(), text);
}

TEST_F(ModbusLineTest, APlcThatIsGoneEndsTheJobAndNotTheLine) {
  plc_.give_credit(false);
  const std::string text = program(20);
  const store::Job job = arm(text);
  ASSERT_TRUE(comes_to(job.id, JobState::feeding));
  plc_.go_away(true);
  ASSERT_TRUE(comes_to(job.id, JobState::failed));
  EXPECT_FALSE(shop_.job(job.id).torn) << "a block is appended whole or not at all";
  EXPECT_NE(shop_.job(job.id).reason.find("the PLC does not answer"), std::string::npos) << shop_.job(job.id).reason;
  plc_.go_away(false);
  plc_.give_credit(true);
  until([] { return false; }, 1s);
  EXPECT_EQ(plc_.text(), "") << "nothing goes on by itself";
  const store::Job again = must(shop_.jobs.add(job.release, "anna"));
  must(shop_.jobs.arm(again.id, std::nullopt, "olga"));
  until([&] { return store::ended(shop_.state(again.id)); }, 30s);
  EXPECT_TRUE(plc_.text().empty() || plc_.text() == text);
}

// What a transfer that broke off left at the PLC is never taken away by the next job alone.
TEST_F(ModbusLineTest, ASessionThatIsLeftOpenNeedsAPersonsWord) {
  plc_.give_credit(false);
  const std::string text = program(20);
  const store::Job job = arm(text);
  ASSERT_TRUE(comes_to(job.id, JobState::feeding));
  plc_.go_away(true);
  ASSERT_TRUE(comes_to(job.id, JobState::failed));
  plc_.go_away(false);
  plc_.give_credit(true);
  const store::Job second = must(shop_.jobs.add(job.release, "anna"));
  must(shop_.jobs.arm(second.id, std::nullopt, "olga"));
  ASSERT_TRUE(comes_to(second.id, JobState::failed));
  EXPECT_TRUE(shop_.job(second.id).torn);
  EXPECT_EQ(shop_.report("press").state, LineState::torn);
  EXPECT_EQ(plc_.text(), "");
  const store::Job third = must(shop_.jobs.add(job.release, "anna"));
  EXPECT_FALSE(shop_.jobs.arm(third.id, std::nullopt, "olga"));
  must(shop_.jobs.confirm_reset("press", "the press was reset", "olga"));
  EXPECT_EQ(shop_.report("press").state, LineState::idle);
  must(shop_.jobs.arm(third.id, std::nullopt, "olga"));
  ASSERT_TRUE(comes_to(third.id, JobState::done)) << shop_.report("press").cause;
  EXPECT_EQ(plc_.text(), text);
}

TEST_F(ModbusLineTest, AnArmingThatFindsNoPlcExpires) {
  plc_.go_away(true);
  const store::Job queued = shop_.add_job("press", program(20));
  const store::Job armed = must(shop_.jobs.arm(queued.id, 0.05, "olga"));
  EXPECT_EQ(armed.expires_at_ms, armed.armed_at_ms + 3'000);
  ASSERT_TRUE(comes_to(queued.id, JobState::queued));
  EXPECT_EQ(shop_.job(queued.id).reason, "disarmed, nothing was sent: expired");
  plc_.go_away(false);
  until([] { return false; }, 1s);
  EXPECT_EQ(plc_.text(), "") << "nothing is armed any more";
  must(shop_.jobs.arm(queued.id, std::nullopt, "olga"));
  ASSERT_TRUE(comes_to(queued.id, JobState::done));
}

TEST_F(ModbusLineTest, StopHoldsAtABlockEndAndResumeGoesOn) {
  const std::string text = program(2000);
  plc_.give_credit(false);
  const store::Job job = arm(text);
  ASSERT_TRUE(comes_to(job.id, JobState::feeding));
  must(shop_.jobs.stop(job.id, "olga"));
  plc_.give_credit(true);
  ASSERT_TRUE(comes_to(job.id, JobState::held));
  EXPECT_TRUE(until([&] { return shop_.report("press").stall == "stopped"; }));
  const std::string held = plc_.text();
  EXPECT_LT(held.size(), text.size());
  until([] { return false; }, 3s);
  EXPECT_EQ(plc_.text(), held);
  EXPECT_EQ(plc_.status().state, modbus::ReceiverState::held);
  must(shop_.jobs.resume(job.id, "", "olga"));
  ASSERT_TRUE(comes_to(job.id, JobState::done));
  EXPECT_EQ(plc_.text(), text);
}

TEST_F(ModbusLineTest, CancelInformsThePlc) {
  plc_.give_credit(false);
  const store::Job job = arm(program(50));
  ASSERT_TRUE(comes_to(job.id, JobState::feeding));
  must(shop_.jobs.cancel(job.id, "olga"));
  ASSERT_TRUE(comes_to(job.id, JobState::cancelled));
  EXPECT_EQ(plc_.status().state, modbus::ReceiverState::idle);
  EXPECT_EQ(plc_.text(), "");
}

// The bus works without the line's lock: what a person does meanwhile must not change the registers under it.
TEST_F(ModbusLineTest, ACommandDoesNotTouchTheRegistersThatAreBeingWritten) {
  Gate gate;
  std::atomic<bool> unchanged = false;
  std::atomic<bool> seen = false;
  plc_.give_credit(false);
  const store::Job job = arm(program(50));
  ASSERT_TRUE(comes_to(job.id, JobState::feeding));
  plc_.look_at_writes([&](std::span<const std::uint16_t> registers) {
    if (seen.exchange(true)) return;
    const std::vector<std::uint16_t> before(registers.begin(), registers.end());
    gate.pass();
    unchanged = std::ranges::equal(registers, before);
  });
  plc_.give_credit(true);
  until([&] { return seen.load(); });
  gate.await_someone();
  EXPECT_TRUE(shop_.lines.find("press")->command(feed::Command::cancel));
  gate.open();
  ASSERT_TRUE(comes_to(job.id, JobState::cancelled));
  EXPECT_TRUE(unchanged);
}

TEST_F(ModbusLineTest, CommandsWithoutAMeaningAreRefused) {
  const auto line = shop_.lines.find("press");
  EXPECT_FALSE(line->command(feed::Command::resume_as_if_dc1));
  EXPECT_FALSE(line->command(feed::Command::stop)) << "no job is on it";
}

}  // namespace
}  // namespace dripfeed::app
