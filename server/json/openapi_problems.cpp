// The statuses of a route from its row.
#include "server/json/openapi_problems.h"

#include <algorithm>
#include <array>
#include <set>
#include <string>

#include <fmt/format.h>

#include "server/json/openapi_headers.h"
#include "server/json/problem_codes.h"

namespace dripfeed::json {

namespace {

// No route's own: its path with another method, and a header before the route is known.
constexpr std::array kOfNoRoute = {405U, 431U};

constexpr unsigned kNotAuthenticated = 401;

// A body that may name the revision that it changes.
constexpr std::string_view kNamesRevision = "AcceptOrder";

std::string name_of(unsigned status) { return fmt::format("Problem{}", status); }

Document problem_content() {
  return {{"application/problem+json", {{"schema", {{"$ref", "#/components/schemas/Problem"}}}}}};
}

bool has_type(const OpenApiRoute& route, std::string_view type) {
  return std::ranges::find(route.types, type) != route.types.end();
}

std::set<unsigned> statuses_of(const OpenApiRoute& route) {
  std::set<unsigned> all = {400, 500, 503};
  const bool is_read = route.method == "GET";
  const bool has_body = !route.body.empty() || route.takes_file;
  const auto add = [&](bool if_so, std::initializer_list<unsigned> some) {
    if (if_so) all.insert(some);
  };
  const bool signs_in = route.open && !is_read;
  add(!route.open || signs_in, {401, 403});
  add(route.path.contains('{') || has_body || signs_in, {404});
  if (has_type(route, "application/xml")) return all;  // all else as MTConnect has it
  add(!is_read, {409, 413, 415});
  add(has_body, {413, 415, 507});
  add(has_body || route.once || route.paged || !route.query.empty() || has_type(route, "text/event-stream"), {422});
  add(route.if_match, {412, 428});
  add(route.body == kNamesRevision, {412});
  add(signs_in || has_type(route, "text/event-stream"), {429});
  return all;
}

}  // namespace

Document header_object(std::string_view name) {
  const ApiHeader& header = api_header(name);
  Document schema = {{"type", header.is_seconds ? "integer" : "string"}};
  if (header.is_seconds) schema["minimum"] = 1;
  if (!header.pattern.empty()) schema["pattern"] = header.pattern;
  return {{"description", header.about}, {"required", true}, {"schema", std::move(schema)}};
}

Document problem_responses() {
  Document all = Document::object();
  for (const ProblemCode& row : problem_codes()) {
    if (std::ranges::find(kOfNoRoute, row.status) != kOfNoRoute.end()) continue;
    Document& response = all[name_of(row.status)];
    if (response.is_null()) {
      response["description"] = fmt::format("`{}`: {}", row.code, row.about);
      if (row.retry_s != 0) response["headers"]["Retry-After"] = header_object("Retry-After");
      if (row.status == kNotAuthenticated) response["headers"]["WWW-Authenticate"] = header_object("WWW-Authenticate");
      response["content"] = problem_content();
    } else {
      auto& text = response["description"].get_ref<std::string&>();
      text += fmt::format("; `{}`: {}", row.code, row.about);
    }
  }
  return all;
}

void add_problems(const OpenApiRoute& route, Document& responses) {
  for (const unsigned status : statuses_of(route))
    responses[std::to_string(status)] = {{"$ref", fmt::format("#/components/responses/{}", name_of(status))}};
  Document other = {{"description", "another problem"}, {"content", problem_content()}};
  if (has_type(route, "application/xml")) other["content"]["application/xml"] = {{"schema", {{"type", "string"}}}};
  responses["default"] = std::move(other);
}

}  // namespace dripfeed::json
