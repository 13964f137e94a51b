// One function reads each body and describes it. A planner's own data goes through as it came.
#include "server/json/orders.h"

#include <algorithm>

#include <fmt/format.h>

#include "server/app/base/names.h"
#include "server/json/bodies.h"
#include "server/json/parse.h"

namespace dripfeed::json {

namespace {

constexpr std::int64_t kMostParts = 1'000'000'000;

void read_metadata(ObjectReader& o, std::string& into) {
  constexpr std::size_t kLongest = 4096;
  const Document* metadata = o.member("metadata", map_of(any("of the planner"), ""));
  if (metadata == nullptr) return;
  if (!metadata->is_object()) return o.fault("metadata", "must be an object");
  into = dump(*metadata);
  if (into.size() > kLongest) o.fault("metadata", fmt::format("must not have more than {} bytes", kLongest));
}

void read_members(ObjectReader& o, store::OrderPlan& into) {
  constexpr std::int64_t kMostPriority = 100;
  o.proper_name("part", into.part);
  o.integer("quantity", into.quantity, 1, kMostParts, true);
  o.text("machine", into.machine);
  o.integer("due_at_ms", into.due_at_ms, 1, kMaxId);
  o.integer("priority", into.priority, 0, kMostPriority);
  read_metadata(o, into.metadata);
}

void read_members(ObjectReader& o, store::NewOrder& into) {
  o.proper_name("number", into.number);
  o.proper_name("operation", into.operation, false);
  read_members(o, into.plan);
}

void read_members(ObjectReader& o, OrderMoveBody& into) {
  if (const auto to = o.choice("to", store::kNames<store::OrderState>, true))
    into.to = static_cast<store::OrderState>(*to);
  o.text("reason", into.reason);
  const bool needs_reason = into.to == store::OrderState::held || into.to == store::OrderState::cancelled;
  if (needs_reason && !o.has("reason")) o.fault("reason", "is missing");
}

void read_members(ObjectReader& o, store::PartsReport& into) {
  o.integer("good", into.good, 0, kMostParts);
  o.integer("scrap", into.scrap, 0, kMostParts);
  o.text("note", into.note);
}

}  // namespace

app::Result<store::NewOrder> read_order_body(std::string_view body) {
  return read_by<store::NewOrder>(read_members, body);
}
app::Result<store::OrderPlan> read_order_plan_body(std::string_view body) {
  return read_by<store::OrderPlan>(read_members, body);
}
app::Result<OrderMoveBody> read_order_move_body(std::string_view body) {
  return read_by<OrderMoveBody>(read_members, body);
}
app::Result<store::PartsReport> read_parts_body(std::string_view body) {
  return read_by<store::PartsReport>(read_members, body);
}

Schemas order_request_schemas() {
  return {
      described<store::NewOrder>("NewOrder", read_members, "what is to be made"),
      described<store::OrderPlan>("OrderPlan", read_members, "the new plan of an order, as a whole"),
      described<OrderMoveBody>("OrderMove", read_members, "one step of an order"),
      described<store::PartsReport>("PartsReport", read_members, "parts that were made since the last report"),
  };
}

std::string order(const store::Order& order) {
  const store::OrderPlan& plan = order.of.plan;
  return dump({{"id", order.id},
               {"number", order.of.number},
               {"operation", text_or_null(order.of.operation)},
               {"part", plan.part},
               {"quantity", plan.quantity},
               {"machine", text_or_null(plan.machine)},
               {"due_at_ms", time_or_null(plan.due_at_ms)},
               {"priority", plan.priority},
               {"metadata", embedded(plan.metadata)},
               {"state", store::name_of(order.state)},
               {"reason", text_or_null(order.reason)},
               {"good", order.good},
               {"scrap", order.scrap},
               {"open", plan.quantity - std::min(plan.quantity, order.good)},
               {"transfers", order.transfers},
               {"waiting", order.waiting},
               {"revision", order.revision},
               {"created_by", order.created_by},
               {"created_at_ms", order.created_at_ms},
               {"changed_at_ms", order.changed_at_ms}});
}

}  // namespace dripfeed::json
