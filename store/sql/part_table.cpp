// The table part says which revision is the newest; part_revision has them all.
#include "store/sql/part_table.h"

#include <fmt/format.h>

#include "store/hash/sha256.h"
#include "store/sql/audit_table.h"
#include "store/sql/paging.h"

namespace dripfeed::sql {
namespace {

using store::ErrorCode;
using store::Part;
using store::PartValues;
using store::Result;
using store::Revision;
using store::Stamp;

constexpr std::string_view kNewest =
    "SELECT r.part, r.revision, r.family, r.family_revision, r.part_values, r.actor, r.at_ms FROM part p "
    "JOIN part_revision r ON r.part = p.number AND r.revision = p.revision WHERE p.number = ?";
constexpr std::string_view kOne =
    "SELECT part, revision, family, family_revision, part_values, actor, at_ms FROM part_revision "
    "WHERE part = ? AND revision = ?";
constexpr std::string_view kList =
    "SELECT r.part, r.revision, r.family, r.family_revision, r.part_values, r.actor, r.at_ms FROM part p "
    "JOIN part_revision r ON r.part = p.number AND r.revision = p.revision WHERE p.number > ? ORDER BY p.number LIMIT "
    "?";
constexpr std::string_view kListOfFamily =
    "SELECT r.part, r.revision, r.family, r.family_revision, r.part_values, r.actor, r.at_ms FROM part p "
    "JOIN part_revision r ON r.part = p.number AND r.revision = p.revision "
    "WHERE r.family = ? AND p.number > ? ORDER BY p.number LIMIT ?";
constexpr std::string_view kRevisions =
    "SELECT part, revision, family, family_revision, part_values, actor, at_ms FROM part_revision "
    "WHERE part = ? AND revision < ? ORDER BY revision DESC LIMIT ?";

Part read_part(Query& query) {
  Part part;
  part.number = query.text();
  part.revision = query.number();
  part.made_of.family = query.text();
  part.made_of.family_revision = query.number();
  part.made_of.values = query.text();
  part.changed_by = query.text();
  part.changed_at_ms = query.signed_number();
  return part;
}

std::string subject_of(std::string_view number) { return fmt::format("part/{}", number); }

Part add_revision(Session& session, std::string_view number, Revision revision, const PartValues& values,
                  const Stamp& by, std::string_view action) {
  session.run(
      "INSERT INTO part_revision (part, revision, family, family_revision, part_values, actor, at_ms) "
      "VALUES (?, ?, ?, ?, ?, ?, ?)",
      number, revision, values.family, values.family_revision, values.values, by.actor, by.at_ms);
  add_audit_row(session,
                {.action = std::string(action),
                 .subject = subject_of(number),
                 .detail = fmt::format("revision {} of family {} revision {} sha256 {}", revision, values.family,
                                       values.family_revision, hash::sha256_hex(values.values))},
                by);
  return {std::string(number), revision, values, by.actor, by.at_ms};
}

}  // namespace

Result<Part> PartTable::add(std::string_view number, const PartValues& values, const Stamp& by) {
  return database_.write(subject_of(number), [&](Session& session) -> Result<Part> {
    if (number.empty()) return session.refuse(ErrorCode::invalid_value, "a part needs a number");
    session.run("INSERT INTO part (number, revision) VALUES (?, 1)", number);
    return add_revision(session, number, 1, values, by, "part.add");
  });
}

Result<Part> PartTable::change(std::string_view number, Revision expected, const PartValues& values, const Stamp& by) {
  return database_.write(subject_of(number), [&](Session& session) -> Result<Part> {
    const auto newest = get(number);
    if (!newest) return newest;
    if (newest->revision != expected) return session.refuse(ErrorCode::stale_revision);
    session.run("UPDATE part SET revision = ? WHERE number = ?", expected + 1, number);
    return add_revision(session, number, expected + 1, values, by, "part.change");
  });
}

Result<Part> PartTable::get(std::string_view number) {
  return database_.read(subject_of(number), [&](Session& session) -> Result<Part> {
    Query query(session, kNewest, number);
    if (!query.next()) return session.refuse(ErrorCode::not_found);
    return read_part(query);
  });
}

Result<Part> PartTable::get(std::string_view number, Revision revision) {
  return database_.read(subject_of(number), [&](Session& session) -> Result<Part> {
    Query query(session, kOne, number, revision);
    if (!query.next()) return session.refuse(ErrorCode::not_found);
    return read_part(query);
  });
}

Result<store::Page<Part>> PartTable::list(const store::PageRequest& page, std::string_view family) {
  return database_.read("parts", [&](Session& session) -> Result<store::Page<Part>> {
    const auto rows = rows_of(page);
    if (!rows) return std::unexpected(rows.error());
    const auto key = [](const Part& part) { return part.number; };
    if (family.empty()) {
      Query query(session, kList, page.after, *rows);
      return collect(query, page, read_part, key);
    }
    Query query(session, kListOfFamily, family, page.after, *rows);
    return collect(query, page, read_part, key);
  });
}

Result<store::Page<Part>> PartTable::revisions(std::string_view number, const store::PageRequest& page) {
  return database_.read(subject_of(number), [&](Session& session) -> Result<store::Page<Part>> {
    const auto from = newest_first(page);
    if (!from) return std::unexpected(from.error());
    Query query(session, kRevisions, number, from->after, from->rows);
    return collect(query, page, read_part, [](const Part& part) { return fmt::format("{}", part.revision); });
  });
}

}  // namespace dripfeed::sql
