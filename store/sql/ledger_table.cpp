// Rows of all jobs lie in the order of their commits, so a commit for 512 lines writes a handful of pages and not 512.
// A job's rows form a list, each naming the one before:
//
//   ledger_head ──► row n ──► row n-1 ──► … ──► row 1        and every 256th row has a mark to jump in at
//
#include "store/sql/ledger_table.h"

#include <algorithm>

#include <fmt/format.h>

#include "store/sql/paging.h"

namespace dripfeed::sql {
namespace {

using store::ErrorCode;
using store::Id;
using store::LedgerCounts;
using store::LedgerFault;
using store::LedgerInterval;
using store::LedgerRow;
using store::NewLedgerRow;
using store::Result;

constexpr std::uint64_t kMarkEvery = 256;

constexpr std::string_view kHead =
    "SELECT last, seq, at_ms, handed, clocked, confirmed, reserve FROM ledger_head WHERE job = ?";
constexpr std::string_view kInsert =
    "INSERT INTO ledger (job, seq, at_ms, handed, clocked, confirmed, reserve, note, previous) "
    "VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?)";
constexpr std::string_view kUpdateHead =
    "UPDATE ledger_head SET last = ?, seq = ?, at_ms = ?, handed = ?, clocked = ?, confirmed = ?, reserve = ? WHERE "
    "job = ?";
// The first marked row at or after a place.
constexpr std::string_view kMark = "SELECT ledger FROM ledger_mark WHERE job = ? AND seq >= ? ORDER BY seq LIMIT 1";
// From one row back along the list to a row number.
constexpr std::string_view kWalk =
    "WITH RECURSIVE walk (id, seq, at_ms, handed, clocked, confirmed, reserve, note, previous) AS ("
    "SELECT id, seq, at_ms, handed, clocked, confirmed, reserve, note, previous FROM ledger WHERE id = ? AND job = ? "
    "UNION ALL SELECT l.id, l.seq, l.at_ms, l.handed, l.clocked, l.confirmed, l.reserve, l.note, l.previous "
    "FROM walk JOIN ledger l ON l.id = walk.previous WHERE walk.seq > ? AND l.job = ?) "
    "SELECT seq, at_ms, handed, clocked, confirmed, reserve, note FROM walk";

struct Head {
  Id last = 0;
  LedgerInterval known;
};

std::string subject_of(Id job) { return fmt::format("job/{}", job); }

LedgerCounts read_counts(Query& query) {
  LedgerCounts counts;
  counts.handed = query.number();
  counts.clocked = query.number();
  counts.confirmed = query.number();
  counts.reserve = query.number();
  return counts;
}

std::optional<Head> head_of(Session& session, Id job) {
  Query query(session, kHead, job);
  if (!query.next()) return std::nullopt;
  Head head;
  head.last = query.number();
  head.known.seq = query.number();
  head.known.at_ms = query.signed_number();
  head.known.last = read_counts(query);
  head.known.low = head.known.last.clocked;
  head.known.high = head.known.last.reserve;
  return head;
}

LedgerRow read_row(Query& query) {
  LedgerRow row;
  row.seq = query.number();
  row.at_ms = query.signed_number();
  row.counts = read_counts(query);
  row.note = query.text();
  return row;
}

void write_row(Session& session, const Head& head, const NewLedgerRow& row, std::int64_t at_ms) {
  const std::uint64_t seq = head.known.seq + 1;
  const LedgerCounts& counts = row.counts;
  session.run(kInsert, row.job, seq, at_ms, counts.handed, counts.clocked, counts.confirmed, counts.reserve, row.note,
              NumberOrNull{head.last});
  const Id id = session.last_id();
  session.run(kUpdateHead, id, seq, at_ms, counts.handed, counts.clocked, counts.confirmed, counts.reserve, row.job);
  if (seq % kMarkEvery == 0) {
    session.run("INSERT INTO ledger_mark (job, seq, ledger) VALUES (?, ?, ?)", row.job, seq, id);
  }
}

// Rows `from`..`to` of a job, oldest first.
std::vector<LedgerRow> rows_between(Session& session, Id job, const Head& head, std::uint64_t from, std::uint64_t to) {
  Id start = head.last;
  {
    Query mark(session, kMark, job, to);
    if (mark.next()) start = mark.number();
  }
  std::vector<LedgerRow> rows;
  Query query(session, kWalk, start, job, from, job);
  while (query.next()) {
    LedgerRow row = read_row(query);
    if (row.seq <= to) rows.push_back(std::move(row));
  }
  std::ranges::reverse(rows);
  return rows;
}

}  // namespace

Result<std::vector<LedgerFault>> LedgerTable::append(std::span<const NewLedgerRow> rows, std::int64_t at_ms) {
  return database_.write_first("ledger", [&](Session& session) -> Result<std::vector<LedgerFault>> {
    std::vector<LedgerFault> faults;
    for (const NewLedgerRow& row : rows) {
      const auto head = head_of(session, row.job);
      if (!head) {
        faults.push_back({row.job, "there is no such job", false});
        continue;
      }
      const auto fault = store::fault_of(row.job, head->known.last, row.counts);
      if (fault) faults.push_back(*fault);
      if (!fault || fault->written) write_row(session, *head, row, at_ms);
    }
    return faults;
  });
}

Result<store::Page<LedgerRow>> LedgerTable::rows(Id job, const store::PageRequest& page) {
  return database_.read(subject_of(job), [&](Session& session) -> Result<store::Page<LedgerRow>> {
    const auto from = oldest_first(page);
    if (!from) return std::unexpected(from.error());
    const auto head = head_of(session, job);
    if (!head) return session.refuse(ErrorCode::not_found);
    store::Page<LedgerRow> found;
    const std::uint64_t newest = head->known.seq;
    if (from->after >= newest) return found;
    const std::uint64_t to = newest - from->after > page.limit ? from->after + page.limit : newest;
    found.items = rows_between(session, job, *head, from->after + 1, to);
    if (to < newest) found.next = fmt::format("{}", to);
    return found;
  });
}

Result<LedgerInterval> LedgerTable::interval(Id job) {
  return database_.read(subject_of(job), [&](Session& session) -> Result<LedgerInterval> {
    const auto head = head_of(session, job);
    if (!head) return session.refuse(ErrorCode::not_found);
    return head->known;
  });
}

Result<std::uint64_t> LedgerTable::verify(Id job) {
  return database_.read(subject_of(job), [&](Session& session) -> Result<std::uint64_t> {
    const auto head = head_of(session, job);
    if (!head) return session.refuse(ErrorCode::not_found);
    LedgerCounts before;
    std::uint64_t seq = 0;
    while (seq < head->known.seq) {
      const std::uint64_t to = std::min(seq + kMarkEvery, head->known.seq);
      for (const LedgerRow& row : rows_between(session, job, *head, seq + 1, to)) {
        if (row.seq != ++seq || store::fault_of(job, before, row.counts)) {
          return session.refuse(ErrorCode::corrupt, fmt::format("row {} of job {}", row.seq, job));
        }
        before = row.counts;
      }
      if (seq != to)
        return session.refuse(ErrorCode::corrupt, fmt::format("row {} of job {} is missing", seq + 1, job));
    }
    if (before != head->known.last) return session.refuse(ErrorCode::corrupt, fmt::format("the head of job {}", job));
    return seq;
  });
}

}  // namespace dripfeed::sql
