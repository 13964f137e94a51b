// A beat a second, or as often as the service manager wants.
#include "server/io/line_pulse.h"

#include <algorithm>

#include <spdlog/spdlog.h>

namespace dripfeed::io {

namespace {

constexpr feed::Time kBeat = std::chrono::seconds(1);
constexpr int kBeatsForOneAskedFor = 3;

}  // namespace

LinePulse::LinePulse(app::LinkThread& lines, const ServiceNotices& notices)
    : lines_(lines),
      notices_(notices),
      wanted_every_(ServiceNotices::wants_life_every()),
      last_ns_(lines.clock().now().count()) {
  lines_.run([this] { lines_.add(*this); });
}

LinePulse::~LinePulse() {
  lines_.run([this] { lines_.remove(*this); });
}

void LinePulse::tick(feed::Time now) {
  due_ = now + (wanted_every_ ? std::min(kBeat, *wanted_every_ / kBeatsForOneAskedFor) : kBeat);
  last_ns_ = now.count();
  if (wanted_every_) notices_.notify("WATCHDOG=1");
}

void PulseWatch::look(feed::Time now) {
  const feed::Time last = pulse_.last();
  const auto seconds = [](feed::Time time) { return std::chrono::duration_cast<std::chrono::seconds>(time).count(); };
  if (now - last > kLongSilence && !silent_since_) {
    silent_since_ = last;
    spdlog::critical("the lines have not been served for {} s", seconds(now - last));
  } else if (silent_since_ && last > *silent_since_) {
    spdlog::warn("the lines are served again, after {} s", seconds(last - *silent_since_));
    silent_since_.reset();
  }
}

}  // namespace dripfeed::io
