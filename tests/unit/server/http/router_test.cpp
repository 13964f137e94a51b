// Targets and routes: what is decoded, what is refused, which row of the table answers, and the table itself.
#include "server/http/router.h"

#include <algorithm>
#include <array>
#include <functional>
#include <map>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "server/http/api.h"
#include "server/http/rights.h"
#include "server/json/schemas.h"

namespace dripfeed::http {
namespace {

using Path = std::vector<std::string>;

std::optional<Request> target(std::string_view text) {
  Request request;
  if (!read_target(text, request)) return std::nullopt;
  return request;
}

TEST(Router, DecodesPathsSegmentBySegment) {
  EXPECT_EQ(target("/")->path, Path{""});
  EXPECT_EQ(target("/a/b")->path, (Path{"a", "b"}));
  EXPECT_EQ(target("/a/")->path, (Path{"a", ""}));
  EXPECT_EQ(target("//a")->path, (Path{"", "a"}));
  EXPECT_EQ(target("/a%2fb/c")->path, (Path{"a/b", "c"})) << "an encoded slash is a character of its segment";
  EXPECT_EQ(target("/a%2Fb")->path, Path{"a/b"});
  EXPECT_EQ(target("/%C3%A4%20x")->path, Path{"\xC3\xA4 x"});
  EXPECT_EQ(target("/a+b")->path, Path{"a+b"}) << "a plus is a blank in a query only";
  EXPECT_EQ(target("/...")->path, Path{"..."});
  EXPECT_EQ(target("/a%25")->path, Path{"a%"}) << "decoded once";
  EXPECT_EQ(target("/%252e%252e")->path, Path{"%2e%2e"});
}

TEST(Router, RefusesPathsThatLeadElsewhere) {
  for (const char* text : {"", "a", "*", "http://host/a", "/..", "/a/../b", "/.", "/a/./b", "/%2e%2e", "/%2E./x",
                           "/.%2e", "/%2e", "/a%", "/a%4", "/a%zz", "/a%4g", "/a%00b", "/%-1", "/% 1"}) {
    EXPECT_FALSE(target(text)) << text;
  }
}

TEST(Router, DecodesQueries) {
  using Query = std::map<std::string, std::string>;
  EXPECT_EQ(target("/a?")->query, Query{});
  EXPECT_EQ(target("/a?x=1&y=2")->query, (Query{{"x", "1"}, {"y", "2"}}));
  EXPECT_EQ(target("/a?x")->query, (Query{{"x", ""}}));
  EXPECT_EQ(target("/a?x=a+b%26c%3Dd")->query, (Query{{"x", "a b&c=d"}}));
  EXPECT_EQ(target("/a?x=1?2/..")->query, (Query{{"x", "1?2/.."}}));
  EXPECT_EQ(target("/a?x=1&x=2")->query, (Query{{"x", "2"}}));
  for (const char* text : {"/a?x=%", "/a?%zz=1", "/a?x=%00", "/a?x=1&y=%4"}) EXPECT_FALSE(target(text)) << text;
}

TEST(Router, EscapesNamesSoThatTheyComeBack) {
  for (const std::string name : {"mill-1", "a/b", "50% \xC3\xA4?#+&", "..", "~_.-"}) {
    const std::string escaped = escape_segment(name);
    EXPECT_EQ(escaped.find_first_of("/?# +&"), std::string::npos) << escaped;
    if (name == "..") continue;  // no segment of a path
    EXPECT_EQ(target("/" + escaped)->path, Path{name});
  }
  EXPECT_EQ(escape_segment("a/b %"), "a%2Fb%20%25");
}

Response nothing(const Call& /*call*/) { return {}; }

constexpr Route row(Method method, std::string_view pattern) {
  return {method, pattern, Right::viewer, Weight::light, nothing, "", kNoBody, kGivesNothing, Takes::no_more};
}
constexpr Route kRows[] = {
    row(Method::get, "/"),          row(Method::get, "/jobs"),           row(Method::post, "/jobs"),
    row(Method::get, "/jobs/{id}"), row(Method::post, "/jobs/{id}/arm"), row(Method::put, "/a/{x}/b/{y}"),
};

Match match(Method method, std::string_view text) {
  Request request = *target(text);
  request.method = method;
  return find_route(kRows, request);
}

TEST(Router, FindsTheRowOfAPath) {
  EXPECT_EQ(match(Method::get, "/").route, &kRows[0]);
  EXPECT_EQ(match(Method::post, "/jobs").route, &kRows[2]);
  const Match job = match(Method::get, "/jobs/7?x=1");
  EXPECT_EQ(job.route, &kRows[3]);
  EXPECT_EQ(job.parameters, Path{"7"});
  EXPECT_EQ(match(Method::put, "/a/1%2F2/b/3").parameters, (Path{"1/2", "3"}));
}

TEST(Router, APathThatIsNotThereDiffersFromAMethodThatIsNot) {
  for (const char* text : {"/job", "/jobs/", "/jobs//arm", "/jobs/7/arm/x", "/Jobs", "/jobs/7/", "//jobs", "/a/1/b"}) {
    const Match none = match(Method::get, text);
    EXPECT_EQ(none.route, nullptr) << text;
    EXPECT_FALSE(none.path_known) << text;
  }
  const Match wrong = match(Method::del, "/jobs");
  EXPECT_EQ(wrong.route, nullptr);
  EXPECT_TRUE(wrong.path_known);
  EXPECT_EQ(wrong.allowed, "GET, POST");
  EXPECT_EQ(match(Method::other, "/jobs/7/arm").allowed, "POST");
}

// The table that the server has: what must hold for every row, whatever rows there are.
TEST(Routes, EveryChangeNeedsARoleAndEveryRowIsReachable) {
  for (const Route& route : routes()) {
    SCOPED_TRACE(std::string(name_of(route.method)) + " " + std::string(route.pattern));
    ASSERT_NE(route.handler, nullptr);
    EXPECT_FALSE(route.summary.empty());
    const bool changes = route.method != Method::get;
    const bool signs_in = route.pattern.starts_with("/api/v1/session");
    EXPECT_TRUE(!changes || signs_in || route.right >= Right::operator_);
    EXPECT_TRUE(!route.pattern.starts_with("/api/v1") || signs_in || route.right >= Right::viewer);
    Request request;
    std::string path(route.pattern);
    for (std::size_t open = path.find('{'); open != std::string::npos; open = path.find('{'))
      path.replace(open, path.find('}') - open + 1, "1");
    ASSERT_TRUE(read_target(path, request));
    request.method = route.method;
    EXPECT_EQ(find_route(routes(), request).route, &route) << "an earlier row takes its requests";
  }
}

// What a token with a scope may change, and what a role on one machine is good for.
TEST(Routes, AScopeAllowsItsOwnChangesAndAllReading) {
  std::size_t all = 0;
  for (const Route& route : routes()) {
    SCOPED_TRACE(std::string(name_of(route.method)) + " " + std::string(route.pattern));
    const std::string own(scope_of(route));
    EXPECT_NE(std::ranges::find(kScopes, own), std::end(kScopes));
    EXPECT_TRUE(allows("", route));
    EXPECT_TRUE(allows("nothing " + own, route));
    std::string others;
    for (const std::string_view scope : kScopes)
      if (scope != own) others += std::string(scope) + " ";
    EXPECT_EQ(allows(others, route), route.method == Method::get);
    all += own == "setup" ? 0U : 1U;
  }
  EXPECT_GT(all, 40U);
  EXPECT_EQ(unknown_scope("queue line"), "");
  EXPECT_EQ(unknown_scope("queue lines"), "lines");
}

TEST(Routes, ARoleOnOneMachineReachesWhatActsOnMachines) {
  const Caller caller{.name = "olga", .right = Right::viewer, .on_machines = {{"mill", Right::approver}}};
  const auto reached = [&](Method method, std::string_view pattern) {
    const auto route = std::ranges::find_if(
        routes(), [&](const Route& one) { return one.method == method && one.pattern == pattern; });
    return reach(*route, caller);
  };
  for (const std::string_view pattern : {"/api/v1/jobs/{id}/arm", "/api/v1/jobs/{id}/stop", "/api/v1/jobs",
                                         "/api/v1/releases/{id}/transitions", "/api/v1/checks/{id}/waivers"})
    EXPECT_EQ(reached(Method::post, pattern), Right::approver) << pattern;
  for (const std::string_view pattern : {"/api/v1/programs", "/api/v1/families", "/api/v1/users", "/api/v1/machines"})
    EXPECT_EQ(reached(Method::post, pattern), Right::viewer) << pattern;
}

// No route describes a body or an answer by a name that openapi.json has no schema for.
TEST(Routes, EveryBodyAndAnswerHasASchema) {
  std::set<std::string, std::less<>> names;
  for (const json::NamedSchema& one : json::all_schemas()) names.insert(one.name);
  for (const Route& route : routes()) {
    SCOPED_TRACE(std::string(name_of(route.method)) + " " + std::string(route.pattern));
    EXPECT_TRUE(route.body.schema.empty() || names.contains(route.body.schema)) << route.body.schema;
    EXPECT_TRUE(route.answer.schema.empty() || names.contains(route.answer.schema)) << route.answer.schema;
    // Two state more than their page, and some are short enough to be one.
    const bool states_more = route.pattern.ends_with("/ledger") || route.pattern.ends_with("/search");
    const bool is_short = route.pattern.ends_with("/work") || route.pattern == "/api/v1/groups" ||
                          route.pattern == "/api/v1/nodes" || route.pattern.ends_with("/event-types") ||
                          route.pattern == "/api/v1/backups";
    EXPECT_EQ(route.answer.page,
              (route.takes == Takes::page && !states_more) || (is_short && route.method == Method::get));
    EXPECT_TRUE(route.method != Method::get || route.body.schema.empty());
    const bool says_nothing = route.answer.schema.empty() && route.answer.types.empty();
    EXPECT_EQ(says_nothing, route.answer.status == 204);
  }
}

TEST(Routes, WhatMovesAMachineIsForOperatorsAndNoTransactionUndoesIt) {
  int count = 0;
  for (const Route& route : routes()) {
    const bool moves = route.pattern.starts_with("/api/v1/jobs/{id}/") || route.pattern.ends_with("/confirm-reset");
    // Rows alone: nothing is armed by them.
    constexpr std::array kOfTheQueue{"move", "schedule", "hold", "end-hold", "retry", "confirm-end", "stop-reasons"};
    const bool orders_queue = std::ranges::any_of(
        kOfTheQueue, [&](const char* word) { return route.pattern == std::string("/api/v1/jobs/{id}/") + word; });
    if (!moves || route.method == Method::get) continue;
    EXPECT_EQ(route.right, Right::operator_) << route.pattern;
    if (orders_queue) continue;
    const bool arms = route.pattern == "/api/v1/jobs/{id}/arm";
    EXPECT_EQ(route.weight, arms ? Weight::arming : Weight::command) << route.pattern;
    ++count;
  }
  EXPECT_GE(count, 5);
}

TEST(Answers, IfMatchNamesARevision) {
  const auto with = [](std::string tag) {
    Request request;
    request.if_match = std::move(tag);
    return expected_revision(request);
  };
  EXPECT_EQ(with("\"3\""), 3U);
  EXPECT_EQ(with("3"), 3U);
  EXPECT_EQ(with("").error().status, 428U);
  for (const char* tag : {"*", "\"\"", "\"x\"", "W/\"3\"", "\"3", "-1", "\"3\", \"4\"", "99999999999999999999"})
    EXPECT_EQ(with(tag).error().status, 412U) << tag;
  const Response tagged = with_revision(json_response(200, "{}"), 7);
  EXPECT_EQ(tagged.headers.back(), (std::pair<std::string, std::string>{"ETag", "\"7\""}));
}

TEST(Answers, PagesAndIds) {
  const auto page = [](std::string_view query) { return page_of(*target("/a?" + std::string(query))); };
  EXPECT_EQ(page("")->limit, 50U);
  EXPECT_EQ(page("limit=1")->limit, 1U);
  EXPECT_EQ(page("limit=200&after=x")->after, "x");
  for (const char* query : {"limit=0", "limit=201", "limit=-1", "limit=", "limit=ten", "limit=5x", "limit=99999999999"})
    EXPECT_EQ(page(query).error().status, 422U) << query;
  EXPECT_EQ(id_of("17"), 17U);
  for (const char* id : {"", "0", "-1", "1x", " 1", "0x1", "99999999999999999999"})
    EXPECT_EQ(id_of(id).error().status, 404U) << id;
}

TEST(Answers, ErrorsBecomeProblems) {
  using enum app::ErrorCode;
  const std::pair<app::ErrorCode, unsigned> rows[] = {{not_found, 404},   {exists, 409},  {malformed, 400},
                                                      {invalid, 422},     {stale, 412},   {refused, 409},
                                                      {unavailable, 503}, {internal, 500}};
  for (const auto& [code, status] : rows) {
    const Response response = problem_response({code, "why", {}});
    EXPECT_EQ(response.status, status);
    EXPECT_EQ(response.content_type, "application/problem+json");
    EXPECT_NE(response.body.find("\"detail\":\"why\""), std::string::npos);
  }
}

}  // namespace
}  // namespace dripfeed::http
