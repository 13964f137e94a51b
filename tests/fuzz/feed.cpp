// One feed under any inputs in any order. An input is a row of decisions: the line, then what happens on it. The line
// has an account of its own of what is unsent and of where blocks end, and shares nothing with the feed's but the time
// that one character takes.
#include "protocol/feed/feed.h"

#include <algorithm>
#include <array>
#include <expected>
#include <string>
#include <vector>

#include "protocol/tape_code/parity.h"
#include "tests/fuzz/target.h"

using namespace dripfeed;
using feed::State;
using feed::Time;

namespace {

constexpr std::string_view kText = "%\nO1\nG0X1.\nG1Z-2.5F80\n(A)\nM30\n%\n";

feed::ProgramFacts facts() {
  feed::ProgramCheck check(feed::kParenthesesSyntax);
  check.append(kText);
  const auto facts = check.finish();
  fuzz::require(facts.has_value(), "the text may be fed");
  return *facts;
}

// The text in pieces, at times not ready, at times broken off.
class Pieces final : public tape_code::TextSource {
 public:
  tape_code::TextPiece next() noexcept override {
    if (broken) return {.status = tape_code::SourceStatus::failed, .text = {}};
    if (given_ == kText.size()) return {.status = tape_code::SourceStatus::end, .text = {}};
    if (ready == 0) return {.status = tape_code::SourceStatus::not_ready, .text = {}};
    const std::size_t count = std::min(ready, kText.size() - given_);
    given_ += count;
    ready -= count;
    return {.status = tape_code::SourceStatus::text, .text = std::span(kText).subspan(given_ - count, count)};
  }
  std::size_t ready = kText.size();
  bool broken = false;

 private:
  std::size_t given_ = 0;
};

feed::Settings settings_of(fuzz::Choices& choices) {
  constexpr std::array kEobs = {tape_code::Eob::lf, tape_code::Eob::cr_lf, tape_code::Eob::lf_cr_cr,
                                tape_code::Eob::cr};
  constexpr std::array kBauds = {4800U, 9600U, 19200U, 115200U};
  feed::Settings settings;
  settings.baud = kBauds[choices.below(4)];
  settings.wire.eob = kEobs[choices.below(4)];
  settings.wire.leader_chars = choices.below(4);
  settings.wire.trailer_chars = choices.below(4);
  settings.unsent = 1 + choices.below(6);
  settings.latency_chars = choices.below(5);
  settings.start = choices.flag() ? feed::Start::at_once : feed::Start::on_dc1;
  const std::uint32_t signs = choices.below(4);
  settings.end = {.dc3 = signs != 1, .eot = {}, .quiet = {}};
  if (signs == 1 || signs == 2) settings.end.quiet = std::chrono::milliseconds(50);
  if (signs == 3) settings.end.eot = std::uint8_t{0x04};
  settings.blind = choices.flag();
  settings.watch_cts = choices.flag();
  settings.watch_dsr = choices.flag();
  return settings;
}

// The wire as it should be, and after how many of its bytes a block is whole.
struct Wire {
  std::string bytes;
  std::vector<bool> whole_after;  // [n]: n bytes leave no block unfinished
  std::size_t text_end = 0;       // bytes up to the final '%'

  explicit Wire(const tape_code::WireFormat& format) {
    add_fillers(format.leader_chars);
    whole_after.push_back(true);
    for (const char c : kText) {
      if (c != '\n') {
        add(c, false, format);
        if (c == '%') text_end = bytes.size();
        continue;
      }
      const std::string_view eob = characters(format.eob);
      for (std::size_t i = 0; i < eob.size(); ++i) add(eob[i], i + 1 == eob.size(), format);
    }
    for (std::uint32_t i = 0; i < format.trailer_chars; ++i) add('\0', true, format);
  }

 private:
  void add_fillers(std::uint32_t count) {
    bytes.assign(count, '\0');
    whole_after.assign(count, true);
  }
  void add(char c, bool whole, const tape_code::WireFormat& format) {
    bytes.push_back(static_cast<char>(tape_code::with_parity(static_cast<std::uint8_t>(c), format.eighth_bit)));
    whole_after.push_back(whole);
  }
};

bool may_send(State state) {
  return state == State::sending || state == State::stopping || state == State::cancelling || state == State::trailer;
}

class Line {
 public:
  explicit Line(fuzz::Choices& choices)
      : choices_(choices), settings_(settings_of(choices)), wire_(settings_.wire), feed_(feed::Feed::make(settings_)) {}

  void run() {
    if (!feed_) return;
    for (int steps = 0; !choices_.done() && steps < 2000; ++steps) {
      const State before = feed_->state();
      const bool reset = step();
      require_state(before, reset);
    }
  }

