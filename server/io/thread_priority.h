// How the system lets the links' thread go before what else the machine computes, and keeps what it runs on in memory.
// docs/scheduling.md says what that is for.
#pragma once

#include <string>

namespace dripfeed::io {

// For the calling thread: real-time priority, else the highest ordinary one that the system grants. What it refuses
// stays as it was: the links work all the same, as well as the machine has time.
void go_before_others();

// Whatever of this process was touched stays in memory, as far as it is mapped now, and so does the calling thread's
// stack; where the system grants that.
void stay_in_memory();

// How the calling thread is scheduled, for people: "with real-time priority 1", "at nice -11", "like any other".
std::string how_scheduled();

}  // namespace dripfeed::io
