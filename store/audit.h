// The audit: who did what to what, and when. Rows never change, and each holds the hash of the one before, so that a
// row that was altered or taken out is found. Every change made through the other repositories leaves its row by
// itself, in the same transaction, but for contents, ledger rows, replies and the holds of a line; append() is for what
// is no change of the store (a login, a refused right).
#pragma once

#include <optional>

#include "store/basics.h"
#include "store/error.h"
#include "store/event_log.h"

namespace dripfeed::store {

struct AuditEntry {
  std::string action{};   // "machine.change"
  std::string subject{};  // "machine/mill-3"
  std::string detail{};   // document or words, not read here
};

struct AuditRow {
  std::uint64_t seq = 0;
  Stamp by;
  AuditEntry entry;
  std::string previous_hash;  // empty in the first row
  std::string hash;
};

// Empty and 0: all.
struct AuditFilter {
  std::string subject{};
  std::string actor{};
  std::string action{};
  std::int64_t from_ms = 0;
  std::int64_t to_ms = 0;  // before it
};

struct AuditCheck {
  std::uint64_t rows = 0;
  std::string head;                           // hash of the last row: note it elsewhere to notice a cut tail
  std::optional<std::uint64_t> first_broken;  // seq
};

class Audit : public Repository {
 public:
  virtual Result<AuditRow> append(const AuditEntry& entry, const Stamp& by) = 0;
  // With what other systems hear of it, in one transaction.
  virtual Result<AuditRow> append(const AuditEntry& entry, const NewEvent& event, const Stamp& by) = 0;
  // Newest first.
  virtual Result<Page<AuditRow>> list(const PageRequest& page, const AuditFilter& filter = {}) = 0;
  // Walks the whole chain.
  virtual Result<AuditCheck> verify() = 0;
};

}  // namespace dripfeed::store
