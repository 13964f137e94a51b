// dripfeed worker: one piece of work for the server, in a process that can touch nothing of it. Not for people: it
// reads a package from standard input and writes one to standard output.
#include <algorithm>
#include <cerrno>
#include <csignal>
#include <memory>
#include <string>
#include <string_view>

#include <CLI/CLI.hpp>
#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <unistd.h>

#include "server/cli/cli.h"
#include "server/cli/memory_budget.h"
#include "server/cli/output.h"
#include "server/json/workers.h"

namespace dripfeed::cli {

namespace {

struct WorkerOptions {
  std::uint64_t memory_bytes = 0;
  std::uint32_t seconds = 0;
};

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

// Nothing of the server but standard input, output and error; ends with it; behind everything else.
void withdraw(const WorkerOptions& options) {
  constexpr rlim_t kSpareSeconds = 10;
  constexpr rlim_t kMostFiles = 64;
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  ::close_range(STDERR_FILENO + 1, ~0U, 0);
  ::setpriority(PRIO_PROCESS, 0, 19);
  limit(RLIMIT_CORE, 0);
  prefer_to_be_killed();
  limit(RLIMIT_NOFILE, kMostFiles);
  if (options.seconds > 0) limit(RLIMIT_CPU, options.seconds + kSpareSeconds);
  if (options.memory_bytes > 0)
    limit_memory(options.memory_bytes, "dripfeed: a check needs more memory than it may have\n", kOverMemory);
}

bool read_request(std::string& into) {
  constexpr std::size_t kPieceBytes = std::size_t{256} << 10U;
  for (;;) {
    const std::size_t size = into.size();
    into.resize(size + kPieceBytes);
    const ssize_t count = ::read(STDIN_FILENO, into.data() + size, kPieceBytes);
    into.resize(size + static_cast<std::size_t>(std::max<ssize_t>(count, 0)));
    if (count == 0) return true;
    if (count < 0 && errno != EINTR) return false;
  }
}

bool write_reply(std::string_view reply) {
  while (!reply.empty()) {
    const ssize_t count = ::write(STDOUT_FILENO, reply.data(), reply.size());
    if (count > 0) reply.remove_prefix(static_cast<std::size_t>(count));
    if (count < 0 && errno != EINTR) return false;
  }
  return true;
}

int work(const WorkerOptions& options) {
  withdraw(options);
  std::string request;
  if (!read_request(request) || request.empty()) return kWrongUse;  // it was not needed
  return write_reply(json::carry_out(request)) ? kDone : kWrongUse;
}

}  // namespace

void add_worker(CLI::App& app, int& exit_code) {
  CLI::App* command = app.add_subcommand("worker", "one check for the server; not for people");
  command->group("");  // not in the help
  const auto options = std::make_shared<WorkerOptions>();
  command->add_option("--memory-bytes", options->memory_bytes, "what it may take");
  command->add_option("--seconds", options->seconds, "of computing; 0: as long as it takes");
  command->callback([options, &exit_code] { exit_code = work(*options); });
}

}  // namespace dripfeed::cli
