// Measuring without keeping: accuracy, gouges, time and sweeps, as figures or as a picture. All of it is done by a
// worker while a thread of the pool waits for it.
#include <algorithm>
#include <atomic>
#include <expected>
#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "server/app/checks/checking.h"
#include "server/http/api.h"
#include "server/http/handlers.h"
#include "server/json/requests.h"
#include "server/json/workers.h"

namespace dripfeed::http {

namespace {

// ?plot=, one of these names; "" where figures are wanted.
std::expected<std::string, Response> plot_of(const Request& request, std::initializer_list<std::string_view> names) {
  const auto given = request.query.find("plot");
  if (given == request.query.end()) return "";
  if (std::ranges::find(names, given->second) != names.end()) return given->second;
  std::string known;
  for (const std::string_view name : names) known += fmt::format("{}{}", known.empty() ? "" : " or ", name);
  return std::unexpected(problem_response(422, fmt::format("plot must be {}", known)));
}

Response figures_response(const app::Result<json::Figures>& figures) {
  if (!figures) return problem_response(figures.error());
  if (!figures->is_picture) return json_response(200, figures->body);
  Response response;
  response.content_type = "image/svg+xml";
  response.body = figures->body;
  return response;
}

// The worker reads the body for itself; here it says which program is meant.
Response measure(const Call& call, json::Measure what, std::string_view kind,
                 std::initializer_list<std::string_view> plots) {
  const auto plot = plot_of(call.request, plots);
  if (!plot) return plot.error();
  const auto body = json::read_measure_body(call.request.body, what);
  if (!body) return problem_response(body.error());
  app::Application& app = call.api.application();
  auto stored = app::load_case(app.store(), app.documents(), body->order.of);
  if (!stored) return problem_response(stored.error());
  return figures_response(call.api.workers().figures(
      {.kind = std::string(kind),
       .plot = *plot,
       .body = call.request.body,
       .of = std::move(stored->order),
       .sweep = {}},
      waiter_of(call, kind, fmt::format("program/{}", body->order.of.program), body->order.of.machine)));
}

// Holds the only place for a sweep while it lives, if that was free.
class SweepPlace {
 public:
  explicit SweepPlace(std::atomic_flag& flag) : flag_(flag), is_ours_(!flag.test_and_set()) {}
  SweepPlace(const SweepPlace&) = delete;
  SweepPlace& operator=(const SweepPlace&) = delete;
  ~SweepPlace() {
    if (is_ours_) flag_.clear();
  }
  [[nodiscard]] bool is_ours() const { return is_ours_; }

 private:
  std::atomic_flag& flag_;
  bool is_ours_;
};

}  // namespace

Response measure_accuracy(const Call& call) {
  return measure(call, json::Measure::accuracy, "accuracy", {"deviation"});
}
Response measure_gouge(const Call& call) { return measure(call, json::Measure::gouge, "gouge", {"stock"}); }
Response measure_timing(const Call& call) { return measure(call, json::Measure::timing, "timing", {"feed", "buffer"}); }

Response sweep_family(const Call& call) {
  const auto plot = plot_of(call.request, {"region"});
  if (!plot) return plot.error();
  const auto order = json::read_sweep_body(call.request.body);
  if (!order) return problem_response(order.error());
  const SweepPlace place(call.api.sweeping());
  if (!place.is_ours()) return problem_response(409, "another sweep is running: ask again when it is done");
  store::Store& store = call.api.application().store();
  const auto family = app::lift(store.families().get(order->family));
  if (!family) return problem_response(family.error());
  const auto machine = app::lift(store.machines().get(order->machine));
  if (!machine) return problem_response(machine.error());
  const app::RenderWork of{.family = family->name,
                           .text = family->text,
                           .values = {},
                           .profile = machine->profile,
                           .mode = order->mode,
                           .delivery = order->delivery,
                           .name = {}};
  return figures_response(
      call.api.workers().figures({.kind = "sweep", .plot = *plot, .body = call.request.body, .of = {}, .sweep = of},
                                 waiter_of(call, "sweep", fmt::format("family/{}", order->family), order->machine)));
}

}  // namespace dripfeed::http
