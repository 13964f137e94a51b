// store/journal: what a line's feed needs while the database of the store does not answer. What the ledger and the
// answers to operators write goes to a file on this computer's disk first; a thread books it in the database. A text
// that is fed is read from a copy on this disk. Nothing here names an engine, and nothing else of the store is kept
// here: whoever wants to queue or arm needs the database.
//
//   ledger, answers ──► journal file ──► the caller goes on            (LedgerJournal::keep)
//                            └──► booked in the database, by serial     (its thread)
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "store/answers.h"
#include "store/ledger.h"

namespace dripfeed::journal {

// An answer to an operator that begins (`sending`) or ended. A machine has one at a time.
struct AnswerStep {
  std::string machine;
  store::AnswerState to = store::AnswerState::sending;
  std::uint64_t bytes_total = 0;  // of one that begins
  std::string reason;             // of one that ended
  std::string actor;

  friend bool operator==(const AnswerStep&, const AnswerStep&) = default;
};

// What one commit has.
struct Entry {
  std::uint64_t serial = 0;  // 1, 2, 3, … of this journal, given by it
  std::int64_t at_ms = 0;
  std::vector<store::NewLedgerRow> rows;
  std::optional<AnswerStep> answer;
};

}  // namespace dripfeed::journal
