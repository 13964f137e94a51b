// Users, their secrets and sessions, groups of machines with the rights in them, and the second pair of eyes.
#include "tests/store/fixture.h"

namespace dripfeed::store_test {
namespace {

using namespace store;

class UserTest : public StoreTest {
 protected:
  Users& users() { return store_->users(); }
  User add(std::string_view name, UserRoles roles = {}) { return must(users().add(name, roles, by("anna"))); }
  bool is_there(std::string_view session) { return store_->browser_sessions().find(session).has_value(); }
};

TEST_F(UserTest, AreKeptWithTheirRoles) {
  must(store_->machines().add("mill-1", "{}", by("anna")));
  must(users().put_group({.name = "mills", .machines = {"mill-1"}}, by("anna")));
  add("olga", {.role = Role::viewer, .grants = {{"mills", Role::operator_}}});
  add("bert", {.role = Role::programmer});
  reopen({.own = true});
  const User olga = must(users().get("olga"));
  EXPECT_EQ(olga.roles.role, Role::viewer);
  EXPECT_EQ(olga.roles.grants, (std::vector<Grant>{{"mills", Role::operator_}}));
  EXPECT_EQ(olga.revision, 1U);
  EXPECT_EQ(olga.created_by, "anna");
  const Page<User> page = must(users().list({.limit = 1}));
  EXPECT_EQ(page.items.at(0).name, "bert");
  EXPECT_EQ(must(users().list({.limit = 1, .after = page.next})).items.at(0).roles.grants.size(), 1U);
  EXPECT_EQ(refusal(users().get("nobody")), ErrorCode::not_found);
  EXPECT_EQ(refusal(users().add("olga", {}, by("anna"))), ErrorCode::exists);
  EXPECT_EQ(refusal(users().add("", {}, by("anna"))), ErrorCode::invalid_value);
  EXPECT_EQ(refusal(users().add("carl", {.grants = {{"lathes", Role::admin}}}, by("anna"))),
            ErrorCode::broken_reference);
  EXPECT_EQ(refusal(users().get("carl")), ErrorCode::not_found) << "a half user was left";
}

TEST_F(UserTest, ChangeWithTheRevisionThatWasSeen) {
  add("olga");
  const User changed = must(users().change("olga", 1, {.roles = {.role = Role::approver}}, by("anna")));
  EXPECT_EQ(changed.roles.role, Role::approver);
  EXPECT_EQ(changed.revision, 2U);
  EXPECT_EQ(refusal(users().change("olga", 1, {}, by("anna"))), ErrorCode::stale_revision);
  EXPECT_EQ(refusal(users().change("nobody", 1, {}, by("anna"))), ErrorCode::not_found);
}

TEST_F(UserTest, DisablingEndsSessionsAndRights) {
  const User olga = add("olga", {.role = Role::operator_});
  must(store_->browser_sessions().open("s", {.user = "olga", .secret = SecretKind::pin}, 8, 50));
  const BrowserSession session = must(store_->browser_sessions().find("s"));
  EXPECT_FALSE(session.token.has_value());
  EXPECT_EQ(session.user_id, olga.id);
  EXPECT_EQ(session.secret, SecretKind::pin);
  must(users().change("olga", 1, {.roles = {.role = Role::operator_}, .disabled = true}, by("anna", 70)));
  EXPECT_FALSE(is_there("s"));
  EXPECT_EQ(refusal(users().rights(olga.id)), ErrorCode::not_found);
  EXPECT_EQ(store_->browser_sessions().open("t", {.user = "olga"}, 8, 80).error().code, ErrorCode::not_found);
  must(users().change("olga", 2, {.roles = {.role = Role::operator_}}, by("anna", 90)));
  EXPECT_FALSE(is_there("s")) << "it came back";
  EXPECT_EQ(must(users().rights(olga.id)).name, "olga");
}

TEST_F(UserTest, OfAProviderAreFoundByTheirSubjectAndKeepIt) {
  const ProviderIdentity olga{"https://login.shop", "s-1"};
  add("bert");
  const User added = must(users().add_of_provider("olga", olga, {.role = Role::operator_}, false, by("dripfeed")));
  EXPECT_EQ(added.issuer, "https://login.shop");
  EXPECT_FALSE(added.has_password);
  EXPECT_EQ(must(users().get("bert")).issuer, "");
  EXPECT_EQ(must(users().of_provider(olga)).name, "olga");
  EXPECT_EQ(refusal(users().of_provider({"https://login.shop", "s-2"})), ErrorCode::not_found);
  EXPECT_EQ(refusal(users().of_provider({"https://other.shop", "s-1"})), ErrorCode::not_found);
  EXPECT_EQ(refusal(users().of_provider({"", ""})), ErrorCode::not_found) << "an account of the shop";
  EXPECT_EQ(refusal(users().add_of_provider("carl", olga, {}, false, by("dripfeed"))), ErrorCode::exists);
  EXPECT_EQ(refusal(users().add_of_provider("bert", {"https://login.shop", "s-2"}, {}, false, by("dripfeed"))),
            ErrorCode::exists);
  EXPECT_EQ(refusal(users().add_of_provider("carl", {"https://login.shop", ""}, {}, false, by("dripfeed"))),
            ErrorCode::invalid_value);
  const User waits = must(users().add_of_provider("dora", {"https://login.shop", "s-3"}, {}, true, by("dripfeed", 70)));
  EXPECT_EQ(waits.disabled_at_ms, 70);
  must(store_->browser_sessions().open("s", {.user = "olga", .by_provider = true}, 8, 50));
  EXPECT_TRUE(must(store_->browser_sessions().find("s")).by_provider);
  must(users().end_sessions("olga"));
  EXPECT_FALSE(is_there("s"));
  EXPECT_EQ(refusal(users().end_sessions("carl")), ErrorCode::not_found);
  must(users().change("olga", 1, {.roles = {.role = Role::viewer}}, by("anna")));
  EXPECT_EQ(must(users().of_provider(olga)).name, "olga");
  EXPECT_EQ(must(store_->audit().list({}, {.subject = "user/olga"})).items.back().entry.detail,
            "operator, of https://login.shop");
}

TEST_F(UserTest, ASecretIsKeptAndANewOneEndsSessions) {
  add("olga");
  add("bert");
  must(store_->browser_sessions().open("o", {.user = "olga"}, 8, 50));
  must(store_->browser_sessions().open("b", {.user = "bert"}, 8, 50));
  must(users().set_secret("olga", SecretKind::password, "hash", by("anna")));
  EXPECT_FALSE(is_there("o"));
  EXPECT_TRUE(is_there("b")) << "another one's";
  EXPECT_EQ(must(users().secret("olga", SecretKind::password)), "hash");
  EXPECT_EQ(must(users().secret("olga", SecretKind::pin)), "");
  EXPECT_TRUE(must(users().get("olga")).has_password);
  EXPECT_FALSE(must(users().get("olga")).has_pin);
  const auto rows = must(store_->audit().list({}, {.subject = "user/olga"})).items;
  for (const AuditRow& row : rows) EXPECT_EQ(row.entry.detail.find("hash"), std::string::npos) << row.entry.detail;
}

TEST_F(UserTest, RefusalsAreCountedAndALockLastsUntilAPersonUnlocks) {
  add("olga");
  must(users().note_refusal("olga", 0, by("dripfeed", 10)));
  must(users().note_refusal("olga", 900, by("dripfeed", 20)));
  must(users().note_refusal("olga", 0, by("dripfeed", 30)));
  EXPECT_EQ(must(users().get("olga")).failures, 3U);
  EXPECT_EQ(must(users().get("olga")).locked_until_ms, 900);
  const User unlocked = must(users().unlock("olga", by("anna", 40)));
  EXPECT_EQ(unlocked.failures, 0U);
  EXPECT_EQ(unlocked.locked_until_ms, 0);
}

TEST_F(UserTest, RightsFollowTheGroupOfTheMachine) {
  for (const std::string_view machine : {"mill-1", "mill-2", "lathe"})
    must(store_->machines().add(machine, "{}", by("anna")));
  must(users().put_group({.name = "mills", .machines = {"mill-1", "mill-2"}}, by("anna")));
  const User olga = add("olga", {.role = Role::viewer, .grants = {{"mills", Role::operator_}}});
  const Rights rights = must(users().rights(olga.id));
  EXPECT_EQ(rights.role, Role::viewer);
  EXPECT_EQ(rights.on_machines,
            (std::map<std::string, Role, std::less<>>{{"mill-1", Role::operator_}, {"mill-2", Role::operator_}}));
  const store::MachineGroup turning{.name = "turning", .machines = {"mill-2", "lathe"}};
  EXPECT_EQ(refusal(users().put_group(turning, by("anna"))), ErrorCode::exists) << "mill-2 is in another group";
  EXPECT_EQ(must(users().groups()).size(), 1U) << "a half change was left";
  must(users().put_group({.name = "mills", .machines = {"mill-1"}}, by("anna")));
  must(users().put_group(turning, by("anna")));
  EXPECT_EQ(must(users().rights(olga.id)).on_machines.size(), 1U) << "mill-2 is in another group now";
  EXPECT_EQ(must(users().groups()).at(0).machines, std::vector<std::string>{"mill-1"});
  EXPECT_EQ(refusal(users().put_group({.name = "mills", .machines = {"nobody"}}, by("anna"))),
            ErrorCode::broken_reference);
  EXPECT_EQ(must(users().groups()).at(0).machines, std::vector<std::string>{"mill-1"}) << "a half change was left";
  ASSERT_TRUE(users().remove_group("mills", by("anna")));
  EXPECT_TRUE(must(users().rights(olga.id)).on_machines.empty());
  EXPECT_TRUE(must(users().get("olga")).roles.grants.empty());
  EXPECT_EQ(users().remove_group("mills", by("anna")).error().code, ErrorCode::not_found);
}

TEST_F(UserTest, TokensOfAUserNameIt) {
  const User olga = add("olga");
  must(store_->tokens().add({.name = "tablet", .hash = "h", .user = "olga", .scope = "queue", .expires_at_ms = 1099},
                            by("anna", 1000)));
  const Token found = must(store_->tokens().find("h"));
  EXPECT_EQ(found.user, "olga");
  EXPECT_EQ(found.user_id, olga.id);
  EXPECT_EQ(found.scope, "queue");
  EXPECT_EQ(found.expires_at_ms, 1099);
  EXPECT_EQ(refusal(store_->tokens().add({.name = "late", .hash = "j", .expires_at_ms = 1000}, by("anna", 1000))),
            ErrorCode::invalid_value);
  EXPECT_EQ(refusal(store_->tokens().add({.name = "x", .hash = "i", .user = "nobody"}, by("anna"))),
            ErrorCode::broken_reference);
}

TEST_F(UserTest, APersonAndATokenDoNotShareAName) {
  add("olga");
  EXPECT_EQ(refusal(store_->tokens().add({.name = "olga", .hash = "h"}, by("anna"))), ErrorCode::exists);
  must(store_->tokens().add({.name = "olga", .hash = "h", .user = "olga"}, by("anna")));
  const Token mes = must(store_->tokens().add({.name = "mes", .hash = "i"}, by("anna")));
  EXPECT_EQ(refusal(users().add("mes", {}, by("anna"))), ErrorCode::exists);
  must(store_->tokens().revoke(mes.id, by("anna")));
  must(users().add("mes", {}, by("anna")));
}

TEST_F(UserTest, TheLastAdminIsNotRevoked) {
  const Token first = must(store_->tokens().add({.name = "first", .role = Role::admin, .hash = "h"}, by("anna")));
  must(store_->tokens().add({.name = "over", .role = Role::admin, .hash = "i", .expires_at_ms = 5}, by("anna", 1)));
  add("boss", {.role = Role::admin});  // who has no password cannot sign in
  EXPECT_EQ(refusal(store_->tokens().revoke(first.id, by("anna", 9))), ErrorCode::refused_transition);
  must(store_->tokens().add({.name = "second", .role = Role::admin, .hash = "j"}, by("anna")));
  must(store_->tokens().revoke(first.id, by("anna", 9)));
}

TEST_F(UserTest, ACopyOfATextHasItsAuthorsToo) {
  must(store_->machines().add("mill-1", "{}", by("boss")));
  const Program program = add_program(*store_, "%\nM30\n%\n");
  const std::string author = program.newest.created_by;
  store::NewProgramText again;
  again.sha256 = program.newest.sha256;
  again.blocks = 1;
  const Program copy = must(store_->programs().add("COPY", "fanuc", again, by("carl")));
  must(store_->verdicts().add({copy.id, 1, "mill-1", 1, Delivery::drip, Outcome::pass, ""}, by("checker")));
  must(users().put_group({.name = "mills", .machines = {"mill-1"}, .four_eyes = true}, by("boss")));
  const Release release = must(store_->releases().add({copy.id, 1, "mill-1", Delivery::drip}, by("dora")));
  const auto move = [&](ReleaseState to, const std::string& who) {
    return store_->releases().move(release.id, {to, "good", 1}, by(who));
  };
  must(move(ReleaseState::in_review, "carl"));
  for (const std::string& who : {author, std::string("carl"), std::string("dora")})
    EXPECT_EQ(refusal(move(ReleaseState::proving, who)), ErrorCode::four_eyes) << who;
  must(move(ReleaseState::proving, "bert"));
}

TEST_F(UserTest, WhoWroteAFamilyWroteWhatIsRenderedFromIt) {
  must(store_->machines().add("mill-1", "{}", by("boss")));
  must(store_->families().add("roll", "family roll\n", by("fred")));
  const Program program = add_rendered(*store_, "%\nM30\n%\n", "mill-1");
  const auto verdict =
      must(store_->verdicts().add({program.id, 1, "mill-1", 1, Delivery::drip, Outcome::warn, ""}, by("checker")));
  must(users().put_group({.name = "mills", .machines = {"mill-1"}, .four_eyes = true}, by("boss")));
  EXPECT_EQ(refusal(store_->verdicts().waive(verdict.id, {.reason = "known"}, by("fred"))), ErrorCode::four_eyes);
  must(store_->verdicts().waive(verdict.id, {.reason = "known"}, by("bert")));
}

TEST_F(UserTest, WhoWroteATextDoesNotApproveItWhereFourEyesAreWanted) {
  must(store_->machines().add("mill-1", "{}", by("boss")));
  const Program program = add_program(*store_, "%\nM30\n%\n");
  const std::string author = program.newest.created_by;
  const auto verdict =
      must(store_->verdicts().add({program.id, 1, "mill-1", 1, Delivery::drip, Outcome::warn, ""}, by("checker")));
  must(users().put_group({.name = "mills", .machines = {"mill-1"}, .four_eyes = true, .operator_sign_off = false},
                         by("boss")));
  EXPECT_EQ(refusal(store_->verdicts().waive(verdict.id, {.reason = "known"}, by(author))), ErrorCode::four_eyes);
  must(store_->verdicts().waive(verdict.id, {.reason = "known"}, by("bert")));
  const Release release = must(store_->releases().add({program.id, 1, "mill-1", Delivery::drip}, by("dora")));
  const auto move = [&](ReleaseState to, const std::string& who) {
    return store_->releases().move(release.id, {to, "the first part is good", 1}, by(who));
  };
  must(move(ReleaseState::in_review, author));
  EXPECT_EQ(refusal(move(ReleaseState::proving, author)), ErrorCode::four_eyes) << "it is sent from then on";
  must(move(ReleaseState::proving, "bert"));
  EXPECT_EQ(refusal(move(ReleaseState::approved, author)), ErrorCode::four_eyes);
  EXPECT_EQ(refusal(move(ReleaseState::approved, "dora")), ErrorCode::four_eyes) << "who made the release";
  EXPECT_EQ(must(store_->releases().get(release.id)).state, ReleaseState::proving);
  EXPECT_EQ(must(move(ReleaseState::approved, "bert")).approved_by, "bert");
}

}  // namespace
}  // namespace dripfeed::store_test
