// dripfeed user: who may sign in, as what, and with which secret. It works on the store of a server, which may run
// meanwhile and sees the change with its next request. Secrets are read from standard input, never from the command
// line, where others can see them.
#include <iostream>
#include <memory>
#include <string>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <termios.h>
#include <unistd.h>

#include "server/app/base/error.h"
#include "server/app/base/names.h"
#include "server/app/shop/sign_in.h"
#include "server/cli/cli.h"
#include "server/cli/open_store.h"
#include "server/cli/output.h"
#include "server/io/steady_clock.h"

namespace dripfeed::cli {

namespace {

struct UserOptions {
  std::string data = "data";
  std::string store{};
  std::string name;
  std::string role = "viewer";
  std::vector<std::string> grants;  // "mills=operator"
  bool takes_away = false;
};

using Work = app::Result<void> (*)(store::Store& store, const UserOptions& options, const store::Stamp& by);

app::Result<store::Role> role_named(std::string_view name) {
  if (const auto role = store::named<store::Role>(name)) return *role;
  return app::fail(app::ErrorCode::invalid,
                   fmt::format("the role \"{}\" is none of {}", name, fmt::join(store::kNames<store::Role>, ", ")));
}

app::Result<store::UserRoles> roles_of(const UserOptions& options) {
  store::UserRoles roles;
  const auto role = role_named(options.role);
  if (!role) return std::unexpected(role.error());
  roles.role = *role;
  for (const std::string& grant : options.grants) {
    const std::size_t equals = grant.rfind('=');
    if (equals == std::string::npos)
      return app::fail(app::ErrorCode::invalid, fmt::format("\"{}\" is not GROUP=ROLE", grant));
    const auto there = role_named(std::string_view(grant).substr(equals + 1));
    if (!there) return std::unexpected(there.error());
    roles.grants.push_back({grant.substr(0, equals), *there});
  }
  return roles;
}

app::Result<void> add_one(store::Store& store, const UserOptions& options, const store::Stamp& by) {
  if (const std::string why = app::why_no_name(options.name); !why.empty())
    return app::fail(app::ErrorCode::invalid, fmt::format("the name of a user {}", why));
  const auto roles = roles_of(options);
  if (!roles) return std::unexpected(roles.error());
  const auto added = app::lift(store.users().add(options.name, *roles, by));
  if (!added) return std::unexpected(added.error());
  fmt::print(stderr, "{} is added as {}; give a password next: dripfeed user password {}\n", added->name, options.role,
             added->name);
  return {};
}

std::string grants_of(const store::User& user) {
  std::string text;
  for (const store::Grant& grant : user.roles.grants)
    text += fmt::format(" {}={}", grant.group, store::name_of(grant.role));
  return text;
}

app::Result<void> list_users(store::Store& store, const UserOptions& /*options*/, const store::Stamp& by) {
  store::PageRequest page{.limit = store::kPageLimitMax, .after = {}};
  do {
    const auto users = app::lift(store.users().list(page));
    if (!users) return std::unexpected(users.error());
    for (const store::User& user : users->items) {
      fmt::print("{:10}  {:8}  {:8} {:3}  {}{}{}\n", store::name_of(user.roles.role),
                 user.disabled_at_ms != 0          ? "disabled"
                 : user.locked_until_ms > by.at_ms ? "locked"
                                                   : "enabled",
                 user.has_password ? "password" : "", user.has_pin ? "pin" : "", user.name, grants_of(user),
                 user.issuer.empty() ? "" : fmt::format("  signs in by {}", user.issuer));
    }
    page.after = users->next;
  } while (!page.after.empty());
  return {};
}

app::Result<void> change_roles(store::Store& store, const UserOptions& options, const store::Stamp& by) {
  const auto roles = roles_of(options);
  if (!roles) return std::unexpected(roles.error());
  const auto user = app::lift(store.users().get(options.name));
  if (!user) return std::unexpected(user.error());
  const auto changed = app::lift(
      store.users().change(options.name, user->revision, {.roles = *roles, .disabled = user->disabled_at_ms != 0}, by));
  return changed ? app::Result<void>{} : std::unexpected(changed.error());
}

app::Result<void> set_disabled(store::Store& store, const UserOptions& options, const store::Stamp& by, bool disabled) {
  const auto user = app::lift(store.users().get(options.name));
  if (!user) return std::unexpected(user.error());
  const auto changed =
      app::lift(store.users().change(options.name, user->revision, {.roles = user->roles, .disabled = disabled}, by));
  return changed ? app::Result<void>{} : std::unexpected(changed.error());
}

app::Result<void> disable(store::Store& store, const UserOptions& options, const store::Stamp& by) {
  return set_disabled(store, options, by, true);
}
app::Result<void> enable(store::Store& store, const UserOptions& options, const store::Stamp& by) {
  return set_disabled(store, options, by, false);
}

app::Result<void> unlock(store::Store& store, const UserOptions& options, const store::Stamp& by) {
  const auto user = app::lift(store.users().unlock(options.name, by));
  return user ? app::Result<void>{} : std::unexpected(user.error());
}

// A terminal that shows nothing of what is typed, as long as this lives.
class Unseen {
 public:
  Unseen() : is_terminal_(::tcgetattr(STDIN_FILENO, &before_) == 0) {
    if (!is_terminal_) return;
    termios silent = before_;
    silent.c_lflag &= ~static_cast<tcflag_t>(ECHO);
    ::tcsetattr(STDIN_FILENO, TCSAFLUSH, &silent);
  }
  Unseen(const Unseen&) = delete;
  Unseen& operator=(const Unseen&) = delete;
  ~Unseen() {
    if (!is_terminal_) return;
    ::tcsetattr(STDIN_FILENO, TCSAFLUSH, &before_);
    fmt::print(stderr, "\n");
  }
  [[nodiscard]] bool is_terminal() const { return is_terminal_; }

