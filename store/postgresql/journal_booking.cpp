// The table `journal` has a row for each journal that ever booked here.
#include "store/postgresql/journal_booking.h"

#include <utility>

namespace dripfeed::postgresql {
namespace {

using journal::AnswerStep;
using journal::Entry;
using sql::Query;
using sql::Session;
using store::LedgerFault;
using store::Result;

constexpr std::string_view kSent =
    "SELECT id FROM answer WHERE machine = ? AND state = 'sending' ORDER BY id DESC LIMIT 1";

std::uint64_t booked_of(Session& session, const std::string& name) {
  Query query(session, "SELECT booked FROM journal WHERE name = ?", name);
  return query.next() ? query.number() : 0;
}

Result<void> book_answer(Session& session, store::Answers& answers, const AnswerStep& step, std::int64_t at_ms) {
  const store::Stamp by{step.actor, at_ms};
  if (step.to == store::AnswerState::sending) {
    const auto begun = answers.begin(step.machine, step.bytes_total, by);
    return begun ? Result<void>() : std::unexpected(begun.error());
  }
  store::Id sent = 0;
  {
    Query query(session, kSent, step.machine);
    if (query.next()) sent = query.number();
  }
  const auto ended = answers.end(sent, step.to, step.reason, by);
  return ended ? Result<void>() : std::unexpected(ended.error());
}

class Booking {
 public:
  Booking(sql::Database& database, BookedIn tables, std::string name)
      : database_(database), tables_(tables), name_(std::move(name)) {}

  Result<std::uint64_t> begin() const {
    return database_.write("journal", [&](Session& session) -> Result<std::uint64_t> {
      session.run("INSERT INTO journal (name, booked) VALUES (?, 0) ON CONFLICT (name) DO NOTHING", name_);
      return booked_of(session, name_);
    });
  }

  Result<std::vector<LedgerFault>> operator()(const Entry& entry) const {
    return database_.write_first("ledger", [&](Session& session) -> Result<std::vector<LedgerFault>> {
      std::vector<LedgerFault> faults;
      if (booked_of(session, name_) >= entry.serial) return faults;
      if (!entry.rows.empty()) {
        auto appended = tables_.ledger.append(entry.rows, entry.at_ms);
        if (!appended) return appended;
        faults = std::move(*appended);
      }
      if (entry.answer) {
        if (auto booked = book_answer(session, tables_.answers, *entry.answer, entry.at_ms); !booked)
          return std::unexpected(booked.error());
      }
      session.run("UPDATE journal SET booked = ? WHERE name = ?", entry.serial, name_);
      return faults;
    });
  }

 private:
  sql::Database& database_;
  BookedIn tables_;
  std::string name_;
};

}  // namespace

Result<std::unique_ptr<journal::LedgerJournal>> open_journal(sql::Database& database, BookedIn tables,
                                                             const std::string& path) {
  auto file = journal::JournalFile::open(path);
  if (!file) return std::unexpected(file.error());
  Booking booking(database, tables, file->name());
  const auto last = booking.begin();
  if (!last) return std::unexpected(last.error());
  return journal::LedgerJournal::open(std::move(*file), *last, std::move(booking));
}

}  // namespace dripfeed::postgresql
