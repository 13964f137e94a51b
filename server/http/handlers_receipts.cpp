// What controls punched, and what their operators asked for.
#include <memory>

#include <fmt/format.h>

#include "server/app/library/value_case.h"
#include "server/http/api.h"
#include "server/http/handlers.h"
#include "server/http/list_response.h"
#include "server/json/records.h"
#include "server/json/requests.h"
#include "server/json/translation.h"
#include "server/json/workers.h"

namespace dripfeed::http {

namespace {

// With the hint; where it cannot be made the receipt stands without.
std::string shown(app::Application& app, const store::Receipt& receipt) {
  const bool open = receipt.state == store::ReceiptState::stored;
  const auto likeness = open ? app.receiving().likeness(receipt) : std::nullopt;
  return json::receipt(receipt, likeness ? *likeness : std::nullopt);
}

Response receipt_response(app::Application& app, const app::Result<store::Receipt>& receipt) {
  if (!receipt) return problem_response(receipt.error());
  return json_response(200, shown(app, *receipt));
}

}  // namespace

Response list_receipts(const Call& call) {
  const auto page = page_of(call.request);
  if (!page) return page.error();
  store::ReceiptFilter filter{.machine = query_text(call.request, "machine"), .state = std::nullopt};
  if (const std::string state = query_text(call.request, "state"); !state.empty()) {
    filter.state = store::named<store::ReceiptState>(state);
    if (!filter.state) return problem_response(422, fmt::format("\"{}\" is not a state of a receipt", state));
  }
  app::Application& app = call.api.application();
  return list_response(app.store().receipts().list(*page, filter),
                       [&](const store::Receipt& receipt) { return shown(app, receipt); });
}

Response get_receipt(const Call& call) {
  const auto id = id_of(call.parameters[0]);
  if (!id) return id.error();
  app::Application& app = call.api.application();
  return receipt_response(app, app::lift(app.store().receipts().get(*id)));
}

Response get_receipt_text(const Call& call) {
  const auto id = id_of(call.parameters[0]);
  if (!id) return id.error();
  store::Store& store = call.api.application().store();
  const auto receipt = store.receipts().get(*id);
  if (!receipt) return problem_response(app::from_store(receipt.error()));
  const std::string form = query_text(call.request, "form");
  if (!form.empty() && form != "read")
    return problem_response(422, fmt::format("\"{}\" is not a form of a text", form));
  if (form == "read" && receipt->of.quarantined) {
    auto text = call.api.application().receiving().readable(*receipt);
    if (!text) return problem_response(text.error());
    Response read;
    read.content_type = "text/plain; charset=iso-8859-1";
    read.body = std::move(*text);
    return read;
  }
  Response response;
  response.content_type = receipt->of.quarantined ? "application/octet-stream" : "text/plain; charset=utf-8";
  const auto offset = std::make_shared<std::uint64_t>(0);
  response.source = [&contents = store.contents(), sha256 = receipt->of.sha256,
                     offset](std::span<char> into) -> std::expected<std::size_t, std::string> {
    const auto count = contents.read(sha256, *offset, into);
    if (!count) return std::unexpected(store::message_of(count.error()));
    *offset += *count;
    return *count;
  };
  return response;
}

Response explain_receipt(const Call& call) {
  const auto id = id_of(call.parameters[0]);
  if (!id) return id.error();
  app::Application& app = call.api.application();
  const auto receipt = app::lift(app.store().receipts().get(*id));
  if (!receipt) return problem_response(receipt.error());
  const auto of = app::load_value_case(app.store(), app.documents(), *receipt);
  if (!of) return problem_response(of.error());
  const auto changes = call.api.workers().explain(
      of->order, waiter_of(call, "explain", fmt::format("receipt/{}", *id), receipt->of.machine));
  if (!changes) return problem_response(changes.error());
  return json_response(200, json::received_values(*changes, of->stored));
}

Response accept_receipt(const Call& call) {
  const auto id = id_of(call.parameters[0]);
  if (!id) return id.error();
  const auto order = json::read_accept_body(call.request.body);
  if (!order) return problem_response(order.error());
  app::Application& app = call.api.application();
  const auto receipt = app::lift(app.store().receipts().get(*id));
  if (!receipt) return problem_response(receipt.error());
  if (receipt->of.quarantined && call.right < Right::approver)
    return problem_response(403, "a receipt in quarantine is accepted by an approver");
  return receipt_response(app, app.receiving().accept(*id, *order, call.user));
}

Response discard_receipt(const Call& call) {
  const auto id = id_of(call.parameters[0]);
  if (!id) return id.error();
  const auto body = json::read_reason_body(call.request.body, true);
  if (!body) return problem_response(body.error());
  app::Application& app = call.api.application();
  return receipt_response(app, app.receiving().discard(*id, body->reason, call.user));
}

Response list_requests(const Call& call) {
  const auto page = page_of(call.request);
  if (!page) return page.error();
  return list_response(call.api.application().store().receipts().requests(*page, query_text(call.request, "machine")),
                       [](const store::Request& request) { return json::request(request); });
}

}  // namespace dripfeed::http
