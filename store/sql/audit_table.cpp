// Rows are added one after the other, each with the hash of the one before.
#include "store/sql/audit_table.h"

#include <fmt/format.h>

#include "store/sql/audit_chain.h"
#include "store/sql/event_table.h"
#include "store/sql/paging.h"

namespace dripfeed::sql {
namespace {

using store::AuditRow;
using store::Result;

AuditRow read_row(Query& query) {
  AuditRow row;
  row.seq = query.number();
  row.by.at_ms = query.signed_number();
  row.by.actor = query.text();
  row.entry.action = query.text();
  row.entry.subject = query.text();
  row.entry.detail = query.text();
  row.previous_hash = query.text();
  row.hash = query.text();
  return row;
}

constexpr std::string_view kColumns = "seq, at_ms, actor, action, subject, detail, previous_hash, hash";

// One text of the columns that are asked for; each is bound once, also where it is not asked for.
std::string list_where(const store::AuditFilter& filter) {
  const auto equals = [](std::string_view column, bool is_given) {
    return is_given ? fmt::format("{} = ?", column) : std::string("? = ''");
  };
  return fmt::format(
      "SELECT {} FROM audit WHERE {} AND {} AND {} AND at_ms >= ? AND (? = 0 OR at_ms < ?) AND seq < ?"
      " ORDER BY seq DESC LIMIT ?",
      kColumns, equals("subject", !filter.subject.empty()), equals("actor", !filter.actor.empty()),
      equals("action", !filter.action.empty()));
}
constexpr std::string_view kWalk =
    "SELECT seq, at_ms, actor, action, subject, detail, previous_hash, hash FROM audit ORDER BY seq";

}  // namespace

AuditRow add_audit_row(Session& session, const store::AuditEntry& entry, const store::Stamp& by) {
  AuditRow row{.seq = 1, .by = by, .entry = entry, .previous_hash = {}, .hash = {}};
  {
    Query last(session, "SELECT seq, hash FROM audit ORDER BY seq DESC LIMIT 1");
    if (last.next()) {
      row.seq = last.number() + 1;
      row.previous_hash = last.text();
    }
  }
  row.hash = audit_hash(row);
  session.run(
      "INSERT INTO audit (seq, at_ms, actor, action, subject, detail, previous_hash, hash) VALUES (?, ?, ?, ?, ?, ?, "
      "?, ?)",
      row.seq, row.by.at_ms, row.by.actor, entry.action, entry.subject, entry.detail, row.previous_hash, row.hash);
  return row;
}

Result<AuditRow> AuditTable::append(const store::AuditEntry& entry, const store::Stamp& by) {
  return database_.write("audit",
                         [&](Session& session) -> Result<AuditRow> { return add_audit_row(session, entry, by); });
}

Result<AuditRow> AuditTable::append(const store::AuditEntry& entry, const store::NewEvent& event,
                                    const store::Stamp& by) {
  return database_.write("audit", [&](Session& session) -> Result<AuditRow> {
    if (event.word.empty()) return session.refuse(store::ErrorCode::invalid_value, "an event has a word");
    add_event_row(session, event, by);
    return add_audit_row(session, entry, by);
  });
}

Result<store::Page<AuditRow>> AuditTable::list(const store::PageRequest& page, const store::AuditFilter& filter) {
  return database_.read("audit", [&](Session& session) -> Result<store::Page<AuditRow>> {
    const auto from = newest_first(page);
    if (!from) return std::unexpected(from.error());
    const std::string sql = list_where(filter);
    Query query(session, sql, filter.subject, filter.actor, filter.action, filter.from_ms, filter.to_ms, filter.to_ms,
                from->after, from->rows);
    return collect(query, page, read_row, [](const AuditRow& row) { return fmt::format("{}", row.seq); });
  });
}

Result<store::AuditCheck> AuditTable::verify() {
  return database_.read("audit", [&](Session& session) -> Result<store::AuditCheck> {
    store::AuditCheck check;
    AuditChain chain;
    Query query(session, kWalk);
    while (!check.first_broken && query.next()) {
      const AuditRow row = read_row(query);
      if (!chain.follows(row)) check.first_broken = row.seq;
    }
    check.rows = chain.rows();
    check.head = chain.head();
    return check;
  });
}

}  // namespace dripfeed::sql
