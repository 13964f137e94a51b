// What a real line does between a control's DC3 and our silence, measured on the line itself with its two data wires
// bridged (a loopback plug): how long a character takes back and forth, and how many of ours still come after a DC3.
// The stream is paced as a feed is, so the count is the one that a control would see.
#pragma once

#include <array>
#include <cstdint>
#include <expected>
#include <string>
#include <vector>

#include "server/app/ports/link_thread.h"
#include "server/machine/profile.h"

namespace dripfeed::app {

struct LinkTestPlan {
  std::uint32_t round_trips = 50;
  std::uint32_t holds = 50;
  feed::Time patience = std::chrono::seconds(3);  // for a character that should come back
};

struct LinkTestResult {
  std::vector<feed::Time> latencies;     // sorted; of a character beyond its own line time
  std::vector<std::uint64_t> after_dc3;  // sorted; characters that arrived behind each DC3
  std::uint64_t characters = 0;          // sent in all
  std::uint64_t wrong = 0;               // came back as something else
  std::uint32_t latency_chars = 0;       // the longest of latencies on this line, rounded up
  feed::Time char_time{};                // of one character
  LineErrors errors;                     // that the UART counted
};

// Sends on the line: nothing but a plug may be at its other end. Or one sentence that says what was seen instead: the
// link did not open, nothing came back. Not from the links' thread; takes about round_trips + holds times 50 ms.
std::expected<LinkTestResult, std::string> test_link(const machine::LineSettings& line, LinkThread& thread,
                                                     const LinkTestPlan& plan);

}  // namespace dripfeed::app
