// The steps of a feed's dialog.
#include "tests/wire/feed_player.h"

#include <algorithm>
#include <stdexcept>

#include "protocol/tape_code/parity.h"

namespace dripfeed::wire {
namespace {

using feed::Command;
using feed::EventKind;
using feed::LineChange;
using feed::Time;

std::string hex(std::uint8_t byte) {
  constexpr std::string_view kDigits = "0123456789ABCDEF";
  return {kDigits[byte >> 4U], kDigits[byte & 0xFU]};
}

std::string shown(std::string_view bytes) {
  std::string out;
  for (const char c : bytes) out += hex(static_cast<std::uint8_t>(c)) + " ";
  return out.empty() ? "nothing" : out;
}

std::string described(const feed::Event& event) {
  std::string text(name(event.kind));
  const auto add = [&](std::string_view more) { text += " " + std::string(more); };
  switch (event.kind) {
    case EventKind::state_changed:
      add(name(event.from));
      add(name(event.to));
      add(name(event.cause));
      break;
    case EventKind::stall_changed: add(name(event.stall)); break;
    case EventKind::dc1_unarmed:
    case EventKind::dc3_seen:
    case EventKind::punch_code: add(hex(event.byte)); break;
    case EventKind::noticed:
      add(name(event.cause));
      add(hex(event.byte));
      break;
    case EventKind::command_refused: add(name(event.input)); break;
    case EventKind::resumed_by_person: break;
    case EventKind::cts_changed:
    case EventKind::dsr_changed:
    case EventKind::link_changed: add(event.up ? "on" : "off"); break;
  }
  return text;
}

const std::pair<std::string_view, Command> kCommands[] = {
    {"disarm", Command::disarm},
    {"stop", Command::stop},
    {"resume", Command::resume},
    {"cancel", Command::cancel},
    {"abort", Command::abort},
    {"resume_as_dc1", Command::resume_as_if_dc1},
    {"confirm_reset", Command::confirm_reset},
};
const std::pair<std::string_view, LineChange> kLines[] = {
    {"link on", LineChange::link_up}, {"link off", LineChange::link_down}, {"cts on", LineChange::cts_on},
    {"cts off", LineChange::cts_off}, {"dsr on", LineChange::dsr_on},      {"dsr off", LineChange::dsr_off},
};

const std::pair<std::string_view, feed::Flow> kFlows[] = {
    {"none", feed::Flow::none},     {"xonxoff", feed::Flow::xonxoff}, {"rtscts", feed::Flow::rtscts},
    {"dtrdsr", feed::Flow::dtrdsr}, {"both", feed::Flow::both},
};
const std::pair<std::string_view, feed::XoffBy> kXoffBys[] = {
    {"host", feed::XoffBy::host}, {"kernel", feed::XoffBy::kernel}, {"device", feed::XoffBy::device}};

template <class Rows>
auto one_of(const Rows& rows, std::string_view name) {
  for (const auto& [key, value] : rows) {
    if (key == name) return value;
  }
  throw std::runtime_error("there is no " + std::string(name));
}

std::uint64_t number(const std::string& text) { return std::stoull(text); }

}  // namespace

tape_code::TextPiece StagedSource::next() noexcept {
  if (given_ == text_.size() && rounds > 1) {
    --rounds;
    given_ = 0;
  }
  const std::size_t limit = std::min(ready, text_.size());
  if (given_ < limit) {
    const std::size_t from = given_;
    given_ = limit;
    return {.status = tape_code::SourceStatus::text, .text = std::span(text_).subspan(from, limit - from)};
  }
  if (broken) return {.status = tape_code::SourceStatus::failed};
  if (given_ < text_.size()) return {.status = tape_code::SourceStatus::not_ready};
  return {.status = tape_code::SourceStatus::end};
}

feed::ProgramFacts facts_of(const std::string& text, const feed::ProgramSyntax& syntax) {
  feed::ProgramCheck check(syntax);
  check.append(text);
  const auto facts = check.finish();
  if (!facts) throw std::runtime_error("the text of the dialog: " + std::string(message(facts.error().fault)));
  return *facts;
}

std::string FeedPlayer::play(const Dialog& dialog) {
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
  if (!events_.empty()) return dialog.name + ": not expected at the end: " + events_.front();
  return {};
}

std::string FeedPlayer::step(const Step& step) {
  if (step.kind != '!' && step.kind != '=' && !events_.empty()) return "not expected before it: " + events_.front();
  switch (step.kind) {
    case 's': return set(step.rest);
    case '>': return expect_out(step.rest);
    case '~': return late_write(step.rest);
    case '<': return give_in(step.rest);
    case '@': return pass_time(step.rest);
    case '!': return expect_event(step.rest);
    case '*': return command(step.rest);
    case '=': return check(step.rest);
    default: return "unknown step";
  }
}

feed::Feed& FeedPlayer::feed() {
  if (feed_) return *feed_;
  auto made = feed::Feed::make(settings_);
  if (!made) throw std::runtime_error(message(made.error()));
  feed_ = std::move(*made);
  feed_->observe_rows(
      [](void* rows, std::size_t row) {
        if (rows != nullptr) static_cast<std::set<std::size_t>*>(rows)->insert(row);
      },
      rows_);
  return *feed_;
}

void FeedPlayer::drain() {
  if (!feed_) return;
  while (const auto event = feed_->next_event()) events_.push_back(described(*event));
}

std::string FeedPlayer::set(const std::string& rest) {
  if (rest.starts_with("text ")) {
    text_ = characters(std::string_view(rest).substr(5));
    return {};
  }
  for (const std::string& word : words(rest)) {
    const std::size_t equal = word.find('=');
    const std::string key = word.substr(0, equal);
    std::string value = equal == std::string::npos ? "" : word.substr(equal + 1);
    std::ranges::replace(value, '_', ' ');
    if (key == "framing") {
      settings_.framing = tape_code::parse_framing(value).value();
      settings_.wire.eighth_bit = eighth_bit(settings_.framing, tape_code::Code::ascii, tape_code::ParityBy::software);
    } else if (key == "baud") {
      settings_.baud = static_cast<std::uint32_t>(number(value));
    } else if (key == "eob") {
      settings_.wire.eob = tape_code::parse_eob(value).value();
    } else if (key == "leader") {
      settings_.wire.leader_chars = static_cast<std::uint32_t>(number(value));
    } else if (key == "trailer") {
      settings_.wire.trailer_chars = static_cast<std::uint32_t>(number(value));
    } else if (key == "unsent") {
      settings_.unsent = static_cast<std::uint32_t>(number(value));
    } else if (key == "start") {
      settings_.start = value == "at once" ? feed::Start::at_once : feed::Start::on_dc1;
    } else if (key == "trigger") {
      settings_.start = feed::Start::on_trigger;
      settings_.trigger = value;
    } else if (key == "flow") {
      settings_.flow = one_of(kFlows, value);
    } else if (key == "xoff_by") {
      settings_.xoff_by = one_of(kXoffBys, value);
    } else if (key == "own_flow_characters") {
      settings_.flow_characters = {.xon = 0x0E, .xoff = 0x0F};
    } else if (key == "char_delay") {
      settings_.char_delay = duration(value);
    } else if (key == "line_delay") {
      settings_.line_delay = duration(value);
    } else if (key == "end") {
      settings_.end = {.dc3 = value.find("dc3") != std::string::npos};
      if (value.find("eot") != std::string::npos) settings_.end.eot = 0x04;
      if (value.find("quiet") != std::string::npos) settings_.end.quiet = std::chrono::seconds(2);
    } else if (key == "link") {
      settings_.blind = value == "blind";
    } else if (key == "watch") {
      settings_.watch_cts = value.find("cts") != std::string::npos;
      settings_.watch_dsr = value.find("dsr") != std::string::npos;
    } else {
      return "unknown setting " + key;
    }
  }
  return {};
}

std::string FeedPlayer::wire(const std::string& text) const {
  std::string out;
  for (const char c : text) {
    out += static_cast<char>(tape_code::with_parity(static_cast<std::uint8_t>(c), settings_.wire.eighth_bit));
  }
  return out;
}

std::size_t FeedPlayer::piece(std::size_t most) {
  switch (splits_) {
    case Splits::whole: return most;
    case Splits::single_bytes: return 1;
    case Splits::random: return 1 + random_() % most;
  }
  return most;
}

// Takes exactly these bytes, letting time run from deadline to deadline as far as the pacing needs.
std::string FeedPlayer::expect_out(const std::string& rest) {
  const std::string expected = wire(characters(rest));
  if (expected.empty()) {
    const auto bytes = feed().pending_out();
    return bytes.empty() ? "" : "there is output: " + std::to_string(bytes.size()) + " bytes";
  }
  std::string seen;
  while (seen.size() < expected.size()) {
    const auto bytes = feed().pending_out();
    if (bytes.empty()) {
      const auto next = feed().deadline();
      if (!next || *next <= now_ || *next > now_ + std::chrono::seconds(1)) return "output ends after: " + shown(seen);
      now_ = *next;
      feed().tick(now_);
      continue;
    }
    const std::size_t count = piece(std::min(bytes.size(), expected.size() - seen.size()));
    for (std::size_t i = 0; i < count; ++i) seen += static_cast<char>(bytes[i]);
    feed().mark_sent(count, now_);
    if (!expected.starts_with(seen)) return "went out: " + shown(seen) + "instead of " + shown(expected);
  }
  return {};
}

// A write that the driver had begun before the last input and reports now.
std::string FeedPlayer::late_write(const std::string& rest) {
  feed().mark_sent(number(rest), now_);
  return {};
}

std::string FeedPlayer::give_in(const std::string& rest) {
  const std::string bytes = characters(rest);
  for (std::size_t at = 0; at < bytes.size();) {
    const std::size_t count = piece(bytes.size() - at);
    feed().receive(std::as_bytes(std::span(bytes).subspan(at, count)), now_);
    at += count;
  }
  return {};
}

std::string FeedPlayer::pass_time(const std::string& rest) {
  const Time until = now_ + duration(rest);
  for (auto next = feed().deadline(); next && *next <= until; next = feed().deadline()) {
    if (*next <= now_) break;
    now_ = *next;
    feed().tick(now_);
  }
  now_ = until;
  feed().tick(now_);
  return {};
}

std::string FeedPlayer::expect_event(const std::string& rest) {
  if (events_.empty()) return "no event";
  const std::string event = events_.front();
  events_.pop_front();
  return event == rest ? "" : "the event is: " + event;
}

// "* stop", "* arm expires=10s", or several commands that are all refused: "* stop cancel refused".
std::string FeedPlayer::command(const std::string& rest) {
  std::vector<std::string> all = words(rest);
  if (all.empty()) return "no command";
  const bool refused = all.back() == "refused";
  if (!refused) return one_command(all[0], rest.size() > all[0].size() ? rest.substr(all[0].size() + 1) : "");
  all.pop_back();
  for (const std::string& one : all) {
    if (one_command(one, "").empty()) return "not refused: " + one;
    drain();
    if (events_.empty() || events_.front() != "command_refused " + one) return "no event of the refusal of " + one;
    events_.pop_front();
  }
  return {};
}

std::string FeedPlayer::one_command(const std::string& name, const std::string& argument) {
  for (const auto& [key, line] : kLines) {
    if (key == name + " " + argument) {
      feed().line(line, now_);
      return {};
    }
  }
  for (const auto& [key, one] : kCommands) {
    if (key != name) continue;
    const auto taken = feed().command(one, now_);
    return taken ? "" : std::string(message(taken.error()));
  }
  if (name == "taken") {
    feed().mark_sent(number(argument), now_);
  } else if (name == "reserve") {
    feed().extend_reserve(number(argument), now_);
  } else if (name == "queue") {
    feed().report_queue(number(argument), now_);
  } else if (name == "unconfirmed") {
    feed().report_unconfirmed(number(argument), now_);
  } else if (name == "ready") {
    ready_ = number(argument);
    if (source_) source_->ready = ready_;
  } else if (name == "broken") {
    source_->broken = true;
  } else if (name == "arm") {
    auto source = std::make_unique<StagedSource>(text_);
    source->ready = ready_;
    feed::Job job{.facts = facts_of(text_), .source = source.get(), .reserve = feed::kNoReserve};
    for (const std::string& word : words(argument)) {
      if (word.starts_with("expires=")) job.expires_after = duration(word.substr(8));
      if (word.starts_with("reserve=")) job.reserve = number(word.substr(8));
      if (word.starts_with("rounds=")) job.rounds = static_cast<std::uint32_t>(number(word.substr(7)));
    }
    source->rounds = job.rounds;
    const auto taken = feed().arm(job, now_);
    if (!taken) return std::string(message(taken.error()));
    source_ = std::move(source);
  } else {
    return "unknown command";
  }
  return {};
}

std::string FeedPlayer::check(const std::string& rest) {
  const std::vector<std::string> all = words(rest);
  const feed::Interval interval = feed().interval();
  const auto is = [&](std::string_view have) { return have == all.at(1) ? "" : "it is " + std::string(have); };
  if (all.at(0) == "state") return is(name(feed().state()));
  if (all[0] == "stall") return is(name(feed().stall()));
  if (all[0] == "end") return is(name(feed().end_cause()));
  if (all[0] == "handed") return is(std::to_string(feed().counters().handed));
  if (all[0] == "clocked") return is(std::to_string(feed().counters().clocked));
  if (all[0] == "round") return is(std::to_string(feed().round()));
  if (all[0] == "total") return is(std::to_string(feed().wire_bytes()));
  if (all[0] == "holds") return is(std::to_string(feed().counters().holds));
  if (all[0] == "from") return is(std::to_string(interval.from));
  if (all[0] == "to") return is(std::to_string(interval.to));
  if (all[0] == "from_line") return is(std::to_string(interval.from_position.value().line));
  if (all[0] == "to_line") return is(std::to_string(interval.to_position.value().line));
  return "unknown check";
}

}  // namespace dripfeed::wire
