// Orders: what is to be made. Nothing here starts anything: jobs are queued and armed by people.
#include <fmt/format.h>

#include "server/http/api.h"
#include "server/http/handlers.h"
#include "server/http/list_response.h"
#include "server/json/orders.h"

namespace dripfeed::http {

namespace {

store::Orders& orders_of(const Call& call) { return call.api.application().store().orders(); }

Response order_response(const store::Result<store::Order>& order) {
  if (!order) return problem_response(app::from_store(order.error()));
  return with_revision(json_response(200, json::order(*order)), order->revision);
}

}  // namespace

Response list_orders(const Call& call) {
  const auto page = page_of(call.request);
  if (!page) return page.error();
  store::OrderFilter filter{.number = query_text(call.request, "number"),
                            .part = query_text(call.request, "part"),
                            .machine = query_text(call.request, "machine"),
                            .state = std::nullopt};
  if (const std::string state = query_text(call.request, "state"); !state.empty()) {
    filter.state = store::named<store::OrderState>(state);
    if (!filter.state) return problem_response(422, fmt::format("\"{}\" is not a state of an order", state));
  }
  return list_response(orders_of(call).list(*page, filter), [](const store::Order& one) { return json::order(one); });
}

Response add_order(const Call& call) {
  const auto body = json::read_order_body(call.request.body);
  if (!body) return problem_response(body.error());
  const auto added = orders_of(call).add(*body, stamp_of(call));
  if (!added) return problem_response(app::from_store(added.error()));
  return with_revision(created(fmt::format("/api/v1/orders/{}", added->id), json::order(*added)), added->revision);
}

Response get_order(const Call& call) {
  const auto id = id_of(call.parameters[0]);
  return id ? order_response(orders_of(call).get(*id)) : id.error();
}

Response change_order(const Call& call) {
  const auto id = id_of(call.parameters[0]);
  if (!id) return id.error();
  const auto revision = expected_revision(call.request);
  if (!revision) return revision.error();
  const auto plan = json::read_order_plan_body(call.request.body);
  if (!plan) return problem_response(plan.error());
  return order_response(orders_of(call).change(*id, *revision, *plan, stamp_of(call)));
}

Response move_order(const Call& call) {
  const auto id = id_of(call.parameters[0]);
  if (!id) return id.error();
  const auto move = json::read_order_move_body(call.request.body);
  if (!move) return problem_response(move.error());
  return order_response(orders_of(call).move(*id, move->to, move->reason, stamp_of(call)));
}

Response report_parts(const Call& call) {
  const auto id = id_of(call.parameters[0]);
  if (!id) return id.error();
  const auto parts = json::read_parts_body(call.request.body);
  if (!parts) return problem_response(parts.error());
  return order_response(orders_of(call).report(*id, *parts, stamp_of(call)));
}

}  // namespace dripfeed::http
