// The memory that a command may take for the programs that it was given: an allocation beyond it ends the command with
// a sentence. Commands that feed a line do without: nothing but the line may end them.
#pragma once

#include <cstdint>
#include <string>

namespace dripfeed::cli {

// From here on no more than `bytes` may be taken beyond what the process has. `sentence` is what standard error says
// then, and `exit_code` what the process ends with.
void limit_memory(std::uint64_t bytes, std::string sentence, int exit_code);

// A text of that size is about to be worked on: the budget grows by what app::memory_for says. Does nothing before
// begin_text_budget.
void grant_memory(std::uint64_t text_bytes);
void begin_text_budget();

}  // namespace dripfeed::cli
