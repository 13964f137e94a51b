// What belongs to the server itself: health, description, page, session, live events.
#include <charconv>
#include <memory>

#include <fmt/format.h>

#include "server/app/shop/sign_in.h"
#include "server/http/api.h"
#include "server/http/describe.h"
#include "server/http/handlers.h"
#include "server/http/provider_sign_in.h"
#include "server/json/people.h"

namespace dripfeed::http {

namespace {

constexpr std::size_t kSignInLimit = 4096;  // bytes that anyone may have read as JSON
constexpr std::size_t kProviderAnswerLimit = 8192;

Response no_file() { return problem_response(404, "there is no such file of the page; is web/dist built?"); }

Response file_response(const Call& call, const std::filesystem::path& path) {
  auto response = call.api.page_files().answer(path, call.request);
  return response ? std::move(*response) : no_file();
}

// A segment may hold an encoded slash, and "..%2F" leaves the folder: only plain names are files of the page.
bool is_plain_name(const Call& call, const std::string& name) {
  return !call.api.web_root().empty() && !name.starts_with('.') && name.find_first_of("/\\") == std::string::npos;
}

// Secure where the browser has spoken to us, or to a trusted proxy, by TLS.
std::string cookie(const Request& request, std::string_view value, std::string_view attributes) {
  return fmt::format("{}={}; Path=/; HttpOnly; SameSite=Strict{}{}", kSessionCookie, value,
                     request.is_encrypted ? "; Secure" : "", attributes);
}

}  // namespace

Response get_health(const Call& call) {
  return json_response(200, fmt::format(R"({{"status":"ok","version":"{}"}})", call.api.version()));
}

Response get_openapi(const Call& call) { return json_response(200, describe_api(call.api.version())); }

Response get_page(const Call& call) {
  if (call.api.web_root().empty()) return no_file();
  return file_response(call, call.api.web_root() / "index.html");
}

Response get_asset(const Call& call) {
  const std::string& name = call.parameters[0];
  return is_plain_name(call, name) ? file_response(call, call.api.web_root() / "assets" / name) : no_file();
}

Response get_docs(const Call& call) {
  if (call.api.web_root().empty()) return no_file();
  return file_response(call, call.api.web_root() / "docs" / "index.html");
}

Response get_docs_page(const Call& call) {
  const std::string& name = call.parameters[0];
  if (!is_plain_name(call, name)) return no_file();
  return file_response(call, call.api.web_root() / "docs" / (name.ends_with(".png") ? name : name + ".html"));
}

Response get_session(const Call& call) {
  json::SessionView view{.name = call.user,
                         .role = name_of(call.right),
                         .by = call.caller->signed_in_by,
                         .scope = call.caller->scope,
                         .machines = {}};
  for (const auto& [machine, right] : call.caller->on_machines) view.machines.emplace(machine, name_of(right));
  return json_response(200, json::session(view));
}

namespace {

// The cookie of a new session, or why there is none.
std::expected<std::string, Response> sign_in(const Call& call, const json::SessionBody& body) {
  Sessions& sessions = call.api.sessions();
  const auto refuse = [](Response response) { return std::unexpected(std::move(response)); };
  if (body.token.empty()) {
    app::Application& app = call.api.application();
    const auto answer = app::check_secret(app.store(), body.name, body.kind, body.secret, app.clock());
    if (!answer) return refuse(problem_response(answer.error()));
    if (answer->outcome == app::SignIn::locked) {
      const std::int64_t wait_s = (answer->locked_until_ms - app.clock().wall_ms()) / 1000 + 1;
      Response response = problem_response(429, fmt::format("too many wrong ones: try again in {} s", wait_s));
      retry_after(response, wait_s);
      return refuse(std::move(response));
    }
    if (answer->outcome == app::SignIn::wrong)
      return refuse(problem_response(401, fmt::format("the name or the {} is wrong", store::name_of(body.kind))));
  }
  const auto value = body.token.empty() ? sessions.open(body.name, body.kind) : sessions.open(body.token);
  if (value) return *value;
  if (value.error().code == store::ErrorCode::not_found)
    return refuse(problem_response(401, "this token is not valid"));
  return refuse(problem_response(app::from_store(value.error())));
}

}  // namespace

Response open_session(const Call& call) {
  // No one signs a browser in from another site.
  if (!call.request.origin.empty() && !same_origin(call.request))
    return problem_response(403, "a sign-in must come from this server's own page");
  if (call.request.body.size() > kSignInLimit) return problem_response(413, "this is longer than any token");
  const auto body = json::read_session_body(call.request.body);
  if (!body) return problem_response(body.error());
  const auto value = sign_in(call, *body);
  if (!value) return value.error();
  Response response = no_content();
  response.headers.emplace_back("Set-Cookie", cookie(call.request, *value, ""));
  return response;
}

namespace {

constexpr std::string_view kSignInCookie = "dripfeed_sign_in";

// Only the routes of this sign-in get it, from our own page.
std::string sign_in_cookie(const Request& request, std::string_view value, std::int64_t seconds) {
  return fmt::format("{}={}; Path=/api/v1/session/provider; HttpOnly; SameSite=Strict; Max-Age={}{}", kSignInCookie,
                     value, seconds, request.is_encrypted ? "; Secure" : "");
}

Response no_provider() { return problem_response(404, "no provider is configured here"); }

// No one begins or ends a sign-in of a browser from another site.
bool is_of_other_site(const Request& request) {
  const bool names_site = !request.origin.empty() || !request.fetch_site.empty();
  return names_site && !same_origin(request);
}

// The cookie of a new session, or why there is none.
app::Result<std::string> sign_in_by_provider(const Call& call, const json::ProviderAnswerBody& body) {
  ProviderSignIn& by = *call.api.provider();
  app::Application& app = call.api.application();
  const auto identity =
      by.provider.finish({.code = body.code, .state = body.state, .issuer = body.iss, .error = body.error},
                         cookie_value(call.request.cookie, kSignInCookie));
  if (!identity) return std::unexpected(identity.error());
  const app::VouchedPerson person{.identity = {by.provider.settings().issuer, identity->subject},
                                  .name = identity->name,
                                  .groups = identity->groups};
  const auto name = app::admit(app.store(), person, by.mapping, app.clock().wall_ms());
  if (!name) return std::unexpected(name.error());
  return app::lift(call.api.sessions().open_by_provider(*name));
}

}  // namespace

Response get_sign_in_provider(const Call& call) {
  const ProviderSignIn* const by = call.api.provider();
  return json_response(200, json::sign_in_provider(by == nullptr ? std::string() : by->provider.settings().title));
}

Response begin_provider_sign_in(const Call& call) {
  if (is_of_other_site(call.request)) return problem_response(403, "a sign-in must come from this server's own page");
  if (call.api.provider() == nullptr) return no_provider();
  const auto begun = call.api.provider()->provider.begin();
  if (!begun) return problem_response(begun.error());
  Response response = json_response(200, json::provider_sign_in(begun->url));
  response.headers.emplace_back("Cache-Control", "no-store");
  response.headers.emplace_back("Set-Cookie",
                                sign_in_cookie(call.request, begun->cookie, oidc::Tickets::kLast_ms / 1000));
  return response;
}

Response open_provider_session(const Call& call) {
  if (is_of_other_site(call.request)) return problem_response(403, "a sign-in must come from this server's own page");
  if (call.api.provider() == nullptr) return no_provider();
  if (call.request.body.size() > kProviderAnswerLimit) return problem_response(413, "this is longer than any answer");
  const auto body = json::read_provider_answer_body(call.request.body);
  if (!body) return problem_response(body.error());
  const auto value = sign_in_by_provider(call, *body);
  Response response = value ? no_content() : problem_response(value.error());
  response.headers.emplace_back("Set-Cookie", sign_in_cookie(call.request, "", 0));
  if (value) response.headers.emplace_back("Set-Cookie", cookie(call.request, *value, ""));
  return response;
}

Response close_session(const Call& call) {
  if (const auto closed = call.api.sessions().close(call.request); !closed)
    return problem_response(app::from_store(closed.error()));
  Response response = no_content();
  response.headers.emplace_back("Set-Cookie", cookie(call.request, "", "; Max-Age=0"));
  return response;
}

Response get_events(const Call& call) {
  app::Events& events = call.api.application().events();
  std::uint64_t after = events.last_id();
  const std::string& given = call.request.last_event_id;
  if (!given.empty()) {
    const auto [end, error] = std::from_chars(given.data(), given.data() + given.size(), after);
    if (error != std::errc{} || end != given.data() + given.size())
      return problem_response(422, "Last-Event-ID is not a number of this server");
  }
  return event_stream(call.api.live().watch(after, call.caller->credential));
}

Response event_stream(std::expected<std::shared_ptr<EventSubscription>, std::string> watcher) {
  if (!watcher) return problem_response(429, watcher.error());
  Response response;
  response.content_type = "text/event-stream";
  response.headers.emplace_back("Cache-Control", "no-store");
  response.events = std::move(*watcher);
  return response;
}

}  // namespace dripfeed::http
