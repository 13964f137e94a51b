// The nominal comes from the family with its values, never from the printed text.
#include "server/cli/measured.h"

#include <utility>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "dialects/compile/dialect/execute.h"
#include "dialects/compile/dialect/stream.h"
#include "server/cli/called_programs.h"
#include "server/cli/cli.h"
#include "server/cli/documents.h"
#include "server/cli/output.h"
#include "server/cli/program_file.h"

namespace dripfeed::cli {

namespace {

app::Result<Measured> measure_family(const MeasureOptions& options) {
  auto source = read_source(find_family(options.family.file));
  if (!source) return std::unexpected(source.error());
  auto rendered = render_family(options.family, std::move(*source));
  if (!rendered) return std::unexpected(rendered.error());
  print_diagnostics(rendered->result.diagnostics, rendered->source, rendered->chosen.control.title);
  if (text::has_error(rendered->result.diagnostics))
    return app::fail(app::ErrorCode::refused, "the family cannot be rendered");
  const app::Examination e = examination_of(*rendered, ir::Delivery::memory);
  return Measured{app::measured_of(app::examine(e), e), std::move(*rendered)};
}

// While it is read: its text is not validated, and that is reported.
app::Result<Measured> measure_stream(const MeasureOptions& options, app::Examination e, ProgramFile& file,
                                     app::SurfaceScope scope) {
  app::CheckReport report;
  report.validated = false;
  print_not_validated(options.family.file);
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
  return Measured{app::measured_of(std::move(report), e), {}};
}

app::Result<Measured> measure_file(const MeasureOptions& options, app::SurfaceScope scope) {
  const std::string& path = options.family.file;
  auto nominal = read_nominal(options.nominal, options.family.values);
  if (!nominal) return std::unexpected(nominal.error());
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
                     .geometry = std::move(nominal->geometry),
                     .profile_lines = std::move(nominal->profile_lines)};
  if (streams) return measure_stream(options, std::move(e), *file, scope);
  return Measured{app::measured_of(app::examine(e), e), {}};
}

}  // namespace

void add_nominal_options(CLI::App& command, NominalOptions& options, const std::string& help) {
  CLI::Option* nominal = command.add_option("--nominal", options.family, help);
  command
      .add_option("--profile", options.profile, "with --nominal: lines that make it, 12-60,70-71; otherwise every cut")
      ->needs(nominal);
}

app::Result<Nominal> read_nominal(const NominalOptions& options, const std::vector<std::string>& values) {
  auto source = read_source(find_family(options.family));
  if (!source) return std::unexpected(source.error());
  const auto overrides = overrides_of(values, *source);
  if (!overrides) return std::unexpected(overrides.error());
  auto made = compile::family_geometry(*source, *overrides);
  print_diagnostics(made.diagnostics, *source, "family");
  if (text::has_error(made.diagnostics)) return app::fail(app::ErrorCode::refused, "the nominal has errors");
  auto lines = app::read_line_ranges(options.profile);
  if (!lines) return app::fail(app::ErrorCode::invalid, "--profile names lines as 12-60,70-71");
  return Nominal{std::move(made.geometry), std::move(*lines)};
}

void add_measure_options(CLI::App& command, MeasureOptions& options) {
  add_family_options(command, options.family);
  add_nominal_options(command, options.nominal,
                      "FAMILY is a program, this family (with the values of --set) has its stock and nominal");
  command.add_option("--plot", options.plot, "writes a picture as SVG");
}

app::Result<Measured> measure(const MeasureOptions& options, app::SurfaceScope scope) {
  return options.nominal.family.empty() ? measure_family(options) : measure_file(options, scope);
}

std::string in_family(const Measured& measured, std::uint32_t line) {
  const std::string place = measured.family ? place_in_family(*measured.family, line) : std::string();
  // Its file is the one that was named: the folder says nothing new.
  return place.empty() ? std::string() : fmt::format(" ({})", place.substr(place.rfind('/') + 1));
}

std::string figures_with_lines(const Measured& measured, const std::string& figures) {
  return measured.family ? with_family_lines(figures, measured.family->lines) : figures;
}

int not_measured(const MeasureOptions& options, const app::CheckReport& report) {
  const std::vector<checks::NotChecked> not_checked = checks::not_checked_of(report.checks);
  print_diagnostics(report.checks.diagnostics, report.source, report.control_title);
  for (const checks::NotChecked& one : not_checked) fmt::print(stderr, "not checked: {}\n", one.text);
  const TextOptions& out = options.family.text;
  if (!out.json) return kFailed;
  const std::string document =
      not_measured_document(report.checks.diagnostics, report.source, report.ran, report.validated, not_checked);
  return write_output(out.output, document) ? kFailed : kWrongUse;
}

}  // namespace dripfeed::cli
