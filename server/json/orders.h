// Orders as the API takes and shows them.
#pragma once

#include <string>
#include <string_view>

#include "server/app/base/error.h"
#include "server/app/shop/sign_in.h"
#include "server/json/schemas.h"

namespace dripfeed::json {

app::Result<store::NewOrder> read_order_body(std::string_view body);
app::Result<store::OrderPlan> read_order_plan_body(std::string_view body);

struct OrderMoveBody {
  store::OrderState to = store::OrderState::open;
  std::string reason;
};
app::Result<OrderMoveBody> read_order_move_body(std::string_view body);
app::Result<store::PartsReport> read_parts_body(std::string_view body);

Schemas order_request_schemas();
Schemas order_schemas();

std::string order(const store::Order& order);

}  // namespace dripfeed::json
