// What a PLC says of its machine, and its doorbell, through the use cases: shown, reported, answered once, and never in
// the course of a transfer; a PLC without the words works as before.
#include <chrono>
#include <thread>

#include "server/app/lines/modbus_line.h"
#include "server/app/receive/receiving.h"
#include "tests/unit/server/app/register_plc.h"
#include "tests/unit/server/app/whole_shop.h"

namespace dripfeed::app {
namespace {

using namespace std::chrono_literals;
using namespace test;
using modbus::MachineState;
using store::JobState;

constexpr const char* kPlcUrl = "modbus-tcp://plc:502/1";

class MachineWordsTest : public ShopTest {
 protected:
  MachineWordsTest()
      : shop_(database(), seat()),
        programs_(shop_.store, shop_.links.clock(), shop_.documents),
        receiving_({shop_.store, shop_.lines, shop_.jobs, programs_, shop_.events, shop_.alarms, shop_.links.clock(),
                    shop_.documents}) {}
  ~MachineWordsTest() override { receiving_.stop(); }

  void open() { shop_.add_machine("press", kPlcUrl); }
  // Virtual time passes while the line works, until it is so or too long.
  template <class Condition>
  bool until(const Condition& condition, std::chrono::milliseconds most = 60s) {
    for (std::chrono::milliseconds passed{}; passed < most; passed += 50ms) {
      if (condition()) return true;
      shop_.links.advance(50ms);
      std::this_thread::sleep_for(3ms);
      shop_.round();
      receiving_.round();
    }
    return condition();
  }
  bool shows(std::string_view state) {
    return until([&] { return machine() && machine()->state == state; });
  }
  [[nodiscard]] std::optional<MachineReport> machine() { return shop_.report("press").machine; }
  [[nodiscard]] bool published(std::string_view text) {
    for (const std::string& line : shop_.published()) {
      if (line.find(text) != std::string::npos) return true;
    }
    return false;
  }
  // Rings; the answer's outcome and reason.
  std::pair<int, int> ring(std::uint16_t bell, std::uint16_t request, std::uint32_t program) {
    plc_.show({{.state = MachineState::idle, .bell = bell, .request = request, .requested = program}});
    EXPECT_TRUE(until([&] { return modbus::answered_bell(plc_.answer()) == bell; })) << "bell " << bell;
    return {plc_.answer()[1], plc_.answer()[2]};
  }
  [[nodiscard]] std::size_t requests() {
    return must(shop_.store.receipts().requests({.limit = 100, .after = {}}, "press")).items.size();
  }

  RegisterPlc plc_;
  Shop shop_;
  Programs programs_;
  Receiving receiving_;

