// Webhooks: who receives events, and the result of each delivery. For admins: whoever adds one decides where data goes.
#include <fmt/format.h>

#include "server/http/api.h"
#include "server/http/handlers.h"
#include "server/http/list_response.h"
#include "server/json/cloud_events.h"
#include "server/json/requests.h"

namespace dripfeed::http {

namespace {

// An application that was made without a sender has none.
std::expected<app::Webhooks*, Response> webhooks_of(const Call& call) {
  if (app::Webhooks* const found = call.api.application().webhooks()) return found;
  return std::unexpected(problem_response(503, "this server sends no webhooks"));
}

struct Target {
  app::Webhooks* webhooks;
  store::Id id;
};
std::expected<Target, Response> target_of(const Call& call) {
  const auto webhooks = webhooks_of(call);
  if (!webhooks) return std::unexpected(webhooks.error());
  const auto id = id_of(call.parameters[0]);
  if (!id) return std::unexpected(id.error());
  return Target{*webhooks, *id};
}

template <class Value, class Write>
Response answer(const app::Result<Value>& result, const Write& write) {
  return result ? json_response(200, write(*result)) : problem_response(result.error());
}

}  // namespace

Response list_event_types(const Call& /*call*/) {
  std::vector<std::string> items;
  for (const app::EventType& type : app::event_types()) items.push_back(json::event_type(type));
  return json_response(200, json::list(items, ""));
}

Response list_webhooks(const Call& call) {
  const auto page = page_of(call.request);
  if (!page) return page.error();
  return list_response(call.api.application().store().webhooks().list(*page), json::webhook);
}

Response add_webhook(const Call& call) {
  const auto webhooks = webhooks_of(call);
  if (!webhooks) return webhooks.error();
  const auto settings = json::read_webhook_body(call.request.body);
  if (!settings) return problem_response(settings.error());
  const auto added = (*webhooks)->add(*settings, call.user);
  if (!added) return problem_response(added.error());
  return created(fmt::format("/api/v1/webhooks/{}", added->id), json::webhook_with_secret(*added));
}

Response get_webhook(const Call& call) {
  const auto id = id_of(call.parameters[0]);
  if (!id) return id.error();
  return answer(app::lift(call.api.application().store().webhooks().get(*id)), json::webhook);
}

Response change_webhook(const Call& call) {
  const auto target = target_of(call);
  if (!target) return target.error();
  const auto known = app::lift(call.api.application().store().webhooks().get(target->id));
  if (!known) return problem_response(known.error());
  const auto settings = json::read_webhook_change(call.request.body, known->of);
  if (!settings) return problem_response(settings.error());
  return answer(target->webhooks->change(target->id, *settings, call.user), json::webhook);
}

Response remove_webhook(const Call& call) {
  const auto target = target_of(call);
  if (!target) return target.error();
  if (const auto removed = target->webhooks->remove(target->id, call.user); !removed)
    return problem_response(removed.error());
  return no_content();
}

Response rotate_webhook(const Call& call) {
  const auto target = target_of(call);
  if (!target) return target.error();
  const auto body = json::read_rotate_body(call.request.body);
  if (!body) return problem_response(body.error());
  return answer(target->webhooks->rotate(target->id, body->keep_hours, call.user), json::webhook_with_secret);
}

Response ping_webhook(const Call& call) {
  const auto target = target_of(call);
  if (!target) return target.error();
  return answer(target->webhooks->ping(target->id, call.user), json::webhook_delivery);
}

Response list_deliveries(const Call& call) {
  const auto id = id_of(call.parameters[0]);
  if (!id) return id.error();
  const auto page = page_of(call.request);
  if (!page) return page.error();
  store::DeliveryFilter filter;
  if (const std::string state = query_text(call.request, "state"); !state.empty()) {
    filter.state = store::named<store::DeliveryState>(state);
    if (!filter.state)
      return problem_response(422,
                              fmt::format("\"{}\" is not a state of deliveries: pending, delivered or dead", state));
  }
  return list_response(call.api.application().store().webhooks().deliveries(*id, *page, filter),
                       json::webhook_delivery);
}

Response replay_delivery(const Call& call) {
  const auto target = target_of(call);
  if (!target) return target.error();
  const auto delivery = id_of(call.parameters[1]);
  if (!delivery) return delivery.error();
  return answer(target->webhooks->replay(target->id, *delivery, call.user), json::webhook_delivery);
}

Response replay_deliveries(const Call& call) {
  const auto target = target_of(call);
  if (!target) return target.error();
  const auto body = json::read_replay_body(call.request.body);
  if (!body) return problem_response(body.error());
  return answer(target->webhooks->replay_dead(target->id, body->since_ms, call.user), json::replayed);
}

}  // namespace dripfeed::http
