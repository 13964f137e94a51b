// What each line did since the server's start, summed over its jobs: a line's own report begins again with each job,
// and with each change of its settings. Fed by the follower, from what the ledger saw; nothing here touches a line.
#pragma once

#include <cstdint>
#include <map>
#include <mutex>
#include <string>
#include <string_view>

#include "server/app/lines/line.h"

namespace dripfeed::app {

struct LineSums {
  std::uint64_t sent_bytes = 0;       // handed to the link
  std::uint64_t confirmed_bytes = 0;  // by the protocol
  std::uint64_t sent_blocks = 0;      // lines of text that were handed with their ends
  std::uint64_t holds = 0;
  double hold_s = 0.0;
  LineErrors errors;
  std::uint64_t unarmed_starts = 0;
  std::uint64_t receptions = 0;
  std::uint64_t receptions_lost = 0;
  std::map<std::string_view, std::uint64_t> stalls;  // by name: how often one was seen to begin
  std::int64_t last_sent_ms = 0;                     // wall time at which a byte was seen to leave last; 0: none did
};

class LineTotals {
 public:
  // What the line reports now. All of one thread.
  void look(const std::string& machine, const LineReport& report, std::int64_t wall_ms);
  // From any thread.
  [[nodiscard]] std::map<std::string, LineSums> all() const;

 private:
  struct Seen {
    LineReport last;
    LineSums sums;
  };
  mutable std::mutex mutex_;  // of what the follower and readers share; no line takes it
  std::map<std::string, Seen> seen_;
};

}  // namespace dripfeed::app
