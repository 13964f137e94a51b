// For who writes or reads a text: what is wrong with it as it stands, the words of its language, its figures.
#include <utility>

#include <fmt/format.h>

#include "server/app/checks/diagnose.h"
#include "server/app/library/split_text.h"
#include "server/http/api.h"
#include "server/http/handlers.h"
#include "server/http/text_orders.h"
#include "server/json/diagnostics.h"
#include "server/json/requests.h"
#include "server/json/workers.h"

namespace dripfeed::http {

namespace {

// Longest stored text that is translated or optimized.
constexpr std::uint64_t kTextLimit = std::uint64_t{64} << 20U;

app::Result<void> load_program(store::Store& store, const json::ConvertBody& body, app::TranslationOrder& order) {
  auto stored = load_text(store, body.program, body.revision, kTextLimit);
  if (!stored) return std::unexpected(stored.error());
  order.name = std::move(stored->name);
  order.text = std::move(stored->text);
  if (order.from.dialect.empty()) order.from.dialect = stored->dialect;
  order.caller = {.dialect = std::move(stored->dialect), .machine = body.machine, .folder = std::move(stored->folder)};
  return {};
}

app::Result<app::TranslationOrder> translation_order(store::Store& store, json::ConvertBody& body) {
  app::TranslationOrder order{.name = "text",
                              .text = std::move(body.text),
                              .from = {.dialect = body.dialect, .profile = {}},
                              .to = {.dialect = body.to, .profile = {}},
                              .caller = {},
                              .mode = body.mode};
  if (body.program != 0)
    if (auto loaded = load_program(store, body, order); !loaded) return std::unexpected(loaded.error());
  auto from = profile_of(store, body.machine);
  if (!from) return std::unexpected(from.error());
  auto to = profile_of(store, body.to_machine);
  if (!to) return std::unexpected(to.error());
  order.from.profile = std::move(*from);
  order.to.profile = std::move(*to);
  return order;
}

app::Result<app::OptimizeOrder> optimize_order(store::Store& store, json::OptimizeBody& body) {
  app::OptimizeOrder order{.name = "text",
                           .text = std::move(body.text),
                           .dialect = body.dialect,
                           .profile = {},
                           .caller = {},
                           .words = std::move(body.words)};
  if (body.program != 0) {
    auto stored = load_text(store, body.program, body.revision, kTextLimit);
    if (!stored) return std::unexpected(stored.error());
    order.name = std::move(stored->name);
    order.text = std::move(stored->text);
    if (order.dialect.empty()) order.dialect = stored->dialect;
    order.caller = {
        .dialect = std::move(stored->dialect), .machine = body.machine, .folder = std::move(stored->folder)};
  }
  auto profile = profile_of(store, body.machine);
  if (!profile) return std::unexpected(profile.error());
  order.profile = std::move(*profile);
  return order;
}

using Work = app::Result<std::string> (json::DocumentWorkers::*)(const app::DiagnoseOrder&, const app::Waiter&);

Response work_on_text(const Call& call, Work work, std::string_view kind) {
  auto body = json::read_diagnose_body(call.request.body);
  if (!body) return problem_response(body.error());
  const std::string machine = body->machine;
  const auto order = text_order(call, std::move(*body));
  if (!order) return problem_response(order.error());
  const auto done = (call.api.workers().*work)(*order, waiter_of(call, kind, "text", machine));
  if (!done) return problem_response(done.error());
  return json_response(200, *done);
}

}  // namespace

Response convert(const Call& call) {
  auto body = json::read_convert_body(call.request.body);
  if (!body) return problem_response(body.error());
  auto order = translation_order(call.api.application().store(), *body);
  if (!order) return problem_response(order.error());
  const std::string subject = body->program == 0 ? "text" : fmt::format("program/{}", body->program);
  const auto done = call.api.workers().convert(*order, waiter_of(call, "convert", subject, body->machine));
  if (!done) return problem_response(done.error());
  return json_response(200, *done);
}

Response optimize(const Call& call) {
  auto body = json::read_optimize_body(call.request.body);
  if (!body) return problem_response(body.error());
  const auto order = optimize_order(call.api.application().store(), *body);
  if (!order) return problem_response(order.error());
  const std::string subject = body->program == 0 ? "text" : fmt::format("program/{}", body->program);
  const auto done = call.api.workers().optimize(*order, waiter_of(call, "optimize", subject, body->machine));
  if (!done) return problem_response(done.error());
  return json_response(200, *done);
}

Response rewrite(const Call& call) {
  auto body = json::read_rewrite_body(call.request.body);
  if (!body) return problem_response(body.error());
  const std::string machine = body->of.machine;
  auto of = text_order(call, std::move(body->of));
  if (!of) return problem_response(of.error());
  const app::RewriteOrder order{
      .of = std::move(*of), .how = body->how, .numbering = body->numbering, .first = body->first, .step = body->step};
  const auto done = call.api.workers().rewrite(order, waiter_of(call, "rewrite", "text", machine));
  if (!done) return problem_response(done.error());
  return json_response(200, *done);
}

Response split_text(const Call& call) {
  const auto body = json::read_text_body(call.request.body);
  if (!body) return problem_response(body.error());
  return json_response(200, json::split_text(app::split_text(body->text)));
}

Response diagnose(const Call& call) { return work_on_text(call, &json::DocumentWorkers::diagnose, "diagnose"); }
Response statistics_of_text(const Call& call) {
  return work_on_text(call, &json::DocumentWorkers::statistics, "statistics");
}

Response get_dialect_words(const Call& call) {
  auto words =
      json::dialect_words(call.parameters[0], query_text(call.request, "kind"), query_text(call.request, "g_system"));
  if (!words) return problem_response(words.error());
  return json_response(200, std::move(*words));
}

}  // namespace dripfeed::http
