// Keeps entries on this disk and books them in the database, in their order, on a thread of its own. While the database
// does not answer they wait, in the file and in memory; the thread tries again every second. An entry that the database
// refuses for good (a row that names no job) is counted and left out: it must not hold up those after it.
#pragma once

#include <chrono>
#include <condition_variable>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <thread>

#include "store/journal/journal_file.h"

namespace dripfeed::journal {

// Books one entry in one transaction, with its serial: one whose serial is booked changes nothing. Returns its faults.
using BookEntry = std::function<store::Result<std::vector<store::LedgerFault>>(const Entry&)>;

class LedgerJournal {
 public:
  // Books what the file has after `last_booked` first, and fails where that fails.
  static store::Result<std::unique_ptr<LedgerJournal>> open(JournalFile file, std::uint64_t last_booked,
                                                            BookEntry book);
  // Gives what waits two seconds; what is not booked then is booked by the next start.
  ~LedgerJournal();
  LedgerJournal(const LedgerJournal&) = delete;
  LedgerJournal& operator=(const LedgerJournal&) = delete;

  // Durable on this disk when it returns; the entry's serial. From any thread. Errors: disk_full, io_failed.
  store::Result<std::uint64_t> keep(Entry entry);
  // Until all that was kept is booked. False where that takes longer.
  bool wait_until_booked(std::chrono::milliseconds patience);
  [[nodiscard]] store::LateRows late() const;
  // Each entry that is not booked yet, oldest first.
  void each_waiting(const std::function<void(const Entry&)>& visit) const;

 private:
  LedgerJournal(JournalFile file, std::uint64_t last, BookEntry book);
  void start();
  void loop(const std::stop_token& stop);
  bool book_next();
  void leave_out(const std::vector<store::LedgerFault>& faults);

  BookEntry book_;
  mutable std::mutex mutex_;
  std::condition_variable_any changed_;
  JournalFile file_;
  std::uint64_t last_serial_;
  std::deque<Entry> waiting_;  // only the thread takes from it, so its front stays while it is booked
  std::string why_;            // the last attempt failed; "" where it did not
  std::uint64_t faults_ = 0;
  std::string last_fault_;
  std::jthread thread_;  // last: it uses all of the above
};

}  // namespace dripfeed::journal
