// The start and the end of a server: what a kill left unfinished becomes interrupted before a line opens, and an
// orderly end leaves no block open.
#include "server/app/application.h"

#include <atomic>
#include <chrono>
#include <filesystem>
#include <thread>

#include "tests/unit/server/app/whole_shop.h"

namespace dripfeed::app {
namespace {

using namespace std::chrono_literals;
using namespace test;
using store::JobState;

class ApplicationTest : public ShopTest {
 protected:
  // A server on the store, with cables of its own.
  struct Server {
    explicit Server(const std::string& database, feed::Time later = 0ms)
        : store(must(sqlite::open(database, {.own = true}))) {
      links.advance(later);
      application = std::make_unique<Application>(Application::Environment{
          .store = *store, .links = links, .take_seat = nullptr, .clock = links.clock(), .documents = documents});
    }
    [[nodiscard]] std::string written() { return text_of(links.cable(url_of(kLathe)).written); }

    std::unique_ptr<store::Store> store;
    dripfeed::test::FakeLinkThread links;
    PlainDocuments documents;
    std::unique_ptr<Application> application;
  };

  // A store in which a job fed, and the server was killed.
  store::Job leave_a_killed_job(feed::Time fed) {
    Shop shop(database());
    shop.add_machine(kLathe);
    const store::Job job = shop.start_job(kLathe, program(50));
    shop.run(fed);
    for (const char* ending : {"", "-wal"}) std::filesystem::copy_file(database() + ending, killed() + ending);
    return job;
  }
  [[nodiscard]] std::string killed() const { return folder_.file("killed.db"); }
};

TEST_F(ApplicationTest, AfterAKillJobsAreInterruptedAndNothingMoves) {
  const store::Job job = leave_a_killed_job(300ms);
  Server server(killed());
  must(server.application->start());
  server.links.run_posted();
  const store::Job after = must(server.store->jobs().get(job.id));
  EXPECT_EQ(after.state, JobState::interrupted);
  EXPECT_TRUE(after.needs_confirmation());
  const auto first = static_cast<std::uint64_t>(server.links.clock().wall_ms());
  const auto events = server.application->events().since(first - 1).events;
  ASSERT_FALSE(events.empty());
  EXPECT_EQ(events.front().kind, EventKind::job);
  EXPECT_EQ(events.front().job.state, JobState::interrupted);

  const MachineStatus status = server.application->status(kLathe);
  EXPECT_EQ(status.report.state, LineState::torn) << "the line is made as it was left";
  ASSERT_TRUE(status.needs_confirmation);
  EXPECT_EQ(status.needs_confirmation->job, job.id);
  server.links.receive(url_of(kLathe), kDc1);
  server.links.advance(10s);
  EXPECT_EQ(server.written(), "");
  Jobs& jobs = server.application->jobs();
  const store::Job next = must(jobs.add(job.release, "anna"));
  EXPECT_EQ(refusal(jobs.arm(next.id, std::nullopt, "olga")).code, ErrorCode::refused);
  must(jobs.confirm_reset(kLathe, "reset", "olga"));
  EXPECT_EQ(server.application->status(kLathe).report.state, LineState::idle);
  must(jobs.arm(next.id, std::nullopt, "olga"));
  must(jobs.cancel(next.id, "olga"));
}

TEST_F(ApplicationTest, EventIdsGoOnAboveThoseOfTheServerBefore) {
  std::uint64_t last = 0;
  {
    Server server(database());
    must(server.application->start());
    must(server.application->catalog().add_machine("lathe " + url_of(kLathe), "anna"));
    last = server.application->events().last_id();
  }
  Server next(database(), 1s);
  EXPECT_GE(next.application->events().last_id(), last);
  EXPECT_TRUE(next.application->events().since(last).reset) << "who saw that server is told to reload";
}

TEST_F(ApplicationTest, ShowsTheBlockThatIsInTransit) {
  Server server(database());
  must(server.application->start());
  must(server.application->catalog().add_machine("lathe " + url_of(kLathe), "anna"));
  server.links.run_posted();
  EXPECT_EQ(server.application->status(kLathe).program, "");
  for (const bool two_characters : {false, true}) {
    std::string text;
    for (const char c : program(20)) text += two_characters && c == '\n' ? "\r\n" : std::string(1, c);
    Jobs& jobs = server.application->jobs();
    const store::Job job = must(jobs.add(release_text(*server.store, kLathe, text).id, "anna"));
    must(jobs.arm(job.id, std::nullopt, "olga"));
    const std::size_t before = server.written().size();
    server.links.receive(url_of(kLathe), kDc1);
    jobs.wait_until_booked();  // the first window is reserved
    server.links.run_posted();
    for (int i = 0; i < 80; ++i) {
      server.links.advance(3ms);
      server.links.receive(url_of(kLathe), kDc3);  // news are reported at once, counters alone only every 20 ms
      server.links.receive(url_of(kLathe), kDc1);
      const std::string sent = server.written().substr(before);
      if (sent.empty()) continue;
      const std::size_t from = sent.size() < 2 ? 0 : sent.rfind('\n', sent.size() - 2) + 1;
      std::string block = program(20).substr(from);
      block.resize(block.find('\n'));
      ASSERT_EQ(server.application->status(kLathe).block_text, block) << "after " << sent.size();
    }
    EXPECT_EQ(server.application->status(kLathe).program, "O0042");
    must(jobs.cancel(job.id, "olga"));
    server.links.advance(1s);
    for (int i = 0; i < 500 && !store::ended(must(server.store->jobs().get(job.id)).state); ++i)
      std::this_thread::sleep_for(10ms);
    ASSERT_EQ(must(server.store->jobs().get(job.id)).state, JobState::cancelled);
  }
}

TEST_F(ApplicationTest, AnOrderlyEndCancelsAtABlockEnd) {
  store::Id fed = 0;
  store::Id armed = 0;
  std::string written;
  {
    Server server(database());
    must(server.application->start());
    for (const std::string machine : {"lathe", "mill"})
      must(server.application->catalog().add_machine(machine + " " + url_of(machine), "anna"));
    server.links.run_posted();
    Jobs& jobs = server.application->jobs();
    fed = must(jobs.add(release_text(*server.store, "lathe", program(50)).id, "anna")).id;
    armed = must(jobs.add(release_text(*server.store, "mill", "%\n(MILL)\nM30\n%\n").id, "anna")).id;
    must(jobs.arm(fed, std::nullopt, "olga"));
    must(jobs.arm(armed, std::nullopt, "olga"));
    server.links.receive(url_of("lathe"), kDc1);
    jobs.wait_until_booked();  // the first window is reserved
    server.links.run_posted();
    server.links.advance(100ms);
    ASSERT_NE(server.written().back(), '\n');
    // Time goes on while the server ends.
    std::atomic<bool> over = false;
    std::thread clock([&] {
      while (!over.load()) {
        server.links.advance(1ms);
        std::this_thread::sleep_for(1ms);
      }
    });
    server.application.reset();
    over.store(true);
    clock.join();
    written = server.written();
  }
  EXPECT_EQ(written.back(), '\n');
  EXPECT_LT(written.size(), program(50).size());
  const auto store = must(sqlite::open(database()));
  EXPECT_EQ(must(store->jobs().get(fed)).state, JobState::cancelled);
  EXPECT_FALSE(must(store->jobs().get(fed)).torn);
  EXPECT_EQ(must(store->jobs().get(armed)).state, JobState::queued);
}

}  // namespace
}  // namespace dripfeed::app
