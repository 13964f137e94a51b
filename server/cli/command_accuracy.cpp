// dripfeed accuracy: how far what is cut lies from the nominal, and what a measuring machine found.
#include <memory>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "checks/accuracy/cmm.h"
#include "dialects/text/number.h"
#include "server/cli/cli.h"
#include "server/cli/measured.h"
#include "server/cli/output.h"
#include "server/json/reports.h"

namespace dripfeed::cli {

namespace {

struct AccuracyOptions {
  MeasureOptions measure;
  std::string cmm;
  bool best_fit = false;
};

std::string mm(double value) { return text::format_fixed(value, 6); }

std::string figures_text(const accuracy::Report& a, const Measured& measured) {
  std::string text = fmt::format("blocks       {}\npath         max {} mm at line {}{}, mean {}, rmse {}\n", a.blocks,
                                 mm(a.path.max_mm), a.path.max_line, in_family(measured, a.path.max_line),
                                 mm(a.path.mean_mm), mm(a.path.rmse_mm));
  if (a.surface)
    text += fmt::format("surface cut  max {} mm at line {}{}, mean {}, rmse {}\n", mm(a.surface->max_mm),
                        a.surface->max_line, in_family(measured, a.surface->max_line), mm(a.surface->mean_mm),
                        mm(a.surface->rmse_mm));
  text += a.chord_bound_mm ? fmt::format("chord bound  {} mm (proved)\n", mm(*a.chord_bound_mm))
                           : "chord bound  none: the nominal's curvature is not bounded\n";
  text += fmt::format("covered      {}{}\n", a.covered ? "yes" : "no",
                      a.overrun_mm > 0 ? fmt::format("; runs out {} mm beyond the nominal", mm(a.overrun_mm)) : "");
  return text;
}

std::string cmm_line(std::string_view name, const accuracy::CmmFigures& f) {
  return fmt::format("{} {} points, min {} mm, max {}, mean {}, rmse {}, largest in row {}\n", name, f.points,
                     mm(f.min_mm), mm(f.max_mm), mm(f.mean_mm), mm(f.rmse_mm), f.max_row);
}

std::string cmm_text(const accuracy::CmmReport& report) {
  std::string text = cmm_line("measured    ", report.measured);
  if (!report.fitted) return text;
  text += cmm_line("best fit    ", *report.fitted);
  text += fmt::format("fitted by    shift {} {} mm, turn {} deg\n", mm(report.fit.shift.z), mm(report.fit.shift.x),
                      mm(report.fit.angle_deg));
  return text;
}

app::Result<accuracy::CmmReport> cmm_of(const AccuracyOptions& options, const Measured& measured) {
  const auto source = read_source(options.cmm);
  if (!source) return std::unexpected(source.error());
  auto found = app::measure_points(source->text(), options.best_fit, measured);
  if (!found) found.error().text.insert(0, options.cmm + ": ");
  return found;
}

int accuracy_of(const AccuracyOptions& options) {
  const auto measured = measure(options.measure, app::SurfaceScope::accuracy_alone);
  if (!measured) {
    print_error(measured.error());
    return kWrongUse;
  }
  const app::CheckReport& report = measured->report;
  if (!report.checks.accuracy || !report.ran) return not_measured(options.measure, report);
  std::optional<accuracy::CmmReport> cmm;
  if (!options.cmm.empty()) {
    const auto points = cmm_of(options, *measured);
    if (!points) {
      print_error(points.error());
      return kWrongUse;
    }
    cmm = *points;
  }
  if (!options.measure.plot.empty() && report.pictures.accuracy &&
      !write_output(options.measure.plot, plot::svg(*report.pictures.accuracy)))
    return kWrongUse;
  const TextOptions& out = options.measure.family.text;
  const std::string text =
      out.json ? figures_with_lines(*measured, json::accuracy_figures(*report.checks.accuracy, cmm, report.validated))
               : figures_text(*report.checks.accuracy, *measured) + (cmm ? cmm_text(*cmm) : "");
  return write_output(out.output, text) ? kDone : kWrongUse;
}

}  // namespace

void add_accuracy(CLI::App& app, int& exit_code) {
  CLI::App* command = app.add_subcommand("accuracy", "deviation of what is cut from the nominal");
  const auto options = std::make_shared<AccuracyOptions>();
  add_measure_options(*command, options->measure);
  command->add_option("--cmm", options->cmm, "CSV of measured points: x,y or x,z, or nominal,measured, or deviation");
  command->add_flag("--best-fit", options->best_fit, "shifts and turns the measured points onto the nominal, too");
  command->callback([options, &exit_code] { exit_code = accuracy_of(*options); });
}

}  // namespace dripfeed::cli
