// Users, their secrets, tokens, groups of machines, and the audit.
#include <algorithm>

#include <fmt/format.h>

#include "server/app/base/names.h"
#include "server/app/shop/sign_in.h"
#include "server/http/api.h"
#include "server/http/handlers.h"
#include "server/http/list_response.h"
#include "server/http/rights.h"
#include "server/json/people.h"
#include "store/hash/hash.h"

namespace dripfeed::http {

namespace {

store::Store& store_of(const Call& call) { return call.api.application().store(); }

Response user_response(const store::Result<store::User>& user) {
  if (!user) return problem_response(app::from_store(user.error()));
  return with_revision(json_response(200, json::user(*user)), user->revision);
}

// An administrator who locks everybody out, by a slip, has only the command left.
bool gives_up_own_rights(const Call& call, const store::UserChange& change) {
  return call.parameters[0] == call.user && (change.disabled || change.roles.role != store::Role::admin);
}

Response change_secret(const Call& call, store::SecretKind kind, std::string_view secret) {
  const auto changed = app::set_secret(store_of(call), call.parameters[0], kind, secret, stamp_of(call));
  return changed ? no_content() : problem_response(changed.error());
}

Response new_secret(const Call& call, store::SecretKind kind) {
  const auto body = json::read_secret_body(call.request.body);
  if (!body) return problem_response(body.error());
  if (body->secret.empty()) return problem_response(422, "a secret must not be empty; DELETE takes it away");
  return change_secret(call, kind, body->secret);
}

}  // namespace

Response list_users(const Call& call) {
  const auto page = page_of(call.request);
  if (!page) return page.error();
  return list_response(store_of(call).users().list(*page), [](const store::User& user) { return json::user(user); });
}

Response add_user(const Call& call) {
  const auto body = json::read_user_body(call.request.body);
  if (!body) return problem_response(body.error());
  const auto added = store_of(call).users().add(body->name, body->roles, stamp_of(call));
  if (!added) return problem_response(app::from_store(added.error()));
  return with_revision(created("/api/v1/users/" + escape_segment(added->name), json::user(*added)), added->revision);
}

Response get_user(const Call& call) { return user_response(store_of(call).users().get(call.parameters[0])); }

Response change_user(const Call& call) {
  const auto revision = expected_revision(call.request);
  if (!revision) return revision.error();
  const auto body = json::read_user_change_body(call.request.body);
  if (!body) return problem_response(body.error());
  if (gives_up_own_rights(call, *body))
    return problem_response(409, "an admin cannot remove their own role of admin: ask another admin");
  return user_response(store_of(call).users().change(call.parameters[0], *revision, *body, stamp_of(call)));
}

Response unlock_user(const Call& call) {
  return user_response(store_of(call).users().unlock(call.parameters[0], stamp_of(call)));
}

Response set_password(const Call& call) { return new_secret(call, store::SecretKind::password); }
Response set_pin(const Call& call) { return new_secret(call, store::SecretKind::pin); }
Response remove_password(const Call& call) { return change_secret(call, store::SecretKind::password, ""); }
Response remove_pin(const Call& call) { return change_secret(call, store::SecretKind::pin, ""); }

Response change_own_password(const Call& call) {
  const auto body = json::read_own_secret_body(call.request.body);
  if (!body) return problem_response(body.error());
  app::Application& app = call.api.application();
  if (!app.store().users().get(call.user)) return problem_response(409, "a token of a program has no password");
  const auto answer =
      app::check_secret(app.store(), call.user, store::SecretKind::password, body->current, app.clock());
  if (!answer) return problem_response(answer.error());
  if (answer->outcome != app::SignIn::right) return problem_response(403, "the present password is wrong");
  const auto changed =
      app::set_secret(app.store(), call.user, store::SecretKind::password, body->secret, stamp_of(call));
  return changed ? no_content() : problem_response(changed.error());
}

Response list_tokens(const Call& call) {
  const auto page = page_of(call.request);
  if (!page) return page.error();
  return list_response(store_of(call).tokens().list(*page),
                       [](const store::Token& token) { return json::token(token); });
}

Response add_token(const Call& call) {
  auto body = json::read_token_body(call.request.body);
  if (!body) return problem_response(body.error());
  if (const auto word = unknown_scope(body->scope); !word.empty())
    return problem_response(422, fmt::format("\"{}\" is no scope: {}", word, fmt::join(kScopes, ", ")));
  const std::string secret = hash::random_token();
  body->hash = hash::token_hash(secret);
  const auto added = store_of(call).tokens().add(*body, stamp_of(call));
  if (!added) return problem_response(app::from_store(added.error()));
  Response response = created(fmt::format("/api/v1/tokens/{}", added->id), json::new_token(*added, secret));
  response.headers.emplace_back("Cache-Control", "no-store");
  return response;
}

Response get_token(const Call& call) {
  const auto id = id_of(call.parameters[0]);
  if (!id) return id.error();
  // The list goes by falling ids: the first one below the next id.
  const auto found = store_of(call).tokens().list({.limit = 1, .after = fmt::format("{}", *id + 1)});
  if (!found) return problem_response(app::from_store(found.error()));
  if (found->items.empty() || found->items.front().id != *id) return problem_response(404, "there is no such token");
  return json_response(200, json::token(found->items.front()));
}

Response revoke_token(const Call& call) {
  const auto id = id_of(call.parameters[0]);
  if (!id) return id.error();
  const auto revoked = store_of(call).tokens().revoke(*id, stamp_of(call));
  return revoked ? no_content() : problem_response(app::from_store(revoked.error()));
}

Response list_groups(const Call& call) {
  store::Page<store::MachineGroup> page;
  auto groups = store_of(call).users().groups();
  if (!groups) return problem_response(app::from_store(groups.error()));
  page.items = std::move(*groups);
  return list_response(store::Result<store::Page<store::MachineGroup>>(std::move(page)),
                       [](const store::MachineGroup& group) { return json::machine_group(group); });
}

Response put_group(const Call& call) {
  auto body = json::read_group_body(call.request.body);
  if (!body) return problem_response(body.error());
  store::MachineGroup group{.name = call.parameters[0], .machines = std::move(body->machines)};
  if (const std::string why = app::why_no_name(group.name); !why.empty())
    return problem_response(422, fmt::format("the name of a group {}", why));
  const auto known = store_of(call).users().groups();
  if (!known) return problem_response(app::from_store(known.error()));
  const auto before = std::ranges::find(*known, group.name, &store::MachineGroup::name);
  const store::MachineGroup as_it_is = before == known->end() ? store::MachineGroup{} : *before;
  group.four_eyes = body->four_eyes.value_or(as_it_is.four_eyes);
  group.operator_sign_off = body->operator_sign_off.value_or(as_it_is.operator_sign_off);
  const auto put = store_of(call).users().put_group(group, stamp_of(call));
  if (!put) return problem_response(app::from_store(put.error()));
  return json_response(200, json::machine_group(*put));
}

Response remove_group(const Call& call) {
  const auto removed = store_of(call).users().remove_group(call.parameters[0], stamp_of(call));
  return removed ? no_content() : problem_response(app::from_store(removed.error()));
}

Response list_audit(const Call& call) {
  const auto page = page_of(call.request);
  if (!page) return page.error();
  const auto span = span_of(call.request);
  if (!span) return span.error();
  const store::AuditFilter filter{.subject = query_text(call.request, "subject"),
                                  .actor = query_text(call.request, "actor"),
                                  .action = query_text(call.request, "action"),
                                  .from_ms = span->from_ms,
                                  .to_ms = span->to_ms};
  return list_response(store_of(call).audit().list(*page, filter),
                       [](const store::AuditRow& row) { return json::audit_row(row); });
}

}  // namespace dripfeed::http
