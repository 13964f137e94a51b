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

Document path_parameters(std::string_view path) {
  Document parameters = Document::array();
  for (std::size_t open = path.find('{'); open != std::string_view::npos; open = path.find('{', open + 1)) {
    const std::size_t close = path.find('}', open);
    parameters.push_back({{"name", path.substr(open + 1, close - open - 1)},
                          {"in", "path"},
                          {"required", true},
                          {"schema", {{"type", "string"}}}});
  }
  return parameters;
}

}  // namespace

std::string openapi(std::span<const OpenApiRoute> routes, std::string_view version) {
  Document paths = Document::object();
  for (const OpenApiRoute& route : routes) {
    Document operation = {{"summary", route.summary}, {"parameters", path_parameters(route.path)}};
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
               {"security", Document::array({{{"token", Document::array()}}})},
               {"paths", std::move(paths)},
               {"components",
                {{"schemas", {{"Problem", problem}}},
                 {"securitySchemes", {{"token", {{"type", "http"}, {"scheme", "bearer"}}}}}}}});
}

}  // namespace dripfeed::json
