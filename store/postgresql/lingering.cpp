// Two seconds: a server that is busy takes some tenths of one to end a process.
#include "store/postgresql/lingering.h"

#include <chrono>
#include <thread>

namespace dripfeed::postgresql {

store::Result<void> wait_for_the_ended(store::ErrorCode code, const std::function<store::Result<void>()>& attempt) {
  constexpr std::chrono::milliseconds kPatience{2000};
  constexpr std::chrono::milliseconds kBetween{20};
  const auto until = std::chrono::steady_clock::now() + kPatience;
  auto done = attempt();
  while (!done && done.error().code == code && std::chrono::steady_clock::now() < until) {
    std::this_thread::sleep_for(kBetween);
    done = attempt();
  }
  return done;
}

}  // namespace dripfeed::postgresql
