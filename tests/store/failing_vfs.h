// A VFS of SQLite that passes all on to the system's, and fails the n-th change of a file: a write in half, a sync, a
// truncation or a removal. After that every change fails, as with a full disk or a lost one, or everything works again.
#pragma once

#include <cstdint>

namespace dripfeed::store_test {

inline constexpr const char* kFailingVfs = "failing";

enum class Fault : std::uint8_t {
  full_for_good,  // disk full, from the n-th change on
  lost_for_good,  // I/O error, from the n-th change on
  once,           // an I/O error, then all is well again
};

// Makes the VFS known to SQLite; calling it again changes nothing.
void register_failing_vfs();
// From now on the n-th change fails (1 is the next one); 0 never.
void fail_at(std::uint64_t n, Fault fault);
// Whether that change came.
bool failed();

}  // namespace dripfeed::store_test
