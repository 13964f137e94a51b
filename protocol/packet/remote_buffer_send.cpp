// The host's side: an answer to everything the buffer says. A data message counts as taken when the buffer's next one
// does not ask for it again. What answers a reset or an alarm holds no text, so it goes out on a torn line, too.
#include <utility>

#include "protocol/packet/remote_buffer.h"

namespace dripfeed::packet {

using remote_buffer::Command;

namespace {

constexpr std::uint32_t kAttempts = 10;
constexpr Time kEndPatience = std::chrono::seconds(30);

}  // namespace

RemoteBufferSendRules::RemoteBufferSendRules(const Settings& settings)
    : settings_(settings), form_(remote_buffer::form_of(settings)), reader_(form_) {}

void RemoteBufferSendRules::link_up() {
  reader_.forget();
  reply_.reset();
}

Heard RemoteBufferSendRules::hear(std::uint8_t byte, State state) {
  switch (reader_.put(byte)) {
    case remote_buffer::Reader::Found::nothing: return {};
    case remote_buffer::Reader::Found::message: return hear_message(state);
    case remote_buffer::Reader::Found::damaged: break;
  }
  // What comes while a message goes out is ignored, as the buffer does.
  if (state == State::sending) return {};
  reply_ = Command::rty;
  return {Signal::noise};
}

Heard RemoteBufferSendRules::hear_message(State state) {
  const bool on_the_line = is_on_the_line(state) || state == State::armed;
  const bool awaits_next = state == State::waiting || state == State::closing;
  if (state == State::sending) return {};
  switch (reader_.message().command) {
    case Command::syn:
      reply_ = Command::rdy;
      return state == State::armed || !on_the_line ? Heard{} : Heard{Signal::broken, Cause::peer_reset};
    case Command::rdy: reply_ = Command::rdy; return {awaits_next ? Signal::accepted : Signal::none};
    case Command::rst: reply_ = Command::ars; return {Signal::broken, Cause::peer_reset};
    case Command::alm: reply_ = Command::aal; return {Signal::broken, Cause::peer_alarm};
    case Command::sat: reply_ = Command::set; return {awaits_next ? Signal::accepted : Signal::none};
    case Command::gtd:
      if (state == State::closing || !on_the_line) reply_ = Command::wat;
      return {state == State::closing ? Signal::accepted : Signal::asked};
    case Command::rty: return hear_repeat(state);
    case Command::ars:
    case Command::aal:
    case Command::set:
    case Command::dat:
    case Command::wat:
    case Command::eod:
    case Command::clb:
    case Command::rdi:
    case Command::sdi:
    case Command::sdo: break;  // the host's own, and inputs that no one asked for
  }
  return {Signal::noise};
}

Heard RemoteBufferSendRules::hear_repeat(State state) {
  const bool awaits_next = state == State::waiting || state == State::closing;
  if (awaits_next && last_is_frame_) return {Signal::again};
  // We asked for a message again, and are asked again: for that request, or for the text before it? Sending text on a
  // guess might bring it twice.
  if (awaits_next && last_ == Command::rty) return {Signal::broken, Cause::out_of_step};
  if (last_ != Command::rty) reply_ = last_;
  return {};
}

Patience RemoteBufferSendRules::patience(State state) const {
  if (state == State::waiting) return {.limit = settings_.answer_patience, .attempts = kAttempts};
  if (state == State::closing) return {.limit = kEndPatience, .attempts = kAttempts};
  return {.limit = {}, .attempts = kAttempts};
}

std::size_t RemoteBufferSendRules::frame_size(std::size_t available, bool complete) const {
  if (available >= settings_.payload) return settings_.payload;
  return complete ? available : 0;
}

std::size_t RemoteBufferSendRules::compose(std::span<const std::byte> payload, std::span<std::byte> out) {
  last_is_frame_ = true;
  return remote_buffer::compose(form_, Command::dat, payload, out);
}

std::size_t RemoteBufferSendRules::close(std::span<std::byte> out) {
  last_is_frame_ = true;
  return remote_buffer::compose(form_, Command::eod, {}, out);
}

std::size_t RemoteBufferSendRules::part(std::span<std::byte> out) { return say(Command::eod, out); }
std::size_t RemoteBufferSendRules::nothing_now(std::span<std::byte> out) { return say(Command::wat, out); }

std::size_t RemoteBufferSendRules::reply(std::span<std::byte> out) {
  if (!reply_) return 0;
  return say(*std::exchange(reply_, std::nullopt), out);
}

std::size_t RemoteBufferSendRules::say(Command command, std::span<std::byte> out) {
  last_ = command;
  last_is_frame_ = false;
  return remote_buffer::compose(form_, command, {}, out);
}

}  // namespace dripfeed::packet
