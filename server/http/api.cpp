// Order: find the route, the caller, the right, the origin of a write by cookie, an earlier answer; then the handler.
#include "server/http/api.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <exception>
#include <utility>

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include "server/http/handlers.h"
#include "server/http/rights.h"
#include "server/json/records.h"

namespace dripfeed::http {

namespace {

constexpr store::Id kMostId = INT64_MAX;  // of a row

template <class Number>
bool read_number(std::string_view text, Number& into) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), into);
  return error == std::errc{} && end == text.data() + text.size();
}

// Bodies are JSON. What curl and others call a body that no one described is taken as well; a type that a page of
// another site may send unasked (text/plain) is not.
bool is_json(const Request& request) {
  constexpr std::array<std::string_view, 3> kTaken = {"", "application/json", "application/x-www-form-urlencoded"};
  std::string type = request.content_type.substr(0, request.content_type.find(';'));
  while (type.ends_with(' ') || type.ends_with('\t')) type.pop_back();
  for (char& c : type) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return std::ranges::find(kTaken, type) != kTaken.end() && request.content_encoding.empty();
}

// What is wrong with the form of a body; "" where nothing is. A file comes unchanged.
std::string_view why_not_taken(const Route& route, const Request& request) {
  if (route.carries == Carries::file)
    return request.content_encoding.empty() ? "" : "a file must be sent without a content encoding";
  return request.body.empty() || is_json(request) ? "" : "a body must be JSON, without a content encoding";
}

}  // namespace

Response json_response(unsigned status, std::string body) {
  Response response;
  response.status = status;
  response.body = std::move(body);
  return response;
}

namespace {

Response problem_of(const json::ProblemCode& code, const app::Error& error) {
  Response response = json_response(code.status, json::problem(code, error));
  response.content_type = "application/problem+json";
  if (code.retry_s != 0) retry_after(response, code.retry_s);
  if (code.status == 401) response.headers.emplace_back("WWW-Authenticate", "Bearer");  // RFC 9110, 11.6.1
  return response;
}

}  // namespace

void retry_after(Response& response, std::int64_t seconds) {
  constexpr const char* kName = "Retry-After";
  std::erase_if(response.headers, [](const auto& header) { return header.first == kName; });
  response.headers.emplace_back(kName, fmt::format("{}", seconds));
}

Response problem_response(const app::Error& error) { return problem_of(json::problem_code(error), error); }

Response problem_response(unsigned status, std::string text) {
  const json::ProblemCode& code = json::problem_code(status, text);
  return problem_of(code, {app::ErrorCode::invalid, std::move(text), {}});
}

Response created(std::string location, std::string body) {
  Response response = json_response(201, std::move(body));
  response.headers.emplace_back("Location", std::move(location));
  return response;
}

Response no_content() {
  Response response;
  response.status = 204;
  response.content_type.clear();
  return response;
}

store::Stamp stamp_of(const Call& call) { return {std::string(call.user), call.api.application().clock().wall_ms()}; }

Response with_revision(Response response, std::uint64_t revision) {
  response.headers.emplace_back("ETag", fmt::format("\"{}\"", revision));
  return response;
}

std::expected<std::uint64_t, Response> expected_revision(const Request& request) {
  if (request.if_match.empty())
    return std::unexpected(problem_response(428, "If-Match with the revision that is changed is needed"));
  std::string_view tag = request.if_match;
  if (tag.size() >= 2 && tag.starts_with('"') && tag.ends_with('"')) tag = tag.substr(1, tag.size() - 2);
  std::uint64_t revision = 0;
  if (!read_number(tag, revision)) return std::unexpected(problem_response(412, "If-Match is not a revision of this"));
  return revision;
}

std::expected<TimeSpan, Response> span_of(const Request& request) {
  constexpr std::uint64_t kLatest_ms = std::uint64_t{1} << 53U;
  const auto from_ms = number_of(request, "from_ms", 0, 0, kLatest_ms);
  if (!from_ms) return std::unexpected(from_ms.error());
  const auto to_ms = number_of(request, "to_ms", kLatest_ms, 1, kLatest_ms);
  if (!to_ms) return std::unexpected(to_ms.error());
  if (*from_ms >= *to_ms) return std::unexpected(problem_response(422, "from_ms must be before to_ms"));
  return TimeSpan{static_cast<std::int64_t>(*from_ms), static_cast<std::int64_t>(*to_ms)};
}

std::string query_text(const Request& request, const std::string& name) {
  const auto found = request.query.find(name);
  return found == request.query.end() ? std::string() : found->second;
}

