// In the order of their names.
#include "server/json/openapi_headers.h"

#include <algorithm>
#include <array>
#include <cstdlib>

namespace dripfeed::json {

namespace {

constexpr std::array kHeaders = {
    ApiHeader{"Content-Disposition", "as a file, under its name (RFC 6266)"},
    ApiHeader{"Content-Security-Policy", "what a browser that shows it may load"},
    ApiHeader{"ETag", "of what is there now, quoted; the revision where a change asks for it in `If-Match`",
              "^\"[^\"]+\"$"},
    ApiHeader{"Location", "the path of what was made", "^/"},
    ApiHeader{"Retry-After", "seconds after which asking again may help", "", true},
    ApiHeader{"Set-Cookie", "the cookie of a session, or of a sign-in: HttpOnly, SameSite=Strict"},
    ApiHeader{"Vary", "the headers of the request that decide on it"},
    ApiHeader{"WWW-Authenticate", "how to authenticate", "^Bearer$"},
};

}  // namespace

const ApiHeader& api_header(std::string_view name) {
  const auto row = std::ranges::find(kHeaders, name, &ApiHeader::name);
  if (row == kHeaders.end()) std::abort();
  return *row;
}

}  // namespace dripfeed::json
