// dripfeed check: diagnostics and checks of programs, and the verdict.
#include <algorithm>
#include <memory>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "server/app/base/check_budget.h"
#include "server/app/checks/examine.h"
#include "server/app/library/fix_text.h"
#include "server/cli/called_programs.h"
#include "server/cli/cli.h"
#include "server/cli/documents.h"
#include "server/cli/inputs.h"
#include "server/cli/measured.h"
#include "server/cli/output.h"
#include "server/json/sarif.h"

namespace dripfeed::cli {

namespace {

struct CheckOptions {
  TextOptions text;
  std::vector<std::string> files;
  NominalOptions nominal;
  std::vector<std::string> values;
  std::string mode = "auto";
  bool drip = false;
  bool fix = false;
  bool sarif = false;
  std::uint32_t seconds = kCheckSeconds;
};

struct Checked {
  app::CheckReport report;
  std::optional<RenderedFamily> family;  // that its program was rendered from
};

void print_report(const Checked& checked) {
  const app::CheckReport& report = checked.report;
  const bool is_rendered = checked.family && !text::has_error(checked.family->result.diagnostics);
  const auto origin = [&](std::uint32_t line) {
    return is_rendered ? place_in_family(*checked.family, line) : std::string();
  };
  if (is_rendered) {
    const compile::RenderResult& made = checked.family->result;
    print_diagnostics(made.diagnostics, checked.family->source, report.control_title);
    fmt::print(stderr, "{}: {}: {}\n", report.source.name(), compile::name_of(made.mode), made.because);
  }
  print_diagnostics(report.checks.diagnostics, report.source, report.control_title, origin);
  const auto print_findings = [&](const checks::FindingList& findings) {
    for (const checks::Finding& one : findings.kept()) {
      const bool is_called = one.place.program != 0 && one.place.program < report.programs.size();
      const std::string& name = is_called ? report.programs[one.place.program] : report.source.name();
      fmt::print(stderr, "{}:{}: {}[{}]: {}{}\n", name, one.place.line, text::name_of(one.severity),
                 text::row_of(one.id).name, one.text, one.alarm.empty() ? "" : fmt::format(" (alarm {})", one.alarm));
      if (const std::string from = is_called ? "" : origin(one.place.line); !from.empty())
        fmt::print(stderr, "  from: {}\n", from);
      print_help(one.id);
    }
  };
  checks::for_each_check(report.checks, [&](const auto& one) { print_findings(one.findings); });
  for (const checks::NotChecked& one : checks::not_checked_of(report.checks))
    fmt::print(stderr, "{}: not checked: {}\n", report.source.name(), one.text);
  const std::string why = !report.inferred           ? ""
                          : report.because_line == 0 ? ", taken for want of a machine"
                                                     : fmt::format(", inferred from line {}", report.because_line);
  fmt::print(stderr, "{}: verdict {} ({}{})\n", report.source.name(), checks::name_of(report.verdict),
             report.control_title.empty() ? report.dialect : report.control_title, why);
}

// A family with faults has no program: the report is about its own text.
app::CheckReport report_of_faults(const RenderedFamily& rendered) {
  const ChosenControl& chosen = rendered.chosen;
  app::CheckReport report{.source = rendered.source,
                          .dialect = std::string(chosen.dialect->name),
                          .control_title = chosen.control.title,
                          .kind = chosen.control.kind,
                          .g_system = chosen.control.g_system,
                          .checks = {},
                          .programs = {rendered.source.name()},
                          .pictures = {}};
  report.checks.diagnostics = rendered.result.diagnostics;
  report.verdict = checks::verdict_of(report.checks);
  return report;
}

app::Result<Checked> check_family(const CheckOptions& options, text::Source family) {
  if (options.fix || options.sarif || !options.nominal.family.empty())
    return app::fail(app::ErrorCode::invalid,
                     fmt::format("{} is a family: --fix, --sarif and --nominal are for programs", family.name()));
  auto rendered = render_family({.text = options.text,
                                 .file = {},
                                 .values = options.values,
                                 .mode = options.mode,
                                 .name = {},
                                 .drip = options.drip},
                                std::move(family));
  if (!rendered) return std::unexpected(rendered.error());
  if (text::has_error(rendered->result.diagnostics)) {
    app::CheckReport report = report_of_faults(*rendered);
    return Checked{.report = std::move(report), .family = std::move(*rendered)};
  }
  app::Examination e = examination_of(*rendered, options.drip ? ir::Delivery::drip : ir::Delivery::memory);
  e.used_up = app::time_budget(options.seconds);
  app::CheckReport report = app::examine(e);
  report.verdict = checks::combine({report.verdict, checks::verdict_of(rendered->result.diagnostics)});
  return Checked{.report = std::move(report), .family = std::move(*rendered)};
}

app::Result<Checked> check_file(const CheckOptions& options, const std::string& path,
                                const std::optional<Nominal>& nominal) {
  auto source = read_source(find_family(path));
  if (!source) return std::unexpected(source.error());
  if (is_family(*source)) return check_family(options, std::move(*source));
  const auto chosen = choose_control(options.text, *source);
  if (!chosen) return std::unexpected(chosen.error());
  app::CheckReport report =
      app::examine({.source = std::move(*source),
                    .dialect = chosen->dialect,
                    .control = chosen->control,
                    .inferred = chosen->inferred,
                    .profile = chosen->profile ? &*chosen->profile : nullptr,
                    .delivery = options.drip ? ir::Delivery::drip : ir::Delivery::memory,
                    .find_called = find_in(folders_for(options.text, path)),
                    .geometry = nominal ? std::optional(nominal->geometry) : std::nullopt,
                    .profile_lines = nominal ? nominal->profile_lines : std::vector<family::LineRange>{},
                    .used_up = app::time_budget(options.seconds)});
  return Checked{.report = std::move(report), .family = {}};
}

// Carries out the edits of the report in its file. False, with a message, when that cannot be.
bool fix_file(const app::CheckReport& report) {
  const text::Source& source = report.source;
  const app::FixedText fixed = app::fix_text(source, report.checks.diagnostics);
  if (fixed.carried_out.empty()) return true;
  if (const std::string why = replace_file(source.name(), fixed.text); !why.empty()) {
    print_error(why);
    return false;
  }
  for (const text::Diagnostic* one : fixed.carried_out) {
    const text::Position at = source.position(one->fix->replaced.begin);
    fmt::print(stderr, "{}:{}:{}: fixed[{}]: {}\n", source.name(), at.line, at.column, text::row_of(one->id).name,
               app::describe_edit(*one->fix, source));
  }
  if (fixed.left > 0) fmt::print(stderr, "{}: {} fixes overlap others: run it again\n", source.name(), fixed.left);
  return true;
}

std::optional<RenderedFrom> origin_of(const Checked& checked) {
  if (!checked.family) return std::nullopt;
  const compile::RenderResult& made = checked.family->result;
  const bool failed = text::has_error(made.diagnostics);
  return RenderedFrom{.file = checked.family->source.name(),
                      .mode = failed ? "" : std::string(compile::name_of(made.mode)),
                      .because = made.because,
                      .lines = checked.family->lines};
}

int check(const CheckOptions& options) {
  std::vector<app::CheckReport> reports;
  std::vector<std::optional<RenderedFrom>> families;
  std::optional<Nominal> nominal;
  if (options.fix && std::ranges::find(options.files, "-") != options.files.end()) {
    print_error("--fix writes into files; standard input is not one");
    return kWrongUse;
  }
  if (!options.nominal.family.empty()) {
    auto read = read_nominal(options.nominal, options.values);
    if (!read) {
      print_error(read.error());
      return kWrongUse;
    }
    nominal = std::move(*read);
  }
  for (const std::string& file : options.files) {
    auto checked = check_file(options, file, nominal);
    if (checked && options.fix) {
      if (!fix_file(checked->report)) return kWrongUse;
      checked = check_file(options, file, nominal);
    }
    if (!checked) {
      print_error(checked.error());
      return kWrongUse;
    }
    print_report(*checked);
    families.push_back(origin_of(*checked));
    reports.push_back(std::move(checked->report));
  }
  const bool wants_document = options.text.json || options.sarif;
  const auto document = [&] {
    return options.sarif ? json::sarif(reports, kVersion) : check_document(reports, families);
  };
  if (wants_document && !write_output(options.text.output, document())) return kWrongUse;
  bool failed = false;
  for (const app::CheckReport& report : reports) failed = failed || report.verdict == checks::Verdict::fail;
  return failed ? kFailed : kDone;
}

}  // namespace

void add_check(CLI::App& app, int& exit_code) {
  CLI::App* command = app.add_subcommand("check", "diagnostics and checks of programs and families");
  const auto options = std::make_shared<CheckOptions>();
  command->add_option("FILE", options->files, "programs or families, - for standard input")->required();
  add_text_options(*command, options->text);
  add_nominal_options(*command, options->nominal,
                      "this family has stock, nominal and tools: gouges and accuracy are checked, too");
  add_value_options(*command, options->values, options->mode);
  command->add_flag("--drip", options->drip, "as fed block by block while it runs (tape, DNC, remote mode)");
  command->add_flag("--fix", options->fix, "writes the proposed fixes into the files, then checks them");
  command->add_flag("--sarif", options->sarif, "SARIF 2.1.0 on standard output, for editors and code hosts")
      ->excludes("--json");
  add_seconds(*command, options->seconds);
  command->callback([options, &exit_code] { exit_code = check(*options); });
}

}  // namespace dripfeed::cli
