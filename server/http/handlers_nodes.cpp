// Servers that share a store: which there are, and whose a machine's line is.
#include <algorithm>

#include "server/http/api.h"
#include "server/http/handlers.h"
#include "server/json/records.h"
#include "server/json/requests.h"

namespace dripfeed::http {

namespace {

constexpr const char* kAlone = "this server is the only one of its store";

Response status_of(app::Application& app, const std::string& machine) {
  return json_response(200, json::machine_status(app.status(machine)));
}

}  // namespace

Response list_nodes(const Call& call) {
  store::Nodes* const nodes = call.api.application().store().nodes();
  std::vector<std::string> items;
  if (nodes == nullptr) return json_response(200, json::list(items, {}));
  const auto all = nodes->list();
  const auto leases = nodes->leases();
  if (!all || !leases) return problem_response(app::from_store(all ? leases.error() : all.error()));
  for (const store::Node& node : *all) {
    std::vector<store::Lease> held;
    std::ranges::copy_if(*leases, std::back_inserter(held), [&](const auto& one) { return one.node == node.name; });
    items.push_back(json::node(node, held, node.name == nodes->own()));
  }
  return json_response(200, json::list(items, {}));
}

Response hand_over_machine(const Call& call) {
  const auto body = json::read_hand_over_body(call.request.body);
  if (!body) return problem_response(body.error());
  app::Application& app = call.api.application();
  if (app.nodes() == nullptr) return problem_response(409, kAlone);
  const std::string& machine = call.parameters[0];
  if (auto done = app.nodes()->hand_over(machine, body->node, body->reason, call.user); !done)
    return problem_response(done.error());
  return status_of(app, machine);
}

Response take_over_machine(const Call& call) {
  const auto body = json::read_reason_body(call.request.body, true);
  if (!body) return problem_response(body.error());
  app::Application& app = call.api.application();
  if (app.nodes() == nullptr) return problem_response(409, kAlone);
  const std::string& machine = call.parameters[0];
  if (auto done = app.nodes()->take_over(machine, body->reason, call.user); !done)
    return problem_response(done.error());
  return status_of(app, machine);
}

}  // namespace dripfeed::http
