// The bad line and what happens to a transfer from outside.
#include "tests/wire/packet_pair.h"

#include <algorithm>

#include <gtest/gtest.h>

namespace dripfeed::wire {

using namespace std::chrono_literals;
using packet::Time;

namespace {

constexpr Time kLongest = 3h;
constexpr Time kLatency = 5ms;

std::string random_program(std::mt19937& random, std::size_t size) {
  std::string text = "%\nO1\n";
  while (text.size() < size) {
    text += "G1X" + std::to_string(random() % 100'000) + "Y" + std::to_string(random() % 1000) + "\n";
  }
  return text + "M30\n%\n";
}

}  // namespace

PacketPair::PacketPair(const packet::Settings& settings, const LineFaults& faults, unsigned seed)
    : settings_(settings), faults_(faults), random_(seed), text_(random_program(random_, 100 + random_() % 1500)) {
  sender_ = std::move(packet::Sender::make(settings_).value());
  make_receiver();
}

void PacketPair::make_receiver() { receiver_ = std::move(packet::Receiver::make(settings_, sink_).value()); }

Time PacketPair::up_to(Time most) { return Time(static_cast<std::int64_t>(random_() % 1000) * (most.count() / 1000)); }

bool PacketPair::is_beginning() const { return (text_ + std::string(1024, '\x1A')).starts_with(sink_.text); }
// YMODEM states the length, so nothing is filled up.
bool PacketPair::same() const {
  if (settings_.protocol == packet::Protocol::ymodem) return sink_.text == text_;
  return sink_.text.size() >= text_.size() && is_beginning();
}

void PacketPair::put(Wire& wire, std::byte byte) {
  Time at = std::max({now_ + kLatency, line_free_, wire.empty() ? Time() : wire.back().at});
  const std::uint64_t before = faults_made_;
  const auto hit = [&](int parts) { return parts > 0 && chance(parts, 100'000) && ++faults_made_ != 0; };
  if (now_ < silent_until_) return static_cast<void>(++faults_made_);
  if (hit(faults_.silence)) silent_until_ = now_ + up_to(60s);
  if (hit(faults_.delay)) at = line_free_ = at + up_to(3s);
  if (hit(faults_.burst)) burst_left_ = static_cast<int>(1 + random_() % 9);
  if (hit(faults_.insert)) wire.push_back({at, static_cast<std::byte>(random_() % 256)});
  if (hit(faults_.lose)) return;
  if (hit(faults_.flip)) byte ^= static_cast<std::byte>(1U << random_() % 8);
  if (burst_left_ > 0 && burst_left_-- > 0) byte = static_cast<std::byte>(random_() % 256);
  wire.push_back({at, byte});
  if (hit(faults_.twice)) wire.push_back({at, byte});
  static_cast<void>(before);
}

void PacketPair::pump() {
  while (true) {
    const auto out = sender_->pending_out();
    if (out.empty()) break;
    const std::size_t count = 1 + random_() % out.size();
    for (const std::byte byte : out.first(count)) put(to_receiver_, byte);
    sender_->mark_sent(count, now_);
  }
  while (true) {
    const auto out = receiver_->pending_out();
    if (out.empty()) break;
    for (const std::byte byte : out) put(to_sender_, byte);
    receiver_->mark_sent(out.size(), now_);
  }
  while (const auto event = receiver_->next_event()) {
    if (event->kind == packet::ReceiveEventKind::frame) frame_passed();
  }
  while (sender_->next_event()) {
  }
}

// What happens to a transfer from outside, once a frame at most.
void PacketPair::frame_passed() {
  ++frames_;
  if (chance(faults_.full, 100)) {
    sink_.space = 0;
    room_at_ = now_ + up_to(30s);
  }
  if (chance(faults_.stop, 100) && sender_->command(feed::Command::stop, now_)) resume_at_ = now_ + up_to(60s);
  if (chance(faults_.cancel, 100)) static_cast<void>(sender_->command(feed::Command::cancel, now_));
  if (chance(faults_.link_down, 1000)) {
    sender_->link(false, now_);
    ++faults_made_;
  }
  if (chance(faults_.restart, 1000)) {
    make_receiver();
    restarted_ = true;
    sink_.text.clear();
    receiver_->link(true, now_);
    ASSERT_TRUE(receiver_->start(now_));
    ++faults_made_;
  }
}

void PacketPair::arrive(Wire& wire, bool at_receiver) {
  std::string bytes;
  while (!wire.empty() && wire.front().at <= now_) {
    bytes += static_cast<char>(wire.front().byte);
    wire.pop_front();
  }
  if (bytes.empty()) return;
  const auto span = std::as_bytes(std::span(bytes));
  at_receiver ? receiver_->receive(span, now_) : sender_->receive(span, now_);
}

Time PacketPair::next_time() const {
  Time next = now_ + 10s;
  const auto at = [&](std::optional<Time> instant) {
    if (instant && *instant > now_) next = std::min(next, *instant);
  };
  at(sender_->deadline());
  at(receiver_->deadline());
  if (!to_receiver_.empty()) at(to_receiver_.front().at);
  if (!to_sender_.empty()) at(to_sender_.front().at);
  if (sink_.space == 0) at(room_at_);
  if (sender_->stop_wanted()) at(resume_at_);
  return std::max(next, now_ + 1us);
}

// Nothing stands still for longer than a second without saying why.
void PacketPair::check_named() {
  const bool on = packet::is_on_the_line(sender_->state()) || sender_->state() == packet::State::armed;
  if (on && sender_->pending_out().empty() && next_time() > now_ + 1500ms) {
    ASSERT_NE(sender_->stall(), packet::Stall::none) << name(sender_->state());
  }
  const packet::Counters counters = sender_->counters();
  ASSERT_GE(counters.handed, counters.clocked);
  ASSERT_GE(counters.clocked, counters.confirmed);
}

bool PacketPair::over() const {
  switch (sender_->state()) {
    case packet::State::done:
    case packet::State::failed:
    case packet::State::torn:
    case packet::State::cancelled:
    case packet::State::disarmed: return to_receiver_.empty() && sender_->pending_out().empty();
    default: return false;
  }
}

void PacketPair::play() {
  sender_->link(true, now_);
  receiver_->link(true, now_);
  source_ = std::make_unique<tape_code::SpanSource>(text_);
  const feed::Job job{.facts = facts_of(text_), .source = source_.get(), .reserve = feed::kNoReserve};
  ASSERT_TRUE(sender_->arm(job, now_, "O1.nc"));
  ASSERT_TRUE(receiver_->start(now_));
  const Time until = now_ + kLongest;
  while (!over()) {
    ASSERT_LT(now_, until) << "no end: " << name(sender_->state()) << ", " << name(receiver_->state());
    pump();
    check_named();
    if (testing::Test::HasFatalFailure()) return;
    now_ = next_time();
    if (now_ >= room_at_) sink_.space = 1U << 20;
    if (sender_->stop_wanted() && now_ >= resume_at_) static_cast<void>(sender_->command(feed::Command::resume, now_));
    arrive(to_receiver_, true);
    arrive(to_sender_, false);
    sender_->tick(now_);
    receiver_->tick(now_);
  }
  pump();
}

}  // namespace dripfeed::wire
