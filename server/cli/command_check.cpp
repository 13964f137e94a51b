// dripfeed check: diagnostics and checks of programs, and the verdict.
#include <algorithm>
#include <memory>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "server/app/check_budget.h"
#include "server/app/examine.h"
#include "server/cli/called_programs.h"
#include "server/cli/cli.h"
#include "server/cli/fix_text.h"
#include "server/cli/inputs.h"
#include "server/cli/measured.h"
#include "server/cli/output.h"
#include "server/json/reports.h"
#include "server/json/sarif.h"

namespace dripfeed::cli {

namespace {

struct Options {
  TextOptions text;
  std::vector<std::string> files;
  NominalOptions nominal;
  std::vector<std::string> values;
  bool drip = false;
  bool fix = false;
  bool sarif = false;
  std::uint32_t seconds = kCheckSeconds;
};

void print_report(const app::CheckReport& report) {
  print_diagnostics(report.checks.diagnostics, report.source, report.control_title);
  const auto print_findings = [&](const checks::FindingList& findings) {
    for (const checks::Finding& one : findings.kept()) {
      const bool is_called = one.place.program != 0 && one.place.program < report.programs.size();
      const std::string& name = is_called ? report.programs[one.place.program] : report.source.name();
      fmt::print(stderr, "{}:{}: {}[{}]: {}{}\n", name, one.place.line, text::name_of(one.severity),
                 text::row_of(one.id).name, one.text, one.alarm.empty() ? "" : fmt::format(" (alarm {})", one.alarm));
      print_help(one.id);
    }
  };
  if (report.checks.envelope) print_findings(report.checks.envelope->findings);
  if (report.checks.gouge) print_findings(report.checks.gouge->findings);
  if (report.checks.accuracy) print_findings(report.checks.accuracy->findings);
  if (report.checks.timing) print_findings(report.checks.timing->findings);
  for (const checks::NotChecked& one : checks::not_checked_of(report.checks))
    fmt::print(stderr, "{}: not checked: {}\n", report.source.name(), one.text);
  const std::string why = !report.inferred           ? ""
                          : report.because_line == 0 ? ", taken for want of a machine"
                                                     : fmt::format(", inferred from line {}", report.because_line);
  fmt::print(stderr, "{}: verdict {} ({}{})\n", report.source.name(), checks::name_of(report.verdict),
             report.control_title.empty() ? report.dialect : report.control_title, why);
}

app::Result<app::CheckReport> check_file(const Options& options, const std::string& path,
                                         const std::optional<Nominal>& nominal) {
  auto source = read_source(path);
  if (!source) return std::unexpected(source.error());
  const auto chosen = choose_control(options.text, *source);
  if (!chosen) return std::unexpected(chosen.error());
  return app::examine({.source = std::move(*source),
                       .dialect = chosen->dialect,
                       .control = chosen->control,
                       .inferred = chosen->inferred,
                       .profile = chosen->profile ? &*chosen->profile : nullptr,
                       .delivery = options.drip ? ir::Delivery::drip : ir::Delivery::memory,
                       .find_called = find_in(folders_for(options.text, path)),
                       .geometry = nominal ? std::optional(nominal->geometry) : std::nullopt,
                       .profile_lines = nominal ? nominal->profile_lines : std::vector<family::LineRange>{},
                       .used_up = app::time_budget(options.seconds)});
}

// Carries out the edits of the report in its file. False, with a message, when that cannot be.
bool fix_file(const app::CheckReport& report) {
  const text::Source& source = report.source;
  const FixedText fixed = fix_text(source, report.checks.diagnostics);
  if (fixed.carried_out.empty()) return true;
  if (const std::string why = replace_file(source.name(), fixed.text); !why.empty()) {
    print_error(why);
    return false;
  }
  for (const text::Diagnostic* one : fixed.carried_out) {
    const text::Position at = source.position(one->fix->replaced.begin);
    fmt::print(stderr, "{}:{}:{}: fixed[{}]: {}\n", source.name(), at.line, at.column, text::row_of(one->id).name,
               describe_edit(*one->fix, source));
  }
  if (fixed.left > 0) fmt::print(stderr, "{}: {} fixes overlap others: run it again\n", source.name(), fixed.left);
  return true;
}

std::string document_of(const std::vector<app::CheckReport>& reports, const Options& options) {
  return options.sarif ? json::sarif(reports, kVersion) : json::check_files(reports);
}

int check(const Options& options) {
  std::vector<app::CheckReport> reports;
  std::optional<Nominal> nominal;
  if (options.fix && std::ranges::find(options.files, "-") != options.files.end()) {
    print_error("--fix writes into files; standard input is none");
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
    auto report = check_file(options, file, nominal);
    if (report && options.fix) {
      if (!fix_file(*report)) return kWrongUse;
      report = check_file(options, file, nominal);
    }
    if (!report) {
      print_error(report.error());
      return kWrongUse;
    }
    print_report(*report);
    reports.push_back(std::move(*report));
  }
  const bool wants_document = options.text.json || options.sarif;
  if (wants_document && !write_output(options.text.output, document_of(reports, options))) return kWrongUse;
  bool failed = false;
  for (const app::CheckReport& report : reports) failed = failed || report.verdict == checks::Verdict::fail;
  return failed ? kFailed : kDone;
}

}  // namespace

void add_check(CLI::App& app, int& exit_code) {
  CLI::App* command = app.add_subcommand("check", "diagnostics and checks of programs");
  const auto options = std::make_shared<Options>();
  command->add_option("FILE", options->files, "programs, - for standard input")->required();
  add_text_options(*command, options->text);
  add_nominal_options(*command, options->nominal,
                      "this family has stock, nominal and tools: gouges and accuracy are checked, too");
  command->add_option("--set", options->values, "with --nominal, its parameter: roll_length=\"200 mm\"");
  command->add_flag("--drip", options->drip, "as fed block by block while it runs (tape, DNC, remote mode)");
  command->add_flag("--fix", options->fix, "writes the proposed fixes into the files, then checks them");
  command->add_flag("--sarif", options->sarif, "SARIF 2.1.0 on standard output, for editors and code hosts")
      ->excludes("--json");
  add_seconds(*command, options->seconds);
  command->callback([options, &exit_code] { exit_code = check(*options); });
}

}  // namespace dripfeed::cli
