// Members that it does not need are not looked at: providers have many.
#include "server/oidc/provider_document.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "server/oidc/key_set.h"
#include "server/oidc/members.h"

namespace dripfeed::oidc {

namespace {

// Whether a list has one of them. A list that is not there has what the standard says of it.
template <class Is>
bool lists(const json::Document& object, const char* name, bool without, const Is& is) {
  const auto found = object.find(name);
  if (found == object.end() || !found->is_array()) return without;
  return std::ranges::any_of(
      *found, [&](const json::Document& one) { return one.is_string() && is(one.get_ref<const std::string&>()); });
}

bool lists_word(const json::Document& object, const char* name, bool without, std::string_view word) {
  return lists(object, name, without, [&](const std::string& one) { return one == word; });
}

}  // namespace

std::string document_url(std::string_view issuer) {
  while (issuer.ends_with('/')) issuer.remove_suffix(1);
  return fmt::format("{}/.well-known/openid-configuration", issuer);
}

std::string why_no_endpoint(std::string_view url) {
  constexpr std::string_view kPlain = "http://";
  if (url.starts_with("https://")) return {};
  if (!url.starts_with(kPlain)) return "must be https";
  const std::string_view rest = url.substr(kPlain.size());
  constexpr std::array<std::string_view, 3> kHere = {"127.0.0.1", "localhost", "[::1]"};
  const bool is_here = std::ranges::any_of(kHere, [&](std::string_view host) {
    if (!rest.starts_with(host)) return false;
    const std::string_view after = rest.substr(host.size());
    return after.empty() || after.front() == ':' || after.front() == '/';
  });
  return is_here && rest.substr(0, rest.find('/')).find('@') == std::string_view::npos
             ? std::string()
             : "must be https: http is for this computer alone";
}

std::string why_no_page(std::string_view url, bool insecure) {
  const std::size_t scheme = url.find("://");
  std::string why = why_no_endpoint(url);
  if (!why.empty() && !(insecure && url.starts_with("http://"))) return why;
  const std::string_view host = url.substr(scheme + 3);
  const bool is_host = !host.empty() && host.find_first_of("/?#@ ") == std::string_view::npos;
  return is_host ? "" : "must be scheme and host alone, as https://dnc.shop";
}

app::Result<ProviderDocument> read_provider_document(std::string_view text, std::string_view issuer) {
  const auto document = json::parse(text);
  if (!document || !document->is_object()) return refuse("its document is not a JSON object");
  if (text_in(*document, "issuer") != issuer)
    return refuse(fmt::format("its document is of another issuer: \"{}\"", text_in(*document, "issuer")));
  ProviderDocument read{.authorization_endpoint = text_in(*document, "authorization_endpoint"),
                        .token_endpoint = text_in(*document, "token_endpoint"),
                        .jwks_uri = text_in(*document, "jwks_uri")};
  for (const auto& [name, url] :
       {std::pair("authorization_endpoint", &read.authorization_endpoint),
        std::pair("token_endpoint", &read.token_endpoint), std::pair("jwks_uri", &read.jwks_uri)}) {
    if (const std::string why = why_no_endpoint(*url); !why.empty()) return refuse(fmt::format("its {} {}", name, why));
  }
  if (!lists_word(*document, "response_types_supported", true, "code")) return refuse("it has no response type code");
  if (!lists(*document, "id_token_signing_alg_values_supported", true, is_taken_algorithm))
    return refuse("it signs by no algorithm that is taken here: RS, PS or ES");
  if (!lists_word(*document, "code_challenge_methods_supported", true, "S256")) return refuse("it has no PKCE by S256");
  const char* const methods = "token_endpoint_auth_methods_supported";
  read.secret_in_body = !lists_word(*document, methods, true, "client_secret_basic") &&
                        lists_word(*document, methods, false, "client_secret_post");
  return read;
}

}  // namespace dripfeed::oidc
