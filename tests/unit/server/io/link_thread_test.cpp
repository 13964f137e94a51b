// The fence of the links' thread: what one line throws stops no other.
#include <stdexcept>
#include <thread>

#include "tests/unit/server/io/listening.h"

namespace dripfeed::io {
namespace {

using namespace std::chrono_literals;

class Beat final : public app::Ticker {
 public:
  explicit Beat(bool throws) : throws_(throws) {}
  void tick(feed::Time now) override {
    due_ = now + 1ms;
    ++count;
    if (throws_ && count == 3) throw std::runtime_error("no memory for this line");
  }
  [[nodiscard]] std::optional<feed::Time> deadline() const override { return due_; }
  int count = 0;

 private:
  bool throws_;
  feed::Time due_{};
};

TEST(LinkThread, WhatOneLineThrowsStopsNoOther) {
  const auto thread = start_link_thread();
  Beat bad(true);
  Beat good(false);
  thread->run([&] {
    thread->add(bad);
    thread->add(good);
  });
  int beats = 0;
  for (int i = 0; i < 30'000 && beats < 20; ++i) {
    thread->run([&] { beats = good.count; });
    std::this_thread::sleep_for(1ms);
  }
  EXPECT_GE(beats, 20);
  thread->post([] { throw std::runtime_error("a handler"); });
  thread->run([&] {
    EXPECT_GT(bad.count, 3);
    thread->remove(bad);
    thread->remove(good);
  });
}

// Due for ever, and without memory for ever.
class Lost final : public app::Ticker {
 public:
  void tick(feed::Time) override {
    ++count;
    throw std::runtime_error("no memory for this line");
  }
  [[nodiscard]] std::optional<feed::Time> deadline() const override { return feed::Time{}; }
  int count = 0;
};

TEST(LinkThread, WhoThrowsAtEachCallKeepsNoOtherFromItsOwn) {
  const auto thread = start_link_thread();
  Lost lost;
  Beat good(false);
  thread->run([&] {
    thread->add(lost);
    thread->add(good);
  });
  int beats = 0;
  for (int i = 0; i < 30'000 && beats < 20; ++i) {
    thread->run([&] { beats = good.count; });
    std::this_thread::sleep_for(1ms);
  }
  thread->run([&] {
    EXPECT_GE(good.count, 20);
    EXPECT_GT(lost.count, 3);
    // It is called again after a pause, not as fast as the computer can.
    EXPECT_LT(lost.count, 100 * good.count);
    thread->remove(lost);
    thread->remove(good);
  });
}

TEST(LinkThread, WhatIsRunThrowsAtItsCaller) {
  const auto thread = start_link_thread();
  EXPECT_THROW(thread->run([] { throw std::runtime_error("mine"); }), std::runtime_error);
}

}  // namespace
}  // namespace dripfeed::io
