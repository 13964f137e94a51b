// People as the API takes and shows them. One function reads each body and describes it; a secret is in no answer but
// that of a new token.
#include "server/json/people.h"

#include <algorithm>

#include <fmt/format.h>

#include "server/app/base/names.h"
#include "server/json/bodies.h"
#include "server/json/parse.h"

namespace dripfeed::json {

namespace {

// What it is signed in with has to be one thing, and only a person's secret has a name next to it.
void read_members(ObjectReader& o, SessionBody& into) {
  std::string password;
  std::string pin;
  const bool by_token = o.has("token");
  const int given = (by_token ? 1 : 0) + (o.has("password") ? 1 : 0) + (o.has("pin") ? 1 : 0);
  o.text("token", into.token, by_token);
  o.text("name", into.name);
  o.text("password", password, o.has("password"));
  o.text("pin", pin, o.has("pin"));
  if (given != 1) {
    o.fault("token", "or a name with a password or pin: one of the three");
  } else if (by_token && o.has("name")) {
    o.fault("name", "belongs to a password or pin");
  } else if (!by_token && !o.has("name")) {
    o.fault("name", "is missing");
  }
  into.kind = pin.empty() ? store::SecretKind::password : store::SecretKind::pin;
  into.secret = pin.empty() ? std::move(password) : std::move(pin);
}

void read_members(ObjectReader& o, ProviderAnswerBody& into) {
  o.text("code", into.code);
  o.text("state", into.state, true);
  o.text("iss", into.iss);
  o.text("error", into.error);
}

void read_role(ObjectReader& o, store::Role& into) {
  if (const auto role = o.choice("role", store::kNames<store::Role>, true)) into = static_cast<store::Role>(*role);
}

void read_roles(ObjectReader& o, store::UserRoles& into) {
  read_role(o, into.role);
  o.objects("grants", [&](ObjectReader& grant) {
    store::Grant& one = into.grants.emplace_back();
    grant.text("group", one.group, true);
    read_role(grant, one.role);
    for (std::size_t i = 0; i + 1 < into.grants.size(); ++i)
      if (!one.group.empty() && into.grants[i].group == one.group) grant.fault("group", "is given twice");
  });
}

void read_members(ObjectReader& o, UserBody& into) {
  o.proper_name("name", into.name);
  read_roles(o, into.roles);
}

void read_members(ObjectReader& o, store::UserChange& into) {
  read_roles(o, into.roles);
  o.flag("disabled", into.disabled);
}

void read_members(ObjectReader& o, SecretBody& into) { o.text("secret", into.secret, true); }

void read_members(ObjectReader& o, OwnSecretBody& into) {
  o.text("current", into.current, true);
  o.text("secret", into.secret, true);
}

// Texts of a list, each checked by `why`. `if_empty`: the fault of a list that is given and has none; "": it is fine.
template <class Why>
std::vector<std::string> read_texts(ObjectReader& o, std::string_view name, std::string about, const Why& why,
                                    std::string_view if_empty = "") {
  constexpr std::size_t kMost = 1000;
  std::vector<std::string> texts;
  const Document* list = o.member(name, list_of(text(std::move(about)), ""));
  if (list == nullptr) return texts;
  if (!list->is_array() || list->size() > kMost) {
    o.fault(name, fmt::format("must be a list of {} texts at most", kMost));
    return texts;
  }
  if (list->empty() && !if_empty.empty()) o.fault(name, std::string(if_empty));
  for (const Document& one : *list) {
    texts.push_back(one.is_string() ? one.get<std::string>() : std::string());
    if (const std::string fault = why(texts.back()); !fault.empty()) o.fault(name, "has a text that " + fault);
  }
  return texts;
}

void read_members(ObjectReader& o, store::NewToken& into) {
  o.proper_name("name", into.name);
  read_role(o, into.role);
  o.text("user", into.user);
  // No token may change everything because a list came out empty.
  const std::string_view if_empty = "names nothing: leave it out for a token that may change all that its role may";
  for (const std::string& word : read_texts(o, "scope", "what it may change", app::why_no_name, if_empty)) {
    into.scope += into.scope.empty() ? "" : " ";
    into.scope += word;
  }
  o.integer("expires_at_ms", into.expires_at_ms, 1, kMaxId);
}

void read_members(ObjectReader& o, GroupBody& into) {
  into.machines = read_texts(o, "machines", "name of a machine", app::why_no_name);
  if (!o.has("machines")) o.fault("machines", "is missing: state all machines of the group");
  bool four_eyes = false;
  o.flag("four_eyes", four_eyes);
  if (o.has("four_eyes")) into.four_eyes = four_eyes;
  bool operator_sign_off = true;
  o.flag("operator_sign_off", operator_sign_off);
  if (o.has("operator_sign_off")) into.operator_sign_off = operator_sign_off;
}

void read_members(ObjectReader& o, store::AuditRow& into) {
  o.integer("seq", into.seq, 1, kMaxId, true);
  o.integer("at_ms", into.by.at_ms, -kMaxId, kMaxId, true);
  o.text("actor", into.by.actor, true);
  o.text("action", into.entry.action, true);
  o.text("subject", into.entry.subject, true);
  o.text("detail", into.entry.detail);
  o.text("previous_hash", into.previous_hash);
  o.text("hash", into.hash, true);
}

}  // namespace

app::Result<SessionBody> read_session_body(std::string_view body) { return read_by<SessionBody>(read_members, body); }
app::Result<ProviderAnswerBody> read_provider_answer_body(std::string_view body) {
  return read_by<ProviderAnswerBody>(read_members, body);
}
app::Result<UserBody> read_user_body(std::string_view body) { return read_by<UserBody>(read_members, body); }
app::Result<store::UserChange> read_user_change_body(std::string_view body) {
  return read_by<store::UserChange>(read_members, body);
}
app::Result<SecretBody> read_secret_body(std::string_view body) { return read_by<SecretBody>(read_members, body); }
app::Result<OwnSecretBody> read_own_secret_body(std::string_view body) {
  return read_by<OwnSecretBody>(read_members, body);
}
app::Result<store::NewToken> read_token_body(std::string_view body) {
  return read_by<store::NewToken>(read_members, body);
}
app::Result<GroupBody> read_group_body(std::string_view body) { return read_by<GroupBody>(read_members, body); }
app::Result<store::AuditRow> read_audit_row(std::string_view text) {
  return read_by<store::AuditRow>(read_members, text);
}

Schemas people_request_schemas() {
  return {
      described<SessionBody>("NewSession", read_members, "who signs in: a token, or a name with a password or PIN"),
      described<ProviderAnswerBody>("ProviderAnswer", read_members,
                                    "what the provider added to the address at which the browser came back"),
      described<UserBody>("NewUser", read_members, "a person"),
      described<store::UserChange>("UserChange", read_members, "all roles of a user, and whether the user is disabled"),
      described<SecretBody>("NewSecret", read_members, "a new password or PIN"),
      described<OwnSecretBody>("OwnSecret", read_members, "the present password and a new one"),
      described<store::NewToken>("NewToken", read_members,
                                 "a token: of a user or of a program; \"scope\" limits what it may change"),
      described<GroupBody>(
          "GroupChange", read_members,
          "all machines of a group, none of which is in another one, and its rules; a rule that is not given stays"),
  };
}

namespace {

Document words_of(std::string_view list) {
  Document words = Document::array();
  while (!list.empty()) {
    const std::string_view word = list.substr(0, list.find(' '));
    if (!word.empty()) words.push_back(word);
    list.remove_prefix(std::min(list.size(), word.size() + 1));
  }
  return words;
}

Document grants_document(const store::UserRoles& roles) {
  Document grants = Document::array();
  for (const store::Grant& grant : roles.grants)
    grants.push_back({{"group", grant.group}, {"role", store::name_of(grant.role)}});
  return grants;
}

Document token_document(const store::Token& token) {
  return {{"id", token.id},
          {"name", token.name},
          {"role", store::name_of(token.role)},
          {"user", text_or_null(token.user)},
          {"scope", words_of(token.scope)},
          {"created_by", token.created_by},
          {"created_at_ms", token.created_at_ms},
          {"expires_at_ms", time_or_null(token.expires_at_ms)},
          {"revoked_at_ms", time_or_null(token.revoked_at_ms)}};
}

}  // namespace

std::string session(const SessionView& session) {
  Document machines = Document::object();
  for (const auto& [machine, role] : session.machines) machines[machine] = role;
  return dump({{"name", session.name},
               {"role", session.role},
               {"by", session.by},
               {"scope", words_of(session.scope)},
               {"machines", std::move(machines)}});
}

std::string sign_in_provider(std::string_view title) { return dump({{"title", text_or_null(title)}}); }

std::string provider_sign_in(std::string_view url) { return dump({{"url", url}}); }

std::string user(const store::User& user) {
  return dump({{"name", user.name},
               {"provider", text_or_null(user.issuer)},
               {"role", store::name_of(user.roles.role)},
               {"grants", grants_document(user.roles)},
               {"has_password", user.has_password},
               {"has_pin", user.has_pin},
               {"failures", user.failures},
               {"locked_until_ms", time_or_null(user.locked_until_ms)},
               {"disabled_at_ms", time_or_null(user.disabled_at_ms)},
               {"revision", user.revision},
               {"created_by", user.created_by},
               {"created_at_ms", user.created_at_ms}});
}

std::string token(const store::Token& token) { return dump(token_document(token)); }

std::string new_token(const store::Token& token, std::string_view secret) {
  Document document = token_document(token);
  document["token"] = secret;
  return dump(document);
}

std::string machine_group(const store::MachineGroup& group) {
  Document machines = Document::array();
  for (const std::string& machine : group.machines) machines.push_back(machine);
  return dump({{"name", group.name},
               {"machines", std::move(machines)},
               {"four_eyes", group.four_eyes},
               {"operator_sign_off", group.operator_sign_off}});
}

std::string audit_row(const store::AuditRow& row) {
  return dump({{"seq", row.seq},
               {"at_ms", row.by.at_ms},
               {"actor", row.by.actor},
               {"action", row.entry.action},
               {"subject", row.entry.subject},
               {"detail", row.entry.detail},
               {"previous_hash", row.previous_hash},
               {"hash", row.hash}});
}

}  // namespace dripfeed::json
