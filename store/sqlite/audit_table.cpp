// A row's hash covers all its fields, each with its length before it, and the hash of the row before.
#include "store/sqlite/audit_table.h"

#include <fmt/format.h>

#include "store/hash/sha256.h"
#include "store/sqlite/paging.h"

namespace dripfeed::sqlite {
namespace {

using store::AuditRow;
using store::Result;

std::string hash_of(const AuditRow& row) {
  hash::Sha256 hash;
  const auto field = [&](std::string_view text) {
    hash.add(fmt::format("{}:", text.size()));
    hash.add(text);
  };
  field(row.previous_hash);
  field(fmt::format("{}", row.seq));
  field(fmt::format("{}", row.by.at_ms));
  field(row.by.actor);
  field(row.entry.action);
  field(row.entry.subject);
  field(row.entry.detail);
  return hash.hex();
}

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

constexpr std::string_view kList =
    "SELECT seq, at_ms, actor, action, subject, detail, previous_hash, hash FROM audit "
    "WHERE seq < ? ORDER BY seq DESC LIMIT ?";
constexpr std::string_view kListOfSubject =
    "SELECT seq, at_ms, actor, action, subject, detail, previous_hash, hash FROM audit "
    "WHERE subject = ? AND seq < ? ORDER BY seq DESC LIMIT ?";
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
  row.hash = hash_of(row);
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

Result<store::Page<AuditRow>> AuditTable::list(const store::PageRequest& page, std::string_view subject) {
  return database_.read("audit", [&](Session& session) -> Result<store::Page<AuditRow>> {
    const auto from = newest_first(page);
    if (!from) return std::unexpected(from.error());
    const auto key = [](const AuditRow& row) { return fmt::format("{}", row.seq); };
    if (subject.empty()) {
      Query query(session, kList, from->after, from->rows);
      return collect(query, page, read_row, key);
    }
    Query query(session, kListOfSubject, subject, from->after, from->rows);
    return collect(query, page, read_row, key);
  });
}

Result<store::AuditCheck> AuditTable::verify() {
  return database_.read("audit", [&](Session& session) -> Result<store::AuditCheck> {
    store::AuditCheck check;
    Query query(session, kWalk);
    while (query.next()) {
      const AuditRow row = read_row(query);
      ++check.rows;
      if (row.seq != check.rows || row.previous_hash != check.head || row.hash != hash_of(row)) {
        check.first_broken = row.seq;
        break;
      }
      check.head = row.hash;
    }
    return check;
  });
}

}  // namespace dripfeed::sqlite
