// Tokens are looked up by their hash. A valid one is known until the store says that anything changed, in this process
// or another, so a revocation counts with the next request.
#include "server/http/sessions.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include "store/hash/hash.h"

namespace dripfeed::http {

namespace {

// The name of the scheme is written in any case.
std::optional<std::string_view> bearer_token(std::string_view authorization) {
  constexpr std::string_view kBearer = "bearer ";
  if (authorization.size() < kBearer.size()) return std::nullopt;
  for (std::size_t i = 0; i < kBearer.size(); ++i) {
    const char c = authorization[i];
    if ((c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c) != kBearer[i]) return std::nullopt;
  }
  return authorization.substr(kBearer.size());
}

}  // namespace

std::string cookie_value(std::string_view header, std::string_view name) {
  while (!header.empty()) {
    std::string_view item = header.substr(0, header.find(';'));
    header.remove_prefix(std::min(header.size(), item.size() + 1));
    while (item.starts_with(' ')) item.remove_prefix(1);
    const std::size_t equals = item.find('=');
    if (equals != std::string_view::npos && item.substr(0, equals) == name) return std::string(item.substr(equals + 1));
  }
  return {};
}

namespace {

bool names_host(std::string_view origin, std::string_view host) {
  const std::size_t scheme = origin.find("://");
  return scheme != std::string_view::npos && !host.empty() && origin.substr(scheme + 3) == host;
}

}  // namespace

// No page can set Sec-Fetch-Site, and a proxy passes it on: where it is there it decides, whatever host the proxy calls
// us by.
bool same_origin(const Request& request) {
  if (!request.fetch_site.empty()) return request.fetch_site == "same-origin";
  return names_host(request.origin, request.host) || names_host(request.origin, request.forwarded_host);
}

namespace {

std::string owner_of(store::Id user) { return fmt::format("user/{}", user); }

}  // namespace

// A user that is disabled, or a token whose user is, is as good as none.
store::Result<Sessions::Known> Sessions::ask(const std::string& hash, bool is_session) {
  Known known;
  store::Id user = 0;
  if (is_session) {
    auto found = kept_.find(hash);
    if (!found) return std::unexpected(found.error());
    known = {.token = std::move(found->token),
             .user = std::nullopt,
             .owner = std::move(found->token_hash),
             .secret = found->secret,
             .by_provider = found->by_provider,
             .opened_at_ms = found->opened_at_ms,
             .used_at_ms = found->used_at_ms};
    user = found->user_id;
  } else {
    auto token = tokens_.find(hash);
    if (!token) return std::unexpected(token.error());
    known.token = std::move(*token);
    known.owner = hash;
  }
  if (known.token) user = known.token->user_id;
  if (user == 0) return known;
  auto rights = users_.rights(user);
  if (!rights) return std::unexpected(rights.error());
  known.user = std::move(*rights);
  if (!known.token) known.owner = owner_of(user);
  return known;
}

store::Result<Sessions::Known> Sessions::known(const std::string& hash, bool is_session,
                                               std::optional<std::uint64_t> version) {
  if (version) {
    const std::lock_guard lock(mutex_);
    if (const auto found = known_.find(hash); found != known_.end() && found->second.version == *version)
      return found->second.known;
  }
  auto asked = ask(hash, is_session);
  const std::lock_guard lock(mutex_);
  if (!asked) {
    const bool is_gone = asked.error().code == store::ErrorCode::not_found;
    if (is_gone) known_.erase(hash);
    const auto before = known_.find(hash);
    return before == known_.end() ? asked : before->second.known;
  }
  // Read after its version was asked for: should it have changed meanwhile, the next request finds another version.
  if (version) {
    if (known_.size() >= kMostKnown) known_.clear();
    known_[hash] = {.known = *asked, .version = *version};
  }
  return asked;
}

namespace {

// The rights follow the roles in the same order, after `anybody`.
Right right_of(store::Role role) { return static_cast<Right>(static_cast<int>(role) + 1); }

}  // namespace

// Of a user's token each right is the lower one of both.
Caller Sessions::caller_of(const Known& known) {
  Right most = Right::admin;
  Caller caller;
  if (known.token) {
    most = right_of(known.token->role);
    caller.name = known.token->name;
    caller.scope = known.token->scope;
    caller.signed_in_by = "token";
  } else {
    if (known.secret == store::SecretKind::pin) most = kPinRight;
    caller.signed_in_by = known.by_provider ? "provider" : store::name_of(known.secret);
  }
  caller.right = most;
  if (known.user) {
    caller.name = known.user->name;
    caller.right = std::min(most, right_of(known.user->role));
    for (const auto& [machine, role] : known.user->on_machines)
      caller.on_machines.emplace(machine, std::min(most, right_of(role)));
  }
  caller.credential = {.owner = known.owner, .session = {}};
  return caller;
}

bool Sessions::has_ended(const std::optional<store::Token>& token) const {
  return token && token->expires_at_ms != 0 && token->expires_at_ms <= now_ms_();
}

// With the lock held.
bool Sessions::has_expired(const Known& session, const std::string& hash) const {
  const bool is_pin = !session.token && session.secret == store::SecretKind::pin;
  const auto used = used_.find(hash);
  const std::int64_t last_ms = std::max(session.used_at_ms, used == used_.end() ? 0 : used->second);
  const std::int64_t now = now_ms_();
  return now - last_ms >= (is_pin ? kPinIdle_ms : kIdle_ms) ||
         now - session.opened_at_ms >= (is_pin ? kPinLongest_ms : kLongest_ms);
}

namespace {

std::unexpected<store::Error> no_credential() {
  return std::unexpected(store::Error{store::ErrorCode::not_found, "no valid token or session"});
}

}  // namespace

store::Result<Caller> Sessions::caller(const Request& request, std::optional<std::uint64_t> version) {
  if (const auto token = bearer_token(request.authorization)) {
    const auto found = known(hash::token_hash(*token), false, version);
    if (!found) return std::unexpected(found.error());
    if (has_ended(found->token)) return no_credential();
    return caller_of(*found);
  }
  const std::string cookie = cookie_value(request.cookie, kSessionCookie);
  if (cookie.empty()) return no_credential();
  const std::string session = hash::token_hash(cookie);
  const auto found = known(session, true, version);
  if (!found) return std::unexpected(found.error());
  if (has_ended(found->token)) return no_credential();
  {
    const std::lock_guard lock(mutex_);
    if (has_expired(*found, session)) return no_credential();
    used_[session] = now_ms_();
  }
  Caller caller = caller_of(*found);
  caller.by_cookie = true;
  caller.credential.session = session;
  return caller;
}

namespace {

// A store that cannot be read says nothing of the credential.
template <class T>
bool may_be_there(const store::Result<T>& found) {
  return found.has_value() || found.error().code != store::ErrorCode::not_found;
}

}  // namespace

bool Sessions::is_valid(const Credential& credential) {
  if (!credential.session.empty()) return is_valid_session(credential);
  const auto token = tokens_.find(credential.owner);
  if (!token) return may_be_there(token);
  if (has_ended(*token)) return false;
  return token->user_id == 0 || may_be_there(users_.rights(token->user_id));
}

bool Sessions::is_valid_session(const Credential& credential) {
  const auto found = kept_.find(credential.session);
  if (!found) return may_be_there(found);
  if (has_ended(found->token)) return false;
  if (found->token && found->token->user_id != 0 && !may_be_there(users_.rights(found->token->user_id))) return false;
  std::int64_t used_ms = 0;
  {
    const std::lock_guard lock(mutex_);
    const Known session{.token = found->token,
                        .user = std::nullopt,
                        .owner = {},
                        .secret = found->secret,
                        .by_provider = found->by_provider,
                        .opened_at_ms = found->opened_at_ms,
                        .used_at_ms = found->used_at_ms};
    if (has_expired(session, credential.session)) return false;
    if (const auto used = used_.find(credential.session); used != used_.end()) used_ms = used->second;
  }
  if (used_ms - found->used_at_ms >= kNoteEvery_ms) {
    if (const auto noted = kept_.note_use(credential.session, used_ms); !noted)
      spdlog::warn("the use of a session is not noted: {}", store::message_of(noted.error()));
  }
  return true;
}

store::Result<std::string> Sessions::open(std::string_view token) {
  if (const auto found = tokens_.find(hash::token_hash(token)); found && has_ended(*found))
    return std::unexpected(store::Error{store::ErrorCode::not_found, "the token has expired"});
  return open_for({.token_hash = hash::token_hash(token)});
}

store::Result<std::string> Sessions::open(std::string_view user, store::SecretKind secret) {
  return open_for({.user = std::string(user), .secret = secret});
}

store::Result<std::string> Sessions::open_by_provider(std::string_view user) {
  return open_for({.user = std::string(user), .by_provider = true});
}

// What has expired goes with the next sign-in; no one ends the session of another by signing in often.
store::Result<std::string> Sessions::open_for(const store::SessionOwner& owner) {
  const std::int64_t now = now_ms_();
  std::string cookie = hash::random_token();
  const auto opened = kept_.open(hash::token_hash(cookie), owner, kMostOfOne, now);
  if (!opened) return std::unexpected(opened.error());
  if (const auto done = kept_.forget(now - kLongest_ms, now - kLongest_ms); !done)
    spdlog::warn("old sessions are not forgotten: {}", store::message_of(done.error()));
  const std::lock_guard lock(mutex_);
  std::erase_if(used_, [&](const auto& use) { return now - use.second >= kLongest_ms; });
  return cookie;
}

store::Result<void> Sessions::close(const Request& request) {
  const std::string session = hash::token_hash(cookie_value(request.cookie, kSessionCookie));
  if (auto done = kept_.close(session); !done) return done;
  const std::lock_guard lock(mutex_);
  used_.erase(session);
  known_.erase(session);
  return {};
}

}  // namespace dripfeed::http
