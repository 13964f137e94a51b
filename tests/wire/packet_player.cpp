// The steps of a packet protocol's dialog.
#include "tests/wire/packet_player.h"

#include <algorithm>
#include <stdexcept>

namespace dripfeed::wire {
namespace {

using packet::Time;

std::string hex(std::string_view bytes) {
  constexpr std::string_view kDigits = "0123456789ABCDEF";
  std::string out;
  for (const char c : bytes) {
    const auto value = static_cast<unsigned char>(c);
    out += {kDigits[value >> 4U], kDigits[value & 0xFU], ' '};
  }
  return out.empty() ? "nothing" : out;
}

std::string described(const packet::Event& event) {
  std::string text(name(event.kind));
  const auto add = [&](std::string_view more) { text += " " + std::string(more); };
  switch (event.kind) {
    case packet::EventKind::state_changed: add(name(event.to)); break;
    case packet::EventKind::stall_changed: add(event.stall == packet::Stall::none ? "none" : name(event.stall)); break;
    case packet::EventKind::command_refused: add(name(event.input)); break;
    case packet::EventKind::noticed: add(hex(std::string(1, static_cast<char>(event.byte))).substr(0, 2)); break;
    case packet::EventKind::telegram: add(std::to_string(event.count)); break;
    case packet::EventKind::start_unarmed:
    case packet::EventKind::repeated: break;
  }
  const bool over = event.kind == packet::EventKind::state_changed && event.cause != packet::Cause::none;
  if (over) add("by " + std::string(name(event.cause)));
  return text;
}

std::string described(const packet::ReceiveEvent& event) {
  std::string text(name(event.kind));
  if (event.kind == packet::ReceiveEventKind::state_changed) {
    text += " " + std::string(name(event.to));
    if (event.cause != packet::Cause::none) text += " by " + std::string(name(event.cause));
  }
  if (event.kind == packet::ReceiveEventKind::frame) text += " " + std::to_string(event.count);
  return text;
}

constexpr std::array<std::pair<std::string_view, feed::Command>, 7> kCommands{{
    {"disarm", feed::Command::disarm},
    {"stop", feed::Command::stop},
    {"resume", feed::Command::resume},
    {"cancel", feed::Command::cancel},
    {"abort", feed::Command::abort},
    {"confirm_reset", feed::Command::confirm_reset},
    {"resume_as_dc1", feed::Command::resume_as_if_dc1},
}};

// A block of XMODEM, made bit by bit so that the product's own check sums are not their own judge.
std::string xmodem_block(bool is_long, unsigned number, bool crc, std::string text, bool wrong, char fill = '\x1A') {
  text.resize(is_long ? 1024 : 128, fill);
  unsigned check = 0;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (!crc) {
      check = (check + byte) % 256;
      continue;
    }
    for (int bit = 7; bit >= 0; --bit) {
      const unsigned in = (byte >> bit & 1U) ^ (check >> 15U & 1U);
      check = (check << 1U & 0xFFFFU) ^ (in != 0 ? 0x1021U : 0U);
    }
  }
  if (wrong) check ^= 1U;
  std::string out{is_long ? '\x02' : '\x01', static_cast<char>(number), static_cast<char>(255 - number)};
  out += text;
  if (crc) out += static_cast<char>(check >> 8U);
  return out + static_cast<char>(check & 0xFFU);
}

}  // namespace

std::string PacketPlayer::play(const Dialog& dialog) {
  for (const Step& one : dialog.steps) {
    std::string wrong;
    try {
      wrong = step(one);
    } catch (const std::exception& error) {
      wrong = error.what();
    }
    if (!wrong.empty())
      return one.file + ":" + std::to_string(one.line) + ": " + one.kind + " " + one.rest + ": " + wrong;
    drain();
  }
  return events_.empty() ? "" : dialog.name + ": not expected at the end: " + events_.front();
}

std::string PacketPlayer::step(const Step& step) {
  if (step.kind != '!' && step.kind != '=' && !events_.empty()) return "not expected before it: " + events_.front();
  if (step.kind != 's') begin();
  switch (step.kind) {
    case 's': return set(step.rest);
    case '>': return expect_out(step.rest);
    case '<': return give_in(step.rest);
    case '@': return pass_time(step.rest);
    case '!': return expect_event(step.rest);
    case '*': return command(step.rest);
    case '=': return check(step.rest);
    default: return "unknown step";
  }
}

