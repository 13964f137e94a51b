// What a real line does between a control's DC3 and our silence, measured on the line itself with its two data wires
// bridged (a loopback plug): how long a character takes back and forth, and how many of ours still come after a DC3.
// The stream is paced as a feed is, so the count is the one that a control would see.
#pragma once

#include <array>
#include <cstdint>
#include <expected>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

#include "server/app/ports/link_thread.h"
#include "server/machine/profile.h"

namespace dripfeed::app {

struct LinkTestPlan {
  std::uint32_t round_trips = 50;
  std::uint32_t holds = 50;
  feed::Time patience = std::chrono::seconds(3);  // for a character that should come back
  std::stop_token stop;                           // ends it at once
};

// What was seen instead of a result.
struct LinkTestFault {
  std::string_view id;  // one of kLinkTestFaults
  std::string text;     // one sentence
};
inline constexpr std::string_view kLinkTestFaults[] = {
    "no_characters",  // the link carries none
    "settings",       // of the line are wrong
    "not_open",       // the system refuses the port, or the other side does not answer
    "lost",           // the link broke
    "nothing_came",   // of what was sent: no plug
    "other_came",     // what came is not what was sent: a control, or another speed or framing
    "ended",          // by the server's end
};

struct LinkTestResult {
  std::vector<feed::Time> latencies;     // sorted; of a character beyond its own line time
  std::vector<std::uint64_t> after_dc3;  // sorted; characters that arrived after each DC3
  std::uint64_t characters = 0;          // sent in all
  std::uint64_t wrong = 0;               // came back as something else
  std::uint32_t latency_chars = 0;       // the longest of latencies on this line, rounded up
  feed::Time char_time{};                // of one character
  LineErrors errors;                     // that the UART counted
};

// Nothing came back wrong, and no more after a DC3 than the machine takes.
bool keeps_budget(const LinkTestResult& result, const machine::LineSettings& line);

// First a few NUL and DEL are sent, one at a time, which every control skips. Only where each comes back the line is
// bridged, and letters follow: never the end of a block, so that a control would run nothing even then. Not from the
// links' thread; takes about round_trips + holds times 50 ms.
std::expected<LinkTestResult, LinkTestFault> test_link(const machine::LineSettings& line, LinkThread& thread,
                                                       const LinkTestPlan& plan);

}  // namespace dripfeed::app
