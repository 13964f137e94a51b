// The steps of a receiver's dialog.
#include "tests/wire/receive_player.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "protocol/tape_code/parity.h"

namespace dripfeed::wire {

using receive::Time;

void ReceiveDriver::take() {
  const auto kept = receiver.kept();
  raw_.insert(raw_.end(), kept.begin(), kept.end());
  receiver.mark_taken();
  const auto ended = receiver.ended();
  if (!ended) return;
  got.push_back({*ended, receive::judge(raw_, *ended, receiver.settings()), std::exchange(raw_, {})});
}

void ReceiveDriver::give(std::span<const std::byte> bytes, Time now) {
  while (!bytes.empty()) {
    bytes = bytes.subspan(receiver.receive(bytes, now));
    take();
  }
}

ReceiveDriver& ReceivePlayer::driver() {
  if (driver_) return *driver_;
  driver_.emplace(settings_);
  driver_->receiver.observe_rows(
      [](void* rows, std::size_t row) {
        if (rows != nullptr) static_cast<std::set<std::size_t>*>(rows)->insert(row);
      },
      rows_);
  return *driver_;
}

std::string ReceivePlayer::play(const Dialog& dialog) {
  for (const Step& one : dialog.steps) {
    std::string wrong;
    try {
      wrong = step(one);
    } catch (const std::exception& error) {
      wrong = error.what();
    }
    if (!wrong.empty())
      return one.file + ":" + std::to_string(one.line) + ": " + one.kind + " " + one.rest + ": " + wrong;
  }
  if (!driver().got.empty()) return dialog.name + ": a reception that nobody expected";
  return {};
}

std::string ReceivePlayer::step(const Step& step) {
  switch (step.kind) {
    case 's': return set(step.rest);
    case '>': return expect_out(step.rest);
    case '<': return give_in(step.rest);
    case '@':
      now_ += duration(step.rest);
      driver().receiver.tick(now_);
      driver().take();
      return {};
    case '!': return expect_got(step.rest);
    case '*': return command(step.rest);
    case '=': return check(step.rest);
    default: return "unknown step";
  }
}

std::string ReceivePlayer::set(const std::string& rest) {
  for (const std::string& word : words(rest)) {
    const std::size_t equal = word.find('=');
    const std::string key = word.substr(0, equal);
    const std::string value = word.substr(equal + 1);
    if (key == "eighth") {
      settings_.eighth_bit = value == "even"   ? tape_code::EighthBit::even
                             : value == "odd"  ? tape_code::EighthBit::odd
                             : value == "data" ? tape_code::EighthBit::data
                                               : tape_code::EighthBit::clear;
    } else if (key == "end") {
      settings_.end_character = static_cast<std::uint8_t>(std::stoul(value, nullptr, 16));
    } else if (key == "hold") {
      settings_.hold = value == "dc3" ? receive::Hold::dc3 : value == "rts" ? receive::Hold::rts : receive::Hold::none;
    } else if (key == "max") {
      settings_.max_bytes = std::stoull(value);
    } else if (key == "xon") {
      settings_.xon = static_cast<std::uint8_t>(std::stoul(value, nullptr, 16));
    } else if (key == "xoff") {
      settings_.xoff = static_cast<std::uint8_t>(std::stoul(value, nullptr, 16));
    } else if (key == "code") {
      settings_.find_code = value == "auto";
    } else if (key == "below") {
      settings_.flow_below = value == "yes";
    } else if (key == "eia") {
      settings_.eia_known = true;
      settings_.eia = value == "yes";
    } else {
      return "unknown setting " + key;
    }
  }
  return {};
}

// Characters in quotes get the line's parity, bytes in hex go as they are.
std::string ReceivePlayer::give_in(const std::string& rest) {
  const bool quoted = rest.find('"') != std::string::npos;
  std::vector<std::byte> bytes;
  for (const char c : characters(rest)) {
    const auto byte = static_cast<std::uint8_t>(c);
    bytes.push_back(static_cast<std::byte>(quoted ? tape_code::with_parity(byte, settings_.eighth_bit) : byte));
  }
  std::span<const std::byte> left = bytes;
  while (!left.empty()) {
    const std::size_t size = cuts_ == Cuts::whole          ? left.size()
                             : cuts_ == Cuts::single_bytes ? 1
                                                           : 1 + random_() % left.size();
    driver().give(left.first(size), now_);
    left = left.subspan(size);
  }
  return {};
}

std::string ReceivePlayer::command(const std::string& rest) {
  if (rest == "full" || rest == "room") {
    driver().receiver.can_take(rest == "room", now_);
  } else if (rest == "link off") {
    driver().receiver.link_lost(now_);
  } else {
    return "unknown command";
  }
  driver().take();
  return {};
}

std::string ReceivePlayer::check(const std::string& rest) {
  const std::vector<std::string> all = words(rest);
  if (all[0] == "state") {
    const std::string state(receive::name(driver().receiver.state()));
    return state == all[1] ? "" : "it is " + state;
  }
  if (all[0] == "rts") return driver().receiver.rts() == (all[1] == "on") ? "" : "it is not";
  return "unknown check";
}

std::string ReceivePlayer::expect_out(const std::string& rest) {
  const auto out = driver().receiver.pending_out();
  std::string got;
  for (const std::byte byte : out) got += static_cast<char>(byte);
  driver().receiver.mark_sent(out.size());
  return got == characters(rest) ? "" : "it sends " + std::to_string(got.size()) + " others";
}

std::string ReceivePlayer::expect_got(const std::string& rest) {
  if (driver().got.empty()) return "nothing was received";
  const ReceiveDriver::Got got = driver().got.front();
  driver().got.pop_front();
  const std::string fault(receive::name(got.transfer.fault));
  const std::string shown = std::string(receive::name(got.ending.by)) + " " + (fault.empty() ? "whole" : fault) + " " +
                            std::string(receive::name(got.transfer.code));
  const std::size_t quote = rest.find('"');
  const std::string expected = rest.substr(0, quote == std::string::npos ? quote : quote - 1);
  if (shown != expected) return "it is " + shown;
  if (quote != std::string::npos && got.transfer.text != characters(rest.substr(quote)))
    return "its text is\n" + got.transfer.text;
  return {};
}

}  // namespace dripfeed::wire
