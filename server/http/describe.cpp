// Each row of the table of routes as the writer of openapi.json wants it.
#include "server/http/describe.h"

#include <vector>

#include "server/http/api.h"
#include "server/http/rights.h"
#include "server/json/openapi.h"

namespace dripfeed::http {

std::string describe_api(std::string_view version) {
  std::vector<json::OpenApiRoute> described;
  for (const Route& route : routes()) {
    const bool is_change = route.method != Method::get && route.right != Right::anybody;
    described.push_back({.method = name_of(route.method),
                         .path = route.pattern,
                         .summary = route.summary,
                         .right = name_of(route.right),
                         .scope = is_change ? scope_of(route) : std::string_view(),
                         .open = route.right == Right::anybody,
                         .paged = route.takes == Takes::page,
                         .if_match = route.takes == Takes::if_match,
                         .once = is_change && !opens_session(route.weight),
                         .query = own_query(route),
                         .body = route.body.schema,
                         .needs_body = route.body.needed,
                         .takes_file = route.carries == Carries::file,
                         .status = route.answer.status,
                         .answer = route.answer.schema,
                         .lists = route.answer.page,
                         .types = other_types(route),
                         .headers = words_in(route.answer.headers)});
  }
  return json::openapi(described, version);
}

}  // namespace dripfeed::http
