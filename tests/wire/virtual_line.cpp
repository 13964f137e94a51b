// The modelled control, line and driver, event by event.
#include "tests/wire/virtual_line.h"

#include <algorithm>

#include "protocol/tape_code/parity.h"
#include "tests/wire/feed_player.h"

namespace dripfeed::wire {
namespace {

constexpr std::uint8_t kDc1 = 0x11;
constexpr std::uint8_t kDc3 = 0x93;
constexpr Time kCommitEvery = std::chrono::milliseconds(100);

feed::Feed made(const feed::Settings& settings) { return feed::Feed::make(settings).value(); }

Time true_char_time(const LineModel& model) {
  const double bits = model.settings.framing.bits_per_char();
  return Time(static_cast<std::int64_t>(bits * 1e9 / (model.settings.baud * model.true_rate)));
}

}  // namespace

std::string random_program(std::mt19937& random, int blocks) {
  constexpr std::string_view kCharacters = "GXYZFIJ0123456789.-";
  std::string text = "%\nO1\n";
  for (int i = 0; i < blocks; ++i) {
    const std::size_t length = random() % 5 == 0 ? 0 : random() % 40;
    for (std::size_t k = 0; k < length; ++k) text += kCharacters[random() % kCharacters.size()];
    text += '\n';
  }
  return text + "M30\n%\n";
}

VirtualLine::VirtualLine(const LineModel& model, const std::string& text, unsigned seed)
    : model_(model),
      random_(seed),
      text_(text),
      source_(text_),
      feed_(made(model.settings)),
      char_time_(true_char_time(model)) {
  high_ = 20 + random_() % (model.high_most - 20);
  low_ = high_ / (2 + random_() % 8);
}

void VirtualLine::add(Time at, Kind kind, std::uint8_t byte) {
  happenings_.push({.at = std::max(at, now_), .order = order_++, .kind = kind, .byte = byte});
}

Time VirtualLine::random_time(Time most) {
  if (most <= Time::zero()) return Time::zero();
  return Time(static_cast<std::int64_t>(random_() % static_cast<std::uint64_t>(most.count() + 1)));
}

void VirtualLine::run(Time limit) {
  const Time until = now_ + limit;
  feed_.line(feed::LineChange::link_up, now_);
  const std::uint64_t reserve = ledger_window > 0 ? ledger_window : feed::kNoReserve;
  static_cast<void>(feed_.arm({.facts = facts_of(text_), .source = &source_, .reserve = reserve}, now_));
  if (ledger_window > 0) add(now_ + kCommitEvery, Kind::ledger_commits);
  if (!model_.by_lines) control_sends(kDc1);
  add(now_ + char_time_, Kind::control_eats);
  drive();
  while (!happenings_.empty() && happenings_.top().at <= until && feed_.counters().ended_at == Time::zero()) {
    const Happening next = happenings_.top();
    happenings_.pop();
    now_ = next.at;
    happen(next);
    if (at_step) at_step(*this);
    drive();
  }
}

void VirtualLine::happen(const Happening& happening) {
  switch (happening.kind) {
    case Kind::arrival: control_takes(happening.byte); break;
    case Kind::host_receives: {
      const std::byte byte{happening.byte};
      feed_.receive({&byte, 1}, now_);
      break;
    }
    case Kind::host_sees_cts:
      feed_.line(happening.byte != 0 ? feed::LineChange::cts_on : feed::LineChange::cts_off, now_);
      break;
    case Kind::host_wakes:
      wake_.reset();
      if (model_.reports_queue) feed_.report_queue(arrivals_.size() - arrived_count(), now_);
      feed_.tick(now_);
      break;
    case Kind::control_eats: control_eats(); break;
    case Kind::ledger_commits:
      feed_.extend_reserve(feed_.counters().handed + ledger_window, now_);
      add(now_ + kCommitEvery, Kind::ledger_commits);
      break;
  }
}

void VirtualLine::drive() {
  while (now_ >= blocked_until_) {
    const auto bytes = feed_.pending_out();
    if (bytes.empty()) break;
    std::size_t count = bytes.size();
    if (model_.short_writes) {
      count = random_() % (count + 1);
      if (count == 0) {
        blocked_until_ = now_ + random_time(4 * char_time_);
        add(blocked_until_, Kind::host_wakes);
        break;
      }
    }
    Time starts = now_ + random_time(model_.max_out_delay);
    for (std::size_t i = 0; i < count; ++i) {
      const Time begins = std::max(starts, line_free_at_);
      line_free_at_ = begins + char_time_;
      arrivals_.push_back(line_free_at_);
      const Time leaves = std::max(now_, port_free_at_);
      port_free_at_ = leaves + char_time_;
      busy_spans_.push_back({leaves, port_free_at_});
      handed_ += static_cast<char>(bytes[i]);
      add(line_free_at_, Kind::arrival, std::to_integer<std::uint8_t>(bytes[i]));
    }
    last_handed_at_ = now_;
    feed_.mark_sent(count, now_);
  }
  note_free(feed_.state() == feed::State::sending && feed_.stall() == feed::Stall::none && now_ >= blocked_until_);
  wake_at_deadline();
}

void VirtualLine::note_free(bool free) {
  if (free == free_) return;
  free_ = free;
  if (free) {
    free_spans_.push_back({now_, Time::max()});
  } else {
    free_spans_.back().to = now_;
  }
}

void VirtualLine::wake_at_deadline() {
  const auto deadline = feed_.deadline();
  if (!deadline || (wake_ && *wake_ <= *deadline + model_.max_wake_delay && *wake_ >= *deadline)) return;
  wake_ = std::max(*deadline, now_) + random_time(model_.max_wake_delay);
  add(*wake_, Kind::host_wakes);
}

std::size_t VirtualLine::arrived_count(Time by) const {
  return static_cast<std::size_t>(std::ranges::upper_bound(arrivals_, by) - arrivals_.begin());
}

std::string VirtualLine::arrived() const { return handed_.substr(0, arrived_count()); }

void VirtualLine::control_sends(std::uint8_t byte) {
  reverse_free_at_ = std::max(now_ + char_time_ + random_time(model_.max_in_delay), reverse_free_at_);
  add(reverse_free_at_, Kind::host_receives, byte);
}

// Counts what still comes in after a DC3; sends DC3 above the high mark and after the final '%'.
void VirtualLine::control_takes(std::uint8_t byte) {
  if (control_holds_) worst_after_dc3 = std::max(worst_after_dc3, ++after_dc3_);
  const bool eia = model_.settings.wire.eia.has_value();
  const bool percent = eia ? byte == tape_code::kEiaEor : (byte & tape_code::kLowSevenBits) == '%';
  percents_ += percent ? 1 : 0;
  ++fill_;
  const bool ended = percent && percents_ == 2;
  const bool whim = percents_ < 2 && random_() % 300 == 0;
  if (ended || (!control_holds_ && (fill_ >= high_ || whim))) {
    if (!model_.by_lines) control_sends(kDc3);
    // Some keep their RTS on after the end, some drop it. (One that ends inside a hold and stays off cannot be
    // distinguished from one that holds on.)
    if (ended && model_.by_lines) return control_holds(!control_holds_ && random_() % 2 == 0);
    if (control_holds_) return;
    if (model_.by_lines) control_holds(true);
    control_holds_ = true;
    after_dc3_ = 0;
    ++holds;
  }
}

// By its RTS: seen by the host when its driver looks.
void VirtualLine::control_holds(bool on) {
  reverse_free_at_ = std::max(now_ + random_time(model_.max_in_delay), reverse_free_at_);
  add(reverse_free_at_, Kind::host_sees_cts, on ? 0 : 1);
}

void VirtualLine::control_eats() {
  const std::uint64_t bite = 1 + random_() % 60;
  fill_ -= std::min(fill_, bite);
  const bool starved = percents_ < 2 && !control_holds_ && fill_ == 0 && random_() % 20 == 0;
  if (control_holds_ && fill_ <= low_ && percents_ < 2) {
    control_holds_ = false;
    ++after_dc3[std::min<std::size_t>(after_dc3_, after_dc3.size() - 1)];
    if (model_.by_lines) {
      control_holds(false);
    } else {
      control_sends(kDc1);
    }
  } else if (starved && !model_.by_lines) {
    control_sends(kDc1);  // some controls ask again
  }
  add(now_ + random_time(static_cast<std::int64_t>(2 * bite) * char_time_), Kind::control_eats);
}

double VirtualLine::line_use() const {
  Time free{};
  Time busy{};
  std::size_t at = 0;
  for (Span span : free_spans_) {
    span.to = std::min(span.to, now_);
    free += span.to - span.from;
    while (at < busy_spans_.size() && busy_spans_[at].to <= span.from) ++at;
    for (std::size_t i = at; i < busy_spans_.size() && busy_spans_[i].from < span.to; ++i) {
      busy += std::min(busy_spans_[i].to, span.to) - std::max(busy_spans_[i].from, span.from);
    }
  }
  return free == Time::zero() ? 1.0 : static_cast<double>(busy.count()) / static_cast<double>(free.count());
}

}  // namespace dripfeed::wire
