// An idle link sends nothing, so opening it again is harmless; a machine that is off is not asked too often.
#include "server/app/lines/kept_link.h"

#include <algorithm>
#include <chrono>
#include <utility>

namespace dripfeed::app {

namespace {

constexpr feed::Time kReopenFirst = std::chrono::milliseconds(500);
constexpr feed::Time kReopenLongest = std::chrono::seconds(5);

tape_code::DecodeTable code_of(const machine::LineSettings& settings) {
  const tape_code::DecodeFormat format = machine::decode_format_of(settings);
  return {format.eighth_bit, format.eia};
}

}  // namespace

KeptLink::KeptLink(machine::LineSettings settings, LinkThread& thread, LinkListener& listener)
    : settings_(std::move(settings)),
      thread_(thread),
      listener_(listener),
      tap_(std::make_shared<WireTap>(code_of(settings_))) {}

std::size_t KeptLink::read(std::span<std::byte> into) {
  const std::size_t count = link_->read(into);
  if (count > 0) heard(into.first(count));
  return count;
}

std::size_t KeptLink::write(std::span<const std::byte> bytes) {
  const std::size_t taken = link_->write(bytes);
  if (taken > 0) note(WireKind::out, bytes.first(taken));
  return taken;
}

void KeptLink::close() {
  link_.reset();
  tap_->end();
}

void KeptLink::open() {
  auto opened = thread_.open(settings_, listener_);
  if (opened) {
    link_ = std::move(*opened);
    error_.clear();
    return;
  }
  error_ = opened.error();
  open_later();
}

void KeptLink::open_later() {
  reopen_wait_ = std::min(reopen_wait_ == feed::Time{} ? kReopenFirst : reopen_wait_ * 2, kReopenLongest);
  reopen_at_ = thread_.clock().now() + reopen_wait_;
}

void KeptLink::came_up() {
  up_ = true;
  signal(WireKind::up);
  reopen_wait_ = {};
  error_.clear();
}

void KeptLink::was_lost(std::string_view reason) {
  up_ = false;
  signal(WireKind::lost);
  error_ = reason;
  link_.reset();
  open_later();
}

std::expected<void, std::string> KeptLink::all_heard() const {
  if (!link_ || !link_->unheard()) return {};
  return std::unexpected("the other side sends faster than it can be heard: nothing is armed until that ends");
}

void KeptLink::tick(feed::Time now) {
  if (!link_ && now >= reopen_at_) open();
}

std::optional<feed::Time> KeptLink::deadline() const { return link_ ? std::nullopt : std::optional(reopen_at_); }

void KeptLink::report(LineReport& report) const {
  if (report.link_error != error_) report.link_error = error_;
  if (link_) report_link(*link_, report);
}

}  // namespace dripfeed::app
