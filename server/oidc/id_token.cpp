// Each rule of the standard is one line of check_claims(). The parser refuses a claim that is given twice.
#include "server/oidc/id_token.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "server/oidc/members.h"
#include "store/hash/token.h"

namespace dripfeed::oidc {

namespace {

using json::Document;

constexpr std::size_t kMostGroups = 1000;
constexpr std::size_t kLongestSubject = 255;  // Core 1.0, 2

const Document* member_of(const Document& object, const std::string& name) {
  const auto found = object.is_object() ? object.find(name) : object.end();
  return object.is_object() && found != object.end() ? &*found : nullptr;
}

// A name with dots may be a claim itself, as a URL is.
const Document* find_claim(const Document& claims, std::string_view name) {
  if (const Document* const whole = member_of(claims, std::string(name))) return whole;
  const std::size_t dot = name.find('.');
  if (dot == std::string_view::npos) return nullptr;
  const Document* const inner = member_of(claims, std::string(name.substr(0, dot)));
  return inner == nullptr ? nullptr : find_claim(*inner, name.substr(dot + 1));
}

// Of a time in seconds; nothing where it is none.
std::optional<std::int64_t> time_in(const Document& claims, const char* name) {
  constexpr double kLatest = 1e12;
  const Document* const found = member_of(claims, name);
  if (found == nullptr || !found->is_number()) return std::nullopt;
  const double seconds = found->get<double>();
  if (!std::isfinite(seconds) || seconds < 0.0 || seconds > kLatest) return std::nullopt;
  return static_cast<std::int64_t>(seconds);
}

// One text, or a list of them.
std::vector<std::string> texts_of(const Document* claim) {
  std::vector<std::string> texts;
  if (claim != nullptr && claim->is_string()) texts.push_back(claim->get<std::string>());
  if (claim == nullptr || !claim->is_array()) return texts;
  for (const Document& one : *claim)
    if (one.is_string() && texts.size() < kMostGroups) texts.push_back(one.get<std::string>());
  return texts;
}

// "" where it is for us alone, or for us by its `azp`.
std::string why_not_for(const Document& claims, std::string_view client_id) {
  const std::vector<std::string> audience = texts_of(member_of(claims, "aud"));
  if (std::ranges::find(audience, client_id) == audience.end()) return "it is for another client";
  const Document* const party = member_of(claims, "azp");
  if (party == nullptr) return audience.size() == 1 ? "" : "it is for several clients and does not name which";
  return text_in(claims, "azp") == client_id ? "" : "it was made for another client";
}

std::string why_not_now(const Document& claims, std::int64_t now_s) {
  const auto until = time_in(claims, "exp");
  const auto made = time_in(claims, "iat");
  if (!until || !made) return "it states no time";
  if (*until + kClockSkew.count() <= now_s) return "it has expired";
  if (*made - kClockSkew.count() > now_s) return "its time is in the future: the clocks differ";
  if (*made + kOldestToken.count() + kClockSkew.count() < now_s) return "it was made too long ago";
  const auto from = time_in(claims, "nbf");
  return from && *from - kClockSkew.count() > now_s ? "it is not valid yet" : "";
}

std::string why_not(const Document& claims, const ExpectedClaims& expected) {
  if (text_in(claims, "iss") != expected.issuer) return "it is of another issuer";
  if (std::string why = why_not_for(claims, expected.client_id); !why.empty()) return why;
  if (std::string why = why_not_now(claims, expected.now_s); !why.empty()) return why;
  if (!hash::same_secret(text_in(claims, "nonce"), expected.nonce)) return "it is of another sign-in";
  const std::string subject = text_in(claims, "sub");
  return subject.empty() || subject.size() > kLongestSubject ? "it names no person" : "";
}

}  // namespace

TokenAnswer read_token_answer(std::string_view text) {
  const auto document = json::parse(text);
  if (!document) return {};
  return {.id_token = text_in(*document, "id_token"), .error = text_in(*document, "error")};
}

app::Result<Identity> read_id_token(std::string_view payload, const ExpectedClaims& expected, const ClaimNames& names) {
  const auto claims = json::parse(payload);
  if (!claims || !claims->is_object()) return refuse("its claims are not a JSON object");
  if (std::string why = why_not(*claims, expected); !why.empty()) return refuse(std::move(why));
  const Document* const name = find_claim(*claims, names.name);
  return Identity{
      .subject = text_in(*claims, "sub"),
      .name = name != nullptr && name->is_string() ? name->get<std::string>() : std::string(),
      .groups = names.groups.empty() ? std::vector<std::string>() : texts_of(find_claim(*claims, names.groups))};
}

}  // namespace dripfeed::oidc
