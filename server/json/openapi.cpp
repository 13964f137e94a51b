// Paths, parameters, rights, bodies and answers. A page of a list is a schema of its own: "JobPage".
#include "server/json/openapi.h"

#include <array>
#include <cmath>

#include <fmt/format.h>

#include "server/app/out/event_types.h"
#include "server/json/api_examples.h"
#include "server/json/api_words.h"
#include "server/json/object_reader.h"
#include "server/json/openapi_problems.h"
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

// A parameter of this route with what it means.
Document parameter(const OpenApiRoute& route, std::string_view name, std::string_view in, bool required,
                   Document schema) {
  return {{"name", name},
          {"in", in},
          {"required", required},
          {"description", parameter_about(route.path, name)},
          {"schema", std::move(schema)}};
}

Document query_schema(std::string_view path, std::string_view name) {
  Document schema = {{"type", is_query_number(name) ? "integer" : "string"}};
  if (is_query_number(name)) schema["minimum"] = 0;
  if (const auto words = query_words(path, name); !words.empty()) schema["enum"] = words;
  return schema;
}

Document parameters_of(const OpenApiRoute& route) {
  const Document text = {{"type", "string"}};
  Document parameters = Document::array();
  const std::string_view path = route.path;
  for (std::size_t open = path.find('{'); open != std::string_view::npos; open = path.find('{', open + 1)) {
    const std::size_t close = path.find('}', open);
    parameters.push_back(parameter(route, path.substr(open + 1, close - open - 1), "path", true, text));
  }
  if (route.paged) {
    const Document limit = {{"type", "integer"}, {"minimum", 1}, {"maximum", 200}};
    parameters.push_back(parameter(route, "limit", "query", false, limit));
    parameters.push_back(parameter(route, "after", "query", false, text));
  }
  for (const std::string_view name : route.query)
    parameters.push_back(parameter(route, name, "query", false, query_schema(path, name)));
  if (route.if_match) parameters.push_back(parameter(route, "If-Match", "header", true, text));
  if (route.once) parameters.push_back(parameter(route, "Idempotency-Key", "header", false, text));
  return parameters;
}

constexpr std::string_view kJson = "application/json";
constexpr std::string_view kEventStream = "text/event-stream";

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

// A page of what the list's items have as their example.
Document page_example(const Document& item) {
  return Document::array({{{"items", item.value("examples", Document::array())}, {"next", nullptr}}});
}

Document schemas_of(std::span<const OpenApiRoute> routes) {
  Document schemas = Document::object();
  for (const NamedSchema& one : all_schemas()) schemas[one.name] = write(one.schema);
  for (const OpenApiRoute& route : routes)
    if (route.lists) schemas[page_name(route.answer)] = page_of(route.answer);
  const Document examples = Document::parse(api_examples());
  for (const auto& [name, example] : examples.items()) schemas.at(name)["examples"] = Document::array({example});
  for (const OpenApiRoute& route : routes)
    if (route.lists) schemas[page_name(route.answer)]["examples"] = page_example(schemas.at(std::string(route.answer)));
  return schemas;
}

Document content(std::string_view type, Document schema) {
  return {{std::string(type), {{"schema", std::move(schema)}}}};
}

// The events of a stream, each with its data: EventWire belongs to the wire of one machine, all others to the events.
Document event_stream(std::string_view path) {
  Document events = Document::array();
  for (const NamedSchema& one : all_schemas()) {
    constexpr std::string_view kEvent = "Event";
    if (!one.name.starts_with(kEvent) || (one.name == "EventWire") != path.ends_with("/wire")) continue;
    events.push_back(
        {{"type", "object"},
         {"required", {"event", "data"}},
         {"properties",
          {{"event", {{"const", lower(one.name.substr(kEvent.size()))}}}, {"data", to_reference(one.name)}}}});
  }
  Document items = events.size() == 1 ? std::move(events[0]) : Document{{"oneOf", std::move(events)}};
  return {{"type", "string"},
          {"description", "Server-Sent Events: `event` names the kind, `data` is one line of JSON"},
          {"contentMediaType", kEventStream},
          {"contentSchema", {{"type", "array"}, {"items", std::move(items)}}}};
}