std::expected<store::PageRequest, Response> page_of(const Request& request) {
  constexpr std::uint32_t kMostItems = 200;
  store::PageRequest page;
  if (const auto limit = request.query.find("limit"); limit != request.query.end()) {
    if (!read_number(limit->second, page.limit) || page.limit == 0 || page.limit > kMostItems) {
      return std::unexpected(problem_response(422, "limit must be from 1 to 200"));
    }
  }
  if (const auto after = request.query.find("after"); after != request.query.end()) page.after = after->second;
  return page;
}

std::expected<std::uint64_t, Response> number_of(const Request& request, const std::string& name,
                                                 std::uint64_t standard, std::uint64_t low, std::uint64_t high) {
  const auto given = request.query.find(name);
  if (given == request.query.end()) return standard;
  std::uint64_t number = 0;
  if (!read_number(given->second, number) || number < low || number > high)
    return std::unexpected(problem_response(422, fmt::format("{} must be from {} to {}", name, low, high)));
  return number;
}

std::expected<store::Id, Response> id_in(const Request& request, const std::string& name) {
  return number_of(request, name, 0, 1, kMostId);
}

std::expected<store::Id, Response> id_of(std::string_view text) {
  store::Id id = 0;
  if (!read_number(text, id) || id == 0 || id > kMostId)
    return std::unexpected(problem_response(404, fmt::format("\"{}\" is no id", text)));
  return id;
}

Api::Api(app::Application& application, json::DocumentWorkers& workers, std::filesystem::path web_root,
         std::string version, std::stop_token stop, ProviderSignIn* provider)
    : application_(application),
      workers_(workers),
      web_root_(std::move(web_root)),
      version_(std::move(version)),
      stop_(std::move(stop)),
      provider_(provider),
      sessions_(application.store().tokens(), application.store().users(), application.store().browser_sessions(),
                [&application] { return application.clock().wall_ms(); }),
      live_(
          application.events(), [&application](const std::string& machine) { return application.status(machine); },
          [this](const Credential& credential) { return sessions_.is_valid(credential); }),
      machine_list_(application, titles_),
      traffic_(std::make_shared<Traffic>(routes().size())) {}

namespace {

Lane lane_of(const Route& route) {
  switch (route.weight) {
    case Weight::stored: return Lane::read;
    case Weight::light:
      if (route.method != Method::get) return Lane::write;
      return route.right == Right::anybody ? Lane::here : Lane::read;  // a route without a right asks no store
    case Weight::staged: return Lane::write;
    case Weight::command: return Lane::command;
    case Weight::arming: return Lane::arm;
    case Weight::bulk:
    case Weight::setup: return Lane::bulk;
    case Weight::heavy: return Lane::heavy;
    case Weight::secret: return Lane::secret;
    case Weight::provider: return Lane::provider;
  }
  return Lane::here;
}

}  // namespace

namespace {

// A browser that comes by a path ("/jobs/3" was typed, or kept) gets the page, which finds the place itself.
bool wants_page(const Request& request) {
  if (request.method != Method::get || request.accept.find("text/html") == std::string::npos) return false;
  return !request.path.empty() && request.path[0] != "api" && request.path[0] != "assets";
}

}  // namespace

Plan Api::plan(const Request& head) {
  const Match match = find_route(routes(), head);
  if (match.route == nullptr) return {.lane = wants_page(head) ? Lane::bulk : Lane::here};
  return {.lane = lane_of(*match.route),
          .body_limit_bytes = match.route->carries == Carries::document ? kSmallBody_bytes : kLargeBody_bytes,
          .route = static_cast<std::size_t>(match.route - routes().data()),
          .fetches_body = match.route->carries != Carries::file};
}

// The fence of what libraries throw (a document too deep, no memory): one request fails, the lines go on.
Response Api::answer(const Request& request) {
  try {
    return answer_found(request, find_route(routes(), request));
  } catch (const std::exception& error) {
    spdlog::error("{} {}: {}", name_of(request.method), request.target, error.what());
    return problem_response(500, "the request failed inside the server");
  }
}

namespace {

Response no_route(const Request& request, const Match& match) {
  if (!match.path_known) return problem_response(404, fmt::format("there is nothing at {}", request.target));
  Response response = problem_response(405, fmt::format("this path is for {}", match.allowed));
  response.headers.emplace_back("Allow", match.allowed);
  return response;
}

}  // namespace

