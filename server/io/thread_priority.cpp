// Linux keeps a nice value for each thread.
#include "server/io/thread_priority.h"

#include <array>
#include <cstddef>

#include <fmt/format.h>
#include <sched.h>
#include <sys/mman.h>
#include <sys/resource.h>

namespace dripfeed::io {

namespace {

constexpr int kNice = -11;
constexpr std::size_t kStack_bytes = 131'072;
constexpr std::size_t kPage_bytes = 4096;

// More than the links' handlers ever need, so that none of them meets a page that is not there yet.
void touch_stack() {
  std::array<volatile std::byte, kStack_bytes> room;
  for (std::size_t i = 0; i < room.size(); i += kPage_bytes) room[i] = std::byte{0};
}

}  // namespace

void go_before_others() {
  const sched_param lowest{.sched_priority = ::sched_get_priority_min(SCHED_RR)};
  if (::sched_setscheduler(0, SCHED_RR | SCHED_RESET_ON_FORK, &lowest) == 0) return;  // 0: this thread
  static_cast<void>(::setpriority(PRIO_PROCESS, 0, kNice));
}

void stay_in_memory() {
  static_cast<void>(::mlockall(MCL_CURRENT | MCL_ONFAULT));
  touch_stack();
}

std::string how_scheduled() {
  sched_param now{};
  const int policy = ::sched_getscheduler(0) & ~SCHED_RESET_ON_FORK;
  if ((policy == SCHED_RR || policy == SCHED_FIFO) && ::sched_getparam(0, &now) == 0)
    return fmt::format("with real-time priority {}", now.sched_priority);
  const int nice = ::getpriority(PRIO_PROCESS, 0);
  return nice == 0 ? std::string("like any other") : fmt::format("at nice {}", nice);
}

}  // namespace dripfeed::io
