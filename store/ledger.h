// The ledger: for every job, rows that say how many wire bytes were handed to the driver, passed on the line, were
// confirmed by the protocol, and up to where the feed may go before the next row. Rows never change. After a crash the
// true count lies between `clocked` and `reserve` of the last row.
#pragma once

#include <optional>
#include <span>

#include "store/basics.h"
#include "store/error.h"

namespace dripfeed::store {

// Counts are wire offsets: reserve >= handed >= clocked >= confirmed, and none but `reserve` ever falls.
struct LedgerCounts {
  std::uint64_t handed = 0;
  std::uint64_t clocked = 0;
  std::uint64_t confirmed = 0;
  std::uint64_t reserve = 0;

  friend bool operator==(const LedgerCounts&, const LedgerCounts&) = default;
};

struct NewLedgerRow {
  Id job = 0;
  LedgerCounts counts{};
  std::string note{};  // what happened to the line since the row before; mostly empty
};

struct LedgerRow {
  std::uint64_t seq = 0;  // 1, 2, 3, … within the job
  std::int64_t at_ms = 0;
  LedgerCounts counts;
  std::string note;
};

// A row that is wrong. One that breaks the rule of LedgerCounts or names no job is not written. One that handed more
// than was reserved is written all the same: the ledger says what happened.
struct LedgerFault {
  Id job = 0;
  std::string why;
  bool written = false;
};

// What is wrong with a job's row after the one before it; nothing where it keeps the rule.
std::optional<LedgerFault> fault_of(Id job, const LedgerCounts& before, const LedgerCounts& counts);

// Rows that are durable on this computer and not in the store yet, because its database does not answer.
struct LateRows {
  std::uint64_t commits = 0;  // that wait
  std::string why;            // the last attempt failed; "" where it did not
  std::uint64_t faults = 0;   // rows that the store refused when they came, since the start
  std::string last_fault;     // the newest of them
};

// What is known of a job: `low` bytes passed the line for certain, more than `high` never left.
struct LedgerInterval {
  std::uint64_t low = 0;
  std::uint64_t high = 0;
  std::uint64_t seq = 0;   // of the last row; 0: there is none
  std::int64_t at_ms = 0;  // of the last row
  LedgerCounts last;
};

class Ledger : public Repository {
 public:
  // One transaction for all rows, durable when it returns. A wrong row is reported alone, so that one line's fault does
  // not stop the others; an error means that no row was written.
  virtual Result<std::vector<LedgerFault>> append(std::span<const NewLedgerRow> rows, std::int64_t at_ms) = 0;
  // Oldest first. Errors: not_found.
  virtual Result<Page<LedgerRow>> rows(Id job, const PageRequest& page) = 0;
  // Errors: not_found.
  virtual Result<LedgerInterval> interval(Id job) = 0;
  // See LateRows. It waits for nothing.
  [[nodiscard]] virtual LateRows late() const { return {}; }
  // Checks of one job that its rows are complete, in order and keep the rule. Errors: not_found, corrupt.
  virtual Result<std::uint64_t> verify(Id job) = 0;
};

}  // namespace dripfeed::store
