// Paths, parameters, rights, bodies and answers. A page of a list is a schema of its own: "JobPage".
#include "server/json/openapi.h"

#include <array>
#include <cmath>

#include <fmt/format.h>

#include "server/app/event_types.h"
#include "server/json/object_reader.h"
#include "server/json/query_words.h"
#include "server/json/schemas.h"

namespace dripfeed::json {

namespace {

std::string lower(std::string_view text) {
  std::string out(text);
  for (char& c : out) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return out;
}

// "post_jobs_id_arm": the method and the words of the path after its version.
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

Document query_parameter(std::string_view path, std::string_view name) {
  Document schema = {{"type", is_query_number(name) ? "integer" : "string"}};
  if (is_query_number(name)) schema["minimum"] = 0;
  if (const auto words = query_words(path, name); !words.empty()) schema["enum"] = words;
  return {{"name", name}, {"in", "query"}, {"required", false}, {"schema", std::move(schema)}};
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
  for (const std::string_view name : route.query) parameters.push_back(query_parameter(path, name));
  if (route.if_match) parameters.push_back(text_parameter("If-Match", "header", true));
  if (route.method != "GET" && !route.open) parameters.push_back(text_parameter("Idempotency-Key", "header", false));
  return parameters;
}

constexpr std::string_view kJson = "application/json";

Document to_reference(std::string_view name) { return {{"$ref", fmt::format("#/components/schemas/{}", name)}}; }

// A bound as it is written in the tables: whole where it is whole.
Document bound(double value) {
  constexpr double kWhole = 9007199254740992.0;  // 2^53
  return value == std::floor(value) && std::abs(value) <= kWhole ? Document(static_cast<std::int64_t>(value))
                                                                 : Document(value);
}

Document write(const Schema& schema);

void write_object(const Schema& schema, Document& out) {
  Document properties = Document::object();
  Document required = Document::array();
  for (const Member& member : schema.members) {
    properties[member.name] = write(member.schema);
    if (member.presence == Presence::required) required.push_back(member.name);
  }
  out["properties"] = std::move(properties);
  if (!required.empty()) out["required"] = std::move(required);
  if (schema.is_closed) out["additionalProperties"] = false;
}

// What the kinds of schemas say besides their type.
void write_kind(const Schema& schema, Document& out) {
  switch (schema.kind) {
    case Schema::Kind::any:
    case Schema::Kind::reference:
    case Schema::Kind::text_or_number:
    case Schema::Kind::flag: break;
    case Schema::Kind::text:
      if (!schema.words.empty()) out["enum"] = schema.words;
      if (!schema.words.empty() && schema.may_be_null) out["enum"].push_back(nullptr);
      for (std::size_t i = 0; i < schema.meanings.size(); ++i)
        out["x-enumDescriptions"][std::string(schema.words[i])] = schema.meanings[i];
      if (schema.is_filled) out["minLength"] = 1;
      break;
    case Schema::Kind::integer:
    case Schema::Kind::number:
      if (schema.least) out["minimum"] = bound(*schema.least);
      if (schema.most) out["maximum"] = bound(*schema.most);
      break;
    case Schema::Kind::object: write_object(schema, out); break;
    case Schema::Kind::list:
      out["items"] = write(schema.of.front());
      if (schema.length) out["minItems"] = out["maxItems"] = *schema.length;
      break;
    case Schema::Kind::map: out["additionalProperties"] = write(schema.of.front()); break;
  }
}

// "type" of each kind; empty: any.
Document types_of(const Schema& schema) {
  static constexpr std::array<std::string_view, 10> kTypes = {"",       "string", "integer", "number", "boolean",
                                                              "object", "array",  "object",  "",       ""};
  Document types = Document::array();
  const std::string_view type = kTypes[static_cast<std::size_t>(schema.kind)];
  if (!type.empty()) types.push_back(type);
  if (schema.kind == Schema::Kind::text_or_number) types = {"string", "number"};
  if (schema.may_be_null && !types.empty()) types.push_back("null");
  return types;
}

Document write(const Schema& schema) {
  if (schema.kind == Schema::Kind::reference) {
    if (!schema.may_be_null) return to_reference(schema.name);
    return {{"anyOf", Document::array({to_reference(schema.name), {{"type", "null"}}})}};
  }
  Document out = Document::object();
  const Document types = types_of(schema);
  if (types.size() == 1) out["type"] = types[0];
  if (types.size() > 1) out["type"] = types;
  if (!schema.about.empty()) out["description"] = schema.about;
  write_kind(schema, out);
  return out;
}

std::string page_name(std::string_view of) { return fmt::format("{}Page", of); }

Document page_of(std::string_view of) {
  return write(object("a page of a list", {{"items", list_of(reference(std::string(of)), "in the list's order")},
                                           {"next", or_null(text("for `after` of the next page; null: the last"))}}));
}

Document schemas_of(std::span<const OpenApiRoute> routes) {
  Document schemas = Document::object();
  for (const NamedSchema& one : all_schemas()) schemas[one.name] = write(one.schema);
  for (const OpenApiRoute& route : routes)
    if (route.lists) schemas[page_name(route.answer)] = page_of(route.answer);
  return schemas;
}

Document content(std::string_view type, Document schema) {
  return {{std::string(type), {{"schema", std::move(schema)}}}};
}

Document answer_of(const OpenApiRoute& route) {
  Document answer = {{"description", route.summary}};
  Document types = Document::object();
  if (!route.answer.empty())
    types = content(kJson, to_reference(route.lists ? page_name(route.answer) : std::string(route.answer)));
  for (const std::string_view type : route.types) types.update(content(type, {{"type", "string"}}));
  if (!types.empty()) answer["content"] = std::move(types);
  return answer;
}

Document operation_of(const OpenApiRoute& route) {
  Document operation = {
      {"operationId", operation_id(route)}, {"summary", route.summary}, {"parameters", parameters_of(route)}};
  if (!route.body.empty())
    operation["requestBody"] = {{"required", route.needs_body}, {"content", content(kJson, to_reference(route.body))}};
  operation["x-role"] = route.right;
  if (route.open) operation["security"] = Document::array();
  operation["responses"] = {
      {std::to_string(route.status), answer_of(route)},
      {"default",
       {{"description", "a problem"}, {"content", content("application/problem+json", to_reference("Problem"))}}}};
  return operation;
}

// What we post to others: one entry a type of event.
Document webhooks_of(std::span<const app::EventType> types) {
  Document all = Document::object();
  for (const app::EventType& type : types)
    all[std::string(type.name)]["post"] = {
        {"summary", type.when},
        {"requestBody",
         {{"required", true}, {"content", content("application/cloudevents+json", to_reference(type.schema))}}},
        {"responses",
         {{"2XX", {{"description", "taken; all else is tried again"}}},
          {"410", {{"description", "gone: the webhook is disabled"}}}}}};
  return all;
}

}  // namespace

std::string json_schema(const Schema& schema) {
  Document document = {{"$schema", "https://json-schema.org/draft/2020-12/schema"}};
  document.update(write(schema));
  return dump(document);
}

std::string openapi(std::span<const OpenApiRoute> routes, std::string_view version) {
  Document paths = Document::object();
  for (const OpenApiRoute& route : routes) paths[std::string(route.path)][lower(route.method)] = operation_of(route);
  return dump({{"openapi", "3.1.0"},
               {"info", {{"title", "dripfeed"}, {"version", version}}},
               {"security", Document::array({{{"token", Document::array()}}, {{"session", Document::array()}}})},
               {"paths", std::move(paths)},
               {"webhooks", webhooks_of(app::event_types())},
               {"components",
                {{"schemas", schemas_of(routes)},
                 {"securitySchemes",
                  {{"token", {{"type", "http"}, {"scheme", "bearer"}}},
                   {"session", {{"type", "apiKey"}, {"in", "cookie"}, {"name", "dripfeed_session"}}}}}}}});
}

}  // namespace dripfeed::json
