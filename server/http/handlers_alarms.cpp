// Alarms: what is open, and what people do about it.
#include <fmt/format.h>

#include "server/http/api.h"
#include "server/http/handlers.h"
#include "server/http/list_response.h"
#include "server/json/records.h"
#include "server/json/requests.h"

namespace dripfeed::http {

namespace {

Response alarm_response(const app::Result<store::Alarm>& alarm) {
  if (!alarm) return problem_response(alarm.error());
  return json_response(200, json::alarm(*alarm));
}

}  // namespace

Response list_alarms(const Call& call) {
  const auto page = page_of(call.request);
  if (!page) return page.error();
  const std::string state = query_text(call.request, "state");
  if (!state.empty() && state != "open" && state != "all")
    return problem_response(422, fmt::format("\"{}\" is not a state of alarms: open or all", state));
  const store::AlarmFilter filter{.machine = query_text(call.request, "machine"), .open_only = state == "open"};
  return list_response(call.api.application().store().alarms().list(*page, filter),
                       [](const store::Alarm& alarm) { return json::alarm(alarm); });
}

Response get_alarm(const Call& call) {
  const auto id = id_of(call.parameters[0]);
  if (!id) return id.error();
  return alarm_response(app::lift(call.api.application().store().alarms().get(*id)));
}

Response acknowledge_alarm(const Call& call) {
  const auto id = id_of(call.parameters[0]);
  if (!id) return id.error();
  return alarm_response(call.api.application().alarms().acknowledge(*id, call.user));
}

Response shelve_alarm(const Call& call) {
  const auto id = id_of(call.parameters[0]);
  if (!id) return id.error();
  const auto body = json::read_shelve_body(call.request.body);
  if (!body) return problem_response(body.error());
  return alarm_response(call.api.application().alarms().shelve(*id, body->minutes, body->reason, call.user));
}

Response unshelve_alarm(const Call& call) {
  const auto id = id_of(call.parameters[0]);
  if (!id) return id.error();
  return alarm_response(call.api.application().alarms().unshelve(*id, call.user));
}

}  // namespace dripfeed::http
