// The nominal comes from the family with its values, never from the printed text.
#include "server/cli/measured.h"

#include <utility>

#include <fmt/format.h>

#include "dialects/compile/execute.h"
#include "dialects/compile/stream.h"
#include "server/app/machine_facts.h"
#include "server/cli/output.h"
#include "server/cli/program_file.h"

namespace dripfeed::cli {

namespace {

Measured measured_of(app::CheckReport report, const app::Examination& e) {
  return {std::move(report), e.geometry.value_or(family::Geometry{}), e.control.kind,
          app::x_is_diameter(e.control, e.profile)};
}

app::Result<Measured> measure_family(const MeasureOptions& options) {
  const auto rendered = render_family(options.family);
  if (!rendered) return std::unexpected(rendered.error());
  if (text::has_error(rendered->result.diagnostics))
    return app::fail(app::ErrorCode::refused, "the family cannot be rendered");
  const app::Examination e{.source = text::Source(options.family.file, rendered->result.text),
                           .dialect = rendered->chosen.dialect,
                           .control = rendered->chosen.control,
                           .inferred = false,
                           .profile = rendered->chosen.profile ? &*rendered->chosen.profile : nullptr,
                           .delivery = ir::Delivery::memory,
                           .find_called = {},
                           .geometry = rendered->result.geometry,
                           .profile_lines = rendered->result.profile_lines};
  return measured_of(app::examine(e), e);
}

app::Result<family::Geometry> geometry_of(const MeasureOptions& options) {
  auto source = read_source(find_family(options.nominal));
  if (!source) return std::unexpected(source.error());
  auto values = overrides_of(options.family);
  if (!values) return std::unexpected(values.error());
  auto geometry = compile::family_geometry(*source, *values);
  print_diagnostics(geometry.diagnostics, *source, "family");
  if (text::has_error(geometry.diagnostics)) return app::fail(app::ErrorCode::refused, "the nominal has errors");
  return std::move(geometry.geometry);
}

// While it is read: its text is not validated.
app::Result<Measured> measure_stream(const MeasureOptions& options, app::Examination e, ProgramFile& file,
                                     app::SurfaceScope scope) {
  app::CheckReport report;
  app::SurfaceChecks checks(e, scope, report.checks.not_checked);
  compile::FanOut sinks(checks.sinks());
  compile::ProgramLibrary library(e.control, e.find_called);
  const compile::StreamRun ran =
      compile::execute_stream(file, options.family.file, *e.dialect, e.control, &library, sinks, {});
  if (!ran.read_error.empty()) return app::fail(app::ErrorCode::unavailable, ran.read_error);
  for (const interpreter::RunDiagnostic& one : ran.result.diagnostics) {
    fmt::print(stderr, "{}:{}: {}[{}]: {}\n", options.family.file, one.line, text::name_of(one.diagnostic.severity),
               text::row_of(one.diagnostic.id).name, text::message_of(one.diagnostic));
  }
  for (const interpreter::NotInterpreted& one : ran.result.not_interpreted) {
    if (!one.effects_known) report.checks.not_checked.add(fmt::format("{}: not interpreted", one.name), one.first_line);
  }
  report.ran = ran.result.ended == interpreter::Ended::end;
  report.blocks = ran.result.blocks;
  checks.finish(report.checks, report.pictures);
  return measured_of(std::move(report), e);
}

app::Result<Measured> measure_file(const MeasureOptions& options, app::SurfaceScope scope) {
  const std::string& path = options.family.file;
  auto geometry = geometry_of(options);
  if (!geometry) return std::unexpected(geometry.error());
  std::unique_ptr<ProgramFile> file;
  if (path != "-") {
    auto opened = ProgramFile::open(path);
    if (!opened) return std::unexpected(opened.error());
    file = std::move(*opened);
  }
  const bool streams = file && file->size_bytes().value_or(0) > kWholeBytes;
  auto source = streams ? file->head() : read_source(path);
  if (!source) return std::unexpected(source.error());
  const auto chosen = choose_control(options.family.text, *source);
  if (!chosen) return std::unexpected(chosen.error());
  app::Examination e{.source = std::move(*source),
                     .dialect = chosen->dialect,
                     .control = chosen->control,
                     .inferred = chosen->inferred,
                     .profile = chosen->profile ? &*chosen->profile : nullptr,
                     .delivery = ir::Delivery::memory,
                     .find_called = find_in(folders_for(options.family.text, path)),
                     .geometry = std::move(*geometry),
                     .profile_lines = {}};
  if (streams) return measure_stream(options, std::move(e), *file, scope);
  return measured_of(app::examine(e), e);
}

}  // namespace

void add_measure_options(CLI::App& command, MeasureOptions& options) {
  add_family_options(command, options.family);
  command.add_option("--nominal", options.nominal,
                     "FAMILY is a program, this family (with the values of --set) has its stock and nominal");
  command.add_option("--plot", options.plot, "writes a picture as SVG");
}

app::Result<Measured> measure(const MeasureOptions& options, app::SurfaceScope scope) {
  return options.nominal.empty() ? measure_family(options) : measure_file(options, scope);
}

void print_not_measured(const app::CheckReport& report) {
  print_diagnostics(report.checks.diagnostics, report.source, report.control_title);
  for (const checks::NotChecked& one : checks::not_checked_of(report.checks))
    fmt::print(stderr, "not checked: {}\n", one.text);
}

}  // namespace dripfeed::cli
