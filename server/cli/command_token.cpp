// dripfeed token: who may do what. It works on the store of a server, which may run meanwhile and sees the change with
// its next request. Only hashes are kept: a token is shown once, when it is made.
#include <cstdio>
#include <memory>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "server/app/base/error.h"
#include "server/app/base/names.h"
#include "server/cli/cli.h"
#include "server/cli/open_store.h"
#include "server/cli/output.h"
#include "server/http/rights.h"
#include "server/io/steady_clock.h"
#include "store/hash/hash.h"

namespace dripfeed::cli {

namespace {

struct TokenOptions {
  std::string data = "data";
  std::string store{};
  std::string name;
  std::string role;
  std::string user;
  std::vector<std::string> scope;
  std::uint32_t days = 0;  // 0: it does not end
  store::Id id = 0;
};

using Work = store::Result<void> (*)(store::Store& store, const TokenOptions& options, const store::Stamp& by);

store::Result<void> add_one(store::Store& store, const TokenOptions& options, const store::Stamp& by) {
  if (const std::string why = app::why_no_name(options.name); !why.empty())
    return std::unexpected(store::Error{store::ErrorCode::invalid_value, fmt::format("the name of a token {}", why)});
  const std::string token = hash::random_token();
  const auto role = store::named<store::Role>(options.role);
  if (!role) {
    return std::unexpected(store::Error{
        store::ErrorCode::invalid_value,
        fmt::format("the role \"{}\" is none of {}", options.role, fmt::join(store::kNames<store::Role>, ", "))});
  }
  const std::string scope = fmt::format("{}", fmt::join(options.scope, " "));
  if (const auto word = http::unknown_scope(scope); !word.empty()) {
    return std::unexpected(store::Error{store::ErrorCode::invalid_value,
                                        fmt::format("\"{}\" is no scope: {}", word, fmt::join(http::kScopes, ", "))});
  }
  constexpr std::int64_t kDay_ms = std::int64_t{24} * 3600 * 1000;
  const auto added = store.tokens().add({.name = options.name,
                                         .role = *role,
                                         .hash = hash::token_hash(token),
                                         .user = options.user,
                                         .scope = scope,
                                         .expires_at_ms = options.days == 0 ? 0 : by.at_ms + options.days * kDay_ms},
                                        by);
  if (!added) return std::unexpected(added.error());
  fmt::print(stderr, "token {} of {} as {}; it is shown this once:\n", added->id, added->name, options.role);
  fmt::print("{}\n", token);
  return {};
}

std::string_view state_of(const store::Token& token, const store::Stamp& now) {
  if (token.revoked_at_ms != 0) return "revoked";
  return token.expires_at_ms != 0 && token.expires_at_ms <= now.at_ms ? "expired" : "valid";
}

store::Result<void> list_tokens(store::Store& store, const TokenOptions& /*options*/, const store::Stamp& by) {
  store::PageRequest page{.limit = store::kPageLimitMax, .after = {}};
  do {
    const auto tokens = store.tokens().list(page);
    if (!tokens) return std::unexpected(tokens.error());
    for (const store::Token& token : tokens->items) {
      fmt::print("{:>6}  {:10}  {:7}  {}{}{}\n", token.id, store::name_of(token.role), state_of(token, by), token.name,
                 token.user.empty() ? "" : fmt::format(", for {}", token.user),
                 token.scope.empty() ? "" : fmt::format(", may change: {}", token.scope));
    }
    page.after = tokens->next;
  } while (!page.after.empty());
  return {};
}

store::Result<void> revoke_token(store::Store& store, const TokenOptions& options, const store::Stamp& by) {
  const auto revoked = store.tokens().revoke(options.id, by);
  if (!revoked) return std::unexpected(revoked.error());
  fmt::print(stderr, "token {} of {} is revoked\n", revoked->id, revoked->name);
  return {};
}

// Only a store that is there: a wrong folder must not become a new one.
int on_store(const TokenOptions& options, Work work) {
  const auto store = open_existing({.data = options.data, .url = options.store});
  if (!store) {
    print_error(store::message_of(store.error()));
    return kWrongUse;
  }
  const auto done = work(**store, options, {"dripfeed token", io::SteadyClock().wall_ms()});
  if (!done) {
    print_error(store::message_of(done.error()));
    return kWrongUse;
  }
  return kDone;
}

}  // namespace

void add_token(CLI::App& app, int& exit_code) {
  CLI::App* command = app.add_subcommand("token", "API tokens: add, list, revoke");
  command->require_subcommand(1);
  const auto options = std::make_shared<TokenOptions>();
  const auto action = [&](const char* name, const char* summary, Work work) {
    CLI::App* one = command->add_subcommand(name, summary);
    one->add_option("--data", options->data, "folder of the store")->capture_default_str();
    one->add_option("--store", options->store, kStoreOption);
    one->callback([options, work, &exit_code] { exit_code = on_store(*options, work); });
    return one;
  };
  CLI::App* add = action("add", "a new token; it is printed once", add_one);
  add->add_option("name", options->name, "of the person or program that has it")->required();
  add->add_option("--role", options->role, "viewer, operator, programmer, approver or admin")->required();
  add->add_option("--user", options->user, "a person whose rights it has, up to --role");
  add->add_option("--scope", options->scope, "what it may change: library, checks, releases, queue, line, setup")
      ->delimiter(',');
  add->add_option("--days", options->days, "how long it is valid; without it does not end")->check(CLI::Range(1, 3650));
  action("list", "all tokens, newest first", list_tokens);
  action("revoke", "ends a token and its sessions", revoke_token)
      ->add_option("id", options->id, "its number")
      ->required();
}

}  // namespace dripfeed::cli