Response Api::answer_found(const Request& request, const Match& match) {
  if (match.route != nullptr) return answer_route(request, match);
  if (!match.path_known && wants_page(request))
    return get_page({.api = *this, .request = request, .parameters = {}, .user = {}, .right = Right::anybody});
  return no_route(request, match);
}

std::optional<Response> Api::refuse_long(const Request& head) {
  const Match match = find_route(routes(), head);
  if (match.route == nullptr) return no_route(head, match);
  if (match.route->right == Right::anybody) return problem_response(413, "the body is too long for this path");
  const auto caller = admit(head, *match.route);
  return caller ? std::nullopt : std::optional(caller.error());
}

namespace {

// A name that no header can carry comes percent-encoded.
bool is_shown(const std::string& shown, const std::string& name) {
  return shown.empty() || shown == name || decode_segment(shown) == name;
}

Response too_low(const Route& route, const Caller& caller, Right right) {
  return problem_response(403, fmt::format("this needs the role {}; {} has the role {}", name_of(route.right),
                                           caller.name, name_of(right)));
}

std::optional<Response> refuse_query(const Route& route, const Request& request) {
  const std::string_view name = unknown_query(route, request);
  if (name.empty()) return std::nullopt;
  return problem_response(400,
                          fmt::format("no query parameter \"{}\" here; this path takes: {}", name, query_names(route)));
}

}  // namespace

// Who calls, if they may.
std::expected<Caller, Response> Api::admit(const Request& request, const Route& route,
                                           std::optional<std::uint64_t> version) {
  auto caller = sessions_.caller(request, version);
  if (!caller && caller.error().code != store::ErrorCode::not_found)
    return std::unexpected(problem_response(app::from_store(caller.error())));
  if (!caller) return std::unexpected(problem_response(401, "sign in, or send a token"));
  if (reach(route, *caller) < route.right) return std::unexpected(too_low(route, *caller, caller->right));
  if (!allows(caller->scope, route)) {
    return std::unexpected(problem_response(
        403, fmt::format("this token may change: {}; this belongs to {}", caller->scope, scope_of(route))));
  }
  if (request.method != Method::get && caller->by_cookie && !same_origin(request)) {
    return std::unexpected(problem_response(403, "a change by cookie must come from this server's own page"));
  }
  // Two tabs share a cookie: what one of them shows may be another's name by now.
  if (request.method != Method::get && !is_shown(request.shown_user, caller->name)) {
    const auto shown = decode_segment(request.shown_user);
    return std::unexpected(problem_response(409, fmt::format("you are signed in as {}, the page shows {}: reload",
                                                             caller->name, shown.value_or(request.shown_user))));
  }
  return std::move(*caller);
}

namespace {

// Nothing where the store cannot say it: then it is asked for everything again.
std::optional<std::uint64_t> version_of(store::Store& store) {
  const auto version = store.version();
  return version ? std::optional(*version) : std::nullopt;
}

}  // namespace

Response Api::answer_stored(const Call& call, const Route& route) {
  if (!call.version) return route.handler(call);
  if (auto kept = kept_.find(*call.version, call.request.target)) return std::move(*kept);
  Response response = route.handler(call);
  kept_.keep(*call.version, call.request.target, response);
  return response;
}

Response Api::answer_route(const Request& request, const Match& match) {
  const Route& route = *match.route;
  if (const std::string_view why = why_not_taken(route, request); !why.empty())
    return problem_response(415, std::string(why));
  Call call{.api = *this, .request = request, .parameters = match.parameters, .user = {}, .right = Right::anybody};
  if (route.right == Right::anybody) {
    // The page and what watches the server may be asked with any query.
    auto refused = route.pattern.starts_with("/api/v1/") ? refuse_query(route, request) : std::nullopt;
    return refused ? std::move(*refused) : route.handler(call);
  }
  call.version = version_of(application_.store());
  const auto caller = admit(request, route, call.version);
  if (!caller) return caller.error();
  if (auto refused = refuse_query(route, request)) return std::move(*refused);
  call.user = caller->name;
  call.right = right_for(route, call, *caller);
  call.caller = &*caller;
  if (call.right < route.right) return too_low(route, *caller, call.right);
  if (route.weight == Weight::stored) return answer_stored(call, route);
  const bool is_kept = request.method != Method::get && !opens_session(route.weight);
  if (is_kept && !request.idempotency_key.empty()) return answer_once(request, route, call);
  return route.weight == Weight::staged ? answer_staged(call, route, nullptr) : route.handler(call);
}

}  // namespace dripfeed::http
