// The past in sums, as a document or as a file for a spreadsheet, and why transfers stood still.
#include <fmt/format.h>

#include "server/app/jobs/history.h"
#include "server/http/api.h"
#include "server/http/handlers.h"
#include "server/json/history.h"
#include "server/json/orders.h"
#include "server/json/records.h"

namespace dripfeed::http {

namespace {

// ?by=; by machine where it is not given.
std::expected<app::SumsBy, Response> sums_by(const Request& request) {
  const std::string given = query_text(request, "by");
  if (given.empty()) return app::SumsBy::machine;
  for (std::size_t i = 0; i < app::kSumsByNames.size(); ++i)
    if (app::kSumsByNames[i] == given) return static_cast<app::SumsBy>(i);
  return std::unexpected(
      problem_response(422, fmt::format("sums are by machine, part, day or shift, not by \"{}\"", given)));
}

std::expected<store::EndedFilter, Response> ended_filter(const Request& request) {
  const auto span = span_of(request);
  if (!span) return std::unexpected(span.error());
  store::EndedFilter filter{
      .from_ms = span->from_ms, .to_ms = span->to_ms, .machine = query_text(request, "machine"), .state = std::nullopt};
  if (const std::string state = query_text(request, "state"); !state.empty()) {
    filter.state = store::named<store::JobState>(state);
    if (!filter.state || !store::ended(*filter.state))
      return std::unexpected(problem_response(422, fmt::format("no job ends in the state \"{}\"", state)));
  }
  return filter;
}

}  // namespace

Response get_stop_reasons(const Call& call) {
  const auto span = span_of(call.request);
  if (!span) return span.error();
  app::StopReasons& reasons = call.api.application().stop_reasons();
  const auto counts = reasons.counts(span->from_ms, span->to_ms, query_text(call.request, "machine"));
  if (!counts) return problem_response(counts.error());
  return json_response(200, json::stop_reason_counts(reasons.offered(), *counts));
}

Response list_job_stop_reasons(const Call& call) {
  const auto id = id_of(call.parameters[0]);
  if (!id) return id.error();
  const auto reasons = call.api.application().stop_reasons().of_job(*id);
  return reasons ? json_response(200, json::job_stop_reasons(*reasons)) : problem_response(reasons.error());
}

Response add_stop_reason(const Call& call) {
  const auto id = id_of(call.parameters[0]);
  if (!id) return id.error();
  const auto body = json::read_stop_reason_body(call.request.body);
  if (!body) return problem_response(body.error());
  const auto stated = call.api.application().stop_reasons().state(*id, body->reason, body->note, call.user);
  if (!stated) return problem_response(stated.error());
  return created(fmt::format("/api/v1/jobs/{}/stop-reasons", *id), json::stop_reason(*stated));
}

Response get_history_sums(const Call& call) {
  const auto by = sums_by(call.request);
  if (!by) return by.error();
  const auto filter = ended_filter(call.request);
  if (!filter) return filter.error();
  app::Application& app = call.api.application();
  const auto sums = app::history_sums(app.store(), *filter, *by, app.shifts());
  if (!sums) return problem_response(sums.error());
  const bool wants_csv = call.request.accept.find("text/csv") != std::string::npos;
  Response response = json_response(200, wants_csv ? json::history_csv(*sums, *by) : json::history_sums(*sums, *by));
  if (wants_csv) response.content_type = "text/csv; charset=utf-8";
  response.headers.emplace_back("Vary", "Accept");
  return response;
}

}  // namespace dripfeed::http
