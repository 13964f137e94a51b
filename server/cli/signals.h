// What signals mean to a command that serves lines: none of them may cut it off inside a block without being asked
// twice. The table is in signals.cpp. Commands that only compute keep the system's meanings.
#pragma once

#include <functional>
#include <stop_token>

namespace dripfeed::cli {

// A request to stop, and a second one to stop at once; the next one after that ends the process.
struct Stops {
  std::stop_token first;
  std::stop_token second;
};

// For a transfer or a simulated control. Call it before any thread starts: what it blocks is blocked in all of them.
Stops stop_by_two_signals();

// For a server: one request to stop, and the next ends the process. SIGHUP calls `reload`, on a thread of its own.
std::stop_token stop_by_signal_and_reload(std::function<void()> reload);

}  // namespace dripfeed::cli
