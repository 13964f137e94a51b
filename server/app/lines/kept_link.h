// The link of bytes that a line keeps: opened with the line, and opened again after a loss, later each time. All of it
// on the links' thread. What comes over it is the line's own matter.
#pragma once

#include <expected>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "server/app/lines/line.h"
#include "server/app/lines/wire_tap.h"
#include "server/app/ports/link_thread.h"

namespace dripfeed::app {

class KeptLink {
 public:
  // The listener's on_up() and on_lost() call came_up() and was_lost() first.
  KeptLink(machine::LineSettings settings, LinkThread& thread, LinkListener& listener);

  // Now, or when tick() says so.
  void open();
  void close();
  void came_up();
  void was_lost(std::string_view reason);
  void tick(feed::Time now);
  [[nodiscard]] std::optional<feed::Time> deadline() const;

  // Nothing while there is none. What goes over it by read() and write(), and what the listener hands on by heard() and
  // signal(), is seen by whoever looks at the line.
  [[nodiscard]] Link* get() const { return link_.get(); }
  std::size_t read(std::span<std::byte> into);
  std::size_t write(std::span<const std::byte> bytes);
  void heard(std::span<const std::byte> bytes) { note(WireKind::in, bytes); }
  void signal(WireKind change) { tap_->note(change, thread_.clock().now()); }
  [[nodiscard]] const std::shared_ptr<WireTap>& tap() const { return tap_; }
  [[nodiscard]] bool is_up() const { return up_; }
  // Whether all that came was read; or why nothing is armed now.
  [[nodiscard]] std::expected<void, std::string> all_heard() const;
  // Why it is down; empty while it is up, or was never lost.
  [[nodiscard]] const std::string& error() const { return error_; }
  [[nodiscard]] const machine::LineSettings& settings() const { return settings_; }
  // Its part of a line's report.
  void report(LineReport& report) const;

 private:
  // The clock is read for who looks.
  void note(WireKind direction, std::span<const std::byte> bytes) {
    if (tap_->is_watched()) tap_->note(direction, bytes, thread_.clock().now());
  }
  void open_later();

  machine::LineSettings settings_;
  LinkThread& thread_;
  LinkListener& listener_;
  std::shared_ptr<WireTap> tap_;
  std::unique_ptr<Link> link_;
  bool up_ = false;
  std::string error_;
  feed::Time reopen_at_{};
  feed::Time reopen_wait_{};
};

}  // namespace dripfeed::app
