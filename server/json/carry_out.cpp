// The end that does the work.
#include <utility>

#include "server/app/checks/measured.h"
#include "server/json/diagnostics.h"
#include "server/json/documents.h"
#include "server/json/records.h"
#include "server/json/reports.h"
#include "server/json/requests.h"
#include "server/json/sweep_report.h"
#include "server/json/tool_path.h"
#include "server/json/translation.h"
#include "server/json/work_package.h"
#include "server/json/workers.h"

namespace dripfeed::json {

namespace {

using Reply = app::Result<WorkPackage>;

struct Work {
  const WorkPackage& package;
  JsonDocuments documents;
  app::CheckBudget budget;
  app::CalledBy& called;

  [[nodiscard]] const std::string& text(std::string_view member) const { return package.text_of(package.head, member); }
};

Reply reply_figures(bool is_picture, const std::string& body) {
  WorkPackage reply;
  reply.head["is_picture"] = is_picture;
  reply.add(body);
  return reply;
}

Reply check(const Work& work) {
  const auto done =
      app::check_case(read_case(work.package.head.at("case"), work.package), work.documents, work.budget, work.called);
  if (!done) return std::unexpected(done.error());
  WorkPackage reply;
  reply.head["outcome"] = static_cast<int>(done->outcome);
  reply.add(done->report);
  reply.head["points"] = write_texts(done->points, reply);
  return reply;
}

Reply render(const Work& work) {
  const auto done = app::render_family(read_family(work.package.head.at("family"), work.package), work.documents);
  if (!done) return std::unexpected(done.error());
  const compile::RenderResult& result = done->result;
  Document lines = Document::array();
  for (const family::LineRange& one : result.profile_lines) lines.push_back({one.first, one.last});
  WorkPackage reply;
  reply.head = {{"mode", static_cast<int>(result.mode)},
                {"because", result.because},
                {"blocks", result.blocks},
                {"bytes", result.bytes},
                {"variables", result.variables},
                {"profile_lines", std::move(lines)},
                {"diagnostics", write_diagnostics(result.diagnostics)}};
  reply.add(result.text);
  reply.add(done->places);
  reply.add(done->drawing);
  reply.add(legend(result.legend));
  return reply;
}

app::Result<app::Measured> measure(const Work& work, const app::MeasureWishes& wishes) {
  return app::measure_case(read_case(work.package.head.at("case"), work.package), wishes, work.documents, work.budget,
                           work.called);
}

Reply picture(const app::Measured& measured, app::PictureKind kind) {
  auto svg = app::picture_of(measured, kind);
  if (!svg) return app::fail(app::ErrorCode::invalid, app::why_not_measured(measured));
  return reply_figures(true, std::move(*svg));
}

Reply not_measured(const app::Measured& measured) {
  return app::fail(app::ErrorCode::invalid, app::why_not_measured(measured));
}

Reply accuracy(const Work& work) {
  const auto body = read_measure_body(work.text("body"), Measure::accuracy);
  if (!body) return std::unexpected(body.error());
  const auto measured = measure(work, body->order.wishes);
  if (!measured) return std::unexpected(measured.error());
  const auto& report = measured->report.checks.accuracy;
  if (!report) return not_measured(*measured);
  if (!work.text("plot").empty()) return picture(*measured, app::PictureKind::deviation);
  if (body->cmm.empty()) return reply_figures(false, accuracy_figures(*report));
  const auto points = app::measure_points(body->cmm, body->best_fit, *measured);
  if (!points) return std::unexpected(points.error());
  return reply_figures(false, accuracy_figures(*report, *points));
}

Reply gouge(const Work& work) {
  const auto body = read_measure_body(work.text("body"), Measure::gouge);
  if (!body) return std::unexpected(body.error());
  const auto measured = measure(work, body->order.wishes);
  if (!measured) return std::unexpected(measured.error());
  const auto& report = measured->report.checks.gouge;
  if (!report) return not_measured(*measured);
  if (!work.text("plot").empty()) return picture(*measured, app::PictureKind::stock);
  return reply_figures(false, gouge_figures(*report));
}

Reply timing(const Work& work) {
  auto body = read_measure_body(work.text("body"), Measure::timing);
  if (!body) return std::unexpected(body.error());
  const std::string& plot = work.text("plot");
  body->order.wishes.timing = {.keep_whole = true, .wants_curve = !plot.empty()};
  const auto measured = measure(work, body->order.wishes);
  if (!measured) return std::unexpected(measured.error());
  const auto& report = measured->report.checks.timing;
  if (!report) return not_measured(*measured);
  if (plot == "feed") return picture(*measured, app::PictureKind::feed);
  if (plot == "buffer") return picture(*measured, app::PictureKind::buffer);
  return reply_figures(false, time_figures(*report));
}

Reply sweep(const Work& work) {
  const auto order = read_sweep_body(work.text("body"));
  if (!order) return std::unexpected(order.error());
  const app::RenderWork of = read_family(work.package.head.at("family"), work.package);
  const auto report = app::sweep_values(*order, of.text, of.profile, work.documents);
  if (!report) return std::unexpected(report.error());
  if (!work.text("plot").empty()) return reply_figures(true, app::picture_of(*report));
  return reply_figures(false, sweep_report(*report));
}

Reply compare(const Work& work) {
  const app::CompareOrder order{
      .first = {work.text("first_name"), work.text("first_dialect"), work.text("first_text")},
      .second = {work.text("second_name"), work.text("second_dialect"), work.text("second_text")},
      .profile = work.text("profile")};
  const auto done = app::compare_case(order, work.documents, work.budget);
  if (!done) return std::unexpected(done.error());
  WorkPackage reply;
  reply.add(comparison(*done));
  return reply;
}

Reply diagnose(const Work& work) {
  const auto done = app::diagnose_text(read_text_order(work.package), work.documents);
  if (!done) return std::unexpected(done.error());
  WorkPackage reply;
  reply.add(diagnosed(*done));
  return reply;
}

Reply rewrite(const Work& work) {
  const Document& head = work.package.head;
  const auto done = app::rewrite_text({.of = read_text_order(work.package),
                                       .how = static_cast<app::Rewriting>(head.at("how").get<int>()),
                                       .numbering = static_cast<compile::Numbering>(head.at("numbering").get<int>()),
                                       .first = head.at("first").get<std::uint32_t>(),
                                       .step = head.at("step").get<std::uint32_t>()},
                                      work.documents);
  if (!done) return std::unexpected(done.error());
  WorkPackage reply;
  reply.add(rewritten(*done));
  return reply;
}

Reply convert(const Work& work) {
  const app::TranslationOrder order{.name = work.text("name"),
                                    .text = work.text("text"),
                                    .from = {work.text("from_dialect"), work.text("from_profile")},
                                    .to = {work.text("to_dialect"), work.text("to_profile")},
                                    .caller = {},
                                    .mode = static_cast<compile::ConvertMode>(work.package.head.at("mode").get<int>())};
  const auto done = app::translate_text(order, work.documents, work.called);
  if (!done) return std::unexpected(done.error());
  WorkPackage reply;
  reply.add(translation(*done, order.mode));
  return reply;
}

Reply optimize(const Work& work) {
  const auto texts = [&](std::string_view member) { return read_texts(work.package.head.at(member), work.package); };
  const app::OptimizeOrder order{.name = work.text("name"),
                                 .text = work.text("text"),
                                 .dialect = work.text("dialect"),
                                 .profile = work.text("profile"),
                                 .caller = {},
                                 .words = {.with = texts("with"),
                                           .without = texts("without"),
                                           .own = texts("own"),
                                           .free = texts("free"),
                                           .tolerance_mm = work.package.head.at("tolerance_mm").get<double>()}};
  const auto done = app::optimize_case(order, work.documents, work.called);
  if (!done) return std::unexpected(done.error());
  WorkPackage reply;
  reply.add(optimized(done->result, done->cost, done->source));
  return reply;
}

Reply path(const Work& work) {
  const auto done = app::follow_path(read_text_order(work.package), work.documents, work.budget);
  if (!done) return std::unexpected(done.error());
  WorkPackage reply;
  reply.add(tool_path(*done));
  return reply;
}

Reply picture(const Work& work) {
  const auto done = app::follow_path(read_text_order(work.package), work.documents, work.budget);
  if (!done) return std::unexpected(done.error());
  WorkPackage reply;
  reply.add(path_picture(app::picture_of(*done)));
  return reply;
}

Reply stock(const Work& work) {
  const auto done = app::follow_stock(read_text_order(work.package), work.documents, work.budget);
  if (!done) return std::unexpected(done.error());
  WorkPackage reply;
  reply.add(stock_bytes(*done));
  return reply;
}

Reply figures_of_text(const Work& work) {
  const auto done = app::statistics_of(read_text_order(work.package), work.documents, work.budget);
  if (!done) return std::unexpected(done.error());
  WorkPackage reply;
  reply.add(statistics(*done));
  return reply;
}

Reply restart(const Work& work) {
  const Document& head = work.package.head;
  const auto made = app::restart_case({.of = read_case(head.at("case"), work.package),
                                       .line = head.at("line").get<std::uint32_t>(),
                                       .clearance_mm = head.at("clearance_mm").get<double>()},
                                      work.documents, work.budget, work.called);
  if (!made) return std::unexpected(made.error());
  WorkPackage reply;
  reply.head["is_possible"] = made->is_possible();
  reply.add(made->restart.text);
  reply.add(restart_preview(*made));
  return reply;
}

Reply explain(const Work& work) {
  const app::ValueOrder order{.work = read_family(work.package.head.at("family"), work.package),
                              .stored = work.text("stored"),
                              .received = work.text("received")};
  const auto done = app::explain_values(order, work.documents);
  if (!done) return std::unexpected(done.error());
  WorkPackage reply;
  reply.add(value_changes(*done));
  return reply;
}

Reply index(const Work& work) {
  const auto done = app::digest_programs(read_digest_orders(work.package.head.at("orders"), work.package));
  if (!done) return std::unexpected(done.error());
  WorkPackage reply;
  reply.head["digests"] = write_digests(*done, reply);
  return reply;
}

struct KindRow {
  std::string_view name;
  Reply (*carry_out)(const Work&);
};
constexpr KindRow kKinds[] = {{"check", check},     {"render", render},     {"accuracy", accuracy},
                              {"gouge", gouge},     {"timing", timing},     {"sweep", sweep},
                              {"compare", compare}, {"index", index},       {"diagnose", diagnose},
                              {"convert", convert}, {"path", path},         {"restart", restart},
                              {"stock", stock},     {"rewrite", rewrite},   {"statistics", figures_of_text},
                              {"explain", explain}, {"optimize", optimize}, {"picture", picture}};

Reply do_work(const WorkPackage& package, app::CalledBy& called) {
  const Work work{.package = package,
                  .documents = {},
                  .budget = {.seconds = package.head.at("seconds").get<std::uint32_t>(), .memory_bytes = 0},
                  .called = called};
  const auto kind = package.head.at("kind").get<std::string>();
  for (const KindRow& row : kKinds)
    if (row.name == kind) return row.carry_out(work);
  return app::fail(app::ErrorCode::internal, "a worker was asked for work that it does not know: " + kind);
}

}  // namespace

std::string carry_out(std::string_view request) {
  auto package = read_package(request);
  if (!package) return write_package(error_package(package.error()));
  app::CalledBy called;
  if (const auto known = package->head.find("called"); known != package->head.end())
    called.texts = read_called(*known, *package);
  Reply done = do_work(*package, called);
  WorkPackage reply = done ? std::move(*done) : error_package(done.error());
  reply.head["missing"] = write_names(called.missing, reply);
  return write_package(reply);
}

}  // namespace dripfeed::json
