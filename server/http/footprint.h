// What this process takes of its computer, as the system counts it.
#pragma once

#include <cstdint>
#include <optional>

namespace dripfeed::http {

struct Footprint {
  double cpu_s = 0.0;  // user and system, of all threads; not of worker processes
  std::uint64_t resident_bytes = 0;
  std::uint64_t virtual_bytes = 0;
  std::uint64_t threads = 0;
  double started_at_s = 0.0;  // since 1970
  std::uint64_t open_files = 0;
  std::uint64_t most_files = 0;
};

// Nothing where /proc does not say it.
std::optional<Footprint> footprint();

}  // namespace dripfeed::http
