// A profile's change closes the old line before the new one opens.
#include "server/app/lines/lines.h"

#include <chrono>
#include <thread>
#include <utility>

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include "server/app/lines/feed_line.h"
#include "server/app/lines/folder_line.h"
#include "server/app/lines/modbus_line.h"
#include "server/app/lines/packet_line.h"
#include "server/app/lines/packet_receive_line.h"
#include "server/machine/bus_settings.h"

namespace dripfeed::app {

namespace {

constexpr std::chrono::seconds kUsedAtMost{2};

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
                     s.yields_on_collision, s.messages_end_with_cr) +
         fingerprint(s.receive);
}

// Or something else that must not be disturbed.
bool has_job(const Line& line) {
  const LineState state = line.report().state;
  return state != LineState::idle && state != LineState::disconnected;
}

}  // namespace

Lines::Lines(LinkThread& thread, BusSeatMaker take_seat, LineChanged changed, LineHistory history)
    : thread_(thread), take_seat_(take_seat), changed_(std::move(changed)), history_(std::move(history)) {}

std::unique_lock<std::mutex> Lines::hold(const std::string& machine) {
  std::mutex* of_machine = nullptr;
  {
    const std::lock_guard lock(mutex_);
    auto& entry = holds_[machine];
    if (!entry) entry = std::make_unique<std::mutex>();
    of_machine = entry.get();
  }
  return std::unique_lock(*of_machine);
}

std::optional<Lines::Entry> Lines::entry_of(const std::string& machine) const {
  const std::lock_guard lock(mutex_);
  const auto known = lines_.find(machine);
  return known == lines_.end() ? std::nullopt : std::optional(known->second);
}

Result<void> Lines::refuse_busy(const machine::Profile& profile, const std::string& settings) const {
  {
    const std::lock_guard lock(mutex_);
    if (taken_out_.contains(profile.name)) return fail(ErrorCode::refused, refusals_.at(profile.name));
  }
  const auto known = entry_of(profile.name);
  if (!known || known->settings == settings || !has_job(*known->seat.line)) return {};
  return fail(ErrorCode::refused, fmt::format("the line of {} has a job or a torn block; its settings can be changed "
                                              "when that is over",
                                              profile.name));
}

Result<void> Lines::may_set(const machine::Profile& profile) const {
  return refuse_busy(profile, fingerprint(profile.line));
}

Result<void> Lines::set(const machine::Profile& profile) {
  const std::string settings = fingerprint(profile.line);
  if (auto free = refuse_busy(profile, settings); !free) return free;
  if (const auto known = entry_of(profile.name); known && known->settings == settings) return {};
  if (auto gone = let_go(profile.name); !gone) return gone;
  auto seat = make_seat(profile);
  const std::lock_guard lock(mutex_);
  if (!seat) {
    refusals_[profile.name] = seat.error().text;
    return std::unexpected(seat.error());
  }
  refusals_.erase(profile.name);
  lines_[profile.name] = {settings, std::move(*seat)};
  return {};
}

// What is known of the line comes first; the line is made with it.
Result<Seat> Lines::make_seat(const machine::Profile& profile) {
  Seat seat{.machine = profile.name, .line = {}, .claim = {}};
  if (history_.claim) {
    auto claim = history_.claim(profile.line.link);
    if (!claim) return fail(ErrorCode::refused, claim.error());
    seat.claim = std::move(*claim);
  }
  const auto torn = history_.torn(profile.name);
  if (!torn) return std::unexpected(torn.error());
  if (*torn) {
    seat.left_torn = (*torn)->text;
  } else if (seat.claim) {
    seat.left_torn = seat.claim->torn();
  }
  const bool is_torn = *torn || !seat.left_torn.empty();
  if (is_torn) {
    spdlog::warn("{}: nothing leaves on its line before a person confirms that the control was reset: {}", profile.name,
                 seat.left_torn);
  }
  auto line =
      make_line(profile.line, thread_, take_seat_, changed_, is_torn ? feed::LeftAs::torn : feed::LeftAs::whole);
  if (!line) return std::unexpected(line.error());
  seat.line = std::move(*line);
  return seat;
}

