// Tokens are looked up by their hash for each request: the store answers from memory, and a revocation counts at once.
#include "server/http/sessions.h"

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

bool same_origin(const Request& request) {
  if (request.origin.empty()) return request.fetch_site == "same-origin";
  const std::size_t scheme = request.origin.find("://");
  return scheme != std::string::npos && !request.host.empty() && request.origin.substr(scheme + 3) == request.host;
}

std::optional<Caller> Sessions::by_hash(const std::string& hash) {
  const auto token = tokens_.find(hash);
  if (!token) return std::nullopt;
  // The rights follow the roles in the same order, behind `anybody`.
  return Caller{
      .name = token->name, .right = static_cast<Right>(static_cast<int>(token->role) + 1), .by_cookie = false};
}

std::optional<Caller> Sessions::caller(const Request& request) {
  if (const auto token = bearer_token(request.authorization)) return by_hash(hash::token_hash(*token));
  const std::string cookie = cookie_value(request.cookie, kSessionCookie);
  if (cookie.empty()) return std::nullopt;
  std::string hash;
  {
    const std::lock_guard lock(mutex_);
    const auto known = hashes_.find(hash::token_hash(cookie));
    if (known == hashes_.end()) return std::nullopt;
    hash = known->second;
  }
  auto caller = by_hash(hash);
  if (caller) caller->by_cookie = true;
  return caller;
}

std::optional<std::string> Sessions::open(std::string_view token) {
  const std::string hash = hash::token_hash(token);
  if (!by_hash(hash)) return std::nullopt;
  std::string cookie = hash::random_token();
  const std::lock_guard lock(mutex_);
  if (hashes_.size() >= kMost) hashes_.erase(hashes_.begin());
  hashes_[hash::token_hash(cookie)] = hash;
  return cookie;
}

void Sessions::close(const Request& request) {
  const std::lock_guard lock(mutex_);
  hashes_.erase(hash::token_hash(cookie_value(request.cookie, kSessionCookie)));
}

}  // namespace dripfeed::http
