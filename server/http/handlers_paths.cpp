// The toolpath and the stock of a text or of a stored program: what the page draws.
#include <utility>

#include <fmt/format.h>

#include "server/app/checks/checking.h"
#include "server/http/api.h"
#include "server/http/handlers.h"
#include "server/http/text_orders.h"
#include "server/json/requests.h"
#include "server/json/workers.h"

namespace dripfeed::http {

namespace {

// Longest stored text whose path is drawn.
constexpr std::uint64_t kMostText = std::uint64_t{64} << 20U;

struct TextOf {
  app::DiagnoseOrder order;
  std::string subject;
  std::string machine;
  store::Revision revision = 0;  // of a program
};

app::Result<TextOf> order_of_text(const Call& call) {
  auto body = json::read_path_body(call.request.body);
  if (!body) return std::unexpected(body.error());
  TextOf one{.order = {}, .subject = "text", .machine = body->of.machine};
  auto order = text_order(call, std::move(body->of));
  if (!order) return std::unexpected(order.error());
  one.order = std::move(*order);
  one.order.stock = std::move(body->stock);
  if (!body->nominal) return one;
  auto family = app::lift(call.api.application().store().families().get(body->nominal->family));
  if (!family) return std::unexpected(family.error());
  one.order.nominal = app::NominalCase{.family = family->name,
                                       .revision = family->revision,
                                       .text = std::move(family->text),
                                       .values = std::move(body->nominal->values),
                                       .is_from_request = true};
  return one;
}

// A rendered program has the stock and the nominal of its family; they are taken where a machine is named.
app::Result<TextOf> order_of_program(const Call& call, store::Id id, store::Revision revision,
                                     store::Delivery delivery) {
  const std::string machine = query_text(call.request, "machine");
  TextOf one{.order = {}, .subject = fmt::format("program/{}", id), .machine = machine};
  app::Application& app = call.api.application();
  if (machine.empty()) {
    auto text = load_text(app.store(), id, revision, kMostText);
    if (!text) return std::unexpected(text.error());
    one.order.dialect = std::move(text->dialect);
    one.order.text = std::move(text->text);
    one.order.delivery = delivery;
    one.order.stock = query_text(call.request, "stock");
    one.revision = text->revision;
    return one;
  }
  auto stored = app::load_case(app.store(), app.documents(),
                               {.program = id, .revision = revision, .machine = machine, .delivery = delivery});
  if (!stored) return std::unexpected(stored.error());
  one.revision = stored->revision.revision;
  app::CaseOrder& of = stored->order;
  one.order = {.dialect = std::move(of.dialect),
               .text = std::move(of.text),
               .profile = std::move(of.profile),
               .delivery = delivery,
               .nominal = std::move(of.nominal),
               .profile_lines = std::move(of.profile_lines),
               .stock = query_text(call.request, "stock")};
  return one;
}

std::expected<store::Delivery, Response> delivery_in(const Request& request) {
  const std::string given = query_text(request, "delivery");
  for (std::size_t i = 0; i < store::kNames<store::Delivery>.size(); ++i)
    if (given == store::kNames<store::Delivery>[i]) return static_cast<store::Delivery>(i);
  if (given.empty()) return store::Delivery::memory;
  return std::unexpected(problem_response(422, "delivery must be drip or memory"));
}

Response path_response(const Call& call, const TextOf& of) {
  const auto done = call.api.workers().path(of.order, waiter_of(call, "path", of.subject, of.machine));
  return done ? json_response(200, *done) : problem_response(done.error());
}

// Of a longer text no picture is made: it would take too much of a worker for a small drawing.
constexpr std::size_t kMostPictured_bytes = std::size_t{1} << 20U;

Response picture_response(const Call& call, const TextOf& of) {
  if (of.order.text.size() > kMostPictured_bytes)
    return problem_response(422, fmt::format("a picture is made of at most {} bytes of text", kMostPictured_bytes));
  const auto done = call.api.workers().picture(of.order, waiter_of(call, "picture", of.subject, of.machine));
  return done ? json_response(200, *done) : problem_response(done.error());
}

Response stock_response(const Call& call, const TextOf& of) {
  auto done = call.api.workers().stock(of.order, waiter_of(call, "stock", of.subject, of.machine));
  if (!done) return problem_response(done.error());
  Response response;
  response.content_type = "application/octet-stream";
  response.body = std::move(*done);
  return response;
}

using Answer = Response (*)(const Call&, const TextOf&);

Response of_text(const Call& call, Answer answer) {
  const auto of = order_of_text(call);
  return of ? answer(call, *of) : problem_response(of.error());
}

Response of_program(const Call& call, Answer answer) {
  const auto id = id_of(call.parameters[0]);
  if (!id) return id.error();
  const auto revision = number_of(call.request, "revision", 0, 1, INT64_MAX);
  if (!revision) return revision.error();
  const auto delivery = delivery_in(call.request);
  if (!delivery) return delivery.error();
  const auto of = order_of_program(call, *id, *revision, *delivery);
  if (!of) return problem_response(of.error());
  return with_revision(answer(call, *of), of->revision);
}

}  // namespace

Response path_of_text(const Call& call) { return of_text(call, path_response); }
Response stock_of_text(const Call& call) { return of_text(call, stock_response); }
Response get_program_path(const Call& call) { return of_program(call, path_response); }
Response get_program_picture(const Call& call) { return of_program(call, picture_response); }
Response get_program_stock(const Call& call) { return of_program(call, stock_response); }

}  // namespace dripfeed::http