 private:
  // Returns whether a person confirmed a reset.
  bool step() {
    switch (choices_.below(10)) {
      case 0: arm(); break;
      case 1: return command();
      case 2: feed_->line(static_cast<feed::LineChange>(choices_.below(6)), now_); break;
      case 3: receive(); break;
      case 4: now_ += Time(static_cast<std::int64_t>(choices_.word()) * 2000); break;
      case 5: raise_reserve(); break;
      case 6: feed_->report_queue(choices_.below(8), now_); break;
      case 7: sources_[present_].ready = choices_.below(6); break;
      case 8: sources_[present_].broken = choices_.below(16) == 15; break;
      default: wake(); break;
    }
    return false;
  }

  // The job that is on keeps its source, so a new one waits in the other place.
  void arm() {
    const std::size_t other = 1 - present_;
    sources_[other] = Pieces();
    const std::uint64_t reserve = choices_.below(60);
    if (!feed_->arm({.facts = facts(), .source = &sources_[other], .reserve = reserve}, now_)) return;
    present_ = other;
    sent_.clear();
    reserve_ = reserve;
  }

  bool command() {
    const auto command = static_cast<feed::Command>(choices_.below(7));
    const bool taken = feed_->command(command, now_).has_value();
    return taken && command == feed::Command::confirm_reset;
  }

  void receive() {
    constexpr std::array<std::uint8_t, 8> kBytes = {0x11, 0x93, 0x11, 0x13, 0x12, 0x84, 0x96, 0x41};
    const std::uint32_t chosen = choices_.below(16);
    const std::byte byte{chosen < kBytes.size() ? kBytes[chosen] : choices_.byte()};
    feed_->receive({&byte, 1}, now_);
    const bool dc3 = byte == std::byte{0x13} || byte == std::byte{0x93};
    fuzz::require(!dc3 || feed_->pending_out().empty(), "nothing goes out after DC3");
  }

  void raise_reserve() {
    const std::uint64_t offset = sent_.size() + choices_.below(32);
    reserve_ = std::max(reserve_, offset);
    feed_->extend_reserve(offset, now_);
  }

  // The driver wakes, and takes some or all of what it may.
  void wake() {
    feed_->tick(now_);
    const auto deadline = feed_->deadline();
    const auto out = feed_->pending_out();
    fuzz::require(!out.empty() || !deadline || *deadline > now_, "a timer that went off is not set again for the past");
    const std::size_t count = out.empty() ? 0 : out.size() - choices_.below(static_cast<std::uint32_t>(out.size()) + 1);
    for (std::size_t i = 0; i < count; ++i) {
      sent_.push_back(static_cast<char>(out[i]));
      free_at_ = std::max(now_, free_at_) + feed_->paced_char_time();
    }
    feed_->mark_sent(count, now_);
    if (count > 0 && !settings_.watch_cts) {
      const std::int64_t unsent = (free_at_ - now_ + feed_->paced_char_time() - Time(1)) / feed_->paced_char_time();
      fuzz::require(unsent <= settings_.unsent, "what is unsent keeps its part of the budget");
    }
    if (choices_.flag()) now_ = std::max(now_, feed_->deadline().value_or(now_));
  }

  void require_state(State before, bool reset) {
    const State state = feed_->state();
    fuzz::require(wire_.bytes.starts_with(sent_), "what was sent is the beginning of the program");
    fuzz::require(sent_.size() <= reserve_, "the ledger knew of all that was sent");
    fuzz::require(may_send(state) || feed_->pending_out().empty(), "only a state that sends shows bytes");
    fuzz::require(before != State::torn || state == State::torn || reset, "a torn block waits for a person");
    const feed::Counters counters = feed_->counters();
    fuzz::require(counters.confirmed <= counters.clocked && counters.clocked <= counters.handed,
                  "counters are in order");
    const feed::Interval interval = feed_->interval();
    fuzz::require(interval.from <= interval.to, "an interval is no less than empty");
    const bool whole = sent_.empty() || wire_.whole_after[sent_.size()] || sent_.size() >= wire_.text_end;
    const bool ended_clean = state == State::failed || state == State::cancelled || state == State::stopped;
    fuzz::require(!ended_clean || whole, "a feed that ends inside a block is torn");
    fuzz::require(state != State::done || sent_.size() >= wire_.text_end, "a feed that is done sent its program");
    while (feed_->next_event()) {
    }
  }

  fuzz::Choices& choices_;
  feed::Settings settings_;
  Wire wire_;
  std::expected<feed::Feed, feed::SettingsRefusal> feed_;
  std::array<Pieces, 2> sources_;
  std::size_t present_ = 0;
  std::string sent_;
  std::uint64_t reserve_ = 0;
  Time now_ = std::chrono::seconds(1);
  Time free_at_{};
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::Choices choices(data, size);
  Line(choices).run();
  return 0;
}
