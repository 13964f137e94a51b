// The buffer's side: SYN until the host says RDY, then GTD for as long as there is room. A message that came damaged is
// asked for again (RTY); a message that did not come at all is an open line: it begins again with SYN, because after a
// lost GTD the host would repeat text that is here already.
#include <utility>

#include "protocol/packet/remote_buffer.h"

namespace dripfeed::packet {

using remote_buffer::Command;

namespace {

constexpr Time kInviteEvery = std::chrono::seconds(2);
constexpr Time kAnswerTime = std::chrono::seconds(5);
constexpr Time kAskAgainAfter = std::chrono::milliseconds(500);  // Tw
constexpr Time kCharacterTime = std::chrono::milliseconds(250);
constexpr std::uint32_t kAttempts = 10;

}  // namespace

RemoteBufferReceiveRules::RemoteBufferReceiveRules(const Settings& settings)
    : settings_(settings), form_(remote_buffer::form_of(settings)), reader_(form_) {}

void RemoteBufferReceiveRules::begin() {
  reader_.forget();
  ready_ = awaits_text_ = false;
  due_ = Due::answer;
}

std::size_t RemoteBufferReceiveRules::say(Command command, std::span<std::byte> out) {
  last_ = command;
  if (command == Command::gtd) awaits_text_ = true;
  due_ = Due::answer;
  return remote_buffer::compose(form_, command, {}, out);
}

std::size_t RemoteBufferReceiveRules::invite(std::span<std::byte> out) { return say(Command::syn, out); }

Received RemoteBufferReceiveRules::hear(std::uint8_t byte, ReceiveState state) {
  if (state != ReceiveState::inviting && state != ReceiveState::waiting && state != ReceiveState::framing) return {};
  const bool begins = !reader_.is_inside();
  switch (reader_.put(byte)) {
    case remote_buffer::Reader::Found::nothing:
      if (state == ReceiveState::framing) return {};
      return begins ? Received{ReceiveInput::header} : Received{};
    case remote_buffer::Reader::Found::message: return state == ReceiveState::framing ? hear_message() : Received{};
    case remote_buffer::Reader::Found::damaged: break;
  }
  due_ = Due::repeat;
  return {state == ReceiveState::framing ? std::optional(ReceiveInput::bad) : std::nullopt};
}

Received RemoteBufferReceiveRules::hear_message() {
  switch (reader_.message().command) {
    case Command::rdy:
      ready_ = true;
      due_ = Due::ask_now;
      return {ReceiveInput::nothing};
    case Command::dat:
      if (std::exchange(awaits_text_, false)) return {ReceiveInput::good};
      break;
    case Command::eod:
      if (std::exchange(awaits_text_, false)) return {ReceiveInput::end};
      break;
    case Command::wat:
      awaits_text_ = false;
      due_ = Due::ask;
      return {ReceiveInput::nothing};
    case Command::set:
    case Command::syn: due_ = Due::ask; return {ReceiveInput::nothing};
    case Command::rty: due_ = Due::last_again; return {ReceiveInput::nothing};
    case Command::rst:
    case Command::ars:
    case Command::alm:
    case Command::aal:
    case Command::sat:
    case Command::gtd:
    case Command::clb:
    case Command::rdi:
    case Command::sdi:
    case Command::sdo: break;
  }
  return {ReceiveInput::out_of_step, Cause::out_of_step};
}

std::optional<Time> RemoteBufferReceiveRules::silence(ReceiveState state) const {
  if (state == ReceiveState::inviting) return kInviteEvery;
  if (state == ReceiveState::framing || state == ReceiveState::purging) return kCharacterTime;
  if (due_ == Due::last_again || due_ == Due::ask_now) return Time(0);
  return due_ == Due::ask ? kAskAgainAfter : kAnswerTime;
}

std::uint32_t RemoteBufferReceiveRules::attempts(ReceiveState state) const {
  if (state == ReceiveState::inviting) return 0;
  if (state != ReceiveState::waiting) return kAttempts;
  return due_ == Due::answer ? 1 : 0;
}

std::size_t RemoteBufferReceiveRules::acknowledge(std::span<std::byte> out) { return say(Command::gtd, out); }

std::size_t RemoteBufferReceiveRules::refuse(std::span<std::byte> out) {
  reader_.forget();
  if (due_ == Due::ask || due_ == Due::ask_now) return say(ready_ ? Command::gtd : Command::syn, out);
  if (due_ == Due::last_again) return say(last_, out);
  return say(Command::rty, out);
}

std::size_t RemoteBufferReceiveRules::finish(std::span<std::byte> out) { return say(Command::sat, out); }
std::size_t RemoteBufferReceiveRules::cancel(std::span<std::byte> out) { return say(Command::rst, out); }

}  // namespace dripfeed::packet
