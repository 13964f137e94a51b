// Interrupt and termination as a stop token, so that a command ends its work instead of being cut off in a block.
#pragma once

#include <stop_token>

namespace dripfeed::cli {

// Blocks SIGINT and SIGTERM for this thread and those it starts; the first one that comes requests a stop. Call it
// before any thread starts.
std::stop_token stop_by_signal();

// The same for a command that can stop gently, and then at once.
struct Stops {
  std::stop_token first;
  std::stop_token second;
};
Stops stop_by_two_signals();

}  // namespace dripfeed::cli
