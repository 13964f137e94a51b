// dripfeed time and dripfeed accuracy: one figure of the checks each, of a program or a family.
#include <memory>

#include <fmt/format.h>

#include "dialects/text/number.h"
#include "server/app/examine.h"
#include "server/cli/cli.h"
#include "server/cli/family_options.h"
#include "server/cli/output.h"
#include "server/cli/timing_run.h"
#include "server/cli/timing_text.h"
#include "server/json/reports.h"

namespace dripfeed::cli {

namespace {

int fail_with(const app::Error& error) {
  print_error(error);
  return kWrongUse;
}

int time_program(const TimeOptions& options) {
  const auto timed = run_timing(options);
  if (!timed) return fail_with(timed.error());
  if (!timed->report) {
    print_diagnostics(timed->diagnostics, timed->source, timed->control_title);
    return kFailed;
  }
  for (const auto& [path, plot] :
       {std::pair(options.plot_feed, &feed_plot), std::pair(options.plot_buffer, &buffer_plot)}) {
    if (!path.empty() && !write_output(path, plot(*timed->report, options.file))) return kWrongUse;
  }
  const std::string text = options.text.json ? json::time_figures(*timed->report) : timing_text(*timed->report);
  return write_output(options.text.output, text) ? kDone : kWrongUse;
}

// What is measured: the text that a family renders to, or a program against a family's nominal.
app::Result<app::CheckReport> measure(const FamilyOptions& options, const std::string& nominal) {
  if (nominal.empty()) {
    const auto rendered = render_family(options);
    if (!rendered) return std::unexpected(rendered.error());
    if (text::has_error(rendered->result.diagnostics))
      return app::fail(app::ErrorCode::refused, "the family cannot be rendered");
    return app::examine({.source = text::Source(options.file, rendered->result.text),
                         .dialect = rendered->chosen.dialect,
                         .control = rendered->chosen.control,
                         .inferred = false,
                         .profile = rendered->chosen.profile ? &*rendered->chosen.profile : nullptr,
                         .delivery = ir::Delivery::memory,
                         .find_called = {},
                         .geometry = rendered->result.geometry,
                         .profile_lines = rendered->result.profile_lines});
  }
  auto source = read_source(options.file);
  if (!source) return std::unexpected(source.error());
  const auto family = read_source(nominal);
  if (!family) return std::unexpected(family.error());
  const auto chosen = choose_control(options.text, *source);
  if (!chosen) return std::unexpected(chosen.error());
  const auto geometry = compile::family_geometry(*family, {});
  print_diagnostics(geometry.diagnostics, *family, "family");
  if (text::has_error(geometry.diagnostics)) return app::fail(app::ErrorCode::refused, "the nominal has errors");
  return app::examine({.source = std::move(*source),
                       .dialect = chosen->dialect,
                       .control = chosen->control,
                       .inferred = chosen->inferred,
                       .profile = chosen->profile ? &*chosen->profile : nullptr,
                       .delivery = ir::Delivery::memory,
                       .find_called = find_in(folders_for(options.text, options.file)),
                       .geometry = geometry.geometry,
                       .profile_lines = {}});
}

int accuracy_of(const FamilyOptions& options, const std::string& nominal) {
  const auto report = measure(options, nominal);
  if (!report) return fail_with(report.error());
  if (!report->checks.accuracy || !report->ran) {
    print_diagnostics(report->checks.diagnostics, report->source, report->control_title);
    for (const checks::NotChecked& one : checks::not_checked_of(report->checks))
      fmt::print(stderr, "not checked: {}\n", one.text);
    return kFailed;
  }
  const accuracy::Report& a = *report->checks.accuracy;
  if (options.text.json) return write_output(options.text.output, json::accuracy_figures(a)) ? kDone : kWrongUse;
  const auto mm = [](double value) { return text::format_fixed(value, 6); };
  std::string text = fmt::format("blocks       {}\npath         max {} mm at line {}, mean {}, rmse {}\n", a.blocks,
                                 mm(a.path.max_mm), a.path.max_line, mm(a.path.mean_mm), mm(a.path.rmse_mm));
  if (a.surface)
    text += fmt::format("surface cut  max {} mm at line {}, mean {}, rmse {}\n", mm(a.surface->max_mm),
                        a.surface->max_line, mm(a.surface->mean_mm), mm(a.surface->rmse_mm));
  text += a.chord_bound_mm ? fmt::format("chord bound  {} mm (proved)\n", mm(*a.chord_bound_mm))
                           : "chord bound  none: the nominal's curvature is not bounded\n";
  text += fmt::format("covered      {}{}\n", a.covered ? "yes" : "no",
                      a.overrun_mm > 0 ? fmt::format("; runs out {} mm beyond the nominal", mm(a.overrun_mm)) : "");
  return write_output(options.text.output, text) ? kDone : kWrongUse;
}

}  // namespace

void add_time(CLI::App& app, int& exit_code) {
  CLI::App* command = app.add_subcommand("time", "compute, motion and line time of a program");
  const auto options = std::make_shared<TimeOptions>();
  command->add_option("FILE", options->file, "program, - for standard input")->required();
  add_text_options(*command, options->text);
  command->add_flag("--drip", options->drip, "as fed over the machine's line");
  command->add_option("--baud", options->baud, "another speed of the line, with --drip")
      ->check(CLI::Range(50, 4'000'000));
  command->add_option("--threads", options->threads, "threads of the look-ahead; the result is the same for any")
      ->check(CLI::Range(1, 256));
  command->add_option("--plot-feed", options->plot_feed, "writes the speed over the time as SVG");
  command->add_option("--plot-buffer", options->plot_buffer, "writes what lies in the control's buffer as SVG");
  command->callback([options, &exit_code] { exit_code = time_program(*options); });
}

void add_accuracy(CLI::App& app, int& exit_code) {
  CLI::App* command = app.add_subcommand("accuracy", "deviation of what is cut from the nominal");
  const auto options = std::make_shared<FamilyOptions>();
  const auto nominal = std::make_shared<std::string>();
  add_family_options(*command, *options);
  command->add_option("--nominal", *nominal, "FAMILY is a program, this family has its nominal");
  command->callback([options, nominal, &exit_code] { exit_code = accuracy_of(*options, *nominal); });
}

}  // namespace dripfeed::cli
