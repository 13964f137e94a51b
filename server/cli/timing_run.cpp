// Of a large file only the lines' lengths are wanted besides the run; its text is held for that while it is fed.
#include "server/cli/timing_run.h"

#include <utility>

#include "dialects/compile/dialect/stream.h"
#include "server/app/base/check_budget.h"
#include "server/app/checks/examine.h"
#include "server/cli/called_programs.h"
#include "server/cli/program_file.h"

namespace dripfeed::cli {

namespace {

app::Examination examination_of(const TimeOptions& options, text::Source source, ChosenControl& chosen) {
  if (options.baud > 0) {
    chosen.profile->line.baud = static_cast<std::uint32_t>(options.baud);
    chosen.profile->line.link.options.erase("baud");
  }
  app::Examination examination{.source = std::move(source),
                               .dialect = chosen.dialect,
                               .control = chosen.control,
                               .inferred = chosen.inferred,
                               .profile = &*chosen.profile,
                               .delivery = options.drip ? ir::Delivery::drip : ir::Delivery::memory,
                               .find_called = find_in(folders_for(options.text, options.file)),
                               .geometry = {},
                               .profile_lines = {}};
  examination.timing.keep_whole = true;
  examination.timing.wants_curve = !options.plot_feed.empty() || !options.plot_buffer.empty();
  examination.timing.threads = options.threads;
  examination.used_up = app::time_budget(options.seconds);
  return examination;
}

// What is timed, and how the machine differs from its profile.
struct Order {
  const TimeOptions& options;
  timing::MachineFactors factors;
  std::optional<ir::CostModel> cost;
};

app::Result<ChosenControl> as_ordered(const Order& order, app::Result<ChosenControl> chosen) {
  if (!chosen) return chosen;
  if (!chosen->profile) return app::fail(app::ErrorCode::invalid, "time needs a machine: name one with --machine");
  checks::Machine& machine = chosen->profile->machine;
  for (checks::MachineAxis& axis : machine.axes) axis.acceleration_mm_s2 *= order.factors.acceleration;
  if (order.cost) machine.timing.cost = order.cost;
  if (order.factors.compute == 1.0) return chosen;
  machine.timing.cost = ir::scaled(machine.timing.cost.value_or(chosen->control.cost), order.factors.compute);
  return chosen;
}

app::Result<ChosenControl> choose_machine(const Order& order, const text::Source& source) {
  return as_ordered(order, choose_control(order.options.text, source));
}

app::Result<TimedProgram> time_text(const Order& order, text::Source source, ChosenControl& chosen) {
  app::CheckReport report = app::examine(examination_of(order.options, std::move(source), chosen));
  TimedProgram timed{.report = {},
                     .diagnostics = std::move(report.checks.diagnostics),
                     .source = std::move(report.source),
                     .control_title = report.control_title,
                     .not_checked = checks::not_checked_of(report.checks)};
  if (report.ran) timed.report = std::move(report.checks.timing);
  return timed;
}

app::Result<TimedProgram> time_family(const Order& order, text::Source family) {
  const TimeOptions& options = order.options;
  auto rendered = render_family({.text = options.text,
                                 .file = {},
                                 .values = options.values,
                                 .mode = options.mode,
                                 .name = {},
                                 .drip = options.drip},
                                std::move(family));
  if (!rendered) return std::unexpected(rendered.error());
  auto chosen = as_ordered(order, rendered->chosen);
  if (!chosen) return std::unexpected(chosen.error());
  if (text::has_error(rendered->result.diagnostics)) {
    return TimedProgram{.report = {},
                        .diagnostics = rendered->result.diagnostics,
                        .source = rendered->source,
                        .control_title = rendered->chosen.control.title};
  }
  auto timed = time_text(order, rendered_source(*rendered), *chosen);
  if (timed) timed->family = std::move(*rendered);
  return timed;
}

app::Result<TimedProgram> time_whole(const Order& order) {
  auto source = read_source(find_family(order.options.file));
  if (!source) return std::unexpected(source.error());
  if (is_family(*source)) return time_family(order, std::move(*source));
  auto chosen = choose_machine(order, *source);
  if (!chosen) return std::unexpected(chosen.error());
  return time_text(order, std::move(*source), *chosen);
}

app::Result<TimedProgram> time_stream(const Order& order, ProgramFile& file) {
  const TimeOptions& options = order.options;
  auto head = file.head();
  if (!head) return std::unexpected(head.error());
  auto chosen = choose_machine(order, *head);
  if (!chosen) return std::unexpected(chosen.error());
  const app::Examination examination = examination_of(options, *head, *chosen);
  std::string text;
  if (options.drip) {
    auto whole = file.whole();
    if (!whole) return app::fail(app::ErrorCode::unavailable, whole.error());
    text = std::move(*whole);
  }
  auto settings = app::timing_settings(examination, text);
  if (!settings) return app::fail(app::ErrorCode::invalid, settings.error());
  settings->most_kept = app::most_kept_motions(static_cast<std::size_t>(file.size_bytes().value_or(0)));
  timing::Timing timing(std::move(*settings));
  compile::ProgramLibrary library(chosen->control, examination.find_called);
  interpreter::RunOptions run;
  run.used_up = examination.used_up;
  compile::StreamRun ran =
      compile::execute_stream(file, options.file, *chosen->dialect, chosen->control, &library, timing, run);
  if (!ran.read_error.empty()) return app::fail(app::ErrorCode::unavailable, ran.read_error);
  TimedProgram timed{.report = {},
                     .diagnostics = std::move(ran.diagnostics),
                     .source = ran.source ? std::move(*ran.source) : std::move(*head),
                     .control_title = chosen->control.title,
                     .validated = false};
  if (ran.result.ended == interpreter::Ended::end) {
    timed.report = timing.finish();
    return timed;
  }
  for (const interpreter::RunDiagnostic& one : ran.result.diagnostics) {
    timed.diagnostics.push_back(one.diagnostic);
    if (!ran.source) timed.diagnostics.back().span = {};  // its place is not in what is kept
  }
  return timed;
}

}  // namespace

app::Result<TimedProgram> run_timing(const TimeOptions& options, const timing::MachineFactors& factors,
                                     const std::optional<ir::CostModel>& cost) {
  const Order order{options, factors, cost};
  if (options.file == "-" || find_family(options.file) != options.file) return time_whole(order);
  const auto file = ProgramFile::open(options.file);
  if (!file) return std::unexpected(file.error());
  if ((*file)->size_bytes().value_or(0) <= kWholeBytes) return time_whole(order);
  return time_stream(order, **file);
}

}  // namespace dripfeed::cli
