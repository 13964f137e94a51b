// People: their names, roles and secrets, and the groups of machines in which a person's role is another one. Secrets
// come hashed (hash/password.h); the store never sees a password.
#pragma once

#include <map>
#include <optional>
#include <vector>

#include "store/basics.h"
#include "store/error.h"
#include "store/tokens.h"

namespace dripfeed::store {

// What a person signs in with.
enum class SecretKind : std::uint8_t { password, pin };
template <>
inline constexpr std::array<std::string_view, 2> kNames<SecretKind>{"password", "pin"};

// The role on the machines of one group; it stands instead of the user's own role.
struct Grant {
  std::string group;
  Role role = Role::viewer;
  friend bool operator==(const Grant&, const Grant&) = default;
};

struct UserRoles {
  Role role = Role::viewer;     // on machines of no group, and for all that belongs to no machine
  std::vector<Grant> grants{};  // by group
};

// A person as an OpenID Connect provider knows them: the subject is never given to another one.
struct ProviderIdentity {
  std::string issuer;
  std::string subject;
};

struct User {
  Id id = 0;
  std::string name;
  std::string issuer;  // of the provider that vouches for this user; "": an account of this shop alone
  UserRoles roles;
  bool has_password = false;
  bool has_pin = false;
  std::uint32_t failures = 0;        // refused sign-ins since the last one that was right
  std::int64_t locked_until_ms = 0;  // 0: never was
  std::int64_t disabled_at_ms = 0;   // 0: may sign in
  Revision revision = 0;             // of name, roles and disabled_at_ms
  std::string created_by;
  std::int64_t created_at_ms = 0;
};

struct UserChange {
  UserRoles roles{};
  bool disabled = false;
};

// What a user may do now.
struct Rights {
  std::string name;
  Role role = Role::viewer;
  std::map<std::string, Role, std::less<>> on_machines;  // those of the groups that were granted
};

// Some machines that belong together. A machine is in one group at most.
struct MachineGroup {
  std::string name;
  std::vector<std::string> machines;  // by name
  bool four_eyes = false;             // who wrote or released a text must not approve it
  bool operator_sign_off = true;      // an operator signs each proving off before it is approved
};

class Users : public Repository {
 public:
  // Errors: exists (the name), invalid_value (empty name), broken_reference (a group that is not there).
  virtual Result<User> add(std::string_view name, const UserRoles& roles, const Stamp& by) = 0;
  // The same without a secret, for whom a provider vouches; `disabled`: an administrator has to let them in first.
  // Errors: exists (the name, or this identity), invalid_value (an empty part).
  virtual Result<User> add_of_provider(std::string_view name, const ProviderIdentity& identity, const UserRoles& roles,
                                       bool disabled, const Stamp& by) = 0;
  // Errors: not_found.
  virtual Result<User> of_provider(const ProviderIdentity& identity) = 0;
  // Each session of the user. Errors: not_found.
  virtual Result<void> end_sessions(std::string_view name) = 0;
  // Disabling ends the sessions of the user. Errors: not_found, stale_revision, broken_reference.
  virtual Result<User> change(std::string_view name, Revision expected, const UserChange& change, const Stamp& by) = 0;
  // "" takes the secret away. The user's sessions end, and a lock with them. Errors: not_found.
  virtual Result<User> set_secret(std::string_view name, SecretKind kind, std::string_view secret_hash,
                                  const Stamp& by) = 0;
  // The hash, "" where there is none. Errors: not_found.
  virtual Result<std::string> secret(std::string_view name, SecretKind kind) = 0;
  // Counts a refused sign-in; `locked_until_ms`: 0 does not lock.
  virtual Result<void> note_refusal(std::string_view name, std::int64_t locked_until_ms, const Stamp& by) = 0;
  // Forgets refusals and lock.
  virtual Result<User> unlock(std::string_view name, const Stamp& by) = 0;
  // Errors: not_found.
  virtual Result<User> get(std::string_view name) = 0;
  // By name.
  virtual Result<Page<User>> list(const PageRequest& page) = 0;
  // Errors: not_found (none, or disabled).
  virtual Result<Rights> rights(Id user) = 0;

  // Makes the group, or makes it what is given; a machine leaves the group that it was in. Errors: invalid_value,
  // broken_reference (a machine that is not there).
  virtual Result<MachineGroup> put_group(const MachineGroup& group, const Stamp& by) = 0;
  // Its machines are in none then, and its grants are gone. Errors: not_found.
  virtual Result<void> remove_group(std::string_view name, const Stamp& by) = 0;
  // By name.
  virtual Result<std::vector<MachineGroup>> groups() = 0;
};

}  // namespace dripfeed::store
