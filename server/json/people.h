// Users, tokens, groups of machines, sessions and the audit, as the API takes and shows them.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "server/app/shop/sign_in.h"
#include "server/json/schemas.h"

namespace dripfeed::json {

// Either a token, or a name with a password or PIN.
struct SessionBody {
  std::string token;
  std::string name;
  store::SecretKind kind = store::SecretKind::password;
  std::string secret;
};
app::Result<SessionBody> read_session_body(std::string_view body);

// What an OpenID Connect provider sent back with the browser.
struct ProviderAnswerBody {
  std::string code;
  std::string state;
  std::string iss;
  std::string error;
};
app::Result<ProviderAnswerBody> read_provider_answer_body(std::string_view body);

struct UserBody {
  std::string name;
  store::UserRoles roles;
};
app::Result<UserBody> read_user_body(std::string_view body);
app::Result<store::UserChange> read_user_change_body(std::string_view body);

struct SecretBody {
  std::string secret;
};
app::Result<SecretBody> read_secret_body(std::string_view body);

struct OwnSecretBody {
  std::string current;
  std::string secret;
};
app::Result<OwnSecretBody> read_own_secret_body(std::string_view body);

// Its hash is empty. Words of its scope that are no scopes are not refused here.
app::Result<store::NewToken> read_token_body(std::string_view body);

struct GroupBody {
  std::vector<std::string> machines;
  std::optional<bool> four_eyes;  // nothing: as it is
  std::optional<bool> operator_sign_off;
};
app::Result<GroupBody> read_group_body(std::string_view body);

Schemas people_request_schemas();
Schemas people_schemas();

// Who calls.
struct SessionView {
  std::string_view name;
  std::string_view role;
  std::string_view by;                               // "token", "password", "pin", "provider"
  std::string_view scope;                            // "": everything
  std::map<std::string, std::string_view> machines;  // roles that differ, by machine
};
std::string session(const SessionView& session);
std::string sign_in_provider(std::string_view title);  // "": there is none
std::string provider_sign_in(std::string_view url);
std::string user(const store::User& user);
std::string token(const store::Token& token);
// With its secret, which is shown this once.
std::string new_token(const store::Token& token, std::string_view secret);
std::string machine_group(const store::MachineGroup& group);
std::string audit_row(const store::AuditRow& row);
// What audit_row() wrote. Errors: malformed, invalid.
app::Result<store::AuditRow> read_audit_row(std::string_view text);

}  // namespace dripfeed::json
