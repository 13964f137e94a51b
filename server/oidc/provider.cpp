// Each request has a sender of its own, as the arming hook's has: no redirect is followed, TLS is verified, and the
// address is looked at where its socket is made.
#include "server/oidc/provider.h"

#include <algorithm>
#include <span>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include "server/json/base64.h"
#include "server/oidc/form.h"
#include "store/hash/token.h"

namespace dripfeed::oidc {

namespace {

using std::chrono::duration_cast;
using std::chrono::milliseconds;
using std::chrono::steady_clock;

constexpr unsigned kOk = 200;
constexpr std::size_t kLongestWords = 200;

std::unexpected<app::Error> no_answer(std::string_view why) {
  return app::fail(app::ErrorCode::unavailable, fmt::format("the sign-in's provider gives no answer: {}", why));
}

std::unexpected<app::Error> not_usable(std::string_view why) {
  return app::fail(app::ErrorCode::unavailable, fmt::format("the sign-in's provider cannot be used: {}", why));
}

std::unexpected<app::Error> refused_there(std::string_view why) {
  return app::fail(app::ErrorCode::refused, fmt::format("the provider refuses the sign-in: {}", why));
}

std::unexpected<app::Error> token_refused(std::string_view why) {
  return app::fail(app::ErrorCode::refused, fmt::format("the provider's ID token is refused: {}", why));
}

// A few plain characters of what came from outside, for people.
std::string shown(std::string_view text) {
  std::string plain(text.substr(0, kLongestWords));
  std::ranges::replace_if(plain, [](char c) { return c < ' ' || c > '~'; }, '?');
  return plain.empty() ? "it gives no reason" : plain;
}

std::string basic_credentials(const ProviderSettings& settings) {
  const std::string both = encoded(settings.client_id) + ":" + encoded(settings.client_secret);
  return "Basic " + json::base64(std::as_bytes(std::span(both)));
}

}  // namespace

Provider::Provider(ProviderSettings settings) : settings_(std::move(settings)) {}

Provider::Until Provider::end_of_call() const { return steady_clock::now() + settings_.at_most; }

// An answer by which the provider says something: 200, or a refusal of 4xx. The request ends by itself; the time here
// is for a sender that does not keep its word.
app::Result<app::HttpOutcome> Provider::ask(const app::HttpCall& call, Until until) const {
  constexpr milliseconds kLook{100};
  constexpr milliseconds kGrace{1000};
  const auto left = duration_cast<milliseconds>(until - steady_clock::now());
  const auto sender = settings_.make_sender();
  if (!sender) return no_answer("no request can be made");
  if (left.count() <= 0) return no_answer("the time is over");
  app::HttpCall timed = call;
  timed.local = settings_.local;
  timed.at_most = left;
  timed.keeps_bytes = app::kMostOfAnswer_bytes;
  timed.headers.emplace_back("Accept", "application/json");
  sender->begin(1, timed);
  while (steady_clock::now() < until + kGrace) {
    std::vector<app::HttpOutcome> ended = sender->work(kLook);
    if (ended.empty()) continue;
    app::HttpOutcome& outcome = ended.front();
    if (outcome.status == 0) return no_answer(outcome.error);
    if (outcome.status == kOk || (outcome.status >= 400 && outcome.status < 500)) return std::move(outcome);
    return no_answer(fmt::format("it answered {}", outcome.status));
  }
  return no_answer("the time is over");
}

app::Result<std::string> Provider::get(const std::string& url, Until until) const {
  auto answer = ask({.verb = app::HttpVerb::get, .url = url}, until);
  if (!answer) return std::unexpected(answer.error());
  if (answer->status != kOk) return not_usable(fmt::format("it answered {}", answer->status));
  return std::move(answer->body);
}

app::Result<Provider::Known> Provider::read(Until until) const {
  const auto text = get(document_url(settings_.issuer), until);
  if (!text) return std::unexpected(text.error());
  auto document = read_provider_document(*text, settings_.issuer);
  if (!document) return not_usable(document.error().text);
  const auto keys = get(document->jwks_uri, until);
  if (!keys) return std::unexpected(keys.error());
  auto set = KeySet::read(*keys);
  if (!set) return not_usable(set.error().text);
  return Known{.document = std::move(*document),
               .keys = std::make_shared<const KeySet>(std::move(*set)),
               .read_at_ms = settings_.now_ms()};
}

app::Result<Provider::Known> Provider::known(Until until) {
  const std::lock_guard lock(mutex_);
  const std::int64_t now_ms = settings_.now_ms();
  const auto is_within = [&](std::int64_t since_ms, milliseconds time) {
    return since_ms <= now_ms && now_ms - since_ms < time.count();
  };
  if (known_ && is_within(known_->read_at_ms, kKept)) return *known_;
  if (failure_ && is_within(failed_at_ms_, kNotAgain)) return std::unexpected(*failure_);
  auto found = read(until);
  if (found) {
    failure_.reset();
    known_ = *found;
  } else {
    failure_ = found.error();
    failed_at_ms_ = settings_.now_ms();
    spdlog::warn("sign-in by {}: {}", settings_.issuer, found.error().text);
  }
  return found;
}

app::Result<Provider::Begun> Provider::begin() {
  const auto found = known(end_of_call());
  if (!found) return std::unexpected(found.error());
  Ticket ticket = tickets_.open(settings_.now_ms());
  const std::string scope = settings_.scope.empty() ? "openid" : "openid " + settings_.scope;
  const std::string& endpoint = found->document.authorization_endpoint;
  const std::string challenge = hash::challenge_of(ticket.verifier);
  const std::string query = form_of({{"response_type", "code"},
                                     {"client_id", settings_.client_id},
                                     {"redirect_uri", settings_.redirect_url},
                                     {"scope", scope},
                                     {"state", ticket.state},
                                     {"nonce", ticket.nonce},
                                     {"code_challenge", challenge},
                                     {"code_challenge_method", "S256"}});
  const char joined = endpoint.find('?') == std::string::npos ? '?' : '&';
  return Begun{.url = fmt::format("{}{}{}", endpoint, joined, query), .cookie = std::move(ticket.cookie)};
}

app::Result<std::string> Provider::redeem(const Known& known, const Returned& returned, const Ticket& ticket,
                                          Until until) const {
  app::HttpCall call{.url = known.document.token_endpoint};
  call.body = form_of({{"grant_type", "authorization_code"},
                       {"code", returned.code},
                       {"redirect_uri", settings_.redirect_url},
                       {"code_verifier", ticket.verifier}});
  call.headers = {{"Content-Type", "application/x-www-form-urlencoded"}};
  if (settings_.client_secret.empty()) {
    call.body += "&" + form_of({{"client_id", settings_.client_id}});
  } else if (known.document.secret_in_body) {
    call.body += "&" + form_of({{"client_id", settings_.client_id}, {"client_secret", settings_.client_secret}});
  } else {
    call.headers.emplace_back("Authorization", basic_credentials(settings_));
  }
  const auto answer = ask(call, until);
  if (!answer) return std::unexpected(answer.error());
  TokenAnswer answered = read_token_answer(answer->body);
  if (answer->status != kOk)
    return refused_there(answered.error.empty() ? fmt::format("it answered {}", answer->status)
                                                : shown(answered.error));
  if (answered.id_token.empty()) return token_refused("there is none in the answer");
  return std::move(answered.id_token);
}

// Those that are kept, or what the provider has now: it changes its keys now and then.
app::Result<std::shared_ptr<const KeySet>> Provider::keys_for(const SignedToken& token, const Known& known,
                                                              Until until) {
  if (known.keys->has_key_of(token)) return known.keys;
  const auto text = get(known.document.jwks_uri, until);
  if (!text) return std::unexpected(text.error());
  auto set = KeySet::read(*text);
  if (!set) return token_refused(set.error().text);
  auto keys = std::make_shared<const KeySet>(std::move(*set));
  const std::lock_guard lock(mutex_);
  if (known_) known_->keys = keys;
  return keys;
}

app::Result<Identity> Provider::believe(std::string_view text, const Known& known, const Ticket& ticket, Until until) {
  const auto token = SignedToken::read(text);
  if (!token) return token_refused(token.error().text);
  const auto keys = keys_for(*token, known, until);
  if (!keys) return std::unexpected(keys.error());
  const auto payload = (*keys)->verify(*token);
  if (!payload) return token_refused(payload.error().text);
  auto identity = read_id_token(*payload,
                                {.issuer = settings_.issuer,
                                 .client_id = settings_.client_id,
                                 .nonce = ticket.nonce,
                                 .now_s = settings_.now_ms() / 1000},
                                settings_.claims);
  if (!identity) return token_refused(identity.error().text);
  return identity;
}

app::Result<Identity> Provider::finish(const Returned& returned, std::string_view cookie) {
  const auto ticket = tickets_.take(cookie, returned.state, settings_.now_ms());
  if (!ticket) return std::unexpected(ticket.error());
  if (!returned.issuer.empty() && returned.issuer != settings_.issuer)
    return refused_there("another provider answered");
  if (!returned.error.empty()) return refused_there(shown(returned.error));
  if (returned.code.empty()) return refused_there("it sends no code");
  const Until until = end_of_call();
  const auto found = known(until);
  if (!found) return std::unexpected(found.error());
  const auto token = redeem(*found, returned, *ticket, until);
  if (!token) return std::unexpected(token.error());
  return believe(*token, *found, *ticket, until);
}

}  // namespace dripfeed::oidc
