// What a process of the server does first that works for it and must touch nothing of it.
#pragma once

#include <cstdint>

namespace dripfeed::cli {

// Keeps standard input, output and error alone; ends with the server; yields to all other processes, and is the first
// to go where the system runs out of memory. `cpu_seconds`: of computing; 0: as long as it takes.
void withdraw(std::uint32_t cpu_seconds);

}  // namespace dripfeed::cli
