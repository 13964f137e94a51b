// The packet receiver asks this control for room; the tape reader empties the room by running blocks.
#include "server/simulator/packet_control.h"

#include <algorithm>
#include <string>

#include "protocol/tape_code/parity.h"

namespace dripfeed::simulator {

namespace {

packet::Receiver make_receiver(const packet::Settings& settings, packet::Sink& sink) {
  auto made = packet::Receiver::make(settings, sink);
  // A wrong setting was refused where the line was read; what is left is the plainest receiver.
  return made ? std::move(*made) : *packet::Receiver::make({}, sink);
}

// make_control() found this control by the same name.
packet::Protocol protocol_of(const ControlSettings& settings) {
  return packet::parse_protocol(settings.protocol).value_or(packet::Protocol::xmodem);
}

}  // namespace

packet::Settings packet_settings(const ControlSettings& settings, packet::Protocol protocol) {
  packet::Settings packet;
  packet.protocol = protocol;
  packet.wire.eighth_bit = tape_code::eighth_bit(settings.framing, settings.code, tape_code::ParityBy::software);
  packet.char_time =
      packet::Time(std::int64_t{1'000'000'000} * settings.framing.bits_per_char() / std::max(settings.baud, 1U));
  packet.payload = settings.payload_bytes;
  packet.counted = settings.counted_frames;
  packet.yields_on_collision = false;  // the host withdraws
  packet.end_is_cr = settings.messages_end_with_cr;
  return packet;
}

PacketControl::PacketControl(const ControlSettings& settings, Record record)
    : settings_(settings),
      record_(std::move(record)),
      eighth_bit_(tape_code::eighth_bit(settings.framing, settings.code, tape_code::ParityBy::software)),
      receiver_(make_receiver(packet_settings(settings, protocol_of(settings)), *this)),
      tape_(settings.clock, settings.speed) {
  receiver_.link(true, packet::Time(0));
}

void PacketControl::start(Time_ns now) {
  if (report_.state == ControlState::alarm) return;
  now_ = now;
  tape_.start(now);
  if (receiver_.start(packet::Time(now))) report_.state = ControlState::reading;
}

void PacketControl::reset() {
  static_cast<void>(receiver_.stop(packet::Time(now_)));
  tape_.reset();
  report_.state = ControlState::waiting;
  report_.alarm.clear();
}

std::size_t PacketControl::room() const noexcept {
  return settings_.buffer_bytes - std::min<std::uint64_t>(tape_.buffered(), settings_.buffer_bytes);
}

void PacketControl::append(std::span<const std::byte> bytes) noexcept {
  for (const std::byte byte : bytes) {
    const auto value = static_cast<std::uint8_t>(byte);
    ++report_.bytes;
    record_(value);
    if (!tape_code::parity_holds(value, eighth_bit_)) {
      ++report_.parity_errors;
      raise("001 TH PARITY");
    }
    if (report_.state == ControlState::alarm) continue;
    tape_.take(static_cast<char>(tape_code::without_parity(value, eighth_bit_)), now_);
  }
  if (tape_.buffered() > settings_.buffer_bytes) raise("087 BUFFER OVERFLOW");
}

void PacketControl::receive(std::span<const std::byte> bytes, Time_ns, Time_ns now) {
  now_ = now;
  last_arrival_ = now;
  if (first_arrival_ < 0) first_arrival_ = now;
  if (report_.state == ControlState::reading) tape_.run(now);
  receiver_.receive(bytes, packet::Time(now));
  tick(now);
}

void PacketControl::tick(Time_ns now) {
  now_ = now;
  if (report_.state != ControlState::alarm && report_.state != ControlState::waiting) tape_.run(now);
  receiver_.tick(packet::Time(now));
  judge();
}

// What the transfer came to, once it is over.
void PacketControl::judge() {
  while (const auto event = receiver_.next_event()) {
    if (event->kind == packet::ReceiveEventKind::frame && receiver_.state() == packet::ReceiveState::full)
      ++report_.holds;
  }
  if (report_.state != ControlState::reading) return;
  if (!tape_.fault().empty()) return raise("123 CAN NOT USE MACRO COMMAND IN DNC");
  // 3964 has no end of its own; where the others have not sent theirs yet, this is refused.
  const auto protocol = packet::parse_protocol(settings_.protocol);
  if (tape_.at_end() && protocol && packet::is_3964(*protocol))
    static_cast<void>(receiver_.conclude(packet::Time(now_)));
  if (receiver_.state() == packet::ReceiveState::failed)
    return raise("TRANSFER BROKEN: " + std::string(packet::name(receiver_.end_cause())));
  if (receiver_.state() == packet::ReceiveState::done && !tape_.at_end()) return raise("NO END OF TAPE");
  if (receiver_.state() == packet::ReceiveState::done) report_.state = ControlState::ended;
}

std::vector<std::byte> PacketControl::take_out(Time_ns now) {
  const auto out = receiver_.pending_out();
  std::vector<std::byte> bytes(out.begin(), out.end());
  receiver_.mark_sent(bytes.size(), packet::Time(now));
  return bytes;
}

std::optional<Time_ns> PacketControl::deadline() const {
  std::optional<Time_ns> due = tape_.runs_until();
  if (report_.state == ControlState::alarm) due.reset();
  if (const auto protocol = receiver_.deadline()) due = std::min(due.value_or(protocol->count()), protocol->count());
  return due;
}

void PacketControl::raise(std::string_view alarm) {
  if (report_.state == ControlState::alarm) return;
  report_.state = ControlState::alarm;
  report_.alarm = alarm;
}

std::optional<Time_ns> PacketControl::quiet_since() const {
  if (tape_.is_busy() || receiver_.state() == packet::ReceiveState::full || !receiver_.pending_out().empty())
    return std::nullopt;
  return std::max(last_arrival_, tape_.last_run());
}

bool PacketControl::finished() const { return report_.state == ControlState::ended && !tape_.is_busy(); }

ControlReport PacketControl::report() const {
  ControlReport report = report_;
  tape_.report(report);
  const double seconds = static_cast<double>(last_arrival_ - first_arrival_) * 1e-9;
  const double line_s = static_cast<double>(report.bytes) * settings_.framing.bits_per_char() / settings_.baud;
  report.line_use = seconds > 0.0 ? std::min(1.0, line_s / seconds) : 0.0;
  return report;
}

}  // namespace dripfeed::simulator