void PacketPlayer::begin() {
  if (sender_ || receiver_) return;
  if (receives_) {
    receiver_ = std::move(packet::Receiver::make(settings_, sink_).value());
    receiver_->observe_cells(
        [](void* cells, packet::ReceiveState state, packet::ReceiveInput input) {
          if (cells != nullptr) static_cast<PacketCells*>(cells)->receiver.insert({state, input});
        },
        cells_);
    return;
  }
  sender_ = std::move(packet::Sender::make(settings_).value());
  sender_->observe_cells(
      [](void* cells, packet::State state, packet::Input input) {
        if (cells != nullptr) static_cast<PacketCells*>(cells)->sender.insert({state, input});
      },
      cells_);
}

void PacketPlayer::drain() {
  while (sender_) {
    const auto event = sender_->next_event();
    if (!event) return;
    events_.push_back(described(*event));
  }
  while (receiver_) {
    const auto event = receiver_->next_event();
    if (!event) return;
    events_.push_back(described(*event));
  }
}

void PacketPlayer::tick() { sender_ ? sender_->tick(now_) : receiver_->tick(now_); }

std::string PacketPlayer::set(const std::string& rest) {
  if (rest.starts_with("text ")) {
    text_ = characters(std::string_view(rest).substr(5));
    return {};
  }
  for (const std::string& word : words(rest)) {
    const std::size_t equal = word.find('=');
    const std::string key = word.substr(0, equal);
    const std::string value = equal == std::string::npos ? "" : word.substr(equal + 1);
    if (key == "protocol") {
      settings_.protocol = packet::parse_protocol(value).value();
    } else if (key == "role") {
      receives_ = value == "receiver";
    } else if (key == "name") {
      name_ = value;
    } else if (key == "answer") {
      settings_.answer_patience = duration(value);
    } else if (key == "payload") {
      settings_.payload = static_cast<std::uint32_t>(std::stoul(value));
    } else if (key == "counted") {
      settings_.counted = value == "yes";
    } else if (key == "gives_way") {
      settings_.yields_on_collision = value == "yes";
    } else if (key == "end") {
      settings_.end_is_cr = value == "cr";
    } else if (key == "code") {
      settings_.wire.eighth_bit = value == "iso" ? tape_code::EighthBit::even : tape_code::EighthBit::data;
    } else {
      return "unknown setting " + key;
    }
  }
  return {};
}

std::string PacketPlayer::bytes_of(const std::string& rest) const {
  const bool is_header = rest.starts_with("header ");
  if (!is_header && !rest.starts_with("short ") && !rest.starts_with("long ")) return characters(rest);
  const std::vector<std::string> all = words(rest);
  const std::size_t quote = rest.find('"');
  const bool wrong = rest.ends_with(" wrong");
  const std::string text = rest.substr(quote, rest.size() - quote - (wrong ? 6 : 0));
  if (is_header) return xmodem_block(false, 0, all.at(1) == "crc", characters(text), wrong, '\0');
  return xmodem_block(all[0] == "long", static_cast<unsigned>(std::stoul(all.at(1))), all.at(2) == "crc",
                      characters(text), wrong);
}

std::size_t PacketPlayer::piece(std::size_t most) {
  switch (splits_) {
    case Splits::whole: return most;
    case Splits::single_bytes: return 1;
    case Splits::random: return 1 + random_() % most;
  }
  return most;
}

// Takes exactly these bytes, letting time run as far as the line needs.
std::string PacketPlayer::expect_out(const std::string& rest) {
  const std::string expected = bytes_of(rest);
  if (expected.empty()) return pending().empty() ? "" : "there is output: " + std::to_string(pending().size());
  std::string seen;
  while (seen.size() < expected.size()) {
    const auto bytes = pending();
    if (bytes.empty()) {
      const auto next = deadline();
      if (!next || *next <= now_ || *next > now_ + std::chrono::milliseconds(200))
        return "output ends after " + hex(seen);
      now_ = *next;
      tick();
      continue;
    }
    const std::size_t count = piece(std::min(bytes.size(), expected.size() - seen.size()));
    for (std::size_t i = 0; i < count; ++i) seen += static_cast<char>(bytes[i]);
    sender_ ? sender_->mark_sent(count, now_) : receiver_->mark_sent(count, now_);
    if (!expected.starts_with(seen)) return "went out: " + hex(seen) + "instead of " + hex(expected);
  }
  return {};
}

std::string PacketPlayer::give_in(const std::string& rest) {
  const std::string bytes = bytes_of(rest);
  for (std::size_t at = 0; at < bytes.size();) {
    const std::size_t count = piece(bytes.size() - at);
    const auto part = std::as_bytes(std::span(bytes).subspan(at, count));
    sender_ ? sender_->receive(part, now_) : receiver_->receive(part, now_);
    at += count;
  }
  return {};
}

