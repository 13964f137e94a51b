// What could not be written is tried again at the next look, if it still holds.
#include "server/app/out/line_events.h"

#include <spdlog/spdlog.h>

namespace dripfeed::app {

void LineEvents::look() {
  const feed::Time now = clock_.now();
  for (const Progress& shown : events_.snapshot()) {
    if (!is_ours_ || is_ours_(shown.machine)) {
      look_at(shown, now);
    } else {  // its next holder goes on; here it begins again when the line comes back
      seen_.erase(shown.machine);
      logged_.erase(shown.machine);
    }
  }
}

void LineEvents::look_at(const Progress& shown, feed::Time now) {
  Seen& seen = seen_.try_emplace(shown.machine, Seen{.state = shown.report.state, .since = now}).first->second;
  if (seen.state != shown.report.state) seen = {.state = shown.report.state, .since = now};
  if (seen.is_logged || now - seen.since < kStands) return;
  const auto logged = logged_.find(shown.machine);
  const bool is_known =
      logged != logged_.end() && logged->second == seen.state;  // it went and came back within the second
  seen.is_logged = is_known || publish(shown);
  if (seen.is_logged) logged_[shown.machine] = seen.state;
}

bool LineEvents::publish(const Progress& shown) {
  const auto written = store_.event_log().append({.topic = store::EventTopic::line,
                                                  .word = std::string(name_of(shown.report.state)),
                                                  .machine = shown.machine,
                                                  .job = shown.report.job,
                                                  .cause = std::string(shown.report.stall),
                                                  .text = shown.report.link_error},
                                                 {"dripfeed", clock_.wall_ms()});
  if (!written)
    spdlog::warn("{}: its line's state is not an event: {}", shown.machine, store::message_of(written.error()));
  return written.has_value();
}

}  // namespace dripfeed::app
