// People whom an OpenID Connect provider vouches for: which account is theirs, and what they may do. Without a mapping
// of groups an administrator lets a new one in; with a mapping the provider's groups give the roles at each sign-in.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "server/app/base/error.h"
#include "store/store.h"

namespace dripfeed::app {

// Who is in `group` at the provider has the role: everywhere, or on the machines of one group of this shop.
struct GroupRole {
  std::string group;
  store::Role role = store::Role::viewer;
  std::string machines;  // "": everywhere
};
// "GROUP=ROLE" or "GROUP=ROLE@MACHINES". Errors: invalid, as the end of a sentence.
Result<GroupRole> read_group_role(std::string_view text);

struct VouchedPerson {
  store::ProviderIdentity identity;
  std::string name;
  std::vector<std::string> groups;  // at the provider
};

// The name of the account, which is there and may sign in; its roles are those of the mapping where there is one. A
// sign-in and its refusal leave a row in the audit. Errors: refused: the name is another account's or no name, the
// account waits for an administrator or is disabled, is locked, no group gives a role; and those of the store.
Result<std::string> admit(store::Store& store, const VouchedPerson& person, const std::vector<GroupRole>& mapping,
                          std::int64_t now_ms);

}  // namespace dripfeed::app
