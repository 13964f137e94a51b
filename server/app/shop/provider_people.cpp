// An account is found by issuer and subject alone. The name counts once, when the account is made: a provider may give
// it to another person later, and a name that is here already is never handed over.
#include "server/app/shop/provider_people.h"

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include "server/app/base/names.h"

namespace dripfeed::app {

namespace {

constexpr std::string_view kOurselves = "dripfeed";  // who acts by itself in the audit

using Mapping = std::vector<GroupRole>;

store::Stamp stamp(std::int64_t now_ms) { return {std::string(kOurselves), now_ms}; }

// Refuses, with a row in the audit.
std::unexpected<Error> refuse(store::Store& store, std::string_view name, std::string why, std::int64_t now_ms) {
  const auto noted = store.audit().append({"user.refused", fmt::format("user/{}", name), why}, stamp(now_ms));
  if (!noted) return std::unexpected(from_store(noted.error()));
  return fail(ErrorCode::refused, std::move(why));
}

// What the groups give; nothing where they give no role. A group of machines that is not here gives none.
Result<std::optional<store::UserRoles>> roles_of(store::Store& store, const VouchedPerson& person,
                                                 const Mapping& mapping) {
  const auto groups = lift(store.users().groups());
  if (!groups) return std::unexpected(groups.error());
  std::optional<store::UserRoles> roles;
  std::map<std::string, store::Role> grants;
  for (const GroupRole& row : mapping) {
    if (std::ranges::find(person.groups, row.group) == person.groups.end()) continue;
    if (row.machines.empty()) {
      if (!roles) roles.emplace();
      roles->role = std::max(roles->role, row.role);
    } else if (std::ranges::find(*groups, row.machines, &store::MachineGroup::name) == groups->end()) {
      spdlog::warn("sign-in of {}: there is no group of machines \"{}\"", person.name, row.machines);
    } else {
      const auto [grant, is_new] = grants.emplace(row.machines, row.role);
      if (!is_new) grant->second = std::max(grant->second, row.role);
    }
  }
  if (!roles && !grants.empty()) roles.emplace();
  for (const auto& [machines, role] : grants) roles->grants.push_back({machines, role});
  return roles;
}

// A token of a program acts under its name in the audit, as a person does.
Result<bool> is_name_of_token(store::Store& store, std::string_view name) {
  store::PageRequest page{.limit = 200, .after = {}};
  while (true) {
    const auto tokens = lift(store.tokens().list(page));
    if (!tokens) return std::unexpected(tokens.error());
    if (std::ranges::find(tokens->items, name, &store::Token::name) != tokens->items.end()) return true;
    if (tokens->next.empty()) return false;
    page.after = tokens->next;
  }
}

Result<bool> is_taken(store::Store& store, std::string_view name) {
  if (name == kOurselves) return true;
  const auto user = store.users().get(name);
  if (user) return true;
  if (user.error().code != store::ErrorCode::not_found) return std::unexpected(from_store(user.error()));
  return is_name_of_token(store, name);
}

std::string waits(std::string_view name) {
  return fmt::format("the account {} is not enabled: an administrator enables it", name);
}

std::string in_no_group(std::string_view name) {
  return fmt::format("no group of {} at the provider gives a role here", name);
}

Result<std::string> admit_new(store::Store& store, const VouchedPerson& person, const Mapping& mapping,
                              std::int64_t now_ms) {
  if (const std::string why = why_no_name(person.name); !why.empty())
    return fail(ErrorCode::refused, fmt::format("the provider gives no name that can be used here: it {}", why));
  const auto taken = is_taken(store, person.name);
  if (!taken) return std::unexpected(taken.error());
  if (*taken) {
    return refuse(store, person.name,
                  fmt::format("the name {} belongs to another account here: an administrator decides", person.name),
                  now_ms);
  }
  auto roles = roles_of(store, person, mapping);
  if (!roles) return std::unexpected(roles.error());
  if (!mapping.empty() && !*roles) return refuse(store, person.name, in_no_group(person.name), now_ms);
  const bool waits_for_admin = mapping.empty();
  const auto added = lift(store.users().add_of_provider(
      person.name, person.identity, roles->value_or(store::UserRoles{}), waits_for_admin, stamp(now_ms)));
  if (!added) return std::unexpected(added.error());
  if (waits_for_admin) return refuse(store, person.name, waits(person.name), now_ms);
  return person.name;
}

// Rights that the provider has taken away end at once, in sessions and tokens too.
Result<void> take_away(store::Store& store, const store::User& user, std::int64_t now_ms) {
  return lift(store.atomically([&]() -> store::Result<void> {
    const auto changed = store.users().change(user.name, user.revision, {}, stamp(now_ms));
    return changed ? store.users().end_sessions(user.name) : std::unexpected(changed.error());
  }));
}

Result<std::string> admit_known(store::Store& store, const store::User& user, const VouchedPerson& person,
                                const Mapping& mapping, std::int64_t now_ms) {
  if (user.disabled_at_ms != 0) return refuse(store, user.name, waits(user.name), now_ms);
  if (user.locked_until_ms > now_ms) {
    const std::int64_t wait_s = (user.locked_until_ms - now_ms) / 1000 + 1;
    return refuse(store, user.name, fmt::format("the account {} is locked: try again in {} s", user.name, wait_s),
                  now_ms);
  }
  if (mapping.empty()) return user.name;
  auto roles = roles_of(store, person, mapping);
  if (!roles) return std::unexpected(roles.error());
  if (!*roles) {
    if (auto taken = take_away(store, user, now_ms); !taken) return std::unexpected(taken.error());
    return refuse(store, user.name, in_no_group(user.name), now_ms);
  }
  if ((*roles)->role == user.roles.role && (*roles)->grants == user.roles.grants) return user.name;
  const auto changed = lift(store.users().change(user.name, user.revision, {.roles = **roles}, stamp(now_ms)));
  return changed ? Result<std::string>(user.name) : std::unexpected(changed.error());
}

}  // namespace

// A group at a provider may be a name with '=' in it, as of LDAP: the last one before a role counts.
Result<GroupRole> read_group_role(std::string_view text) {
  const std::size_t at = text.rfind('@');
  for (const std::string_view machines :
       {at == std::string_view::npos ? std::string_view() : text.substr(at + 1), std::string_view()}) {
    const std::string_view front = machines.empty() ? text : text.substr(0, at);
    const std::size_t equals = front.rfind('=');
    if (equals == std::string_view::npos || equals == 0) continue;
    const auto role = store::named<store::Role>(front.substr(equals + 1));
    if (role) return GroupRole{std::string(front.substr(0, equals)), *role, std::string(machines)};
  }
  return fail(ErrorCode::invalid, fmt::format("\"{}\": use GROUP=ROLE or GROUP=ROLE@MACHINES; roles are {}", text,
                                              fmt::join(store::kNames<store::Role>, ", ")));
}

Result<std::string> admit(store::Store& store, const VouchedPerson& person, const std::vector<GroupRole>& mapping,
                          std::int64_t now_ms) {
  const auto user = store.users().of_provider(person.identity);
  if (!user && user.error().code != store::ErrorCode::not_found) return std::unexpected(from_store(user.error()));
  auto name = user ? admit_known(store, *user, person, mapping, now_ms) : admit_new(store, person, mapping, now_ms);
  if (!name) return name;
  const store::AuditEntry entry{"user.sign-in", fmt::format("user/{}", *name), "by " + person.identity.issuer};
  const auto noted = store.audit().append(entry, {*name, now_ms});
  if (!noted) return std::unexpected(from_store(noted.error()));
  return name;
}

}  // namespace dripfeed::app
