// What each kind of step does to the client.
#include "tests/wire/telnet_player.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <vector>

namespace dripfeed::wire {

namespace {

std::string hex(std::string_view bytes) {
  std::string out;
  for (const char c : bytes) {
    constexpr std::string_view kDigits = "0123456789ABCDEF";
    const auto value = static_cast<unsigned char>(c);
    out += kDigits[value >> 4U];
    out += kDigits[value & 15U];
    out += ' ';
  }
  return out;
}

std::string hex_octet(std::uint32_t value) {
  constexpr std::string_view kDigits = "0123456789abcdef";
  return {kDigits[value >> 4U & 15U], kDigits[value & 15U]};
}

std::string underscored(std::string_view text) {
  std::string out(text);
  std::ranges::replace(out, ' ', '_');
  return out;
}

std::string text_of(const telnet::ClientEvent& event, const telnet::ComPortClient& client) {
  using Kind = telnet::ClientEvent::Kind;
  switch (event.kind) {
    case Kind::up: return "up";
    case Kind::failed: return "failed " + std::string(telnet::message(client.failure()));
    case Kind::unconfirmed: return "unconfirmed " + std::string(name(event.setting));
    case Kind::differs:
      return "differs " + underscored(name(event.setting)) + " " + std::to_string(event.asked) + " " +
             std::to_string(event.value);
    case Kind::modem_change: return "modem " + hex_octet(event.value);
    case Kind::line_error: return "line_error " + hex_octet(event.value);
    case Kind::suspended: return "suspended";
    case Kind::resumed: return "resumed";
  }
  return "";
}

}  // namespace

std::string TelnetPlayer::play(const Dialog& dialog) {
  for (const Step& one : dialog.steps) {
    std::string wrong = step(one);
    if (!wrong.empty()) return one.file + ":" + std::to_string(one.line) + ": " + wrong;
  }
  if (!events_.empty()) return "an event that nobody expects: " + events_.front();
  return "";
}

telnet::ComPortClient& TelnetPlayer::client() {
  if (!client_) client_.emplace(settings_);
  return *client_;
}

std::string TelnetPlayer::step(const Step& step) {
  switch (step.kind) {
    case 's': set(step.rest); return "";
    case '>': return expect_out(step.rest);
    case '<': give_in(step.rest); return "";
    case '@': pass_time(step.rest); return "";
    case '!': return expect_event(step.rest);
    case '*': return command(step.rest);
    case '=': return check(step.rest);
    default: return "no such step here";
  }
}

void TelnetPlayer::set(const std::string& rest) {
  for (const std::string& word : words(rest)) {
    const auto value = static_cast<std::uint32_t>(std::stoul(word.substr(word.find('=') + 1)));
    if (word.starts_with("baud=")) settings_.baud = value;
    if (word.starts_with("flow=")) settings_.flow = static_cast<telnet::LineFlow>(value);
  }
}

std::string TelnetPlayer::take_out() {
  std::string out;
  while (!client().pending_out().empty()) {
    const auto pending = client().pending_out();
    const std::size_t count = splits_ == Splits::whole ? pending.size() : 1;
    for (const std::byte byte : pending.first(count)) out += static_cast<char>(byte);
    client().mark_sent(count);
  }
  return out;
}

std::string TelnetPlayer::expect_out(const std::string& rest) {
  const std::string out = take_out();
  if (out == characters(rest)) return "";
  return "went out: " + hex(out);
}

void TelnetPlayer::give_in(const std::string& rest) {
  const std::string bytes = characters(rest);
  for (std::size_t at = 0; at < bytes.size();) {
    std::size_t count = bytes.size() - at;
    if (splits_ == Splits::single_bytes) count = 1;
    if (splits_ == Splits::random) count = std::min<std::size_t>(count, 1 + random_() % 7);
    std::vector<std::byte> wire;
    for (std::size_t i = 0; i < count; ++i) wire.push_back(static_cast<std::byte>(bytes[at + i]));
    std::vector<std::byte> data(count);
    const std::size_t got = client().receive(wire, data, now_);
    for (std::size_t i = 0; i < got; ++i) data_ += static_cast<char>(data[i]);
    at += count;
    drain();
  }
}

void TelnetPlayer::pass_time(const std::string& rest) {
  const telnet::Time until = now_ + duration(rest);
  while (client().deadline() && *client().deadline() <= until) {
    now_ = *client().deadline();
    client().tick(now_);
    drain();
  }
  now_ = until;
}

void TelnetPlayer::drain() {
  while (const auto event = client().next_event()) events_.push_back(text_of(*event, client()));
}

std::string TelnetPlayer::expect_event(const std::string& rest) {
  if (events_.empty()) return "no event";
  const std::string event = events_.front();
  events_.pop_front();
  return event == rest ? "" : "event: " + event;
}

std::string TelnetPlayer::command(const std::string& rest) {
  const std::vector<std::string> all = words(rest);
  const bool on = all.back() == "on";
  if (all[0] == "begin") client().begin(now_);
  if (all[0] == "drop") take_out();
  if (all[0] == "purge") client().purge_output();
  if (all[0] == "dtr") client().set_dtr(on);
  if (all[0] == "rts") client().set_rts(on);
  if (all[0] == "break") client().set_break(on);
  if (all[0] == "send") {
    const std::string bytes = characters(rest.substr(5, rest.rfind(' ') - 5));
    std::vector<std::byte> data;
    for (const char c : bytes) data.push_back(static_cast<std::byte>(c));
    const std::size_t taken = client().send(data);
    if (taken != std::stoul(all.back())) return "took " + std::to_string(taken);
  }
  drain();
  return "";
}

std::string TelnetPlayer::check(const std::string& rest) {
  if (rest.starts_with("state ")) {
    const std::string now(name(client().state()));
    return now == rest.substr(6) ? "" : "the state is " + now;
  }
  const std::string data = std::exchange(data_, {});
  return data == characters(rest.substr(5)) ? "" : "data: " + hex(data);
}

}  // namespace dripfeed::wire
