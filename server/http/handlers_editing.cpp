// For who writes a text: what is wrong with it as it stands, and the words of its language.
#include <utility>

#include "server/app/diagnose.h"
#include "server/http/api.h"
#include "server/http/handlers.h"
#include "server/json/diagnostics.h"
#include "server/json/requests.h"

namespace dripfeed::http {

Response diagnose(const Call& call) {
  auto body = json::read_diagnose_body(call.request.body);
  if (!body) return problem_response(body.error());
  app::DiagnoseOrder order{.dialect = body->dialect, .text = std::move(body->text), .delivery = body->delivery};
  if (!body->machine.empty()) {
    auto machine = app::lift(call.api.application().store().machines().get(body->machine));
    if (!machine) return problem_response(machine.error());
    order.profile = std::move(machine->profile);
  }
  const auto done = call.api.workers().diagnose(order, waiter_of(call, "diagnose", "text", body->machine));
  if (!done) return problem_response(done.error());
  return json_response(200, *done);
}

Response get_dialect_words(const Call& call) {
  auto words =
      json::dialect_words(call.parameters[0], query_text(call.request, "kind"), query_text(call.request, "g_system"));
  if (!words) return problem_response(words.error());
  return json_response(200, std::move(*words));
}

}  // namespace dripfeed::http
