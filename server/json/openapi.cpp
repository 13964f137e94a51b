// Paths, parameters, rights and the kinds of answers; the shape of bodies is told by their errors.
#include "server/json/openapi.h"

#include <fmt/format.h>

#include "server/json/object_reader.h"

namespace dripfeed::json {

namespace {

std::string lower(std::string_view text) {
  std::string out(text);
  for (char& c : out) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return out;
}

// "post_jobs_id_arm": the method and the words of the path behind its version.
std::string operation_id(const OpenApiRoute& route) {
  constexpr std::string_view kBase = "/api/v1";
  std::string_view path = route.path;
  if (path.starts_with(kBase)) path.remove_prefix(kBase.size());
  std::string id = lower(route.method);
  bool gap = true;
  for (const char c : path) {
    const bool word = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
    if (word && gap) id += '_';
    if (word) id += c;
    gap = !word;
  }
  return id == "get" ? "get_page" : id;
}

Document text_parameter(std::string_view name, std::string_view in, bool required) {
  return {{"name", name}, {"in", in}, {"required", required}, {"schema", {{"type", "string"}}}};
}

Document parameters_of(const OpenApiRoute& route) {
  Document parameters = Document::array();
  const std::string_view path = route.path;
  for (std::size_t open = path.find('{'); open != std::string_view::npos; open = path.find('{', open + 1)) {
    const std::size_t close = path.find('}', open);
    parameters.push_back(text_parameter(path.substr(open + 1, close - open - 1), "path", true));
  }
  if (route.paged) {
    parameters.push_back({{"name", "limit"},
                          {"in", "query"},
                          {"required", false},
                          {"schema", {{"type", "integer"}, {"minimum", 1}, {"maximum", 200}}}});
    parameters.push_back(text_parameter("after", "query", false));
  }
  for (const std::string_view name : route.query) parameters.push_back(text_parameter(name, "query", false));
  if (route.if_match) parameters.push_back(text_parameter("If-Match", "header", true));
  if (route.method != "GET" && !route.open) parameters.push_back(text_parameter("Idempotency-Key", "header", false));
  return parameters;
}

}  // namespace

std::string openapi(std::span<const OpenApiRoute> routes, std::string_view version) {
  Document paths = Document::object();
  for (const OpenApiRoute& route : routes) {
    Document operation = {
        {"operationId", operation_id(route)}, {"summary", route.summary}, {"parameters", parameters_of(route)}};
    if (route.method == "POST" || route.method == "PUT")
      operation["requestBody"] = {{"content", {{"application/json", {{"schema", {{"type", "object"}}}}}}}};
    operation["x-role"] = route.right;
    if (route.open) operation["security"] = Document::array();
    operation["responses"] = {
        {"2XX", {{"description", "done"}}},
        {"default",
         {{"description", "a problem"},
          {"content", {{"application/problem+json", {{"schema", {{"$ref", "#/components/schemas/Problem"}}}}}}}}}};
    paths[std::string(route.path)][lower(route.method)] = std::move(operation);
  }
  const Document problem = {{"type", "object"},
                            {"properties",
                             {{"title", {{"type", "string"}}},
                              {"status", {{"type", "integer"}}},
                              {"detail", {{"type", "string"}}},
                              {"errors", {{"type", "array"}, {"items", {{"type", "object"}}}}}}}};
  return dump({{"openapi", "3.1.0"},
               {"info", {{"title", "dripfeed"}, {"version", version}}},
               {"security", Document::array({{{"token", Document::array()}}, {{"session", Document::array()}}})},
               {"paths", std::move(paths)},
               {"components",
                {{"schemas", {{"Problem", problem}}},
                 {"securitySchemes",
                  {{"token", {{"type", "http"}, {"scheme", "bearer"}}},
                   {"session", {{"type", "apiKey"}, {"in", "cookie"}, {"name", "dripfeed_session"}}}}}}}});
}

}  // namespace dripfeed::json
