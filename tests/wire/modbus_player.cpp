// The steps of a mailbox sender's dialog.
#include "tests/wire/modbus_player.h"

#include <algorithm>
#include <stdexcept>

namespace dripfeed::wire {
namespace {

using modbus::MailboxCommand;
using modbus::Request;
using modbus::SenderEventKind;

constexpr std::uint32_t kSession = 7;

std::string described(const modbus::SenderEvent& event) {
  std::string text(name(event.kind));
  const auto add = [&](std::string_view more) { text += " " + std::string(more); };
  switch (event.kind) {
    case SenderEventKind::state_changed:
      add(name(event.from));
      add(name(event.to));
      if (event.to == modbus::SenderState::stopped) add(name(event.reason));
      break;
    case SenderEventKind::stall_changed: add(name(event.stall)); break;
    case SenderEventKind::opened: add(std::to_string(event.boot_counter)); break;
    case SenderEventKind::confirmed: add(std::to_string(event.seq)); break;
    case SenderEventKind::rewritten:
    case SenderEventKind::command_refused: break;
  }
  return text;
}

std::string quoted(std::span<const std::byte> bytes) {
  std::string text = "\"";
  for (const std::byte byte : bytes) {
    const char c = static_cast<char>(byte);
    text += c == '\n' ? "\\n" : std::string(1, c);
  }
  return text + "\"";
}

template <typename Enum>
Enum named(std::string_view text, int count) {
  for (int i = 0; i < count; ++i) {
    if (name(static_cast<Enum>(i)) == text) return static_cast<Enum>(i);
  }
  throw std::runtime_error("no such name: " + std::string(text));
}

}  // namespace

tape_code::TextPiece ModbusPlayer::Source::next() noexcept {
  const std::size_t limit = std::min(ready, text_.size());
  if (given_ < limit) {
    const std::size_t from = std::exchange(given_, limit);
    return {.status = tape_code::SourceStatus::text, .text = std::span(text_).subspan(from, limit - from)};
  }
  if (broken) return {.status = tape_code::SourceStatus::failed};
  if (given_ < text_.size()) return {.status = tape_code::SourceStatus::not_ready};
  return {.status = tape_code::SourceStatus::end};
}

std::string ModbusPlayer::play(const Dialog& dialog) {
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

std::string ModbusPlayer::step(const Step& step) {
  if (step.kind != '!' && step.kind != '=' && !events_.empty()) return "not expected before it: " + events_.front();
  if (!sender_ && step.kind != 's') {
    sender_.emplace(settings_);
    sender_->observe_cells(
        [](void* cells, modbus::SenderState state, modbus::SenderInput input) {
          if (cells != nullptr) static_cast<std::set<SenderCellTaken>*>(cells)->insert({state, input});
        },
        cells_);
  }
  switch (step.kind) {
    case 's': return set(step.rest);
    case '>': return expect_request(step.rest);
    case '<': return answer(step.rest);
    case '@':
      now_ += duration(step.rest);
      sender_->tick(now_);
      return {};
    case '!': return expect_event(step.rest);
    case '*': return command(step.rest);
    case '=': return check(step.rest);
    default: return "unknown step";
  }
}

std::string ModbusPlayer::set(const std::string& rest) {
  if (rest.starts_with("text ")) {
    text_ = characters(std::string_view(rest).substr(5));
  } else if (rest.starts_with("payload=")) {
    settings_.max_payload = static_cast<std::uint32_t>(std::stoul(rest.substr(8)));
  } else {
    return "unknown setting";
  }
  return {};
}

void ModbusPlayer::drain() {
  if (!sender_) return;
  while (const auto event = sender_->next_event()) events_.push_back(described(*event));
}

std::optional<Request> ModbusPlayer::take(std::chrono::nanoseconds patience) {
  const modbus::Time until = now_ + patience;
  while (true) {
    if (const auto request = sender_->next_request(now_)) return request;
    const auto next = sender_->deadline();
    if (!next || *next > until || *next <= now_) return std::nullopt;
    now_ = *next;
    sender_->tick(now_);
  }
}

std::string ModbusPlayer::expect_request(const std::string& rest) {
  const auto request = take(rest == "nothing" ? std::chrono::nanoseconds(0) : settings_.poll);
  if (!request) return rest == "nothing" ? "" : "no request";
  if (request->kind == Request::Kind::read_status) return rest == "read" ? "" : "a read";
  modbus::Mailbox mailbox{};
  std::ranges::copy(request->registers, mailbox.begin());
  modbus::Decoded decoded;
  if (!decode(mailbox, decoded)) return "a write that cannot be decoded";
  const modbus::Message& message = decoded.message;
  if (message.session != kSession) return "another session";
  std::string text(name(message.command));
  if (message.command == MailboxCommand::data || message.command == MailboxCommand::eof) {
    text += " " + std::to_string(message.seq);
  }
  if (message.command == MailboxCommand::data) text += " " + quoted(message.payload);
  return text == rest ? "" : "it is: " + text;
}

std::string ModbusPlayer::answer(const std::string& rest) {
  modbus::StatusImage image{};
  if (rest == "ok") {
    sender_->written(now_);
  } else if (rest == "fail") {
    sender_->request_failed(now_);
  } else if (rest == "foreign") {
    sender_->status_read(image, now_);
  } else if (rest == "garbled") {
    encode(status_, image);
    image[13] = static_cast<std::uint16_t>(image[13] + 1);
    sender_->status_read(image, now_);
  } else if (rest.starts_with("status")) {
    if (const std::string wrong = change_status(rest.substr(6)); !wrong.empty()) return wrong;
    status_.text_crc = modbus::crc32(0, std::as_bytes(std::span(text_).first(status_.appended)));
    if (wrong_crc_) status_.text_crc ^= 1U;
    encode(status_, image);
    sender_->status_read(image, now_);
  } else {
    return "unknown answer";
  }
  return {};
}

std::string ModbusPlayer::change_status(const std::string& rest) {
  for (const std::string& word : words(rest)) {
    const std::size_t equal = word.find('=');
    if (equal == std::string::npos) return "not a value: " + word;
    const std::string key = word.substr(0, equal);
    const std::string value = word.substr(equal + 1);
    const auto number = [&] { return static_cast<std::uint16_t>(std::stoul(value)); };
    if (key == "session") {
      status_.session = number();
    } else if (key == "state") {
      status_.state = named<modbus::ReceiverState>(value, 7);
    } else if (key == "ack") {
      status_.ack_seq = number();
    } else if (key == "nak") {
      status_.nak = named<modbus::Nak>(value, 8);
    } else if (key == "nak_seq") {
      status_.nak_seq = number();
    } else if (key == "free") {
      status_.free_blocks = number();
    } else if (key == "consumed") {
      status_.consumed = number();
    } else if (key == "boot") {
      status_.boot_counter = number();
    } else if (key == "has") {
      status_.appended = number();
    } else if (key == "crc") {
      wrong_crc_ = value == "wrong";
    } else {
      return "unknown value " + key;
    }
  }
  return {};
}

std::string ModbusPlayer::command(const std::string& rest) {
  std::vector<std::string> all = words(rest);
  const bool refused = all.back() == "refused";
  if (refused) all.pop_back();
  for (const std::string& one : all) {
    std::expected<void, modbus::SenderRefusal> taken;
    if (one == "start" || one.starts_with("resume=")) {
      auto source = std::make_unique<Source>(text_);
      source->ready = ready_;
      const modbus::SenderJob job{
          .source = source.get(), .text_bytes = text_.size(), .session = kSession, .reserve = UINT64_MAX};
      taken = one == "start" ? sender_->start(job, now_)
                             : sender_->resume(job, static_cast<std::uint16_t>(std::stoul(one.substr(7))), now_);
      if (taken) source_ = std::move(source);
    } else if (one.starts_with("ready=")) {
      ready_ = std::stoul(one.substr(6));
      if (source_) source_->ready = ready_;
    } else if (one == "broken") {
      source_->broken = true;
    } else if (one == "hold") {
      taken = sender_->command(modbus::SenderCommand::hold, now_);
    } else if (one == "release") {
      taken = sender_->command(modbus::SenderCommand::release, now_);
    } else if (one == "abort") {
      taken = sender_->command(modbus::SenderCommand::abort, now_);
    } else if (one == "proceed") {
      taken = sender_->command(modbus::SenderCommand::proceed, now_);
    } else {
      return "unknown command " + one;
    }
    if (taken.has_value() == refused) return one + (refused ? " is not refused" : " is refused");
    if (!refused) continue;
    drain();
    if (events_.empty() || events_.front() != "command_refused") return "no event of the refusal of " + one;
    events_.pop_front();
  }
  return {};
}

std::string ModbusPlayer::expect_event(const std::string& rest) {
  if (events_.empty()) return "no event";
  const std::string event = events_.front();
  events_.pop_front();
  return event == rest ? "" : "the event is: " + event;
}

std::string ModbusPlayer::check(const std::string& rest) {
  const std::vector<std::string> all = words(rest);
  const modbus::SenderCounters counters = sender_->counters();
  const auto is = [&](std::string_view have) { return have == all.at(1) ? "" : "it is " + std::string(have); };
  if (all.at(0) == "state") return is(name(sender_->state()));
  if (all[0] == "stall") return is(name(sender_->stall()));
  if (all[0] == "reason") return is(name(sender_->stop_reason()));
  if (all[0] == "nak") return is(name(sender_->stop_nak()));
  if (all[0] == "confirmed") return is(std::to_string(counters.confirmed));
  if (all[0] == "consumed") return is(std::to_string(counters.consumed));
  if (all[0] == "handed") return is(std::to_string(counters.handed));
  if (all[0] == "rewrites") return is(std::to_string(counters.rewrites));
  return "unknown check";
}

}  // namespace dripfeed::wire
