// The packet sender does all of it; its bytes leave as its own line clock allows.
#include "server/simulator/packet_punch.h"

#include <utility>

#include "server/simulator/packet_control.h"

namespace dripfeed::simulator {

namespace {

constexpr std::string_view kPrefix = "punch-";

packet::Sender make_sender(const ControlSettings& settings) {
  const std::string_view name = std::string_view(settings.protocol).substr(kPrefix.size());
  const auto protocol = packet::parse_protocol(name).value_or(packet::Protocol::xmodem);
  auto made = packet::Sender::make(packet_settings(settings, protocol));
  // A wrong setting was refused where the line was read; what is left is the plainest sender.
  return made ? std::move(*made) : *packet::Sender::make({});
}

}  // namespace

PacketPunch::PacketPunch(const ControlSettings& settings, Record)
    : text_(settings.punches), source_(text_), sender_(make_sender(settings)) {
  sender_.link(true, packet::Time(0));
}

void PacketPunch::start(Time_ns now) {
  now_ = last_sign_ = now;
  feed::ProgramCheck check{feed::ProgramSyntax{}};
  check.append(text_);
  const auto facts = check.finish();
  if (!facts) {
    report_.state = ControlState::alarm;
    report_.alarm = feed::message(facts.error().fault);
    return;
  }
  source_ = tape_code::SpanSource(text_);
  const feed::Job job{.facts = *facts, .source = &source_, .reserve = feed::kNoReserve};
  if (sender_.arm(job, packet::Time(now), "PUNCHED.NC")) report_.state = ControlState::reading;
  judge();
}

void PacketPunch::reset() {
  static_cast<void>(sender_.command(feed::Command::abort, packet::Time(now_)));
  static_cast<void>(sender_.command(feed::Command::confirm_reset, packet::Time(now_)));
  report_.state = ControlState::waiting;
  report_.alarm.clear();
}

void PacketPunch::receive(std::span<const std::byte> bytes, Time_ns, Time_ns now) {
  now_ = last_sign_ = now;
  sender_.receive(bytes, packet::Time(now));
  judge();
}

void PacketPunch::tick(Time_ns now) {
  now_ = now;
  sender_.tick(packet::Time(now));
  judge();
}

std::vector<std::byte> PacketPunch::take_out(Time_ns now) {
  std::vector<std::byte> bytes;
  for (auto out = sender_.pending_out(); !out.empty(); out = sender_.pending_out()) {
    bytes.insert(bytes.end(), out.begin(), out.end());
    sender_.mark_sent(out.size(), packet::Time(now));
  }
  if (!bytes.empty()) last_sign_ = now;
  judge();
  return bytes;
}

std::optional<Time_ns> PacketPunch::deadline() const {
  if (!sender_.pending_out().empty()) return now_;
  const auto due = sender_.deadline();
  return due ? std::optional(due->count()) : std::nullopt;
}

std::optional<Time_ns> PacketPunch::quiet_since() const {
  return sender_.pending_out().empty() ? std::optional(last_sign_) : std::nullopt;
}

// What the transfer came to, once it is over and the last of it has left.
void PacketPunch::judge() {
  while (sender_.next_event()) {
  }
  if (report_.state != ControlState::reading || !sender_.pending_out().empty()) return;
  if (packet::is_on_the_line(sender_.state()) || sender_.state() == packet::State::armed) return;
  report_.bytes = sender_.counters().confirmed;
  report_.state = sender_.state() == packet::State::done ? ControlState::ended : ControlState::alarm;
  if (report_.state == ControlState::alarm)
    report_.alarm = "PUNCH BROKEN: " + std::string(packet::name(sender_.end_cause()));
}

}  // namespace dripfeed::simulator
