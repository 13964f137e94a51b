// What people at a machine do with its line besides jobs: look at what passes, and test it.
#include <fmt/format.h>

#include "server/http/api.h"
#include "server/http/handlers.h"
#include "server/json/link_test.h"
#include "server/json/wire.h"

namespace dripfeed::http {

Response get_wire(const Call& call) {
  app::Application& app = call.api.application();
  auto tap = app.tap(call.parameters[0]);
  if (!tap) return problem_response(tap.error());
  const app::Clock& clock = app.clock();
  const auto write = [&clock, code = (*tap)->code()](const app::WireTap::Batch& batch) {
    return fmt::format("event: wire\ndata: {}\n\n", json::wire(batch, code, clock));
  };
  return event_stream(call.api.live().watch_wire(std::move(*tap), write, call.caller->credential));
}

// As many trials as show a bad line, and no more: the line is out of use meanwhile.
Response test_line(const Call& call) {
  app::LinkTestPlan plan{.round_trips = 20, .holds = 20, .patience = std::chrono::seconds(1), .stop = call.api.stop()};
  const auto tested = call.api.application().test_line(call.parameters[0], plan, call.user);
  if (!tested) return problem_response(tested.error());
  return json_response(200, json::line_test(tested->done, tested->line));
}

}  // namespace dripfeed::http
