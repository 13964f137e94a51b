// The wire is made once; each character leaves when the one before it has passed.
#include "server/simulator/punching_control.h"

#include <algorithm>
#include <optional>
#include <string_view>

#include "protocol/tape_code/code_table.h"
#include "protocol/tape_code/parity.h"

namespace dripfeed::simulator {

namespace {

constexpr std::byte kDc2{0x12};
constexpr std::byte kDc4{0x14};
constexpr std::uint8_t kDc1 = 0x11;
constexpr std::uint8_t kDc3 = 0x13;
constexpr std::size_t kLeader = 20;
constexpr Time_ns kToPunch_ns = 300'000'000;   // the operator presses PUNCH
constexpr Time_ns kToRead_ns = 1'500'000'000;  // ... and READ, once the host had time to look

// A character that the code does not have is left out, as controls do.
std::vector<std::byte> wire_of(const ControlSettings& settings) {
  const auto eighth = tape_code::eighth_bit(settings.framing, settings.code, tape_code::ParityBy::software);
  const bool is_eia = settings.code == tape_code::Code::eia;
  const tape_code::EncodeTable code(eighth, is_eia ? std::optional(settings.eia_specials) : std::nullopt);
  const std::string_view eob = is_eia ? std::string_view("\n") : tape_code::characters(settings.eob);
  std::vector<std::byte> wire = {kDc2};
  wire.resize(1 + kLeader);
  const auto put = [&](char c) {
    if (code.has(c)) wire.push_back(std::byte{code.code(c)});
  };
  for (const char c : settings.punches) {
    if (c == '\n') {
      std::ranges::for_each(eob, put);
    } else {
      put(c);
    }
  }
  wire.resize(wire.size() + kLeader);
  wire.push_back(kDc4);
  return wire;
}

}  // namespace

PunchingControl::PunchingControl(const ControlSettings& settings, Record record)
    : reader_(settings, std::move(record)),
      reads_(settings.protocol == "punch-read"),
      char_ns_(static_cast<Time_ns>(settings.framing.bits_per_char()) * 1'000'000'000 / settings.baud),
      wire_(wire_of(settings)) {}

void PunchingControl::start(Time_ns now) {
  if (reading_ || all_punched()) return;
  next_ = 0;
  begun_at_ = now;
  due_ = now + kToPunch_ns;
}

void PunchingControl::reset() {
  if (reading_) return reader_.reset();
  next_ = wire_.size();
  ended_at_ = due_;
}

void PunchingControl::receive(std::span<const std::byte> bytes, Time_ns looked_before, Time_ns now) {
  if (reading_) return reader_.receive(bytes, looked_before, now);
  for (const std::byte byte : bytes) {
    const auto sign = std::to_integer<std::uint8_t>(byte) & tape_code::kLowSevenBits;
    if (sign == kDc3) held_ = true;
    if (sign == kDc1) {
      held_ = false;
      due_ = std::max(due_, now);
    }
  }
}

void PunchingControl::tick(Time_ns now) {
  if (reading_) return reader_.tick(now);
  if (!all_punched() || !reads_ || now < ended_at_ + kToRead_ns) return;
  reading_ = true;
  reader_.start(now);
}

std::vector<std::byte> PunchingControl::take_out(Time_ns now) {
  if (reading_) return reader_.take_out(now);
  std::vector<std::byte> out;
  while (begun_at_ >= 0 && !held_ && !all_punched() && due_ <= now) {
    out.push_back(wire_[next_++]);
    due_ += char_ns_;
    if (all_punched()) ended_at_ = now;
  }
  return out;
}

std::optional<Time_ns> PunchingControl::deadline() const {
  if (reading_) return reader_.deadline();
  if (begun_at_ < 0 || (held_ && !all_punched())) return std::nullopt;
  if (!all_punched()) return due_;
  return reads_ ? std::optional(ended_at_ + kToRead_ns) : std::nullopt;
}

std::optional<Time_ns> PunchingControl::look_every() const {
  return reading_ ? reader_.look_every() : std::optional(char_ns_);
}

ControlState PunchingControl::state() const {
  if (reading_) return reader_.state();
  if (!all_punched()) return held_ ? ControlState::held : ControlState::waiting;
  return reads_ ? ControlState::waiting : ControlState::ended;
}

std::optional<Time_ns> PunchingControl::quiet_since() const {
  if (reading_) return reader_.quiet_since();
  return all_punched() && !reads_ ? std::optional(ended_at_) : std::nullopt;
}

bool PunchingControl::finished() const { return reading_ ? reader_.finished() : all_punched() && !reads_; }

}  // namespace dripfeed::simulator
