// The table family says which revision is the newest; family_revision has them all.
#include "store/sql/family_table.h"

#include <fmt/format.h>

#include "store/hash/sha256.h"
#include "store/sql/audit_table.h"
#include "store/sql/paging.h"

namespace dripfeed::sql {
namespace {

using store::ErrorCode;
using store::Family;
using store::Result;
using store::Revision;
using store::Stamp;

constexpr std::string_view kNewest =
    "SELECT r.family, r.revision, r.body, r.actor, r.at_ms FROM family f "
    "JOIN family_revision r ON r.family = f.name AND r.revision = f.revision WHERE f.name = ?";
constexpr std::string_view kOne =
    "SELECT family, revision, body, actor, at_ms FROM family_revision WHERE family = ? AND revision = ?";
constexpr std::string_view kList =
    "SELECT r.family, r.revision, r.body, r.actor, r.at_ms FROM family f "
    "JOIN family_revision r ON r.family = f.name AND r.revision = f.revision WHERE f.name > ? ORDER BY f.name LIMIT ?";
constexpr std::string_view kRevisions =
    "SELECT family, revision, body, actor, at_ms FROM family_revision WHERE family = ? AND revision < ? "
    "ORDER BY revision DESC LIMIT ?";
// What was rendered from a family is judged again when the family changes.
constexpr std::string_view kStale =
    "UPDATE verdict SET stale = 1 WHERE stale = 0 AND sha256 IN (SELECT sha256 FROM program_revision WHERE family = ?)";

Family read_family(Query& query) {
  Family family;
  family.name = query.text();
  family.revision = query.number();
  family.text = query.text();
  family.changed_by = query.text();
  family.changed_at_ms = query.signed_number();
  return family;
}

std::string subject_of(std::string_view name) { return fmt::format("family/{}", name); }

Family add_revision(Session& session, std::string_view name, Revision revision, std::string_view text, const Stamp& by,
                    std::string_view action) {
  session.run("INSERT INTO family_revision (family, revision, body, actor, at_ms) VALUES (?, ?, ?, ?, ?)", name,
              revision, text, by.actor, by.at_ms);
  add_audit_row(session,
                {.action = std::string(action),
                 .subject = subject_of(name),
                 .detail = fmt::format("revision {} sha256 {}", revision, hash::sha256_hex(text))},
                by);
  return {std::string(name), revision, std::string(text), by.actor, by.at_ms};
}

}  // namespace

Result<Family> FamilyTable::add(std::string_view name, std::string_view text, const Stamp& by) {
  return database_.write(subject_of(name), [&](Session& session) -> Result<Family> {
    if (name.empty()) return session.refuse(ErrorCode::invalid_value, "a family needs a name");
    session.run("INSERT INTO family (name, revision) VALUES (?, 1)", name);
    return add_revision(session, name, 1, text, by, "family.add");
  });
}

Result<Family> FamilyTable::change(std::string_view name, Revision expected, std::string_view text, const Stamp& by) {
  return database_.write(subject_of(name), [&](Session& session) -> Result<Family> {
    const auto newest = get(name);
    if (!newest) return newest;
    if (newest->revision != expected) return session.refuse(ErrorCode::stale_revision);
    session.run("UPDATE family SET revision = ? WHERE name = ?", expected + 1, name);
    session.run(kStale, name);
    return add_revision(session, name, expected + 1, text, by, "family.change");
  });
}

Result<Family> FamilyTable::get(std::string_view name) {
  return database_.read(subject_of(name), [&](Session& session) -> Result<Family> {
    Query query(session, kNewest, name);
    if (!query.next()) return session.refuse(ErrorCode::not_found);
    return read_family(query);
  });
}

Result<Family> FamilyTable::get(std::string_view name, Revision revision) {
  return database_.read(subject_of(name), [&](Session& session) -> Result<Family> {
    Query query(session, kOne, name, revision);
    if (!query.next()) return session.refuse(ErrorCode::not_found);
    return read_family(query);
  });
}

Result<store::Page<Family>> FamilyTable::list(const store::PageRequest& page) {
  return database_.read("families", [&](Session& session) -> Result<store::Page<Family>> {
    const auto rows = rows_of(page);
    if (!rows) return std::unexpected(rows.error());
    Query query(session, kList, page.after, *rows);
    return collect(query, page, read_family, [](const Family& family) { return family.name; });
  });
}

Result<store::Page<Family>> FamilyTable::revisions(std::string_view name, const store::PageRequest& page) {
  return database_.read(subject_of(name), [&](Session& session) -> Result<store::Page<Family>> {
    const auto from = newest_first(page);
    if (!from) return std::unexpected(from.error());
    Query query(session, kRevisions, name, from->after, from->rows);
    return collect(query, page, read_family, [](const Family& family) { return fmt::format("{}", family.revision); });
  });
}

}  // namespace dripfeed::sql
