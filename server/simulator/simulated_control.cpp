// Characters wait in `pending_` until their virtual arrival, max(now, previous + character time); only then are they
// looked at. So a host that writes eight at once is judged as its UART would be.
#include "server/simulator/simulated_control.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

namespace dripfeed::simulator {

namespace {

constexpr std::uint8_t kDc1 = 0x11;
constexpr std::uint8_t kDc3 = 0x13;
constexpr std::uint8_t kDc3WithParity = 0x93;
constexpr std::uint8_t kNak = 0x95;  // both with parity
constexpr std::uint8_t kSyn = 0x96;

bool is_dc3(std::byte byte) { return byte == std::byte{kDc3} || byte == std::byte{kDc3WithParity}; }

Time_ns character_ns(const ControlSettings& settings) {
  const double bits = settings.framing.bits_per_char();
  return static_cast<Time_ns>(bits * 1e9 / (settings.baud * (1.0 + settings.clock_ppm * 1e-6)));
}

// Parity over all eight bits of a received byte, as the framing and the code ask for it.
bool parity_is_right(std::uint8_t byte, const tape_code::Framing& framing, tape_code::Code code) {
  const bool odd_ones = (std::popcount(byte) & 1) != 0;
  if (framing.data_bits == 8) return code == tape_code::Code::ascii || !odd_ones;
  if (framing.parity == tape_code::Parity::none) return true;
  return odd_ones == (framing.parity == tape_code::Parity::odd);
}

}  // namespace

SimulatedControl::SimulatedControl(const ControlSettings& settings, Record record)
    : settings_(settings),
      record_(std::move(record)),
      char_ns_(character_ns(settings)),
      lines_{.cts = !settings.drives_rts, .dsr = true},
      clock_(settings.clock) {
  if (settings.code == tape_code::Code::eia) eia_.emplace(tape_code::EighthBit::data, settings.eia_specials);
  if (const auto times = find_fault(settings_.faults, FaultKind::slow); times && *times > 0)
    settings_.speed /= static_cast<double>(*times);
}

void SimulatedControl::start(Time_ns now) {
  if (report_.state == ControlState::alarm) return;
  report_.state = ControlState::reading;
  started_at_ = now;
  run_until_ = 0;
  idle_since_ = -1;
  label_skip_ = true;
  seen_percent_ = false;
  block_.clear();
  block_characters_ = 0;
  clock_ = BlockClock(settings_.clock);
  start_reading(now);
}

void SimulatedControl::start_reading(Time_ns at) {
  if (settings_.drives_rts) lines_.cts = true;
  if (settings_.uses_dc) send(kDc1, at);
}

void SimulatedControl::stop_reading(Time_ns at) {
  if (settings_.drives_rts) lines_.cts = false;
  if (!settings_.uses_dc) return;
  const bool with_parity = settings_.framing.data_bits == 7 || settings_.code == tape_code::Code::iso;
  send(with_parity ? kDc3WithParity : kDc3, at);
}

void SimulatedControl::reset() {
  report_.state = ControlState::waiting;
  report_.alarm.clear();
  pending_.clear();
  blocks_.clear();
  block_.clear();
  buffered_ = 0;
  running_ = false;
  excused_ = 0;
  before_dc3_left_.clear();
  lines_ = {.cts = !settings_.drives_rts, .dsr = true};
}

std::optional<Time_ns> SimulatedControl::quiet_since() const {
  const bool busy = !pending_.empty() || !out_.empty() || running_ || report_.state == ControlState::held;
  if (busy) return std::nullopt;
  return std::max({started_at_, last_arrival_, run_until_});
}

std::optional<Time_ns> SimulatedControl::look_every() const {
  const bool listens = report_.state == ControlState::reading || report_.state == ControlState::held;
  return listens ? std::optional(char_ns_) : std::nullopt;
}

void SimulatedControl::receive(std::span<const std::byte> bytes, Time_ns looked_before, Time_ns now) {
  for (const std::byte byte : bytes) {
    last_arrival_ = std::max(looked_before, last_arrival_ + char_ns_);
    pending_.push_back({static_cast<std::uint8_t>(byte), last_arrival_});
  }
  tick(now);
}

void SimulatedControl::tick(Time_ns now) {
  while (!pending_.empty() && pending_.front().at <= now) {
    const Arrival arrival = pending_.front();
    pending_.pop_front();
    run_blocks(arrival.at);
    arrive(arrival);
  }
  run_blocks(now);
}

std::optional<Time_ns> SimulatedControl::deadline() const {
  std::optional<Time_ns> earliest;
  const auto consider = [&](Time_ns at) { earliest = earliest ? std::min(*earliest, at) : at; };
  if (!pending_.empty()) consider(pending_.front().at);
  if (!out_.empty()) consider(out_.front().at);
  if (running_ && report_.state != ControlState::alarm && !silent_)
    consider(run_until_);  // an alarm ends the running, too
  return earliest;
}

std::vector<std::byte> SimulatedControl::take_out(Time_ns now) {
  std::vector<std::byte> bytes;
  took_dc3_ = took_dc1_ = false;
  while (!out_.empty() && out_.front().at <= now) {
    const Due due = out_.front();
    out_.pop_front();
    bytes.push_back(due.byte);
    if (is_dc3(due.byte)) dc3_left(now - due.at);
    if (due.byte == std::byte{kDc1}) dc1_left(now - due.at);
    took_dc3_ = took_dc3_ || is_dc3(due.byte);
    took_dc1_ = took_dc1_ || due.byte == std::byte{kDc1};
  }
  return bytes;
}

void SimulatedControl::left_late(Time_ns by) {
  if (took_dc3_) dc3_left(by);
  if (took_dc1_) dc1_left(by);
}

void SimulatedControl::arrive(const Arrival& arrival) {
  record_(arrival.byte);
  ++report_.bytes;
  if (first_arrival_ < 0) first_arrival_ = arrival.at - char_ns_;
  if (report_.state == ControlState::held) count_after_dc3(arrival.at);
  if (report_.state == ControlState::alarm || report_.state == ControlState::waiting || silent_) return;
  if (strikes(arrival)) return;
  if (eia_) return take_eia(arrival);
  if (!parity_is_right(arrival.byte, settings_.framing, settings_.code)) {
    ++report_.parity_errors;
    return raise("001 TH PARITY");
  }
  const bool seven_bits = settings_.framing.data_bits == 7 || settings_.code == tape_code::Code::iso;
  take_character(static_cast<char>(seven_bits ? arrival.byte & 0x7F : arrival.byte), arrival.at);
}

// A tape without holes is leader; inside the program it is a fault, as is what is no character (TH check).
void SimulatedControl::take_eia(const Arrival& arrival) {
  const tape_code::ByteKind kind = eia_->kind(arrival.byte);
  const bool inside = !label_skip_ && report_.state != ControlState::ended;
  if (kind == tape_code::ByteKind::wrong_nothing || (kind == tape_code::ByteKind::blank && inside)) {
    ++report_.parity_errors;
    return raise("001 TH PARITY");
  }
  if (kind == tape_code::ByteKind::character) take_character(eia_->character(arrival.byte), arrival.at);
}

// The faults of the control itself, by the number of the character that just came; true if it is lost with that.
bool SimulatedControl::strikes(const Arrival& arrival) {
  for (const Fault& fault : settings_.faults) {
    if (fault.kind == FaultKind::baud && fault.number != settings_.baud) {
      ++report_.framing_errors;
      raise("085 COMMUNICATION ERROR");
      return true;
    }
    if (fault.number != report_.bytes) continue;
    if (fault.kind == FaultKind::silent) return silent_ = true;
    if (fault.kind == FaultKind::overrun) raise("087 BUFFER OVERFLOW");
    if (fault.kind == FaultKind::dsr) {
      lines_.dsr = false;
      raise("086 DR SIGNAL OFF");
    }
    if (fault.kind != FaultKind::reset && fault.kind != FaultKind::alarm) continue;
    // As a remote buffer reports it: reading stops, then what happened.
    stop_reading(arrival.at);
    send(fault.kind == FaultKind::reset ? kSyn : kNak, arrival.at);
    if (fault.kind == FaultKind::alarm) {
      raise("ALARM");
    } else {
      reset();
    }
    return true;
  }
  return report_.state == ControlState::alarm;
}

void SimulatedControl::take_character(char c, Time_ns at) {
  if (report_.state == ControlState::ended || c == '\0' || c == '\r' || c == 0x7F) return;
  if (label_skip_) {
    // All up to the first EOB after the first '%' is leader.
    if (c == '%') seen_percent_ = true;
    if (c == '\n' && seen_percent_) label_skip_ = false;
    return;
  }
  if (c == '%' && block_.empty()) {
    // The end of the tape: the control says DC3 and reads no more.
    if (report_.state == ControlState::held) close_hold(at);
    report_.state = ControlState::ended;
    stop_reading(at);
    return;
  }
  ++buffered_;
  ++block_characters_;
  report_.buffer_max = std::max(report_.buffer_max, buffered_);
  // A control that stops in time is not filled; what a late simulation let in has to go somewhere.
  if (buffered_ > settings_.buffer_bytes + excused_) return raise("087 BUFFER OVERFLOW");
  if (c == '\n') {
    finish_block(at);
  } else {
    block_ += c;
  }
  check_flow(at);
}

void SimulatedControl::finish_block(Time_ns at) {
  const bool odd = std::exchange(block_characters_, 0) % 2 != 0;
  if (odd && find_fault(settings_.faults, FaultKind::tv) == 1) return raise("002 TV PARITY");
  blocks_.push_back({std::exchange(block_, {}), 0});
  blocks_.back().bytes = blocks_.back().text.size() + 1;
  if (idle_since_ >= 0 && !running_) {
    // It ran dry and waited for this block.
    if (idle_since_ > 0) {
      ++report_.stalls;
      report_.stall_s += static_cast<double>(at - idle_since_) * 1e-9;
    }
    run_until_ = at;
    idle_since_ = -1;
  }
  run_blocks(at);
}

void SimulatedControl::run_blocks(Time_ns now) {
  while (report_.state != ControlState::alarm && !silent_) {
    if (running_) {
      if (run_until_ > now) return;
      running_ = false;
    }
    if (blocks_.empty()) {
      if (idle_since_ < 0 && report_.state != ControlState::ended && !clock_.ended())
        idle_since_ = std::max(run_until_, Time_ns{0});
      return;
    }
    const Time_ns begin = std::max(run_until_, Time_ns{0}) == 0 ? now : run_until_;
    const Block block = std::move(blocks_.front());
    blocks_.pop_front();
    if (report_.state != ControlState::ended && report_.blocks_run > 0)
      buffer_min_ = std::min(buffer_min_.value_or(buffered_), buffered_);
    buffered_ -= block.bytes;
    const double seconds = clock_.run(block.text);
    if (!clock_.fault().empty()) return raise("123 CAN NOT USE MACRO COMMAND IN DNC");
    ++report_.blocks_run;
    report_.bytes_run += block.bytes;
    running_ = true;
    run_until_ = begin + static_cast<Time_ns>(std::llround(seconds / settings_.speed * 1e9));
    check_flow(begin);
  }
}

std::uint64_t SimulatedControl::free_bytes() const {
  return settings_.buffer_bytes - std::min<std::uint64_t>(buffered_, settings_.buffer_bytes);
}

void SimulatedControl::check_flow(Time_ns at) {
  if (report_.state == ControlState::reading && free_bytes() < settings_.stop_free_bytes) {
    report_.state = ControlState::held;
    ++report_.holds;
    dc3_at_ = at;
    dc3_due_at_ = -1;
    after_dc3_ = 0;
    excused_ = 0;
    const std::uint64_t late = find_fault(settings_.faults, FaultKind::late_xoff).value_or(0);
    stop_reading(at + static_cast<Time_ns>(late) * char_ns_);
  } else if (report_.state == ControlState::held && free_bytes() > settings_.go_free_bytes) {
    close_hold(at);
    report_.state = ControlState::reading;
    start_reading(at);
  }
}

void SimulatedControl::dc3_left(Time_ns late) {
  dc3_at_ += late;
  if (dc3_due_at_ < 0) dc3_due_at_ = dc3_at_ - late;
  for (const Time_ns at : std::exchange(before_dc3_left_, {})) count_after_dc3(at);
}

// The host could not know yet that the hold was over.
void SimulatedControl::dc1_left(Time_ns late) {
  const bool goes_on = report_.state == ControlState::reading && first_arrival_ >= 0;
  if (goes_on) held_ns_ += late;
}

// Came after our DC3 was due and before it left: the simulation was late, the host was not.
bool SimulatedControl::is_before_own_stop(Time_ns at) const {
  const auto stop = std::ranges::find_if(out_, [](const Due& due) { return is_dc3(due.byte); });
  return stop != out_.end() ? at > stop->at : at > dc3_due_at_ && at <= dc3_at_;
}

void SimulatedControl::count_after_dc3(Time_ns at) {
  if (is_before_own_stop(at)) ++excused_;
  const bool still_here = std::ranges::any_of(out_, [](const Due& due) { return is_dc3(due.byte); });
  if (still_here) return before_dc3_left_.push_back(at);
  if (at <= dc3_at_) return;
  ++after_dc3_;
  report_.after_dc3_max = std::max(report_.after_dc3_max, after_dc3_);
  if (after_dc3_ > settings_.overrun_budget) raise("087 BUFFER OVERFLOW");
}

void SimulatedControl::close_hold(Time_ns at) {
  after_dc3_ += std::exchange(before_dc3_left_, {}).size();  // a hold that ended before its DC3 left
  ++report_.after_dc3[std::min<std::uint64_t>(after_dc3_, kAfterDc3Bins - 1)];
  // Characters that came after the DC3 were line time in use; the rest of the hold was not.
  held_ns_ += std::max<Time_ns>(0, at - dc3_at_ - static_cast<Time_ns>(after_dc3_) * char_ns_);
}

void SimulatedControl::send(std::uint8_t byte, Time_ns at) {
  const Time_ns due = at + static_cast<Time_ns>(settings_.host_latency_chars) * char_ns_ + settings_.host_latency_ns;
  out_.push_back({static_cast<std::byte>(byte), out_.empty() ? due : std::max(due, out_.back().at)});
}

void SimulatedControl::raise(std::string_view alarm) {
  if (report_.state == ControlState::alarm) return;
  report_.state = ControlState::alarm;
  report_.alarm = alarm;
}

ControlReport SimulatedControl::report() const {
  ControlReport report = report_;
  const Time_ns span = last_arrival_ - first_arrival_ - held_ns_;
  report.line_use = report.bytes == 0 || span <= 0
                        ? 0.0
                        : static_cast<double>(report.bytes) * static_cast<double>(char_ns_) / static_cast<double>(span);
  report.buffer_min = buffer_min_.value_or(0);
  report.unfinished_block = !block_.empty();
  return report;
}

}  // namespace dripfeed::simulator
