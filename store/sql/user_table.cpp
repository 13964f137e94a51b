// Secrets are in the rows, and in no answer but secret()'s; the audit names what was done with them, never a hash.
#include "store/sql/user_table.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "store/sql/audit_table.h"
#include "store/sql/paging.h"

namespace dripfeed::sql {
namespace {

using store::ErrorCode;
using store::Grant;
using store::Id;
using store::Page;
using store::Result;
using store::Rights;
using store::SecretKind;
using store::Stamp;
using store::User;
using store::UserRoles;

constexpr std::string_view kOne =
    "SELECT id, name, role, password <> '', pin <> '', failures, locked_until_ms, disabled_at_ms, revision, created_by,"
    " created_at_ms, provider FROM account WHERE name = ?";
// The last condition is that of the index, and an account of this shop has no identity.
constexpr std::string_view kOfProvider =
    "SELECT name FROM account WHERE provider = ? AND provider_subject = ? AND provider <> ''";
constexpr std::string_view kList =
    "SELECT id, name, role, password <> '', pin <> '', failures, locked_until_ms, disabled_at_ms, revision, created_by,"
    " created_at_ms, provider FROM account WHERE name > ? ORDER BY name LIMIT ?";

User read_user(Query& query) {
  User user;
  user.id = query.number();
  user.name = query.text();
  user.roles.role = query.value<store::Role>();
  user.has_password = query.flag();
  user.has_pin = query.flag();
  user.failures = static_cast<std::uint32_t>(query.number());
  user.locked_until_ms = query.signed_number();
  user.disabled_at_ms = query.signed_number();
  user.revision = query.number();
  user.created_by = query.text();
  user.created_at_ms = query.signed_number();
  user.issuer = query.text();
  return user;
}

void read_grants(Session& session, User& user) {
  Query query(session, "SELECT machine_group, role FROM account_grant WHERE account = ? ORDER BY machine_group",
              user.id);
  while (query.next()) {
    Grant grant;
    grant.group = query.text();
    grant.role = query.value<store::Role>();
    user.roles.grants.push_back(std::move(grant));
  }
}

std::string subject_of(std::string_view name) { return fmt::format("user/{}", name); }

std::string words_of(const UserRoles& roles) {
  std::string words(store::name_of(roles.role));
  for (const Grant& grant : roles.grants) words += fmt::format(", {} on {}", store::name_of(grant.role), grant.group);
  return words;
}

void write_grants(Session& session, Id user, const UserRoles& roles) {
  session.run("DELETE FROM account_grant WHERE account = ?", user);
  for (const Grant& grant : roles.grants)
    session.run("INSERT INTO account_grant (account, machine_group, role) VALUES (?, ?, ?)", user, grant.group,
                grant.role);
}

void delete_sessions(Session& session, Id user) { session.run("DELETE FROM browser_session WHERE account = ?", user); }

std::string_view update_of(SecretKind kind) {
  return kind == SecretKind::password
             ? "UPDATE account SET password = ?, failures = 0, locked_until_ms = 0 WHERE id = ?"
             : "UPDATE account SET pin = ?, failures = 0, locked_until_ms = 0 WHERE id = ?";
}

// The audit and the four eyes know people and programs by their names. A user's own tokens may have any.
Result<void> refuse_name_of_token(Session& session, std::string_view name) {
  Query query(session, "SELECT 1 FROM token WHERE name = ? AND account IS NULL AND revoked_at_ms = 0 LIMIT 1", name);
  if (!query.next()) return {};
  return session.refuse(ErrorCode::exists, fmt::format("a token has the name {}", name));
}

}  // namespace

Result<User> UserTable::add(std::string_view name, const UserRoles& roles, const Stamp& by) {
  return database_.write(subject_of(name), [&](Session& session) -> Result<User> {
    if (name.empty()) return session.refuse(ErrorCode::invalid_value, "a user needs a name");
    if (auto free = refuse_name_of_token(session, name); !free) return std::unexpected(free.error());
    session.run("INSERT INTO account (name, role, revision, created_by, created_at_ms) VALUES (?, ?, 1, ?, ?)", name,
                roles.role, by.actor, by.at_ms);
    write_grants(session, session.last_id(), roles);
    add_audit_row(session, {.action = "user.add", .subject = subject_of(name), .detail = words_of(roles)}, by);
    if (!session.ok()) return std::unexpected(session.error());
    return get(name);
  });
}

Result<User> UserTable::add_of_provider(std::string_view name, const store::ProviderIdentity& identity,
                                        const UserRoles& roles, bool disabled, const Stamp& by) {
  return database_.write(subject_of(name), [&](Session& session) -> Result<User> {
    if (name.empty() || identity.issuer.empty() || identity.subject.empty())
      return session.refuse(ErrorCode::invalid_value, "a user of a provider needs a name, an issuer and a subject");
    session.run(
        "INSERT INTO account (name, role, revision, created_by, created_at_ms, disabled_at_ms, provider,"
        " provider_subject) VALUES (?, ?, 1, ?, ?, ?, ?, ?)",
        name, roles.role, by.actor, by.at_ms, disabled ? by.at_ms : std::int64_t{0}, identity.issuer, identity.subject);
    write_grants(session, session.last_id(), roles);
    add_audit_row(
        session,
        {.action = "user.add",
         .subject = subject_of(name),
         .detail = fmt::format("{}, of {}{}", words_of(roles), identity.issuer, disabled ? ", disabled" : "")},
        by);
    if (!session.ok()) return std::unexpected(session.error());
    return get(name);
  });
}

Result<User> UserTable::of_provider(const store::ProviderIdentity& identity) {
  return database_.read("user of a provider", [&](Session& session) -> Result<User> {
    std::string name;
    {
      Query query(session, kOfProvider, identity.issuer, identity.subject);
      if (!query.next()) return session.refuse(ErrorCode::not_found);
      name = query.text();
    }
    return get(name);
  });
}

Result<void> UserTable::end_sessions(std::string_view name) {
  return database_.write(subject_of(name), [&](Session& session) -> Result<void> {
    const auto user = get(name);
    if (!user) return std::unexpected(user.error());
    delete_sessions(session, user->id);
    return {};
  });
}

Result<User> UserTable::change(std::string_view name, store::Revision expected, const store::UserChange& change,
                               const Stamp& by) {
  return database_.write(subject_of(name), [&](Session& session) -> Result<User> {
    const auto user = get(name);
    if (!user) return user;
    if (user->revision != expected) return session.refuse(ErrorCode::stale_revision);
    const std::int64_t since_ms = user->disabled_at_ms != 0 ? user->disabled_at_ms : by.at_ms;
    session.run("UPDATE account SET role = ?, disabled_at_ms = ?, revision = revision + 1 WHERE id = ?",
                change.roles.role, change.disabled ? since_ms : std::int64_t{0}, user->id);
    write_grants(session, user->id, change.roles);
    if (change.disabled) delete_sessions(session, user->id);
    add_audit_row(session,
                  {.action = "user.change",
                   .subject = subject_of(name),
                   .detail = fmt::format("{}{}", words_of(change.roles), change.disabled ? ", disabled" : "")},
                  by);
    if (!session.ok()) return std::unexpected(session.error());
    return get(name);
  });
}

Result<User> UserTable::set_secret(std::string_view name, SecretKind kind, std::string_view secret_hash,
                                   const Stamp& by) {
  return database_.write(subject_of(name), [&](Session& session) -> Result<User> {
    const auto user = get(name);
    if (!user) return user;
    session.run(update_of(kind), secret_hash, user->id);
    delete_sessions(session, user->id);
    add_audit_row(session,
                  {.action = "user.secret",
                   .subject = subject_of(name),
                   .detail = fmt::format("{} {}", store::name_of(kind), secret_hash.empty() ? "taken away" : "set")},
                  by);
    if (!session.ok()) return std::unexpected(session.error());
    return get(name);
  });
}

Result<std::string> UserTable::secret(std::string_view name, SecretKind kind) {
  return database_.read(subject_of(name), [&](Session& session) -> Result<std::string> {
    Query query(session, "SELECT password, pin FROM account WHERE name = ?", name);
    if (!query.next()) return session.refuse(ErrorCode::not_found);
    const std::string password = query.text();
    return kind == SecretKind::password ? password : query.text();
  });
}

Result<void> UserTable::note_refusal(std::string_view name, std::int64_t locked_until_ms, const Stamp& by) {
  return database_.write(subject_of(name), [&](Session& session) -> Result<void> {
    session.run(
        "UPDATE account SET failures = failures + 1, locked_until_ms = CASE WHEN locked_until_ms < ? THEN ? ELSE "
        "locked_until_ms END WHERE name = ?",
        locked_until_ms, locked_until_ms, name);
    add_audit_row(
        session,
        {.action = locked_until_ms == 0 ? "user.refused" : "user.locked", .subject = subject_of(name), .detail = {}},
        by);
    return {};
  });
}

Result<User> UserTable::unlock(std::string_view name, const Stamp& by) {
  return database_.write(subject_of(name), [&](Session& session) -> Result<User> {
    const auto user = get(name);
    if (!user || (user->failures == 0 && user->locked_until_ms == 0)) return user;
    session.run("UPDATE account SET failures = 0, locked_until_ms = 0 WHERE id = ?", user->id);
    add_audit_row(session, {.action = "user.unlock", .subject = subject_of(name), .detail = {}}, by);
    if (!session.ok()) return std::unexpected(session.error());
    return get(name);
  });
}

Result<User> UserTable::get(std::string_view name) {
  return database_.read(subject_of(name), [&](Session& session) -> Result<User> {
    Query query(session, kOne, name);
    if (!query.next()) return session.refuse(ErrorCode::not_found);
    User user = read_user(query);
    read_grants(session, user);
    return user;
  });
}

Result<Page<User>> UserTable::list(const store::PageRequest& page) {
  return database_.read("users", [&](Session& session) -> Result<Page<User>> {
    const auto rows = rows_of(page);
    if (!rows) return std::unexpected(rows.error());
    Page<User> found;
    {
      Query query(session, kList, page.after, *rows);
      found = collect(query, page, read_user, [](const User& user) { return user.name; });
    }
    for (User& user : found.items) read_grants(session, user);
    return found;
  });
}

Result<Rights> UserTable::rights(Id user) {
  return database_.read(fmt::format("user {}", user), [&](Session& session) -> Result<Rights> {
    Rights rights;
    {
      Query query(session, "SELECT name, role FROM account WHERE id = ? AND disabled_at_ms = 0", user);
      if (!query.next()) return session.refuse(ErrorCode::not_found);
      rights.name = query.text();
      rights.role = query.value<store::Role>();
    }
    Query query(session,
                "SELECT m.name, g.role FROM account_grant g JOIN machine m ON m.machine_group = g.machine_group"
                " WHERE g.account = ?",
                user);
    while (query.next()) {
      std::string machine = query.text();
      rights.on_machines.emplace(std::move(machine), query.value<store::Role>());
    }
    return rights;
  });
}

}  // namespace dripfeed::sql
