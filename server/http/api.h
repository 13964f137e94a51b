// From a request to its answer: who calls, may they, was this answered before, which handler. The server gives it
// requests; handlers live in handlers_*.cpp, one file a kind of thing, and are listed in routes.cpp.
#pragma once

#include <atomic>
#include <expected>
#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <span>
#include <stop_token>
#include <string>

#include "server/app/application.h"
#include "server/http/kept_answers.h"
#include "server/http/live.h"
#include "server/http/machine_list.h"
#include "server/http/page_files.h"
#include "server/http/router.h"
#include "server/http/server.h"
#include "server/http/sessions.h"
#include "server/http/titles.h"
#include "server/json/workers.h"

namespace dripfeed::http {

struct ProviderSignIn;

class Api {
 public:
  // `web_root`: the built page (web/dist); empty: no page is served. `stop`: the server ends, and long work gives up.
  // `provider`: people may sign in by it; nullptr: there is none.
  Api(app::Application& application, json::DocumentWorkers& workers, std::filesystem::path web_root,
      std::string version, std::stop_token stop = {}, ProviderSignIn* provider = nullptr);

  // From the head of a request: where it is answered, and how long its body may be.
  [[nodiscard]] static Plan plan(const Request& head);
  Response answer(const Request& request);
  // Whether the head of a request says enough to refuse it before a long body is read: no route, no right, nothing
  // that takes one.
  std::optional<Response> refuse_long(const Request& head);

  app::Application& application() { return application_; }
  json::DocumentWorkers& workers() { return workers_; }
  Sessions& sessions() { return sessions_; }
  [[nodiscard]] ProviderSignIn* provider() const { return provider_; }
  LiveHub& live() { return live_; }
  Titles& titles() { return titles_; }
  MachineList& machine_list() { return machine_list_; }
  PageFiles& page_files() { return page_files_; }
  // For the server that asks this API.
  [[nodiscard]] const std::shared_ptr<Traffic>& traffic() const { return traffic_; }
  [[nodiscard]] const std::filesystem::path& web_root() const { return web_root_; }
  [[nodiscard]] const std::string& version() const { return version_; }
  // Set while a sweep runs: it may take minutes, and one at a time leaves the pool to checks.
  std::atomic_flag& sweeping() { return sweeping_; }
  [[nodiscard]] const std::stop_token& stop() const { return stop_; }

 private:
  std::expected<Caller, Response> admit(const Request& request, const Route& route,
                                        std::optional<std::uint64_t> version = std::nullopt);
  Response answer_stored(const Call& call, const Route& route);
  Response answer_found(const Request& request, const Match& match);
  Response answer_route(const Request& request, const Match& match);
  Response answer_once(const Request& request, const Route& route, const Call& call);
  Response answer_first(const Request& request, const Route& route, const Call& call);
  Response answer_staged(const Call& call, const Route& route, const store::ReplyKey* key);  // nullptr: without one
  std::optional<Response> answered_before(const store::ReplyKey& key);
  store::Result<void> keep_answer(const store::ReplyKey& key, const Response& response);
  void forget_old_replies(std::int64_t now_ms);

  app::Application& application_;
  json::DocumentWorkers& workers_;
  std::filesystem::path web_root_;
  std::string version_;
  std::stop_token stop_;
  ProviderSignIn* provider_;
  Sessions sessions_;
  LiveHub live_;
  Titles titles_;
  MachineList machine_list_;
  KeptAnswers kept_;
  PageFiles page_files_;
  std::shared_ptr<Traffic> traffic_;
  std::mutex keys_mutex_;
  std::set<std::string> keys_in_use_;
  std::atomic<std::int64_t> forgot_at_ms_ = 0;
  std::atomic_flag sweeping_;
};

// All routes, in the order of openapi.json.
std::span<const Route> routes();

// Building answers.
Response json_response(unsigned status, std::string body);
Response problem_response(const app::Error& error);
Response problem_response(unsigned status, std::string text);
// When to ask again, in the place of what the problem has by itself.
void retry_after(Response& response, std::int64_t seconds);
// 201 with Location.
Response created(std::string location, std::string body);
// 204.
Response no_content();
// A stream of live events; 429 where too many watch.
Response event_stream(std::expected<std::shared_ptr<EventSubscription>, std::string> watcher);
// With the ETag of a revision.
Response with_revision(Response response, std::uint64_t revision);
// The revision named by If-Match; or 428 without one, 412 when it is not a revision of ours.
std::expected<std::uint64_t, Response> expected_revision(const Request& request);
// Who calls, and when.
store::Stamp stamp_of(const Call& call);
// A parameter of the query; "" where it is not there.
std::string query_text(const Request& request, const std::string& name);
// ?limit= and &after=.
std::expected<store::PageRequest, Response> page_of(const Request& request);
// A number in the query, from `low` to `high`; `standard` where it is not given; or 422.
std::expected<std::uint64_t, Response> number_of(const Request& request, const std::string& name,
                                                 std::uint64_t standard, std::uint64_t low, std::uint64_t high);
struct TimeSpan {
  std::int64_t from_ms = 0;
  std::int64_t to_ms = 0;
};
// ?from_ms= and &to_ms=, without them all of time; or 422.
std::expected<TimeSpan, Response> span_of(const Request& request);
// An id in the path; or 404.
std::expected<store::Id, Response> id_of(std::string_view text);
// Of a query; 0 where it is not given.
std::expected<store::Id, Response> id_in(const Request& request, const std::string& name);

}  // namespace dripfeed::http
