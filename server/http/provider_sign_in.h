// Signing in by an OpenID Connect provider, as the API needs it: who asks it, and what its groups give here.
#pragma once

#include <utility>
#include <vector>

#include "server/app/shop/provider_people.h"
#include "server/oidc/provider.h"

namespace dripfeed::http {

struct ProviderSignIn {
  ProviderSignIn(oidc::ProviderSettings settings, std::vector<app::GroupRole> groups)
      : provider(std::move(settings)), mapping(std::move(groups)) {}

  oidc::Provider provider;
  std::vector<app::GroupRole> mapping;
};

}  // namespace dripfeed::http
