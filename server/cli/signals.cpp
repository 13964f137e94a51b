// A thread waits for the signals: no handler, so nothing runs at a bad moment.
#include "server/cli/signals.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <exception>
#include <string_view>
#include <thread>
#include <utility>

#include <fmt/format.h>
#include <signal.h>
#include <unistd.h>

#include "server/cli/logging.h"

namespace dripfeed::cli {

namespace {

enum class Meaning : std::uint8_t {
  stop,     // at the end of the block; one more at once; one more ends the process
  hang_up,  // a server reloads; a transfer stops at the end of the block. It never counts as the second one, because a
            // terminal that closes sends it twice: the system and the shell
  logged,   // is ignored, and the log says so
  ignored,  // is ignored: the call that failed says what there is to say
};

struct Row {
  int signal;
  std::string_view name;
  Meaning meaning;
};
// Every signal that ends or stops a process unless it is taken, and that a terminal, a shell, a supervisor, a limit or
// an output sends. Left as they are: SIGKILL and SIGSTOP, which no one can take; those of a fault of the program itself
// (SIGSEGV, SIGBUS, SIGILL, SIGFPE, SIGABRT, SIGTRAP, SIGSYS); and those that do nothing by themselves (SIGCHLD,
// SIGCONT, SIGURG, SIGWINCH).
constexpr std::array kRows = {
    Row{SIGINT, "SIGINT", Meaning::stop},          // Ctrl-C
    Row{SIGTERM, "SIGTERM", Meaning::stop},        // a supervisor
    Row{SIGQUIT, "SIGQUIT", Meaning::stop},        // Ctrl-\.
    Row{SIGHUP, "SIGHUP", Meaning::hang_up},       // the terminal closed; a supervisor's reload
    Row{SIGTSTP, "SIGTSTP", Meaning::logged},      // Ctrl-Z: a stopped process starves its controls
    Row{SIGUSR1, "SIGUSR1", Meaning::logged},      //
    Row{SIGUSR2, "SIGUSR2", Meaning::logged},      //
    Row{SIGALRM, "SIGALRM", Meaning::logged},      //
    Row{SIGVTALRM, "SIGVTALRM", Meaning::logged},  //
    Row{SIGPROF, "SIGPROF", Meaning::logged},      //
    Row{SIGIO, "SIGIO", Meaning::logged},          //
    Row{SIGPWR, "SIGPWR", Meaning::logged},        // a power supply's daemon
    Row{SIGSTKFLT, "SIGSTKFLT", Meaning::logged},  //
    Row{SIGXCPU, "SIGXCPU", Meaning::logged},      // the soft limit of CPU time
    Row{SIGXFSZ, "SIGXFSZ", Meaning::ignored},     // the limit of a file's size: the write fails
    Row{SIGPIPE, "SIGPIPE", Meaning::ignored},     // an output or a socket without a reader: the write fails
    Row{SIGTTIN, "SIGTTIN", Meaning::ignored},     // reading from a terminal in the background: the read fails
    Row{SIGTTOU, "SIGTTOU", Meaning::ignored},     // writing to one: it is written
};

struct Taken {
  sigset_t waited_for;
  sigset_t stops;
};

// Sets what the table says for this thread and those that it starts.
Taken take_signals() {
  Taken taken{};
  sigemptyset(&taken.waited_for);
  sigemptyset(&taken.stops);
  for (const Row& row : kRows) {
    if (row.meaning == Meaning::ignored) {
      ::signal(row.signal, SIG_IGN);
      continue;
    }
    sigaddset(&taken.waited_for, row.signal);
    if (row.meaning == Meaning::stop) sigaddset(&taken.stops, row.signal);
  }
  for (int number = SIGRTMIN; number <= SIGRTMAX; ++number) sigaddset(&taken.waited_for, number);
  pthread_sigmask(SIG_BLOCK, &taken.waited_for, nullptr);
  return taken;
}

// It lives as long as the process, and longer than what main destroys: it has sources of its own.
class Waiter {
 public:
  Waiter(const Taken& taken, std::size_t stops, std::function<void()> reload)
      : taken_(taken), stops_(stops), reload_(std::move(reload)) {}

  [[nodiscard]] Stops tokens() const { return {.first = sources_[0].get_token(), .second = sources_[1].get_token()}; }

  void wait() {
    for (;;) {
      int which = 0;
      if (sigwait(&taken_.waited_for, &which) == 0) take(which);
    }
  }

 private:
  void take(int which) {
    const auto* const row = std::ranges::find(kRows, which, &Row::signal);
    if (row == kRows.end()) return say(fmt::format("signal {} is ignored", which));
    switch (row->meaning) {
      case Meaning::stop: return stop();
      case Meaning::hang_up:
        if (reload_) return reload();
        if (seen_ == 0) stop();
        return;
      case Meaning::logged:
      case Meaning::ignored:
        return say(fmt::format("{} is ignored: it would stop the lines inside a block", row->name));
    }
  }

  // The fence of what a reload may do: it must not end the process.
  void reload() {
    try {
      reload_();
    } catch (const std::exception& error) {
      say(fmt::format("SIGHUP: the reload failed: {}", error.what()));
    }
  }

  void stop() {
    sources_[seen_++].request_stop();
    if (seen_ < stops_) return;
    // One more ends the process at once: here it finds a thread that does not block it.
    for (const Row& one : kRows) {
      if (one.meaning == Meaning::stop) sigdelset(&taken_.waited_for, one.signal);
    }
    pthread_sigmask(SIG_UNBLOCK, &taken_.stops, nullptr);
  }

  Taken taken_;
  std::size_t stops_;
  std::function<void()> reload_;
  std::size_t seen_ = 0;
  std::array<std::stop_source, 2> sources_;
};

Stops wait_for_signals(std::size_t stops, std::function<void()> reload) {
  Waiter waiter(take_signals(), stops, std::move(reload));
  const Stops tokens = waiter.tokens();
  std::thread([waiter = std::move(waiter)]() mutable {
    ::pthread_setname_np(::pthread_self(), "signals");
    waiter.wait();
  }).detach();
  return tokens;
}

}  // namespace

std::stop_token stop_by_signal_and_reload(std::function<void()> reload) {
  return wait_for_signals(1, std::move(reload)).first;
}

Stops stop_by_two_signals() { return wait_for_signals(2, {}); }

}  // namespace dripfeed::cli
