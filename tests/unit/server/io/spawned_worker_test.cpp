// Processes of a shell: what goes in and comes out, and how one ends that crashes, hangs or is not waited for.
#include "server/io/spawned_worker.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <csignal>
#include <mutex>
#include <thread>

#include <gtest/gtest.h>
#include <sys/socket.h>
#include <unistd.h>

#include "server/io/worker_desk.h"

namespace dripfeed::io {
namespace {

std::vector<std::string> shell(std::string script) { return {"/bin/sh", "-c", std::move(script)}; }
bool always(bool) { return true; }

TEST(WorkerProcess, GivesARequestLargerThanTheSocketAndHearsTheWholeReply) {
  auto process = WorkerProcess::start(shell("exec cat"));
  ASSERT_TRUE(process) << process.error();
  const std::string request(5'000'000, 'x');
  const auto done = process->exchange(request, -1, always);
  EXPECT_TRUE(done.end.is_good());
  EXPECT_EQ(done.reply, request);
}

TEST(WorkerProcess, SaysByWhichSignalItEnded) {
  auto process = WorkerProcess::start(shell("cat >/dev/null; kill -SEGV $$"));
  ASSERT_TRUE(process);
  const auto done = process->exchange("request", -1, always);
  EXPECT_EQ(done.end.signal, SIGSEGV);
  EXPECT_FALSE(done.was_given_up);
}

TEST(WorkerProcess, HasNoOtherFileOfOurs) {
  std::array<int, 2> pipe{};
  ASSERT_EQ(::pipe(pipe.data()), 0);
  auto process = WorkerProcess::start(shell("cat >/dev/null; exec ls /proc/self/fd"));
  ASSERT_TRUE(process);
  EXPECT_EQ(process->exchange("", -1, always).reply, "0\n1\n2\n3\n") << "3 is the folder";
  ::close(pipe[0]);
  ::close(pipe[1]);
}

TEST(WorkerDesk, KillsWhatTakesLongerThanItMayAndWhatNoOneWaitsFor) {
  WorkerDesk desk({.command = shell("exec sleep 60"), .at_once = 2});
  std::array<int, 2> peer{};
  ASSERT_EQ(::socketpair(AF_UNIX, SOCK_STREAM, 0, peer.data()), 0);
  std::jthread leaves([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(200));
    ::close(peer[1]);
  });
  const auto begun = std::chrono::steady_clock::now();
  const auto left = desk.carry_out("x", 60, {.stop = {}, .peer = peer[0]});
  ASSERT_FALSE(left);
  EXPECT_EQ(left.error().fault, app::WorkFault::abandoned);
  std::stop_source stop;
  stop.request_stop();
  const auto stopped = desk.carry_out("x", 60, {.stop = stop.get_token(), .peer = -1});
  ASSERT_FALSE(stopped);
  EXPECT_EQ(stopped.error().text, "the server is stopping");
  EXPECT_LT(std::chrono::steady_clock::now() - begun, std::chrono::seconds(5));
  ::close(peer[0]);
}

TEST(WorkerDesk, SaysThatItEndedAbnormallyOrWasOverItsMemory) {
  WorkerDesk crashes({.command = shell("cat >/dev/null; kill -ABRT $$"), .at_once = 1});
  const auto crashed = crashes.carry_out("x", 60, {});
  ASSERT_FALSE(crashed);
  EXPECT_EQ(crashed.error().fault, app::WorkFault::ended);
  EXPECT_EQ(crashed.error().text, "the check ended abnormally (signal 6): nothing is known of the program");
  WorkerDesk large({.command = shell("cat >/dev/null; exit 77"),
                    .at_once = 1,
                    .memory_bytes = std::uint64_t{512} << 20U,
                    .memory_exit_code = 77});
  const auto over = large.carry_out("x", 60, {});
  ASSERT_FALSE(over);
  EXPECT_EQ(over.error().fault, app::WorkFault::memory);
  EXPECT_EQ(over.error().text, "the program needs more than 512 MB to be checked");
}

TEST(WorkerDesk, SendsAwayWhoComesWhenAsManyWaitAsMay) {
  WorkerDesk desk({.command = shell("exec sleep 60"), .at_once = 1, .waiting = 1});
  std::stop_source stop;
  std::vector<std::jthread> callers;
  for (int i = 0; i < 2; ++i)
    callers.emplace_back([&] { (void)desk.carry_out("x", 60, {.stop = stop.get_token(), .peer = -1}); });
  while (desk.works().size() < 2) std::this_thread::sleep_for(std::chrono::milliseconds(5));
  const auto third = desk.carry_out("x", 60, {.stop = stop.get_token(), .peer = -1});
  ASSERT_FALSE(third);
  EXPECT_EQ(third.error().fault, app::WorkFault::busy);
  EXPECT_EQ(third.error().text, "1 checks are being made and 1 more wait: ask again in a while");
  stop.request_stop();
}

// Callers that came one after the other, with what each of them was answered.
class Callers {
 public:
  Callers(WorkerDesk& desk, std::size_t count) : desk_(desk), answers_(count) {
    for (std::size_t i = 0; i < count; ++i) {
      threads_.emplace_back([this, i] {
        const auto done = desk_.carry_out(
            "x", 60,
            {.stop = {}, .peer = -1, .work = {.kind = "check", .subject = {}, .machine = {}, .actor = "anna"}});
        const std::lock_guard lock(mutex_);
        answers_[i] = done ? *done : done.error().text;
      });
      while (desk_.works().size() <= i) std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
  }
  // "" until the caller has an answer; it is waited for.
  std::string answer_of(std::size_t caller) {
    threads_[caller].join();
    const std::lock_guard lock(mutex_);
    return answers_[caller];
  }

 private:
  WorkerDesk& desk_;
  std::mutex mutex_;
  std::vector<std::string> answers_;
  std::vector<std::jthread> threads_;
};

void wait_until_runs(WorkerDesk& desk, std::uint64_t work) {
  const auto runs = [&] {
    const auto all = desk.works();
    return std::ranges::any_of(all, [&](const app::Work& one) { return one.id == work && one.running_since_ms > 0; });
  };
  while (!runs()) std::this_thread::sleep_for(std::chrono::milliseconds(2));
}

TEST(WorkerDesk, DoesWhatCameFirstAndCancelsWhatRunsAndWhatWaits) {
  WorkerDesk desk({.command = shell("exec sleep 60"), .at_once = 1});
  Callers callers(desk, 4);
  const auto all = desk.works();
  ASSERT_EQ(all.size(), 4U);
  for (std::size_t i = 0; i < all.size(); ++i) {
    EXPECT_EQ(all[i].id, i + 1);
    EXPECT_EQ(all[i].place, i);
    EXPECT_EQ(all[i].running_since_ms > 0, i == 0);
    EXPECT_GT(all[i].waiting_since_ms, 0);
    EXPECT_EQ(all[i].budget_s, 60U);
    EXPECT_EQ(all[i].name.actor, "anna");
  }
  EXPECT_FALSE(desk.cancel(5, "bert"));
  EXPECT_TRUE(desk.cancel(3, "bert"));
  EXPECT_EQ(callers.answer_of(2), "it was cancelled by bert: nothing is known of it");
  EXPECT_FALSE(desk.cancel(3, "bert")) << "it is gone";
  EXPECT_TRUE(desk.cancel(1, "anna"));
  EXPECT_EQ(callers.answer_of(0), "it was cancelled by anna: nothing is known of it");
  wait_until_runs(desk, 2);
  EXPECT_EQ(desk.works().back().place, 1U) << "the last one is next now";
  EXPECT_TRUE(desk.cancel(2, "anna"));
  wait_until_runs(desk, 4);
  EXPECT_TRUE(desk.cancel(4, "anna"));
  callers.answer_of(1);
  callers.answer_of(3);
  EXPECT_TRUE(desk.works().empty());
}

}  // namespace
}  // namespace dripfeed::io