 private:
  BusSeatMaker seat() {
    plcs()[kPlcUrl] = &plc_;
    return take_plc_seat;
  }
};

TEST_F(MachineWordsTest, AreShownWithoutAJobAndAnAlarmIsAnEvent) {
  plc_.show({{.state = MachineState::running, .program = 42, .line = 17}});
  open();
  ASSERT_TRUE(shows("running"));
  EXPECT_EQ(machine()->program, 42U);
  EXPECT_EQ(machine()->line, 17U);
  EXPECT_EQ(shop_.report("press").state, LineState::idle);
  EXPECT_EQ(shop_.report("press").stall, "") << "no job waits for it";
  plc_.show({{.state = MachineState::alarm, .program = 42, .line = 18, .alarm = 1010}});
  ASSERT_TRUE(shows("alarm"));
  EXPECT_TRUE(until([&] { return published("alarm press machine alarm 1010 (program 42, line 18)"); }));
  plc_.go_away(true);
  EXPECT_TRUE(until([&] { return !machine(); })) << "nobody knows any more";
  EXPECT_NE(shop_.report("press").link_error, "");
  EXPECT_EQ(shop_.report("press").state, LineState::disconnected);
  plc_.go_away(false);
  EXPECT_TRUE(shows("alarm"));
  EXPECT_EQ(shop_.report("press").state, LineState::idle);
  EXPECT_EQ(shop_.report("press").link_error, "");
}

TEST_F(MachineWordsTest, AMachineThatStandsIsANamedStall) {
  plc_.give_credit(false);
  plc_.show({{.state = MachineState::running}});
  open();
  const store::Job job = shop_.add_job("press", program(200));
  must(shop_.jobs.arm(job.id, std::nullopt, "olga"));
  ASSERT_TRUE(until([&] { return shop_.report("press").stall == "waiting for credit"; }));
  plc_.show({{.state = MachineState::held}});
  ASSERT_TRUE(until([&] { return shop_.report("press").stall == "machine held"; }));
  plc_.show({{.state = MachineState::alarm, .alarm = 504}});
  ASSERT_TRUE(until([&] { return shop_.report("press").stall == "machine alarm"; }));
  plc_.show({{.state = MachineState::emergency_stop}});
  ASSERT_TRUE(until([&] { return shop_.report("press").stall == "machine in emergency stop"; }));
  EXPECT_TRUE(published("machine press machine held"));
  std::string notes;
  until([] { return false; }, 500ms);
  for (const store::LedgerRow& row : shop_.ledger_of(job.id)) notes += row.note + "\n";
  EXPECT_NE(notes.find("machine held\n"), std::string::npos) << notes;
  EXPECT_NE(notes.find("machine alarm; machine alarm 504\n"), std::string::npos) << notes;
  plc_.show({{.state = MachineState::running}});
  plc_.give_credit(true);
  ASSERT_TRUE(until([&] { return shop_.state(job.id) == JobState::done; }));
  EXPECT_EQ(plc_.text(), program(200));
}

TEST_F(MachineWordsTest, APlcWithoutThemWorksAsBefore) {
  plc_.show(std::nullopt);
  open();
  const store::Release release = release_text(shop_.store, "press", program(200));
  for (const bool ignores : {false, true}) {
    plc_.show(std::nullopt, ignores);
    const store::Job job = must(shop_.jobs.add(release.id, "anna"));
    must(shop_.jobs.arm(job.id, std::nullopt, "olga"));
    ASSERT_TRUE(until([&] { return shop_.state(job.id) == JobState::done; })) << shop_.report("press").cause;
    EXPECT_EQ(plc_.text(), program(200));
    EXPECT_FALSE(machine());
    EXPECT_EQ(plc_.answers(), 0);
  }
}

TEST_F(MachineWordsTest, ThatComeLaterAreFound) {
  plc_.show(std::nullopt);
  open();
  until([] { return false; }, 5s);
  EXPECT_FALSE(machine());
  plc_.show({{.state = MachineState::manual}});
  EXPECT_TRUE(until([&] { return machine() && machine()->state == "manual"; }, 150s));
}

TEST_F(MachineWordsTest, APlcThatIsAwayIsAskedLessAndLessOften) {
  plc_.go_away(true);
  open();
  until([] { return false; }, 20s);
  const int before = plc_.reads();
  until([] { return false; }, 20s);
  EXPECT_LE(plc_.reads() - before, 6) << "every 5 s";
}

TEST_F(MachineWordsTest, ALineWithoutASeatSaysWhy) {
  Lines lines(
      shop_.links,
      [](const machine::LinkUrl&, BusUser&) -> std::expected<std::unique_ptr<BusSeat>, std::string> {
        return std::unexpected("there are 16 buses already");
      },
      [] {}, history_of(shop_.store, {}));
  const auto profile = must(shop_.documents.read_profile(std::string("press ") + kPlcUrl));
  EXPECT_EQ(refusal(lines.set(profile)).text, "there are 16 buses already");
  EXPECT_EQ(lines.find("press"), nullptr);
  EXPECT_EQ(lines.why_none("press"), "there are 16 buses already");
  EXPECT_EQ(lines.why_none("lathe"), "");
}

TEST_F(MachineWordsTest, ARingIsAnsweredOnceAndRecorded) {
  plc_.show({{.state = MachineState::idle}});
  open();
  ASSERT_TRUE(shows("idle"));
  release_text(shop_.store, "press", program(20));  // O0042, for drip
  const auto refused = static_cast<int>(modbus::BellOutcome::refused);
  using Answer = std::pair<int, int>;
  EXPECT_EQ(ring(1, 1, 42), (Answer{refused, static_cast<int>(modbus::BellReason::drip_only)}));
  EXPECT_EQ(ring(2, 1, 43), (Answer{refused, static_cast<int>(modbus::BellReason::not_found)}));
  EXPECT_EQ(ring(3, 2, 42), (Answer{refused, static_cast<int>(modbus::BellReason::not_allowed)}));
  EXPECT_EQ(ring(4, 9, 42), (Answer{refused, static_cast<int>(modbus::BellReason::unknown)}));
  EXPECT_EQ(ring(5, 3, 0), (Answer{static_cast<int>(modbus::BellOutcome::answered), 0}));
  EXPECT_EQ(ring(6, 4, 0), (Answer{static_cast<int>(modbus::BellOutcome::answered), 0}));
  EXPECT_TRUE(published("receipt press doorbell 6: call 0: answered, the machine calls for a person"));
  EXPECT_TRUE(until([&] { return published("alarm press the machine calls for a person"); }));
  EXPECT_EQ(plc_.answers(), 6);
  EXPECT_EQ(requests(), 6U);
  until([] { return false; }, 3s);
  EXPECT_EQ(plc_.answers(), 6) << "an answered ring stays so";
  EXPECT_EQ(requests(), 6U);
}

TEST_F(MachineWordsTest, ARingBeforeTheStartIsMissed) {
  plc_.show({{.state = MachineState::idle, .bell = 3, .request = 4}});
  open();
  ASSERT_TRUE(until([&] { return modbus::answered_bell(plc_.answer()) == 3; }));
  EXPECT_EQ(plc_.answer()[2], static_cast<std::uint16_t>(modbus::BellReason::missed));
  EXPECT_EQ(requests(), 0U);
  EXPECT_TRUE(until(
      [&] { return shop_.report("press").link_note == "doorbell 3 was missed: the server did not see it come"; }));
  EXPECT_TRUE(until([&] { return published("alarm press doorbell 3 was missed: the server did not see it come"); }));
  EXPECT_EQ(ring(4, 4, 0).first, static_cast<int>(modbus::BellOutcome::answered));
  EXPECT_TRUE(until([&] { return shop_.report("press").link_note.empty(); }));
}

TEST_F(MachineWordsTest, ARingDuringATransferDisturbsNothing) {
  plc_.show({{.state = MachineState::running}});
  open();
  plc_.lose_calls(5);
  const store::Job job = shop_.add_job("press", program(400));
  must(shop_.jobs.arm(job.id, std::nullopt, "olga"));
  for (std::uint16_t bell = 1; bell <= 5; ++bell) ring(bell, 4, 0);
  ASSERT_TRUE(until([&] { return shop_.state(job.id) == JobState::done; })) << shop_.report("press").cause;
  EXPECT_EQ(plc_.text(), program(400));
}

}  // namespace
}  // namespace dripfeed::app
