// A start that came while the line was used is none that waits.
#include "server/app/lines/asks.h"

#include <mutex>
#include <utility>

namespace dripfeed::app {

namespace {

bool is_free(LineState state) { return state == LineState::idle || state == LineState::disconnected; }

}  // namespace

Asks AskWatch::look(const std::string& machine, const LineReport& report, feed::Time now, std::int64_t wall_ms) {
  const std::lock_guard lock(mutex_);
  Heard& heard = heard_[machine];
  if (report.unarmed_starts < heard.starts) heard.starts = 0;  // a line that was made again
  const std::uint64_t more = report.unarmed_starts - std::exchange(heard.starts, report.unarmed_starts);
  if (!is_free(report.state)) return heard.asks = {};
  if (more > 0) {
    heard.last = now;
    if (heard.asks.count == 0) heard.asks.since_ms = wall_ms;
    heard.asks.count += more;
  } else if (now - heard.last >= kHeard) {
    heard.asks = {};
  }
  return heard.asks;
}

Asks AskWatch::of(const std::string& machine) const {
  const std::lock_guard lock(mutex_);
  const auto known = heard_.find(machine);
  return known == heard_.end() ? Asks{} : known->second.asks;
}

}  // namespace dripfeed::app
