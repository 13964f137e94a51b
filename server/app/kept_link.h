// The link of bytes that a line keeps: opened with the line, and opened again after a loss, later each time. All of it
// on the links' thread. What comes over it is the line's own matter.
#pragma once

#include <expected>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "server/app/line.h"
#include "server/app/ports/link_thread.h"

namespace dripfeed::app {

class KeptLink {
 public:
  // The listener's on_up() and on_lost() call came_up() and was_lost() first.
  KeptLink(machine::LineSettings settings, LinkThread& thread, LinkListener& listener)
      : settings_(std::move(settings)), thread_(thread), listener_(listener) {}

  // Now, or when tick() says so.
  void open();
  void close() { link_.reset(); }
  void came_up();
  void was_lost(std::string_view reason);
  void tick(feed::Time now);
  [[nodiscard]] std::optional<feed::Time> deadline() const;

  // Nothing while there is none.
  [[nodiscard]] Link* get() const { return link_.get(); }
  [[nodiscard]] bool is_up() const { return up_; }
  // Whether all that came was read; or why nothing is armed now.
  [[nodiscard]] std::expected<void, std::string> all_heard() const;
  // Why it is down; empty while it is up, or was never lost.
  [[nodiscard]] const std::string& error() const { return error_; }
  [[nodiscard]] const machine::LineSettings& settings() const { return settings_; }
  // Its part of a line's report.
  void tell(LineReport& report) const;

 private:
  void open_later();

  machine::LineSettings settings_;
  LinkThread& thread_;
  LinkListener& listener_;
  std::unique_ptr<Link> link_;
  bool up_ = false;
  std::string error_;
  feed::Time reopen_at_{};
  feed::Time reopen_wait_{};
};

}  // namespace dripfeed::app
