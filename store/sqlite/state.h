// A quick look at a store: what can be known of it without reading all of it. Nothing is written, and a server may run.
// Whether it is whole, verify() says.
#pragma once

#include <string>
#include <vector>

#include "store/error.h"

namespace dripfeed::sqlite {

struct StoreState {
  struct Machine {
    std::string name;
    std::string profile;  // its newest document
  };
  std::uint32_t schema = 0;
  std::uint32_t program_schema = 0;  // of this program
  std::int64_t newest_row_ms = 0;    // time of the newest row of the audit; 0: it has none
  std::uint64_t contents = 0;
  std::uint64_t hollow_contents = 0;  // that have no bytes, although they should
  std::uint64_t torn_machines = 0;    // wait for a person's confirmation
  std::vector<Machine> machines;
};

// A newer schema is not looked into: `schema` alone is set. Errors: cannot_open, not_a_store, corrupt, busy, io_failed.
store::Result<StoreState> look_at_store(const std::string& path);

}  // namespace dripfeed::sqlite
