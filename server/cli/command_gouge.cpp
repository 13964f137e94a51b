// dripfeed gouge: rapids into stock or part, and cuts below the nominal.
#include <memory>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "dialects/text/number.h"
#include "server/cli/cli.h"
#include "server/cli/measured.h"
#include "server/cli/output.h"
#include "server/json/reports.h"

namespace dripfeed::cli {

namespace {

int gouge_of(const MeasureOptions& options) {
  const auto measured = measure(options, app::SurfaceScope::all);
  if (!measured) {
    print_error(measured.error());
    return kWrongUse;
  }
  const app::CheckReport& report = measured->report;
  if (!report.checks.gouge || !report.ran) return not_measured(options, report);
  const gouge::Report& g = *report.checks.gouge;
  const std::string name = report.source.name().empty() ? options.family.file : report.source.name();
  for (const checks::Finding& one : g.findings.kept()) {
    fmt::print(stderr, "{}:{}: {}[{}]: {}{}\n", name, one.place.line, text::name_of(one.severity),
               text::row_of(one.id).name, one.text, in_family(*measured, one.place.line));
  }
  for (const checks::NotChecked& one : g.not_checked.list()) fmt::print(stderr, "not checked: {}\n", one.text);
  if (!options.plot.empty() && report.pictures.gouge && !write_output(options.plot, plot::svg(*report.pictures.gouge)))
    return kWrongUse;
  const auto mm = [](double value) { return text::format_fixed(value, 3); };
  const std::string text =
      options.family.text.json
          ? figures_with_lines(*measured, json::gouge_figures(g, report.validated))
          : fmt::format("rapids   {}, deepest into stock or part {} mm\ncuts     {}, deepest below the nominal {} mm\n",
                        g.rapids, mm(g.deepest_rapid_mm), g.cuts, mm(g.deepest_cut_mm));
  if (!write_output(options.family.text.output, text)) return kWrongUse;
  return g.findings.has(text::Severity::error) ? kFailed : kDone;
}

}  // namespace

void add_gouge(CLI::App& app, int& exit_code) {
  CLI::App* command = app.add_subcommand("gouge", "rapids into stock or part, cuts below the nominal");
  const auto options = std::make_shared<MeasureOptions>();
  add_measure_options(*command, *options);
  command->callback([options, &exit_code] { exit_code = gouge_of(*options); });
}

}  // namespace dripfeed::cli