// A tty, and a claim, has one owner: the old line is gone before the new one opens. Others use a line for moments only.
std::map<std::string, Lines::Entry>::node_type Lines::take_alone(const std::string& machine, bool& is_alone) {
  std::map<std::string, Entry>::node_type old;
  {
    const std::lock_guard lock(mutex_);
    old = lines_.extract(machine);
  }
  is_alone = true;
  if (old.empty()) return old;
  const Seat& seat = old.mapped().seat;
  const auto until = std::chrono::steady_clock::now() + kUsedAtMost;
  while (is_alone && (seat.line.use_count() > 1 || seat.claim.use_count() > 1)) {
    is_alone = std::chrono::steady_clock::now() <= until;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return old;
}

Result<void> Lines::let_go(const std::string& machine) {
  bool is_alone = false;
  const auto old = take_alone(machine, is_alone);
  if (is_alone) return {};
  return fail(ErrorCode::unavailable, fmt::format("the line of {} is still in use", machine));
}

// It is looked at once no other has it: what came until then counts.
Result<void> Lines::take_out(const std::string& machine, std::string why) {
  bool is_alone = false;
  auto old = take_alone(machine, is_alone);
  if (old.empty()) return fail(ErrorCode::refused, fmt::format("{} has no line: {}", machine, why_none(machine)));
  const bool is_free = is_alone && !has_job(*old.mapped().seat.line);
  std::unique_lock lock(mutex_);
  if (!is_free || is_closed_) {
    if (!is_closed_) lines_.insert(std::move(old));
    return fail(ErrorCode::refused, fmt::format("the line of {} is in use", machine));
  }
  taken_out_[machine] = std::move(old.mapped().seat.claim);
  refusals_[machine] = std::move(why);
  lock.unlock();  // before the line closes its link
  return {};
}

Result<void> Lines::put_back(const machine::Profile& profile) {
  std::shared_ptr<LineClaim> claim;  // given up without the lock
  {
    const std::lock_guard lock(mutex_);
    if (const auto taken = taken_out_.extract(profile.name)) claim = taken.mapped();
    if (is_closed_) return fail(ErrorCode::unavailable, "the server ends");
  }
  claim.reset();
  return set(profile);
}

Result<void> Lines::leave(const std::string& machine, std::string why) {
  if (auto gone = let_go(machine); !gone) return gone;
  const std::lock_guard lock(mutex_);
  refusals_[machine] = std::move(why);
  return {};
}

void Lines::close() {
  std::map<std::string, Entry> all;
  const std::lock_guard lock(mutex_);
  is_closed_ = true;
  all.swap(lines_);
}

std::shared_ptr<Line> Lines::find(const std::string& machine) const {
  const std::lock_guard lock(mutex_);
  const auto known = lines_.find(machine);
  return known == lines_.end() ? nullptr : known->second.seat.line;
}

std::string Lines::why_none(const std::string& machine) const {
  const std::lock_guard lock(mutex_);
  const auto known = refusals_.find(machine);
  return known == refusals_.end() ? std::string() : known->second;
}

std::string Lines::why_torn(const std::string& machine) const {
  const auto known = entry_of(machine);
  return known ? known->seat.left_torn : std::string();
}

std::vector<std::string> Lines::machines() const {
  const std::lock_guard lock(mutex_);
  std::vector<std::string> machines;
  machines.reserve(lines_.size());
  for (const auto& [name, entry] : lines_) machines.push_back(name);
  return machines;
}

std::vector<Seat> Lines::all() const {
  const std::lock_guard lock(mutex_);
  std::vector<Seat> all;
  all.reserve(lines_.size());
  for (const auto& [name, entry] : lines_) all.push_back(entry.seat);
  return all;
}

Result<std::unique_ptr<Line>> make_receiving_line(const machine::LineSettings& settings, LinkThread& thread,
                                                  BusSeatMaker take_seat, LineChanged changed) {
  const auto effective = machine::effective_line(settings);
  if (!effective) return fail(ErrorCode::invalid, effective.error());
  const bool has_characters = machine::feeds_characters(settings.link.kind);
  if (!has_characters || !machine::packet_protocol_of(effective->protocol))
    return make_line(settings, thread, take_seat, std::move(changed));
  auto line = make_packet_receive_line(settings, thread, std::move(changed));
  if (!line) return fail(ErrorCode::invalid, line.error());
  return std::move(*line);
}

Result<std::unique_ptr<Line>> make_line(const machine::LineSettings& settings, LinkThread& thread,
                                        BusSeatMaker take_seat, LineChanged changed, feed::LeftAs left) {
  if (machine::is_modbus(settings.link.kind)) {
    const auto bus = machine::bus_settings_of(settings.link);
    if (!bus) return fail(ErrorCode::invalid, bus.error());
    auto line =
        make_modbus_line({.link = settings.link, .idle_poll = std::chrono::milliseconds(bus->poll_ms), .left = left},
                         take_seat, thread.clock(), std::move(changed));
    if (!line) return fail(ErrorCode::refused, line.error());
    return std::move(*line);
  }
  if (settings.link.kind == machine::LinkKind::dir) {
    auto line = make_folder_line(settings, std::move(changed), left);
    if (!line) return fail(ErrorCode::invalid, line.error());
    return std::move(*line);
  }
  const auto effective = machine::effective_line(settings);
  if (!effective) return fail(ErrorCode::invalid, effective.error());
  const bool has_packets = machine::packet_protocol_of(effective->protocol).has_value();
  auto line = has_packets ? make_packet_line(settings, thread, std::move(changed), left)
                          : make_feed_line(settings, thread, std::move(changed), left);
  if (!line) return fail(ErrorCode::invalid, line.error());
  return std::move(*line);
}

}  // namespace dripfeed::app
