// dripfeed calibrate: writes the timing program of a control, and fits the machine's profile to what it measured there
// and to cycle times that were taken with a watch.
#include <algorithm>
#include <chrono>
#include <memory>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "checks/timing/machine_fit.h"
#include "dialects/text/number.h"
#include "server/app/checks/calibration.h"
#include "server/app/lines/variable_dump.h"
#include "server/cli/cli.h"
#include "server/cli/output.h"
#include "server/cli/timing_run.h"
#include "server/json/profile_document.h"

namespace dripfeed::cli {

namespace {

struct CalibrateOptions {
  TextOptions text;
  std::string write;
  bool prints = false;
  bool calls = false;
  std::string results;
  std::vector<std::string> runs;  // FILE=SECONDS
};

int fail_with(const app::Error& error) {
  print_error(error);
  return kWrongUse;
}

std::string fixed(double value, int places) { return text::format_fixed(value, places); }

int write_program(const CalibrateOptions& options) {
  const auto chosen = choose_control(options.text);
  if (!chosen) return fail_with(chosen.error());
  const auto program = app::calibration_program(chosen->control, {.prints = options.prints, .calls = options.calls});
  if (!program) return fail_with(program.error());
  return write_output(options.write, *program) ? kDone : kWrongUse;
}

// The cost model from the results file; what it was fitted to is added to `text`.
app::Result<ir::CostModel> cost_of(const CalibrateOptions& options, const ChosenControl& chosen, std::string& text) {
  const auto results = read_source(options.results);
  if (!results) return std::unexpected(results.error());
  const auto values = app::read_variables(results->text(), *chosen.dialect, chosen.control);
  if (!values) return std::unexpected(values.error());
  const auto rows = app::calibration_rows(*chosen.dialect, chosen.control, *values);
  if (!rows) return std::unexpected(rows.error());
  std::vector<timing::CostRow> measured;
  for (const app::CalibrationRow& row : *rows) measured.push_back(row.row);
  const auto fit = timing::fit_cost(measured);
  if (!fit) return app::fail(app::ErrorCode::invalid, fit.error());
  for (std::size_t i = 0; i < rows->size(); ++i) {
    const double ms = measured[i].measured_ms;
    text +=
        fmt::format("{:<5} {:<34} measured {:>9} ms  model {:>9} ms  {:>6} %\n", (*rows)[i].variable, (*rows)[i].what,
                    fixed(ms, 1), fixed(ms + fit->residual_ms[i], 1), fixed(100 * fit->residual_ms[i] / ms, 2));
  }
  ir::CostModel model = fit->model;
  const ir::CostModel before = chosen.profile->machine.timing.cost.value_or(chosen.control.cost);
  for (std::size_t i = 0; i < ir::kCostTerms.size(); ++i) {
    const ir::CostTerm& term = ir::kCostTerms[i];
    // What the program did not do it says nothing of.
    const bool is_asked =
        std::ranges::any_of(measured, [&](const timing::CostRow& row) { return row.counts.*term.count > 0; });
    if (!is_asked) model.*term.ms = before.*term.ms;
    text += fmt::format("{:>10} ms  {}{}\n", fixed(model.*term.ms, 4), term.what,
                        !is_asked               ? " (as before: not measured)"
                        : fit->is_determined[i] ? ""
                                                : " (not separated from the others)");
  }
  return model;
}

struct TimedRun {
  std::string file;
  double measured_s = 0.0;
};
app::Result<std::vector<TimedRun>> timed_runs(const CalibrateOptions& options) {
  std::vector<TimedRun> runs;
  for (const std::string& one : options.runs) {
    const std::size_t equals = one.rfind('=');
    const auto value = equals == std::string::npos ? std::nullopt : text::parse_number(one.substr(equals + 1));
    if (!value || !(*value > 0.0))
      return app::fail(app::ErrorCode::invalid, fmt::format("--run \"{}\": use FILE=SECONDS", one));
    runs.push_back({one.substr(0, equals), *value});
  }
  return runs;
}

// Factors that explain the measured cycle times, from the memory, with `cost` as the start.
app::Result<timing::MachineFactors> factors_of(const CalibrateOptions& options,
                                               const std::optional<ir::CostModel>& cost, std::string& text) {
  const auto timed = timed_runs(options);
  if (!timed) return std::unexpected(timed.error());
  std::vector<timing::MeasuredRun> runs;
  std::optional<app::Error> failed;
  for (const TimedRun& one : *timed) {
    TimeOptions time;
    time.text = options.text;
    time.file = one.file;
    time.text.json = false;
    runs.push_back({one.measured_s, [time, cost, &failed](const timing::MachineFactors& factors) {
                      const auto ran = run_timing(time, factors, cost);
                      if (ran && ran->report) return ran->report->cycle_s;
                      failed = ran ? app::Error{app::ErrorCode::refused, time.file + ": it does not run to its end", {}}
                                   : ran.error();
                      return 1.0;
                    }});
  }
  const auto fit = timing::fit_machine(runs);
  if (failed) return std::unexpected(*failed);
  if (!fit) return app::fail(app::ErrorCode::invalid, fit.error());
  for (std::size_t i = 0; i < timed->size(); ++i) {
    text += fmt::format("{}: measured {} s, predicted {} % off before, {} % after\n", (*timed)[i].file,
                        fixed((*timed)[i].measured_s, 2), fixed(100 * fit->before_share[i], 1),
                        fixed(100 * fit->after_share[i], 1));
  }
  text += fmt::format("accelerations x {}, computing x {}\n", fixed(fit->factors.acceleration, 3),
                      fixed(fit->factors.compute, 3));
  return fit->factors;
}

// Which programs measured the machine, and when. `before`: what was scaled to cycle times alone.
std::string origin_of(const CalibrateOptions& options, std::string_view before) {
  std::string text(options.results.empty() ? before : app::kTimingProgramName);
  for (const std::string& run : options.runs)
    text += fmt::format("{}{}", text.empty() ? "" : "; ", "cycle time of " + run.substr(0, run.rfind('=')));
  const std::chrono::year_month_day day(std::chrono::floor<std::chrono::days>(std::chrono::system_clock::now()));
  return fmt::format("{}, {:04}-{:02}-{:02}", text, static_cast<int>(day.year()), static_cast<unsigned>(day.month()),
                     static_cast<unsigned>(day.day()));
}

int fit_profile(const CalibrateOptions& options) {
  const auto chosen = choose_control(options.text);
  if (!chosen) return fail_with(chosen.error());
  if (!chosen->profile)
    return fail_with({app::ErrorCode::invalid, "calibrate needs a machine: name one with --machine", {}});
  std::string text;
  std::optional<ir::CostModel> measured;
  if (!options.results.empty()) {
    const auto cost = cost_of(options, *chosen, text);
    if (!cost) return fail_with(cost.error());
    measured = *cost;
  }
  timing::MachineFactors factors;
  if (!options.runs.empty()) {
    const auto found = factors_of(options, measured, text);
    if (!found) return fail_with(found.error());
    factors = *found;
  }
  fmt::print("{}", text);
  if (options.text.output.empty()) return kDone;
  const checks::TimingData& timing = chosen->profile->machine.timing;
  ir::CostModel cost = measured.value_or(timing.cost.value_or(chosen->control.cost));
  cost = ir::scaled(cost, factors.compute);
  const std::string before = timing.cost ? timing.cost_origin : std::string(chosen->control.cost.origin);
  const auto document = read_machine_document(options.text.machine);
  if (!document) return fail_with(document.error());
  const auto profile =
      json::calibrated_profile(document->text(), cost, origin_of(options, before), factors.acceleration);
  if (!profile) return fail_with(profile.error());
  return write_output(options.text.output, *profile) ? kDone : kWrongUse;
}

int calibrate(const CalibrateOptions& options) {
  const bool fits = !options.results.empty() || !options.runs.empty();
  if (options.write.empty() == !fits)
    return fail_with({app::ErrorCode::invalid, "calibrate either writes (--write) or fits (--results, --run)", {}});
  return fits ? fit_profile(options) : write_program(options);
}

}  // namespace

void add_calibrate(CLI::App& app, int& exit_code) {
  CLI::App* command =
      app.add_subcommand("calibrate", "measures a control: its timing program, and the fit of its results");
  const auto options = std::make_shared<CalibrateOptions>();
  add_text_options(*command, options->text);
  command->add_option("--write", options->write, "write the timing program there");
  command->add_flag("--dprnt", options->prints, "with --write: the program sends its results over the line, too");
  command->add_flag("--calls", options->calls,
                    "with --write: a second program is written after it, and calling it is measured, too");
  command->add_option("--results", options->results,
                      "variables that it left or sent: lines as #500=412., R20=0.412 or V500 412.000");
  command->add_option("--run", options->runs, "FILE=SECONDS: a program's measured cycle time, run from the memory");
  command->callback([options, &exit_code] { exit_code = calibrate(*options); });
}

}  // namespace dripfeed::cli
