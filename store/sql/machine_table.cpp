// The table machine says which revision is the newest; machine_revision has them all.
#include "store/sql/machine_table.h"

#include <fmt/format.h>

#include "store/hash/sha256.h"
#include "store/sql/audit_table.h"
#include "store/sql/paging.h"

namespace dripfeed::sql {
namespace {

using store::ErrorCode;
using store::Machine;
using store::Result;
using store::Revision;
using store::Stamp;

constexpr std::string_view kNewest =
    "SELECT r.machine, r.revision, r.profile, r.actor, r.at_ms FROM machine m "
    "JOIN machine_revision r ON r.machine = m.name AND r.revision = m.revision WHERE m.name = ?";
constexpr std::string_view kOne =
    "SELECT machine, revision, profile, actor, at_ms FROM machine_revision WHERE machine = ? AND revision = ?";
constexpr std::string_view kList =
    "SELECT r.machine, r.revision, r.profile, r.actor, r.at_ms FROM machine m "
    "JOIN machine_revision r ON r.machine = m.name AND r.revision = m.revision WHERE m.name > ? ORDER BY m.name LIMIT "
    "?";

Machine read_machine(Query& query) {
  Machine machine;
  machine.name = query.text();
  machine.revision = query.number();
  machine.profile = query.text();
  machine.changed_by = query.text();
  machine.changed_at_ms = query.signed_number();
  return machine;
}

std::string subject_of(std::string_view name) { return fmt::format("machine/{}", name); }

Machine add_revision(Session& session, std::string_view name, Revision revision, std::string_view profile,
                     const Stamp& by, std::string_view action) {
  session.run("INSERT INTO machine_revision (machine, revision, profile, actor, at_ms) VALUES (?, ?, ?, ?, ?)", name,
              revision, profile, by.actor, by.at_ms);
  add_audit_row(session,
                {.action = std::string(action),
                 .subject = subject_of(name),
                 .detail = fmt::format("revision {} sha256 {}", revision, hash::sha256_hex(profile))},
                by);
  return {std::string(name), revision, std::string(profile), by.actor, by.at_ms};
}

}  // namespace

Result<Machine> MachineTable::add(std::string_view name, std::string_view profile, const Stamp& by) {
  return database_.write(subject_of(name), [&](Session& session) -> Result<Machine> {
    if (name.empty()) return session.refuse(ErrorCode::invalid_value, "a machine needs a name");
    session.run("INSERT INTO machine (name, revision) VALUES (?, 1)", name);
    return add_revision(session, name, 1, profile, by, "machine.add");
  });
}

Result<Machine> MachineTable::change(std::string_view name, Revision expected, std::string_view profile,
                                     const Stamp& by) {
  return database_.write(subject_of(name), [&](Session& session) -> Result<Machine> {
    const auto newest = get(name);
    if (!newest) return newest;
    if (newest->revision != expected) return session.refuse(ErrorCode::stale_revision);
    session.run("UPDATE machine SET revision = ? WHERE name = ?", expected + 1, name);
    session.run("UPDATE verdict SET stale = 1 WHERE machine = ? AND stale = 0", name);
    return add_revision(session, name, expected + 1, profile, by, "machine.change");
  });
}

Result<Machine> MachineTable::get(std::string_view name) {
  return database_.read(subject_of(name), [&](Session& session) -> Result<Machine> {
    Query query(session, kNewest, name);
    if (!query.next()) return session.refuse(ErrorCode::not_found);
    return read_machine(query);
  });
}

Result<Machine> MachineTable::get(std::string_view name, Revision revision) {
  return database_.read(subject_of(name), [&](Session& session) -> Result<Machine> {
    Query query(session, kOne, name, revision);
    if (!query.next()) return session.refuse(ErrorCode::not_found);
    return read_machine(query);
  });
}

Result<store::Page<Machine>> MachineTable::list(const store::PageRequest& page) {
  return database_.read("machines", [&](Session& session) -> Result<store::Page<Machine>> {
    const auto rows = rows_of(page);
    if (!rows) return std::unexpected(rows.error());
    Query query(session, kList, page.after, *rows);
    return collect(query, page, read_machine, [](const Machine& machine) { return machine.name; });
  });
}

}  // namespace dripfeed::sql
