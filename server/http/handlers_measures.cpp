// Measuring without keeping: accuracy, gouges, time and sweeps, as figures or as a picture. All of it is heavy work for
// the pool.
#include <algorithm>
#include <atomic>
#include <expected>
#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "server/app/measured.h"
#include "server/http/api.h"
#include "server/http/handlers.h"
#include "server/json/reports.h"
#include "server/json/requests.h"
#include "server/json/sweep_report.h"

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

app::Result<app::Measured> measure(const Call& call, const app::MeasureOrder& order) {
  app::Application& app = call.api.application();
  return app::measure_stored(app.store(), app.documents(), order);
}

Response svg_response(std::string svg) {
  Response response;
  response.content_type = "image/svg+xml";
  response.body = std::move(svg);
  return response;
}

Response picture(const app::Measured& measured, app::PictureKind kind) {
  auto svg = app::picture_of(measured, kind);
  return svg ? svg_response(std::move(*svg)) : problem_response(422, app::why_not_measured(measured));
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
  const auto plot = plot_of(call.request, {"deviation"});
  if (!plot) return plot.error();
  const auto body = json::read_measure_body(call.request.body, json::Measure::accuracy);
  if (!body) return problem_response(body.error());
  const auto measured = measure(call, body->order);
  if (!measured) return problem_response(measured.error());
  const auto& report = measured->report.checks.accuracy;
  if (!report) return problem_response(422, app::why_not_measured(*measured));
  if (!plot->empty()) return picture(*measured, app::PictureKind::deviation);
  if (body->cmm.empty()) return json_response(200, json::accuracy_figures(*report));
  const auto points = app::measure_points(body->cmm, body->best_fit, *measured);
  if (!points) return problem_response(points.error());
  return json_response(200, json::accuracy_figures(*report, *points));
}

Response measure_gouge(const Call& call) {
  const auto plot = plot_of(call.request, {"stock"});
  if (!plot) return plot.error();
  const auto body = json::read_measure_body(call.request.body, json::Measure::gouge);
  if (!body) return problem_response(body.error());
  const auto measured = measure(call, body->order);
  if (!measured) return problem_response(measured.error());
  const auto& report = measured->report.checks.gouge;
  if (!report) return problem_response(422, app::why_not_measured(*measured));
  if (!plot->empty()) return picture(*measured, app::PictureKind::stock);
  return json_response(200, json::gouge_figures(*report));
}

Response measure_timing(const Call& call) {
  const auto plot = plot_of(call.request, {"feed", "buffer"});
  if (!plot) return plot.error();
  auto body = json::read_measure_body(call.request.body, json::Measure::timing);
  if (!body) return problem_response(body.error());
  body->order.timing = {.keep_whole = true, .wants_curve = !plot->empty()};
  const auto measured = measure(call, body->order);
  if (!measured) return problem_response(measured.error());
  const auto& report = measured->report.checks.timing;
  if (!report) return problem_response(422, app::why_not_measured(*measured));
  if (*plot == "feed") return picture(*measured, app::PictureKind::feed);
  if (*plot == "buffer") return picture(*measured, app::PictureKind::buffer);
  return json_response(200, json::time_figures(*report));
}

Response sweep_family(const Call& call) {
  const auto plot = plot_of(call.request, {"region"});
  if (!plot) return plot.error();
  auto order = json::read_sweep_body(call.request.body);
  if (!order) return problem_response(order.error());
  const SweepPlace place(call.api.sweeping());
  if (!place.is_ours()) return problem_response(409, "another sweep is running: ask again when it is done");
  app::Application& app = call.api.application();
  order->settings.stop = call.api.stop();
  const auto report = app::sweep_stored(app.store(), app.documents(), *order);
  if (!report) return problem_response(report.error());
  if (call.api.stop().stop_requested()) return problem_response(503, "the server is stopping");
  if (!plot->empty()) return svg_response(app::picture_of(*report));
  return json_response(200, json::sweep_report(*report));
}

}  // namespace dripfeed::http
