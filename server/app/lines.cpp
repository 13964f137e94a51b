// A profile's change closes the old line before the new one opens: a tty has one owner.
#include "server/app/lines.h"

#include <chrono>
#include <utility>

#include <fmt/format.h>

#include "server/app/drop_line.h"
#include "server/app/feed_line.h"
#include "server/app/mailbox_line.h"
#include "server/app/packet_line.h"
#include "server/app/punch_line.h"
#include "server/machine/bus_settings.h"

namespace dripfeed::app {

namespace {

// What a change of the line's own part of it shows by; who may ask for what is no matter of the line.
std::string fingerprint(const machine::ReceiveSettings& r) {
  return fmt::format(" {} {} {} {} {}", r.enabled, r.quiet_s, r.quiet_after_end_s, r.end_character.value_or(0),
                     static_cast<int>(r.hold));
}

// All that the line was made from, as one comparable text.
std::string fingerprint(const machine::LineSettings& s) {
  return fmt::format("{} {} {} {} {} {} {} {} {} {} {} {} {} {} {} {} {} {} {} {} {} {} {} {} {} {} {} {} {} {} {} {}",
                     s.link.text, s.baud, tape_code::format_framing(s.framing), static_cast<int>(s.code),
                     tape_code::name(s.eob), static_cast<int>(s.filler), fmt::join(s.eia_specials.codes, ","), s.pad_tv,
                     s.leader_chars, s.trailer_chars, static_cast<int>(s.start), s.end_by_dc3,
                     s.end_by_character.value_or(0), s.end_by_quiet_s.value_or(-1.0), s.overrun_budget, s.unsent,
                     s.latency_chars, s.watch_cts, s.watch_dsr, s.start_trigger, static_cast<int>(s.flow), s.xon,
                     s.xoff, static_cast<int>(s.xoff_by), s.char_delay_ms, s.line_delay_ms,
                     machine::name_of(s.protocol), s.answer_s.value_or(0.0), s.payload_bytes, s.counted_frames,
                     s.gives_way, s.messages_end_with_cr) +
         fingerprint(s.receive);
}

bool has_job(const Line& line) {
  const LineState state = line.report().state;
  return state != LineState::idle && state != LineState::disconnected;
}

}  // namespace

Lines::Lines(LinkThread& thread, BusSeatMaker take_seat, LineChanged changed)
    : thread_(thread), take_seat_(take_seat), changed_(std::move(changed)) {}

Result<void> Lines::refuse_busy(const machine::Profile& profile, const std::string& settings) const {
  const auto known = lines_.find(profile.name);
  if (known == lines_.end() || known->second.settings == settings || !has_job(*known->second.line)) return {};
  return fail(ErrorCode::refused, fmt::format("the line of {} has a job or a torn block; its settings can be changed "
                                              "when that is over",
                                              profile.name));
}

Result<void> Lines::may_set(const machine::Profile& profile) const {
  const std::lock_guard lock(mutex_);
  return refuse_busy(profile, fingerprint(profile.line));
}

Result<void> Lines::set(const machine::Profile& profile) {
  const std::lock_guard lock(mutex_);
  const std::string settings = fingerprint(profile.line);
  if (auto free = refuse_busy(profile, settings); !free) return free;
  const auto known = lines_.find(profile.name);
  if (known != lines_.end() && known->second.settings == settings) return {};
  if (known != lines_.end()) lines_.erase(known);
  auto line = make_line(profile.line, thread_, take_seat_, changed_);
  if (!line) {
    refusals_[profile.name] = line.error().text;
    return std::unexpected(line.error());
  }
  refusals_.erase(profile.name);
  lines_[profile.name] = {settings, std::move(*line)};
  return {};
}

void Lines::close() {
  const std::lock_guard lock(mutex_);
  lines_.clear();
}

std::shared_ptr<Line> Lines::find(const std::string& machine) const {
  const std::lock_guard lock(mutex_);
  const auto known = lines_.find(machine);
  return known == lines_.end() ? nullptr : known->second.line;
}

std::string Lines::why_none(const std::string& machine) const {
  const std::lock_guard lock(mutex_);
  const auto known = refusals_.find(machine);
  return known == refusals_.end() ? std::string() : known->second;
}

std::vector<std::pair<std::string, std::shared_ptr<Line>>> Lines::all() const {
  const std::lock_guard lock(mutex_);
  std::vector<std::pair<std::string, std::shared_ptr<Line>>> all;
  all.reserve(lines_.size());
  for (const auto& [name, entry] : lines_) all.emplace_back(name, entry.line);
  return all;
}

Result<std::unique_ptr<Line>> make_receiving_line(const machine::LineSettings& settings, LinkThread& thread,
                                                  BusSeatMaker take_seat, LineChanged changed) {
  const auto effective = machine::effective_line(settings);
  if (!effective) return fail(ErrorCode::invalid, effective.error());
  const bool has_characters = machine::feeds_characters(settings.link.kind);
  if (!has_characters || !machine::packet_protocol_of(effective->protocol))
    return make_line(settings, thread, take_seat, std::move(changed));
  auto line = make_punch_line(settings, thread, std::move(changed));
  if (!line) return fail(ErrorCode::invalid, line.error());
  return std::move(*line);
}

Result<std::unique_ptr<Line>> make_line(const machine::LineSettings& settings, LinkThread& thread,
                                        BusSeatMaker take_seat, LineChanged changed) {
  if (machine::is_modbus(settings.link.kind)) {
    const auto bus = machine::bus_settings_of(settings.link);
    if (!bus) return fail(ErrorCode::invalid, bus.error());
    auto line = make_mailbox_line({.link = settings.link, .idle_poll = std::chrono::milliseconds(bus->poll_ms)},
                                  take_seat, thread.clock(), std::move(changed));
    if (!line) return fail(ErrorCode::refused, line.error());
    return std::move(*line);
  }
  if (settings.link.kind == machine::LinkKind::dir) {
    auto line = make_drop_line(settings, std::move(changed));
    if (!line) return fail(ErrorCode::invalid, line.error());
    return std::move(*line);
  }
  const auto effective = machine::effective_line(settings);
  if (!effective) return fail(ErrorCode::invalid, effective.error());
  const bool has_packets = machine::packet_protocol_of(effective->protocol).has_value();
  auto line = has_packets ? make_packet_line(settings, thread, std::move(changed))
                          : make_feed_line(settings, thread, std::move(changed));
  if (!line) return fail(ErrorCode::invalid, line.error());
  return std::move(*line);
}

}  // namespace dripfeed::app
