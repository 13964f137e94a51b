// Tokens are looked up by their hash. A valid one is known until the store says that anything changed, in this process
// or another, so a revocation counts with the next request.
#include "server/http/sessions.h"

#include <algorithm>
#include <utility>

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

std::optional<store::Token> Sessions::token_of(const std::string& hash, std::optional<std::uint64_t> version) {
  if (version) {
    const std::lock_guard lock(mutex_);
    if (known_version_ != version) known_.clear();
    known_version_ = version;
    if (const auto known = known_.find(hash); known != known_.end()) return known->second;
  }
  const auto token = tokens_.find(hash);
  if (!token) return std::nullopt;
  const std::lock_guard lock(mutex_);
  // Read after its version was asked for: should it have changed meanwhile, the next request finds another version.
  if (version && known_version_ == version) {
    if (known_.size() >= kMostKnown) known_.clear();
    known_[hash] = *token;
  }
  return *token;
}

std::optional<Caller> Sessions::by_hash(const std::string& hash, std::optional<std::uint64_t> version) {
  const auto token = token_of(hash, version);
  if (!token) return std::nullopt;
  // The rights follow the roles in the same order, behind `anybody`.
  return Caller{.name = token->name,
                .right = static_cast<Right>(static_cast<int>(token->role) + 1),
                .by_cookie = false,
                .credential = {.token_hash = hash, .session = {}}};
}

bool Sessions::has_expired(const Session& session, Clock::time_point now) {
  return now - session.used >= kIdle || now - session.opened >= kLongest;
}

Sessions::Rows::iterator Sessions::live(const std::string& session) {
  const auto found = rows_.find(session);
  if (found == rows_.end()) return found;
  if (!has_expired(found->second, now_())) return found;
  rows_.erase(found);
  return rows_.end();
}

std::optional<Caller> Sessions::caller(const Request& request, std::optional<std::uint64_t> version) {
  if (const auto token = bearer_token(request.authorization)) return by_hash(hash::token_hash(*token), version);
  const std::string cookie = cookie_value(request.cookie, kSessionCookie);
  if (cookie.empty()) return std::nullopt;
  const std::string session = hash::token_hash(cookie);
  std::string hash;
  {
    const std::lock_guard lock(mutex_);
    const auto known = live(session);
    if (known == rows_.end()) return std::nullopt;
    known->second.used = now_();
    hash = known->second.token_hash;
  }
  auto caller = by_hash(hash, version);
  if (!caller) return caller;
  caller->by_cookie = true;
  caller->credential.session = session;
  return caller;
}

bool Sessions::is_valid(const Credential& credential) {
  if (!credential.session.empty()) {
    const std::lock_guard lock(mutex_);
    if (live(credential.session) == rows_.end()) return false;
  }
  const auto token = tokens_.find(credential.token_hash);
  // A store that cannot be read says nothing of the token.
  return token.has_value() || token.error().code != store::ErrorCode::not_found;
}

// Those of this token alone: nobody ends the session of another by signing in often.
void Sessions::make_room(const std::string& token_hash) {
  const auto now = now_();
  std::erase_if(rows_, [&](const auto& row) { return has_expired(row.second, now); });
  std::size_t count = 0;
  auto oldest = rows_.end();
  for (auto it = rows_.begin(); it != rows_.end(); ++it) {
    if (it->second.token_hash != token_hash) continue;
    ++count;
    if (oldest == rows_.end() || it->second.used < oldest->second.used) oldest = it;
  }
  if (count >= kMostOfOne) rows_.erase(oldest);
}

std::optional<std::string> Sessions::open(std::string_view token) {
  const std::string hash = hash::token_hash(token);
  if (!by_hash(hash)) return std::nullopt;
  std::string cookie = hash::random_token();
  const std::lock_guard lock(mutex_);
  make_room(hash);
  rows_[hash::token_hash(cookie)] = {.token_hash = hash, .opened = now_(), .used = now_()};
  return cookie;
}

void Sessions::close(const Request& request) {
  const std::lock_guard lock(mutex_);
  rows_.erase(hash::token_hash(cookie_value(request.cookie, kSessionCookie)));
}

}  // namespace dripfeed::http
