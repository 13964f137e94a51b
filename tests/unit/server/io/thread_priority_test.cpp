// What the system grants the links' thread, it has; what it does not grant changes nothing.
#include "server/io/thread_priority.h"

#include <thread>

#include <gtest/gtest.h>
#include <sched.h>

namespace dripfeed::io {
namespace {

TEST(ThreadPriority, AThreadOfItsOwnGoesBeforeOthersOrStaysAsItIs) {
  const std::string here = how_scheduled();
  std::string there;
  int policy = -1;
  std::thread([&] {
    go_before_others();
    stay_in_memory();
    there = how_scheduled();
    policy = ::sched_getscheduler(0) & ~SCHED_RESET_ON_FORK;
  }).join();
  if (policy == SCHED_RR) {
    EXPECT_EQ(there, "with real-time priority 1");
  } else {
    EXPECT_TRUE(there == "at nice -11" || there == here) << there;
  }
  EXPECT_EQ(how_scheduled(), here) << "this thread is none of it";
}

}  // namespace
}  // namespace dripfeed::io
