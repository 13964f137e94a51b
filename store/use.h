// How busy a store is: what its writers waited and took since it was opened. Counted while they work, so that whoever
// asks waits for nothing.
#pragma once

#include <chrono>
#include <cstdint>

namespace dripfeed::store {

// Transactions that write; those that shared one commit count each.
struct WriteUse {
  std::uint64_t begun = 0;            // had their turn
  std::uint64_t waiting = 0;          // wait for it now
  std::chrono::nanoseconds waited{};  // for it, all together
  std::uint64_t turns = 0;            // that are over
  std::chrono::nanoseconds held{};    // from the turn to its end, all together
};

struct StoreUse {
  WriteUse ledger;  // what feeds wait for: it goes first
  WriteUse others;
};

}  // namespace dripfeed::store
