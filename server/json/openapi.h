// The API's own description (OpenAPI 3.1), written from the table of routes and the tables of schemas.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "server/json/schema.h"

namespace dripfeed::json {

struct OpenApiRoute {
  std::string_view method;  // "GET"
  std::string_view path;
  std::string_view summary;
  std::string_view right;
  std::string_view scope = {};                 // of tokens that may change it; empty: it changes nothing
  bool open = false;                           // needs no token
  bool paged = false;                          // takes ?limit= and &after=
  bool if_match = false;                       // takes the revision that is changed
  bool once = false;                           // takes effect once under an idempotency key
  std::vector<std::string_view> query = {};    // names of other query parameters
  std::string_view body = {};                  // schema of the request's body; empty: it takes none
  bool needs_body = false;                     // an empty one is none
  bool takes_file = false;                     // the body is the bytes of a file
  unsigned status = 200;                       // where it is done
  std::string_view answer = {};                // schema of the answer; empty: none as JSON
  bool lists = false;                          // the answer is a page of these
  std::vector<std::string_view> types = {};    // other content types of the answer
  std::vector<std::string_view> headers = {};  // of the answer, besides Location
};

// One schema as a document of its own (JSON Schema 2020-12).
std::string json_schema(const Schema& schema);

std::string openapi(std::span<const OpenApiRoute> routes, std::string_view version);

}  // namespace dripfeed::json
