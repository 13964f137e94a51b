// Limits by setrlimit, priority by setpriority; what a system refuses stays as it is.
#include "server/cli/withdraw.h"

#include <algorithm>
#include <csignal>
#include <string_view>

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <unistd.h>

namespace dripfeed::cli {

namespace {

void limit(int what, rlim_t most) {
  rlimit limits{};
  if (::getrlimit(static_cast<__rlimit_resource>(what), &limits) != 0) return;
  limits.rlim_cur = limits.rlim_max == RLIM_INFINITY ? most : std::min(most, limits.rlim_max);
  limits.rlim_max = limits.rlim_cur;
  ::setrlimit(static_cast<__rlimit_resource>(what), &limits);
}

// Where the system itself runs out of memory, it is this process that goes.
void prefer_to_be_killed() {
  const int file = ::open("/proc/self/oom_score_adj", O_WRONLY | O_CLOEXEC);
  if (file < 0) return;
  constexpr std::string_view kFirst = "1000";
  static_cast<void>(::write(file, kFirst.data(), kFirst.size()) < 0);  // refused in some containers
  ::close(file);
}

}  // namespace

void withdraw(std::uint32_t cpu_seconds) {
  constexpr rlim_t kSpareSeconds = 10;
  constexpr rlim_t kMostFiles = 64;
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  ::close_range(STDERR_FILENO + 1, ~0U, 0);
  ::setpriority(PRIO_PROCESS, 0, 19);
  limit(RLIMIT_CORE, 0);
  prefer_to_be_killed();
  limit(RLIMIT_NOFILE, kMostFiles);
  if (cpu_seconds > 0) limit(RLIMIT_CPU, cpu_seconds + kSpareSeconds);
}

}  // namespace dripfeed::cli
