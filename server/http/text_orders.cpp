// Which machine's document goes with a text.
#include "server/http/text_orders.h"

#include <utility>

namespace dripfeed::http {

app::Result<std::string> profile_of(store::Store& store, const std::string& machine) {
  if (machine.empty()) return std::string();
  auto found = app::lift(store.machines().get(machine));
  if (!found) return std::unexpected(found.error());
  return std::move(found->profile);
}

app::Result<app::DiagnoseOrder> text_order(const Call& call, json::DiagnoseBody body) {
  app::DiagnoseOrder order{.dialect = std::move(body.dialect), .text = std::move(body.text), .delivery = body.delivery};
  auto profile = profile_of(call.api.application().store(), body.machine);
  if (!profile) return std::unexpected(profile.error());
  order.profile = std::move(*profile);
  return order;
}

}  // namespace dripfeed::http
