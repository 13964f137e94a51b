// Groups of machines: a row each, and the machine's row names its group.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "store/sql/audit_table.h"
#include "store/sql/user_table.h"

namespace dripfeed::sql {
namespace {

using store::ErrorCode;
using store::MachineGroup;
using store::Result;
using store::Stamp;

std::string subject_of(std::string_view group) { return fmt::format("group/{}", group); }

// A machine that left its group unseen would lose that group's rules and roles.
Result<void> refuse_of_another(Session& session, const MachineGroup& group) {
  for (const std::string& machine : group.machines) {
    Query query(session, "SELECT machine_group FROM machine WHERE name = ? AND machine_group <> ?", machine,
                group.name);
    if (query.next())
      return session.refuse(ErrorCode::exists,
                            fmt::format("{} is in group {}: take it out of that one before", machine, query.text()));
  }
  return {};
}

// False where a machine is not there.
bool fill(Session& session, const MachineGroup& group) {
  session.run("UPDATE machine SET machine_group = NULL WHERE machine_group = ?", group.name);
  for (const std::string& machine : group.machines) {
    session.run("UPDATE machine SET machine_group = ? WHERE name = ?", group.name, machine);
    if (!session.ok() || session.changed_rows() == 0) return false;
  }
  return true;
}

}  // namespace

Result<MachineGroup> UserTable::put_group(const MachineGroup& group, const Stamp& by) {
  return database_.write(subject_of(group.name), [&](Session& session) -> Result<MachineGroup> {
    if (group.name.empty()) return session.refuse(ErrorCode::invalid_value, "a group needs a name");
    if (auto free = refuse_of_another(session, group); !free) return std::unexpected(free.error());
    session.run(
        "INSERT INTO machine_group (name, four_eyes, operator_sign_off) VALUES (?, ?, ?) ON CONFLICT (name) DO UPDATE "
        "SET four_eyes = excluded.four_eyes, operator_sign_off = excluded.operator_sign_off",
        group.name, std::uint64_t{group.four_eyes ? 1U : 0U}, std::uint64_t{group.operator_sign_off ? 1U : 0U});
    if (!fill(session, group) && session.ok())
      return session.refuse(ErrorCode::broken_reference, "a machine of the group is not there");
    add_audit_row(
        session,
        {.action = "group.put",
         .subject = subject_of(group.name),
         .detail = fmt::format("{}{}{}", fmt::join(group.machines, ", "), group.four_eyes ? "; four eyes" : "",
                               group.operator_sign_off ? "" : "; approved without an operator's sign-off")},
        by);
    return group;
  });
}

Result<void> UserTable::remove_group(std::string_view name, const Stamp& by) {
  return database_.write(subject_of(name), [&](Session& session) -> Result<void> {
    session.run("UPDATE machine SET machine_group = NULL WHERE machine_group = ?", name);
    session.run("DELETE FROM account_grant WHERE machine_group = ?", name);
    session.run("DELETE FROM machine_group WHERE name = ?", name);
    if (session.ok() && session.changed_rows() == 0) return session.refuse(ErrorCode::not_found);
    add_audit_row(session, {.action = "group.remove", .subject = subject_of(name), .detail = {}}, by);
    return {};
  });
}

Result<std::vector<MachineGroup>> UserTable::groups() {
  return database_.read("groups", [&](Session& session) -> Result<std::vector<MachineGroup>> {
    std::vector<MachineGroup> groups;
    Query query(session,
                "SELECT g.name, g.four_eyes, g.operator_sign_off, m.name FROM machine_group g LEFT JOIN machine m ON "
                "m.machine_group = g.name"
                " ORDER BY g.name, m.name");
    while (query.next()) {
      const std::string name = query.text();
      const bool four_eyes = query.flag();
      const bool operator_sign_off = query.flag();
      if (groups.empty() || groups.back().name != name) groups.push_back({name, {}, four_eyes, operator_sign_off});
      if (std::string machine = query.text(); !machine.empty()) groups.back().machines.push_back(std::move(machine));
    }
    return groups;
  });
}

bool needs_four_eyes(Session& session, std::string_view machine) {
  Query query(session,
              "SELECT g.four_eyes FROM machine m JOIN machine_group g ON g.name = m.machine_group WHERE m.name = ?",
              machine);
  return query.next() && query.flag();
}

bool needs_operator_sign_off(Session& session, std::string_view machine) {
  Query query(
      session,
      "SELECT g.operator_sign_off FROM machine m JOIN machine_group g ON g.name = m.machine_group WHERE m.name = ?",
      machine);
  return !query.next() || query.flag();
}

}  // namespace dripfeed::sql