std::string PacketPlayer::pass_time(const std::string& rest) {
  const Time until = now_ + duration(rest);
  for (auto next = deadline(); next && *next <= until && *next > now_; next = deadline()) {
    now_ = *next;
    tick();
  }
  now_ = until;
  tick();
  return {};
}

std::string PacketPlayer::expect_event(const std::string& rest) {
  drain();
  if (events_.empty()) return "no event";
  const std::string event = events_.front();
  events_.pop_front();
  return event == rest ? "" : "the event is: " + event;
}

std::string PacketPlayer::command(const std::string& rest) {
  std::vector<std::string> all = words(rest);
  const bool refused = all.back() == "refused";
  if (!refused) return one_command(all[0], rest.size() > all[0].size() ? rest.substr(all[0].size() + 1) : "");
  all.pop_back();
  for (const std::string& one : all) {
    if (one_command(one, "").empty()) return "not refused: " + one;
    drain();
    const std::string event = receives_ ? "command_refused" : "command_refused " + one;
    if (one == "resume_as_dc1") continue;
    if (events_.empty() || events_.front() != event) return "no event of the refusal of " + one;
    events_.pop_front();
  }
  return {};
}

std::string PacketPlayer::one_command(const std::string& name, const std::string& argument) {
  const auto command_result = [](const std::expected<void, feed::Refusal>& taken) {
    return taken ? std::string() : std::string(message(taken.error()));
  };
  if (name == "link") {
    sender_ ? sender_->link(argument == "on", now_) : receiver_->link(argument == "on", now_);
    return {};
  }
  if (receiver_) {
    if (name == "start") return command_result(receiver_->start(now_));
    if (name == "stop") return command_result(receiver_->stop(now_));
    if (name == "end") return command_result(receiver_->conclude(now_));
    if (name != "room") return "unknown command";
    sink_.space = std::stoul(argument);
    receiver_->tick(now_);
    return {};
  }
  for (const auto& [key, one] : kCommands) {
    if (key == name) return command_result(sender_->command(one, now_));
  }
  if (name == "reserve") {
    sender_->extend_reserve(std::stoul(argument), now_);
  } else if (name == "ready") {
    ready_ = std::stoul(argument);
    if (source_) source_->ready = ready_;
  } else if (name == "take") {
    sender_->take_telegram();
  } else if (name == "broken") {
    source_->broken = true;
  } else if (name == "arm") {
    auto source = std::make_unique<StagedSource>(text_);
    source->ready = ready_;
    feed::Job job{.facts = facts_of(text_), .source = source.get(), .reserve = feed::kNoReserve};
    if (!argument.empty()) job.reserve = std::stoul(argument);
    const auto taken = sender_->arm(job, now_, name_);
    if (taken) source_ = std::move(source);
    return command_result(taken);
  } else {
    return "unknown command " + name;
  }
  return {};
}

std::string PacketPlayer::check(const std::string& rest) {
  const std::vector<std::string> all = words(rest);
  const auto is = [&](std::string_view have) {
    return have == all.at(1) ? std::string() : "it is " + std::string(have);
  };
  if (receiver_) {
    if (all.at(0) == "state") return is(name(receiver_->state()));
    if (all[0] == "bytes") return is(std::to_string(receiver_->counters().bytes));
    if (all[0] == "text") {
      const std::string expected = characters(std::string_view(rest).substr(5));
      return sink_.text == expected ? "" : "it is " + hex(sink_.text);
    }
    return "unknown check";
  }
  if (all.at(0) == "state") return is(name(sender_->state()));
  if (all[0] == "telegram") {
    std::string have;
    for (const std::byte byte : sender_->telegram()) have += static_cast<char>(byte);
    return have == characters(std::string_view(rest).substr(9)) ? "" : "it is " + hex(have);
  }
  if (all[0] == "handed") return is(std::to_string(sender_->counters().handed));
  if (all[0] == "clocked") return is(std::to_string(sender_->counters().clocked));
  if (all[0] == "confirmed") return is(std::to_string(sender_->counters().confirmed));
  if (all[0] == "total") return is(std::to_string(sender_->total_bytes()));
  if (all[0] == "known") {
    const auto known = sender_->interval();
    return is(std::to_string(known.from) + ".." + std::to_string(known.to));
  }
  return "unknown check";
}

}  // namespace dripfeed::wire
