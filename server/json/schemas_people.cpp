// What people.cpp writes.
#include "server/json/people.h"

namespace dripfeed::json {

namespace {

Schema role_of(std::string about) { return one_of(store::kNames<store::Role>, std::move(about)); }

Members token_members() {
  return {{"id", integer("of this token")},
          {"name", text("of the person or program that has it")},
          {"role", role_of("what it may do: each role may do what those before it may")},
          {"user", or_null(text("whose rights it has, up to its role; null: a program's own"))},
          {"scope", list_of(text("library, checks, releases, queue, line or setup"),
                            "what it may change; empty: all that its role may")},
          {"created_by", text("who made it")},
          {"created_at_ms", time_ms("when")},
          {"expires_at_ms", or_null(time_ms("until then; null: it does not end"))},
          {"revoked_at_ms", or_null(time_ms("since then it is not valid"))}};
}

}  // namespace

Schemas people_schemas() {
  static constexpr std::string_view kBy[] = {"token", "password", "pin", "provider"};
  return {
      {"Session",
       object("who calls",
              {{"name", text("of the user, or of a program's token")},
               {"role", role_of("what the caller may do: each role may do what those before it may")},
               {"by", one_of(kBy, "what the caller signed in with")},
               {"scope", list_of(text("a word of a token's scope"), "what it may change; empty: all")},
               {"machines", map_of(role_of("on this machine"), "roles by machine, where they differ from \"role\"")}})},
      {"SignInProvider", object("an OpenID Connect provider that people may sign in by",
                                {{"title", or_null(text("its name for people; null: none is configured"))}})},
      {"ProviderSignIn", object("a sign-in that has begun", {{"url", text("of the provider: the browser opens it")}})},
      {"User",
       object("a person", {{"name", text("with which the person signs in")},
                           {"provider", or_null(text("issuer of the OpenID Connect provider that vouches for the "
                                                     "person; null: an account of this shop alone"))},
                           {"role", role_of("on machines of no granted group, and for all that belongs to no machine")},
                           {"grants", list_of(object("a role on the machines of a group",
                                                     {{"group", text("its name")}, {"role", role_of("there")}}),
                                              "roles by group")},
                           {"has_password", flag("may sign in with a password")},
                           {"has_pin", flag("may sign in with a PIN")},
                           {"failures", integer("refused sign-ins since the last one that was right")},
                           {"locked_until_ms", or_null(time_ms("no person can sign in as this user before then"))},
                           {"disabled_at_ms", or_null(time_ms("since then the user may not sign in"))},
                           {"revision", integer("of the roles")},
                           {"created_by", text("who added the user")},
                           {"created_at_ms", time_ms("when")}})},
      {"Token", object("a token, without its secret", token_members())},
      {"TokenMade", object("a new token", token_members() + Members{{"token", text("the secret; shown this once")}})},
      {"MachineGroup",
       object("machines that belong together; a machine is in one group at most",
              {{"name", text("of this group")},
               {"machines", list_of(text("name of a machine"), "in this group")},
               {"four_eyes", flag("whoever wrote or released a text may not approve it on these machines")},
               {"operator_sign_off",
                flag("a release is approved for these machines after an operator signed its proving off")}})},
      {"AuditRow", object("who did what to what, and when; each row holds the hash of the one before",
                          {{"seq", integer("1, 2, 3, …")},
                           {"at_ms", time_ms("when")},
                           {"actor", text("who did it")},
                           {"action", text("as \"machine.change\"")},
                           {"subject", text("as \"machine/mill-3\"")},
                           {"detail", text("words or a document")},
                           {"previous_hash", text("of the row before; empty in the first one")},
                           {"hash", text("SHA-256 of all other members")}})},
  };
}

}  // namespace dripfeed::json
