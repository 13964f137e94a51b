// A control, a line with its delays and a driver around one feed, in virtual time. The line is a model of its own: it
// shares nothing with the feed's pacing but the instant at which a byte was handed over.
#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <functional>
#include <optional>
#include <queue>
#include <random>
#include <string>
#include <vector>

#include "protocol/feed/feed.h"

namespace dripfeed::wire {

using feed::Time;

struct LineModel {
  feed::Settings settings;
  double true_rate = 1.0;         // line speed in terms of the nominal one
  Time max_out_delay{};           // from the write to the first bit on the line
  Time max_in_delay{};            // from the last bit of a character to receive()
  Time max_wake_delay{};          // of the driver's timer
  bool reports_queue = false;     // the driver reads the unsent count at each wake
  bool short_writes = false;      // the driver takes fewer bytes than offered, or none for a while
  bool by_lines = false;          // the control holds by its RTS instead of DC3, and ends by being quiet
  std::uint64_t high_most = 420;  // the control holds at a random level from 20 to this
};

// The text sent for a test: `blocks` random blocks between '%' lines, ended by M30.
std::string random_program(std::mt19937& random, int blocks);

class VirtualLine {
 public:
  VirtualLine(const LineModel& model, const std::string& text, unsigned seed);

  // Plays until the feed's job is over or `limit` has passed. before_step is called at every step with the time.
  void run(Time limit);
  std::function<void(VirtualLine&)> at_step;

  feed::Feed& feed() { return feed_; }
  Time now() const { return now_; }
  std::mt19937& random() { return random_; }
  // Takes everything that pending_out() offers now; called by run() too.
  void drive();
  // Characters that have reached the control by now.
  std::string arrived() const;
  std::size_t arrived_count() const { return arrived_count(now_); }
  std::size_t arrived_count(Time by) const;
  std::size_t handed_count() const { return arrivals_.size(); }
  // Every wire byte ever handed, and the instant of the last one.
  const std::string& handed_bytes() const { return handed_; }
  Time last_handed_at() const { return last_handed_at_; }
  void control_sends(std::uint8_t byte);
  // The ledger's window, if one is kept: the reserve is raised to handed + window at every commit.
  std::uint64_t ledger_window = 0;

  // What the control saw.
  std::uint64_t holds = 0;
  std::uint64_t worst_after_dc3 = 0;
  std::array<std::uint64_t, 512> after_dc3{};  // holds by the characters that came after
  // Of the time at which the feed was free to send, the share at which the host's port was busy (the link's own delay
  // after it, which no pacing can help, is left out).
  double line_use() const;

 private:
  enum class Kind { arrival, host_receives, host_sees_cts, host_wakes, control_eats, ledger_commits };
  struct Happening {
    Time at;
    std::uint64_t order;
    Kind kind;
    std::uint8_t byte;
    bool operator>(const Happening& other) const { return at != other.at ? at > other.at : order > other.order; }
  };

  void add(Time at, Kind kind, std::uint8_t byte = 0);
  void happen(const Happening& happening);
  void control_takes(std::uint8_t byte);
  void control_eats();
  void control_holds(bool on);
  void wake_at_deadline();
  Time random_time(Time most);
  void note_free(bool free);

  LineModel model_;
  std::mt19937 random_;
  std::string text_;
  tape_code::SpanSource source_;
  feed::Feed feed_;
  Time now_{1'000'000};
  Time char_time_;
  std::priority_queue<Happening, std::vector<Happening>, std::greater<>> happenings_;
  std::uint64_t order_ = 0;
  std::vector<Time> arrivals_;
  std::string handed_;
  Time last_handed_at_{};
  Time line_free_at_{};
  Time port_free_at_{};
  Time reverse_free_at_{};
  std::optional<Time> wake_;
  Time blocked_until_{};

  std::uint64_t fill_ = 0;
  std::uint64_t high_ = 0;
  std::uint64_t low_ = 0;
  bool control_holds_ = false;
  std::uint64_t after_dc3_ = 0;
  int percents_ = 0;

  // When the feed was free to send, as the driver saw it.
  struct Span {
    Time from;
    Time to;
  };
  std::vector<Span> free_spans_;
  std::vector<Span> busy_spans_;
  bool free_ = false;
};

}  // namespace dripfeed::wire
