// Looks at a whole store and changes nothing: whether the file is sound, the audit's chain unbroken, each job's ledger
// complete and in order, each content the one of its hash, and the torn marks possible. A server may run meanwhile.
#pragma once

#include <string>
#include <vector>

#include "store/sqlite/open.h"

namespace dripfeed::sqlite {

struct VerifyFault {
  std::string subject;  // "audit/17", "job/12", "content/ab12…", "machine/mill-3", "file"
  std::string what;     // one sentence
};

struct Verification {
  std::uint64_t audit_rows = 0;
  std::string audit_head;  // hash of the last row: note it elsewhere to notice a cut tail
  std::uint64_t jobs = 0;
  std::uint64_t ledger_rows = 0;
  std::uint64_t contents = 0;
  std::uint64_t content_bytes = 0;
  std::uint64_t torn_machines = 0;  // that wait for a person's confirmation; no fault
  std::vector<VerifyFault> faults;
};

// Errors: cannot_open, not_a_store, newer_schema, migration_failed (an older schema: a server brings it up to date),
// busy, io_failed; and corrupt where the file is so broken that nothing can be read.
store::Result<Verification> verify(const std::string& path);

}  // namespace dripfeed::sqlite
