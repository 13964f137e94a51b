// RLIMIT_DATA counts what is private and writable, which is what a process keeps; the address space would count the
// reserves of allocators and sanitizers, too. What fails then is a single allocation in any thread and any depth, so
// the handler ends the process: there is nothing to tidy up in a command that only reads and prints.
#include "server/cli/memory_budget.h"

#include <algorithm>
#include <fstream>
#include <new>
#include <utility>

#include <fmt/format.h>
#include <sys/resource.h>
#include <unistd.h>

#include "server/app/base/check_budget.h"
#include "server/cli/cli.h"

namespace dripfeed::cli {

namespace {

struct Budget {
  std::string sentence;
  int exit_code = kWrongUse;
  bool counts_texts = false;
  std::uint64_t base_bytes = 0;  // of the process before any text
  std::uint64_t text_bytes = 0;
};
Budget& budget() {
  static Budget one;
  return one;
}

// Private and writable, in bytes: the sixth figure of statm, in pages.
std::uint64_t data_bytes() {
  std::ifstream statm("/proc/self/statm");
  std::uint64_t pages = 0;
  for (int i = 0; i < 6; ++i) statm >> pages;
  return pages * static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE));
}

// No allocation here.
void end_over_budget() {
  const std::string& sentence = budget().sentence;
  if (::write(STDERR_FILENO, sentence.data(), sentence.size()) < 0) ::_exit(budget().exit_code);
  ::_exit(budget().exit_code);
}

void set_limit(std::uint64_t bytes) {
  rlimit limit{};
  if (::getrlimit(RLIMIT_DATA, &limit) != 0) return;
  limit.rlim_cur = limit.rlim_max == RLIM_INFINITY ? bytes : std::min<rlim_t>(bytes, limit.rlim_max);
  ::setrlimit(RLIMIT_DATA, &limit);
  std::set_new_handler(end_over_budget);
}

}  // namespace

void limit_memory(std::uint64_t bytes, std::string sentence, int exit_code) {
  budget().sentence = std::move(sentence);
  budget().exit_code = exit_code;
  set_limit(data_bytes() + bytes);
}

void begin_text_budget() {
  budget().counts_texts = true;
  budget().base_bytes = data_bytes();
}

void grant_memory(std::uint64_t text_bytes) {
  if (!budget().counts_texts) return;
  budget().text_bytes += text_bytes;
  const std::uint64_t bytes = app::memory_for(budget().text_bytes);
  budget().sentence = fmt::format(
      "dripfeed: the program needs more than {} MB of memory, which is all that a text of {} bytes may take: it "
      "was not looked at\n",
      bytes >> 20U, budget().text_bytes);
  set_limit(budget().base_bytes + bytes);
}

}  // namespace dripfeed::cli
