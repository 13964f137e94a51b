// The API's own description (OpenAPI 3.1), written from the table of routes.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace dripfeed::json {

struct OpenApiRoute {
  std::string_view method;  // "GET"
  std::string_view path;
  std::string_view summary;
  std::string_view right;
  bool open = false;                         // needs no token
  bool paged = false;                        // takes ?limit= and &after=
  bool if_match = false;                     // takes the revision that is changed
  std::vector<std::string_view> query = {};  // names of other query parameters
};

std::string openapi(std::span<const OpenApiRoute> routes, std::string_view version);

}  // namespace dripfeed::json
