// The API's own description, /api/openapi.json: also without a server, for what is generated from it.
#pragma once

#include <string>
#include <string_view>

namespace dripfeed::http {

// OpenAPI 3.1, as one line of JSON. `version` is the server's.
std::string describe_api(std::string_view version);

}  // namespace dripfeed::http
