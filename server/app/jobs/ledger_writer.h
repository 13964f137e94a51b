// Writes the ledger of all lines: every 100 ms, or when a line changed, one group commit has the counters of all
// running jobs and reserves what may be handed next; then the lines get their windows. An answer to an operator is
// booked before it leaves, and each line's own record says that it is sending before its first byte may leave.
//
// Its thread waits for what must be on the disk before a byte may leave, and for nothing else: no job moves here,
// nothing is published, no text is read. Whoever does that gets what was booked.
#pragma once

#include <functional>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "server/app/base/disk_reserve.h"
#include "server/app/base/round_thread.h"
#include "server/app/lines/lines.h"
#include "server/app/ports/clock.h"
#include "server/app/ports/line_mutex.h"
#include "store/store.h"

namespace dripfeed::app {

// How far a feed may run ahead of the ledger: half a second of line time, in characters.
inline constexpr double kReserveAhead_s = 0.5;
inline constexpr std::uint64_t kReserveAtLeast = 64;
inline constexpr std::uint64_t kReserveOfBlocks = 65'536;  // block transfer has no line time

// Wire bytes that may be handed before the next commit.
std::uint64_t reserve_window(const LineReport& report);

// A line as the ledger has it now.
struct Booked {
  std::string machine;
  LineReport report;
  std::string refusal;    // why the line's record lets nothing leave, "" where it does
  std::string left_torn;  // why the line was made torn, "" where it was not
  bool is_booked = true;  // false: the ledger could not be written, so no job moves by this report
};

class LedgerWriter {
 public:
  // Gets every round's lines, and why the ledger cannot be written ("" where it can). On the writer's thread: it must
  // only keep them and wake a thread.
  using Take = std::function<void(std::vector<Booked> lines, const std::string& complaint)>;

  // Without a reserve a full disk stops the feeds at what is reserved for them.
  LedgerWriter(store::Store& store, Lines& lines, const Clock& clock, DiskReserve* disk_reserve, Take take);

  // A job that is about to be armed: what its line reports under this session is booked for it. From any thread.
  void expect(store::Id job, std::uint64_t session, std::string_view machine);
  // What a person did to the job stands in its next row, if there is one.
  void note(store::Id job, std::string_view text);
  // A person says that the control was reset: into the line's own record, by the next round.
  void reset_confirmed(const std::string& machine, std::string_view reason);
  // Why the line's record lets nothing leave before a person confirms, though the line was made whole: another device
  // is at its port now. "" where it lets.
  [[nodiscard]] std::string why_refused(const std::string& machine);
  void wake() { thread_.wake(); }
  bool wait_for_round(std::chrono::milliseconds patience) { return thread_.wait_for_round(patience); }
  // One last round.
  void stop() { thread_.stop(); }

 private:
  // What is known of one machine's line.
  struct Tracked {
    store::Id job = 0;          // that is booked now
    std::uint64_t session = 0;  // of its arming
    LineReport last;
    store::LedgerCounts committed;
    bool over = true;             // nothing is to be written for it any more
    bool is_begun = false;        // the line's record says that bytes may leave
    std::uint64_t answer = 0;     // serial of the answer that was looked at last
    store::Id answer_row = 0;     // of the one that may be leaving; 0: none
    std::string refused_because;  // why the record could not be written; empty: it was
  };
  struct Due {
    Seat seat;
    LineReport report;
    Tracked& tracked;
  };
  struct Expected {
    store::Id job = 0;
    std::string machine;
  };

  void round();
  std::vector<Booked> write_books();
  static void let_idle_go(std::vector<Due>& all);
  void begin(const Due& due);
  bool begin_record(const Due& due, std::string_view what);
  void end_record(const Due& due, bool torn, std::string_view reason);
  void book_answer(const Due& due);
  void end_answer(const Due& due);
  void write_confirmations(const std::vector<Due>& all);
  std::vector<store::NewLedgerRow> rows_of(const std::vector<Due>& all);
  std::optional<store::NewLedgerRow> row_of(const Due& due);
  bool commit_rows(const std::vector<Due>& all);
  void give_windows(std::span<const store::NewLedgerRow> rows, std::span<const store::LedgerFault> faults,
                    const std::vector<Due>& all);
  store::Result<std::vector<store::LedgerFault>> append(std::span<const store::NewLedgerRow> rows);
  void after_commit(const Due& due);
  void report_slow_commit(std::chrono::nanoseconds took);
  void report_late();

  store::Store& store_;
  Lines& lines_;
  const Clock& clock_;
  DiskReserve* disk_reserve_;
  Take take_;
  feed::Time restore_at_{};
  feed::Time slow_again_at_{};
  std::map<std::string, Tracked> tracked_;
  std::string complaint_;  // why the last commit failed; empty: it did not
  store::LateRows late_;   // as it was reported last

  LineMutex mutex_{"what is left for the ledger"};  // of what others leave for the next round
  std::map<std::uint64_t, Expected> expected_;      // by session
  std::map<store::Id, std::string> notes_;          // for the jobs' next rows
  std::map<std::string, std::string> confirmations_;
  std::map<std::string, std::string> refusals_;  // see why_refused()
  RoundThread thread_;                           // last: it uses all of the above
};

}  // namespace dripfeed::app