Document answer_of(const OpenApiRoute& route) {
  Document answer = {{"description", route.summary}};
  if (route.status == 201) answer["headers"]["Location"] = header_object("Location");
  for (const std::string_view name : route.headers) answer["headers"][std::string(name)] = header_object(name);
  Document types = Document::object();
  if (!route.answer.empty())
    types = content(kJson, to_reference(route.lists ? page_name(route.answer) : std::string(route.answer)));
  for (const std::string_view type : route.types)
    types.update(content(type, type == kEventStream ? event_stream(route.path) : Document{{"type", "string"}}));
  if (!types.empty()) answer["content"] = std::move(types);
  return answer;
}

// What its row says of a route besides its summary, in sentences.
std::string about(const OpenApiRoute& route) {
  std::string text = route.open ? "Needs no token." : fmt::format("Needs the role `{}`.", route.right);
  if (!route.scope.empty()) text += fmt::format(" A token with scopes needs `{}`.", route.scope);
  if (route.once) text += " Takes effect once under an `Idempotency-Key`.";
  if (route.if_match) text += " Changes the revision that `If-Match` names.";
  if (route.lists && route.paged) text += " The next page is `after` the `next` of this one.";
  return text;
}

// Its type is that of the file; what is none, or not known, is application/octet-stream.
Document file_body(bool is_needed) {
  return {{"required", is_needed},
          {"description", "the bytes of the file"},
          {"content", content("*/*", {{"type", "string"}, {"contentMediaType", "application/octet-stream"}})}};
}

Document operation_of(const OpenApiRoute& route) {
  Document operation = {{"operationId", operation_id(route)},
                        {"summary", route.summary},
                        {"description", about(route)},
                        {"tags", {tag_of(route.path)}},
                        {"parameters", parameters_of(route)}};
  if (!route.body.empty())
    operation["requestBody"] = {{"required", route.needs_body}, {"content", content(kJson, to_reference(route.body))}};
  if (route.takes_file) operation["requestBody"] = file_body(route.needs_body);
  operation["x-role"] = route.right;
  if (route.open) operation["security"] = Document::array();
  Document responses = {{std::to_string(route.status), answer_of(route)}};
  add_problems(route, responses);
  operation["responses"] = std::move(responses);
  return operation;
}

Document tags() {
  Document all = Document::array();
  for (const ApiTag& tag : api_tags()) all.push_back({{"name", tag.name}, {"description", tag.about}});
  return all;
}

Document info(std::string_view version) {
  return {{"title", "dripfeed"},
          {"version", version},
          {"description",
           "Program distribution and DNC for CNC machine tools. Times are in milliseconds since 1970, UTC. A client "
           "must accept members and words of enums that are not listed here: new ones come without a new version."},
          {"contact", {{"name", "the developers of dripfeed"}}},
          {"license", {{"name", "Apache-2.0"}, {"identifier", "Apache-2.0"}}}};
}

// What we post to others: one entry a type of event.
Document webhooks_of(std::span<const app::EventType> types) {
  Document all = Document::object();
  for (const app::EventType& type : types)
    all[std::string(type.name)]["post"] = {
        {"operationId", operation_id({.method = "webhook", .path = type.name, .summary = {}, .right = {}})},
        {"summary", type.when},
        {"description", "Posted to webhooks that want this type, until it is taken."},
        {"tags", {"Webhooks"}},
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
               {"info", info(version)},
               {"servers", Document::array({{{"url", "/"}, {"description", "this server"}}})},
               {"tags", tags()},
               {"security", Document::array({{{"token", Document::array()}}, {{"session", Document::array()}}})},
               {"paths", std::move(paths)},
               {"webhooks", webhooks_of(app::event_types())},
               {"components",
                {{"schemas", schemas_of(routes)},
                 {"responses", problem_responses()},
                 {"securitySchemes",
                  {{"token", {{"type", "http"}, {"scheme", "bearer"}}},
                   {"session", {{"type", "apiKey"}, {"in", "cookie"}, {"name", "dripfeed_session"}}}}}}}});
}

}  // namespace dripfeed::json
