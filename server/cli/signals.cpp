// A thread waits for the signals: no handler, so nothing runs at a bad moment.
#include "server/cli/signals.h"

#include <thread>

#include <signal.h>
#include <unistd.h>

namespace dripfeed::cli {

std::stop_token stop_by_signal() {
  sigset_t signals;
  sigemptyset(&signals);
  sigaddset(&signals, SIGINT);
  sigaddset(&signals, SIGTERM);
  pthread_sigmask(SIG_BLOCK, &signals, nullptr);
  // It lives as long as the process: there is no end to wait for.
  static std::stop_source source;
  std::thread([signals] {
    int which = 0;
    sigwait(&signals, &which);
    source.request_stop();
    // A second one ends the process at once: here it finds somebody who does not block it.
    pthread_sigmask(SIG_UNBLOCK, &signals, nullptr);
    for (;;) ::pause();
  }).detach();
  return source.get_token();
}

}  // namespace dripfeed::cli
