// Looks at a whole store and changes nothing: whether the audit's chain is unbroken, each job's ledger complete and in
// order, each content the one of its hash, and the torn marks possible. Others may change the store meanwhile.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "store/sql/database.h"

namespace dripfeed::sql {

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

// A look at what the engine keeps the tables in. `fault` says in a sentence what is wrong by a row; "" where nothing
// is.
struct FileLook {
  std::string_view sql;
  std::string (*fault)(Query& row);
};

// `files` is looked at first. Errors: busy, io_failed; and corrupt where so much is broken that nothing can be read.
store::Result<Verification> verify(Database& database, std::span<const FileLook> files = {});

}  // namespace dripfeed::sql
