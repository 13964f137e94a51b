// Users and groups of machines in the database.
#pragma once

#include "store/sql/database.h"
#include "store/users.h"

namespace dripfeed::sql {

class UserTable final : public store::Users {
 public:
  explicit UserTable(Database& database) : database_(database) {}
  store::Result<store::User> add(std::string_view name, const store::UserRoles& roles, const store::Stamp& by) override;
  store::Result<store::User> add_of_provider(std::string_view name, const store::ProviderIdentity& identity,
                                             const store::UserRoles& roles, bool disabled,
                                             const store::Stamp& by) override;
  store::Result<store::User> of_provider(const store::ProviderIdentity& identity) override;
  store::Result<void> end_sessions(std::string_view name) override;
  store::Result<store::User> change(std::string_view name, store::Revision expected, const store::UserChange& change,
                                    const store::Stamp& by) override;
  store::Result<store::User> set_secret(std::string_view name, store::SecretKind kind, std::string_view secret_hash,
                                        const store::Stamp& by) override;
  store::Result<std::string> secret(std::string_view name, store::SecretKind kind) override;
  store::Result<void> note_refusal(std::string_view name, std::int64_t locked_until_ms,
                                   const store::Stamp& by) override;
  store::Result<store::User> unlock(std::string_view name, const store::Stamp& by) override;
  store::Result<store::User> get(std::string_view name) override;
  store::Result<store::Page<store::User>> list(const store::PageRequest& page) override;
  store::Result<store::Rights> rights(store::Id user) override;
  store::Result<store::MachineGroup> put_group(const store::MachineGroup& group, const store::Stamp& by) override;
  store::Result<void> remove_group(std::string_view name, const store::Stamp& by) override;
  store::Result<std::vector<store::MachineGroup>> groups() override;

 private:
  Database& database_;
};

// Inside a transaction: whether whoever wrote or released a text may not approve it for this machine.
bool needs_four_eyes(Session& session, std::string_view machine);
// Also of a machine without a group.
bool needs_operator_sign_off(Session& session, std::string_view machine);

}  // namespace dripfeed::sql
