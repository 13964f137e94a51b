// server/oidc: signing in by an OpenID Connect provider (Core 1.0: authorization code with PKCE, RFC 7636). It asks the
// provider who a person is, and believes nothing that is not signed by the provider's own key for this shop and for the
// sign-in that this browser began. Signatures are checked by libcjose on OpenSSL. What the person may do here is not
// its matter (server/app/shop/provider_people.h).
#pragma once

#include "server/oidc/provider.h"
