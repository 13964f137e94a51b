// The same examination as for a verdict; nothing is written.
#include "server/app/checks/measured.h"

#include <utility>

#include <fmt/format.h>

#include "server/app/checks/family_sweep.h"
#include "server/app/checks/machine_facts.h"
#include "server/app/checks/timing_pictures.h"
#include "server/app/checks/workers.h"
#include "server/app/shop/catalog.h"

namespace dripfeed::app {

Measured measured_of(CheckReport report, const Examination& e) {
  return {std::move(report), e.geometry.value_or(family::Geometry{}), e.control.kind,
          x_is_diameter(e.control, e.profile)};
}

Result<Measured> measure_case(CaseOrder of, const MeasureWishes& wishes, const Documents& documents,
                              const CheckBudget& budget, CalledBy& called) {
  const auto one = open_case(std::move(of), documents, called);
  if (!one) return std::unexpected(one.error());
  OpenCase& opened = **one;
  if (wishes.baud != 0) {
    opened.profile.line.baud = wishes.baud;
    opened.profile.line.link.options.erase("baud");
  }
  opened.examination.timing = wishes.timing;
  opened.examination.used_up = time_budget(budget.seconds);
  CheckReport report = examine(opened.examination);
  if (!report.ran) {
    const std::string what = fmt::format("program {}", report.source.name());
    if (auto fine = refuse_errors(report.checks.diagnostics, report.source, what); !fine)
      return std::unexpected(fine.error());
    return fail(ErrorCode::refused, fmt::format("{} does not run to its end", what));
  }
  return measured_of(std::move(report), opened.examination);
}

std::optional<std::string> picture_of(const Measured& measured, PictureKind kind) {
  const CheckReport& report = measured.report;
  const auto drawn = [](const std::optional<plot::Plot>& plot) {
    return plot ? std::optional(plot::svg(*plot)) : std::nullopt;
  };
  switch (kind) {
    case PictureKind::deviation: return drawn(report.pictures.accuracy);
    case PictureKind::stock: return drawn(report.pictures.gouge);
    case PictureKind::feed:
    case PictureKind::buffer: break;
  }
  if (!report.checks.timing) return std::nullopt;
  const auto draw = kind == PictureKind::feed ? feed_plot : buffer_plot;
  return plot::svg(draw(*report.checks.timing, report.source.name()));
}

std::string picture_of(const sweep::Report& report) { return plot::svg(sweep::region_plot(report)); }

std::string why_not_measured(const Measured& measured) {
  std::string why;
  for (const checks::NotChecked& one : checks::not_checked_of(measured.report.checks))
    why += fmt::format("{}{}", why.empty() ? "" : "; ", one.text);
  return why.empty() ? "nothing is known to measure by" : why;
}

Result<accuracy::CmmReport> measure_points(std::string_view csv, bool best_fit, const Measured& measured) {
  const bool turns = measured.kind != ir::MachineKind::mill;
  const auto table =
      accuracy::read_cmm(csv, turns ? accuracy::CmmKind::turning : accuracy::CmmKind::milling, measured.x_is_diameter);
  if (!table) return fail(ErrorCode::invalid, table.error());
  std::vector<curves::ParametricCurve> curves;
  for (const family::PlaneCurve& one : measured.geometry.curves) curves.push_back(one.curve);
  const bool has_nominal = turns ? !measured.geometry.nominal.empty() : !curves.empty();
  if (table->has_points && !has_nominal) return fail(ErrorCode::invalid, "points need a nominal");
  const accuracy::Nearest nearest =
      turns ? accuracy::nearest_on(measured.geometry.nominal) : accuracy::nearest_on(curves);
  return accuracy::measure_cmm(*table, nearest, best_fit);
}

Result<sweep::Report> sweep_values(const SweepOrder& order, std::string_view family_text, std::string_view profile_text,
                                   const Documents& documents) {
  const text::Source source(order.family, std::string(family_text));
  auto fixed = overrides_of(order.values);
  const auto profile = documents.read_profile(profile_text);
  if (!profile) return std::unexpected(profile.error());
  const auto control = control_of(*profile);
  if (!control) return std::unexpected(control.error());
  const auto fine = refuse_errors(compile::check_values(source, fixed), source, fmt::format("family {}", order.family));
  if (!fine) return std::unexpected(fine.error());
  return sweep_family({.family = source,
                       .fixed = std::move(fixed),
                       .control = *control,
                       .profile = &*profile,
                       .mode = order.mode,
                       .delivery = delivery_of(order.delivery),
                       .settings = order.settings});
}

}  // namespace dripfeed::app
