// Books a journal of this computer in the database: each entry and its serial in one transaction.
#pragma once

#include <memory>
#include <string>

#include "store/journal/ledger_journal.h"
#include "store/sql/database.h"

namespace dripfeed::postgresql {

struct BookedIn {
  store::Ledger& ledger;
  store::Answers& answers;
};

// What is in the file and not in the database is booked first. All that it names must outlive it. Errors: as
// JournalFile::open(), and what booking fails with.
store::Result<std::unique_ptr<journal::LedgerJournal>> open_journal(sql::Database& database, BookedIn tables,
                                                                    const std::string& path);

}  // namespace dripfeed::postgresql
