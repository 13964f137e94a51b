// Members of the documents that a provider sends. Only files of this folder include this.
#pragma once

#include <string>
#include <utility>

#include "server/app/base/error.h"
#include "server/json/parse.h"

namespace dripfeed::oidc {

// "" where it is not there, or no text.
inline std::string text_in(const json::Document& object, const std::string& name) {
  if (!object.is_object()) return {};
  const auto found = object.find(name);
  return found != object.end() && found->is_string() ? found->get<std::string>() : std::string();
}

// Why something of a provider's is not taken, as the end of a sentence.
inline std::unexpected<app::Error> refuse(std::string why) {
  return app::fail(app::ErrorCode::refused, std::move(why));
}

}  // namespace dripfeed::oidc
