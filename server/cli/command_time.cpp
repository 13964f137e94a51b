// dripfeed time: compute, motion and line time of a program.
#include <memory>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "dialects/text/number.h"
#include "server/app/checks/examine.h"
#include "server/app/checks/timing_pictures.h"
#include "server/cli/cli.h"
#include "server/cli/documents.h"
#include "server/cli/inputs.h"
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

// Where in its family the lines are that the figures name.
void print_stall_origins(const TimedProgram& timed) {
  if (!timed.family) return;
  const compile::RenderResult& result = timed.family->result;
  fmt::print(stderr, "{}: {}; lines are of the rendered program\n", timed.source.name(), result.because);
  const timing::Report& report = *timed.report;
  for (const std::uint32_t line : {report.first_stall_line, report.longest_stall_line}) {
    const std::string from = place_in_family(*timed.family, line);
    if (report.stalls > 0 && !from.empty()) fmt::print(stderr, "  line {} is from {}\n", line, from);
  }
}

int time_program(const TimeOptions& options) {
  const auto timed = run_timing(options);
  if (!timed) return fail_with(timed.error());
  if (!timed->validated) print_not_validated(options.file);
  if (!timed->report) {
    print_diagnostics(timed->diagnostics, timed->source, timed->control_title);
    if (!options.text.json) return kFailed;
    const std::string document =
        not_measured_document(timed->diagnostics, timed->source, false, timed->validated, timed->not_checked);
    return write_output(options.text.output, document) ? kFailed : kWrongUse;
  }
  print_stall_origins(*timed);
  for (const auto& [path, draw] :
       {std::pair(options.plot_feed, &app::feed_plot), std::pair(options.plot_buffer, &app::buffer_plot)}) {
    if (!path.empty() && !write_output(path, plot::svg(draw(*timed->report, options.file)))) return kWrongUse;
  }
  const std::string text =
      options.text.json ? json::time_figures(*timed->report, timed->validated) : timing_text(*timed->report);
  return write_output(options.text.output, text) ? kDone : kWrongUse;
}

}  // namespace

void add_time(CLI::App& app, int& exit_code) {
  CLI::App* command = app.add_subcommand("time", "compute, motion and line time of a program");
  const auto options = std::make_shared<TimeOptions>();
  command->add_option("FILE", options->file, "program or family, - for standard input")->required();
  add_value_options(*command, options->values, options->mode);
  add_text_options(*command, options->text);
  command->add_flag("--drip", options->drip, "as fed over the machine's line");
  command->add_option("--baud", options->baud, "another speed of the line, with --drip")
      ->check(CLI::Range(50, 4'000'000));
  command->add_option("--threads", options->threads, "threads of the look-ahead; the result is the same for any")
      ->check(CLI::Range(1, 256));
  command->add_option("--plot-feed", options->plot_feed, "writes the speed over the time as SVG");
  command->add_option("--plot-buffer", options->plot_buffer, "writes what lies in the control's buffer as SVG");
  add_seconds(*command, options->seconds);
  command->callback([options, &exit_code] { exit_code = time_program(*options); });
}

}  // namespace dripfeed::cli
