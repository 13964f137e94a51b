// What a provider says of itself (OpenID Connect Discovery 1.0): where it is asked what.
#pragma once

#include <string>
#include <string_view>

#include "server/app/base/error.h"

namespace dripfeed::oidc {

struct ProviderDocument {
  std::string authorization_endpoint;  // for the browser
  std::string token_endpoint;
  std::string jwks_uri;
  bool secret_in_body = false;  // the token endpoint takes the client's secret there alone
};

// Where the document of an issuer is.
std::string document_url(std::string_view issuer);

// Errors: refused, as the end of a sentence ("its document is not JSON"): another issuer's, an endpoint that is missing
// or that must not be asked (why_no_endpoint), no RS or ES signatures, no code flow.
app::Result<ProviderDocument> read_provider_document(std::string_view text, std::string_view issuer);

// "" or what is wrong with a URL, as the end of a sentence: what a provider says is believed because of TLS. Without it
// only this computer itself is asked, for tests.
std::string why_no_endpoint(std::string_view url);
// The same of the address of this server's page, which has no path; `insecure`: http may be any computer.
std::string why_no_page(std::string_view url, bool insecure);

}  // namespace dripfeed::oidc