 private:
  termios before_{};
  bool is_terminal_;
};

app::Result<std::string> read_secret(std::string_view what, std::string_view user) {
  const Unseen unseen;
  if (unseen.is_terminal()) fmt::print(stderr, "new {} of {}: ", what, user);
  std::string secret;
  if (!std::getline(std::cin, secret) || secret.empty())
    return app::fail(app::ErrorCode::invalid, fmt::format("no {} on standard input", what));
  return secret;
}

app::Result<void> change_secret(store::Store& store, const UserOptions& options, const store::Stamp& by,
                                store::SecretKind kind) {
  std::string secret;
  if (!options.takes_away) {
    auto read = read_secret(store::name_of(kind), options.name);
    if (!read) return std::unexpected(read.error());
    secret = std::move(*read);
  }
  const auto changed = app::set_secret(store, options.name, kind, secret, by);
  return changed ? app::Result<void>{} : std::unexpected(changed.error());
}

app::Result<void> set_password(store::Store& store, const UserOptions& options, const store::Stamp& by) {
  return change_secret(store, options, by, store::SecretKind::password);
}
app::Result<void> set_pin(store::Store& store, const UserOptions& options, const store::Stamp& by) {
  return change_secret(store, options, by, store::SecretKind::pin);
}

// Only a store that is there: a wrong folder must not become a new one.
int on_store(const UserOptions& options, Work work) {
  const auto store = app::lift(open_existing({.data = options.data, .url = options.store}));
  if (!store) {
    print_error(store.error());
    return kWrongUse;
  }
  const auto done = work(**store, options, {"dripfeed user", io::SteadyClock().wall_ms()});
  if (!done) {
    print_error(done.error());
    return kWrongUse;
  }
  return kDone;
}

}  // namespace

void add_user(CLI::App& app, int& exit_code) {
  CLI::App* command = app.add_subcommand("user", "people who sign in: add, roles, password, pin, disable, list");
  command->require_subcommand(1);
  const auto options = std::make_shared<UserOptions>();
  const auto action = [&](const char* name, const char* summary, Work work, bool of_one = true) {
    CLI::App* one = command->add_subcommand(name, summary);
    if (of_one) one->add_option("name", options->name, "of the person")->required();
    one->add_option("--data", options->data, "folder of the store")->capture_default_str();
    one->add_option("--store", options->store, kStoreOption);
    one->callback([options, work, &exit_code] { exit_code = on_store(*options, work); });
    return one;
  };
  const auto roles = [&](CLI::App* one) {
    one->add_option("--role", options->role, "viewer, operator, programmer, approver or admin")->capture_default_str();
    one->add_option("--grant", options->grants, "GROUP=ROLE: the role on the machines of that group");
  };
  const auto secret = [&](CLI::App* one) { one->add_flag("--remove", options->takes_away, "take it away instead"); };
  roles(action("add", "a new person", add_one));
  roles(action("roles", "all roles of a person, in place of the present ones", change_roles));
  secret(action("password", "a new password, read from standard input; ends the person's sessions", set_password));
  secret(action("pin", "a new PIN for the shop floor, read from standard input; ends the person's sessions", set_pin));
  action("disable", "ends all sessions; the person can no longer sign in", disable);
  action("enable", "the person may sign in again", enable);
  action("unlock", "ends the lock after too many wrong secrets", unlock);
  action("list", "all people, by name", list_users, false);
}

}  // namespace dripfeed::cli
