// Who holds a file's lock, without taking it: whoever takes one to look could keep a server from starting.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace dripfeed::io {

// The process that holds flock() on the file, from /proc/locks; nothing where none does, or the system does not show
// it (a process of another container).
std::optional<std::int64_t> lock_holder(const std::string& path, const std::string& locks = "/proc/locks");
// "dripfeed serve --data …": how the process was called; "" where the system does not say it.
std::string command_of(std::int64_t process);

}  // namespace dripfeed::io
