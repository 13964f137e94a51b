// Keeps the books of all lines: every 100 ms, or when a line changed, one group commit writes the counters of all
// running jobs and reserves what may be handed next; then the lines are told. It also moves the jobs' states after the
// lines', and publishes both.
#pragma once

#include <condition_variable>
#include <map>
#include <memory>
#include <mutex>
#include <span>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include "server/app/ballast.h"
#include "server/app/content_source.h"
#include "server/app/events.h"
#include "server/app/lines.h"
#include "server/app/ports/clock.h"
#include "store/store.h"

namespace dripfeed::app {

// How far a feed may run ahead of the ledger: half a second of line time, in characters.
inline constexpr double kReserveAhead_s = 0.5;
inline constexpr std::uint64_t kReserveAtLeast = 64;
inline constexpr std::uint64_t kReserveOfBlocks = 65'536;  // block transfer has no line time

// Wire bytes that may be handed before the next commit.
std::uint64_t reserve_window(const LineReport& report);

class Keeper {
 public:
  // Without a ballast a full disk stops the feeds at what is reserved for them.
  Keeper(store::Store& store, Lines& lines, Events& events, const Clock& clock, Ballast* ballast = nullptr);
  ~Keeper();
  Keeper(const Keeper&) = delete;
  Keeper& operator=(const Keeper&) = delete;

  // Some line changed. From any thread, cheap.
  void wake();
  // The text of the machine's job, to be read ahead of the feed.
  void set_source(const std::string& machine, std::shared_ptr<ContentSource> source);
  // What a person did to the job stands in its next ledger row, if there is one.
  void note(store::Id job, std::string_view text);
  [[nodiscard]] const Ballast* ballast() const { return ballast_; }
  // One round now, on the caller's thread. For the start, the end and tests.
  void round();

 private:
  struct Tracked {
    store::Job job;
    std::uint64_t session = 0;  // of the arming that is followed
    LineReport last;
    store::LedgerCounts committed;
    bool over = true;  // nothing is to be written for it any more
    std::uint64_t unarmed_starts = 0;
  };
  struct Due {
    std::string machine;
    std::shared_ptr<Line> line;
    LineReport report;
    Tracked& tracked;
  };

  void loop(const std::stop_token& stop);
  void begin(const Due& due);
  std::vector<store::NewLedgerRow> rows_of(const std::vector<Due>& all);
  void commit(std::span<const store::NewLedgerRow> rows, std::span<const store::LedgerFault> faults,
              const std::vector<Due>& all);
  store::Result<std::vector<store::LedgerFault>> append(std::span<const store::NewLedgerRow> rows);
  void complain(const std::string& error, const std::vector<Due>& all);
  void follow(const Due& due);
  void tell_alarm(const std::string& machine, std::string text);
  void move(Tracked& tracked, store::JobState to, const LineReport& report);

  store::Store& store_;
  Lines& lines_;
  Events& events_;
  const Clock& clock_;
  Ballast* ballast_;
  feed::Time restore_at_{};
  std::mutex round_mutex_;
  std::map<std::string, Tracked> tracked_;
  std::map<store::Id, std::string> notes_;  // for the jobs' next rows
  std::string complaint_;                   // why the last commit failed; empty: it did not
  std::map<std::string, std::shared_ptr<ContentSource>> sources_;
  std::mutex sources_mutex_;
  std::mutex wake_mutex_;
  std::condition_variable_any woken_;
  bool due_ = false;
  std::jthread thread_;  // last: it uses all of the above
};

}  // namespace dripfeed::app
