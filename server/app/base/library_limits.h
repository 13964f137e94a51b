// What a shop lets its library grow to, and how long an archived program stays, as the options of the server state it.
#pragma once

#include <cstdint>

namespace dripfeed::app {

struct LibraryLimits {
  std::uint64_t program_bytes = std::uint64_t{64} << 20U;     // of one text
  std::uint64_t attachment_bytes = std::uint64_t{64} << 20U;  // of one attached file
  std::uint64_t store_bytes = 0;                              // of all contents; 0: no limit but the disk
  std::uint32_t delete_after_days = 30;                       // after a program was archived
};

}  // namespace dripfeed::app
