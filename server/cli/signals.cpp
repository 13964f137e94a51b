// A thread waits for the signals: no handler, so nothing runs at a bad moment.
#include "server/cli/signals.h"

#include <array>
#include <cstddef>
#include <thread>
#include <utility>

#include <signal.h>
#include <unistd.h>

namespace dripfeed::cli {

namespace {

std::array<std::stop_token, 2> wait_for_signals(std::size_t count) {
  sigset_t signals;
  sigemptyset(&signals);
  sigaddset(&signals, SIGINT);
  sigaddset(&signals, SIGTERM);
  pthread_sigmask(SIG_BLOCK, &signals, nullptr);
  // It lives as long as the process, and longer than what main destroys: it has sources of its own.
  std::array<std::stop_source, 2> sources;
  std::array<std::stop_token, 2> tokens = {sources[0].get_token(), sources[1].get_token()};
  std::thread([signals, count, sources = std::move(sources)]() mutable {
    for (std::size_t i = 0; i < count; ++i) {
      int which = 0;
      sigwait(&signals, &which);
      sources[i].request_stop();
    }
    // One more ends the process at once: here it finds somebody who does not block it.
    pthread_sigmask(SIG_UNBLOCK, &signals, nullptr);
    for (;;) ::pause();
  }).detach();
  return tokens;
}

}  // namespace

std::stop_token stop_by_signal() { return wait_for_signals(1)[0]; }

Stops stop_by_two_signals() {
  const auto tokens = wait_for_signals(2);
  return {.first = tokens[0], .second = tokens[1]};
}

}  // namespace dripfeed::cli
