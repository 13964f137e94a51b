// dripfeed worker: one piece of work for the server, in a process that can touch nothing of it. Not for people: it
// reads a package from standard input and writes one to standard output.
#include <algorithm>
#include <cerrno>
#include <memory>
#include <string>
#include <string_view>

#include <CLI/CLI.hpp>
#include <unistd.h>

#include "server/cli/cli.h"
#include "server/cli/memory_budget.h"
#include "server/cli/output.h"
#include "server/cli/withdraw.h"
#include "server/json/workers.h"

namespace dripfeed::cli {

namespace {

struct WorkerOptions {
  std::uint64_t memory_bytes = 0;
  std::uint32_t seconds = 0;
};

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
  withdraw(options.seconds);
  if (options.memory_bytes > 0)
    limit_memory(options.memory_bytes, "dripfeed: a check needs more memory than it may have\n", kOverMemory);
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
