// The sign of life of the thread of the lines. It comes from that thread itself, after the lines that were due: so it
// stops when they are not served any more, whatever else of the server still runs, and comes however busy the rest is.
#pragma once

#include <atomic>
#include <optional>

#include "server/app/ports/link_thread.h"
#include "server/io/service_notices.h"

namespace dripfeed::io {

class LinePulse final : public app::Ticker {
 public:
  // Adds itself to the thread; the destructor takes it away. The service manager gets notices three times as often as
  // it asks for them, and none if it does not.
  LinePulse(app::LinkThread& lines, const ServiceNotices& notices);
  ~LinePulse() override;

  void tick(feed::Time now) override;
  [[nodiscard]] std::optional<feed::Time> deadline() const override { return due_; }

  // When the thread came by last. From any thread.
  [[nodiscard]] feed::Time last() const { return feed::Time(last_ns_.load()); }

 private:
  app::LinkThread& lines_;
  const ServiceNotices& notices_;
  std::optional<feed::Time> wanted_every_;
  feed::Time due_{};
  std::atomic<feed::Time::rep> last_ns_;
};

// Reports in the log when the lines are not served for kLongSilence, and when they are again.
class PulseWatch {
 public:
  static constexpr feed::Time kLongSilence = std::chrono::seconds(5);

  explicit PulseWatch(const LinePulse& pulse) : pulse_(pulse) {}
  // To be called about once a second or more often, from one thread.
  void look(feed::Time now);

 private:
  const LinePulse& pulse_;
  std::optional<feed::Time> silent_since_{};
};

}  // namespace dripfeed::io
