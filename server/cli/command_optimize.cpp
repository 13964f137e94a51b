// dripfeed optimize: the same program, faster for its control to compute.
#include <memory>
#include <string>
#include <utility>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "dialects/compile/render/optimized.h"
#include "server/app/checks/timed_rendering.h"
#include "server/app/library/optimizing.h"
#include "server/cli/called_programs.h"
#include "server/cli/cli.h"
#include "server/cli/inputs.h"
#include "server/cli/optimize_report.h"
#include "server/cli/output.h"
#include "server/json/translation.h"

namespace dripfeed::cli {

namespace {

struct OptimizeOptions {
  TextOptions text;
  std::string file;
  app::OptimizeWords words;
};

int optimize_file(const OptimizeOptions& options) {
  const auto source = read_source(options.file);
  if (!source) {
    print_error(source.error());
    return kWrongUse;
  }
  const auto chosen = choose_control(options.text, *source);
  if (!chosen) {
    print_error(chosen.error());
    return kWrongUse;
  }
  compile::ProgramLibrary library(chosen->control, find_in(folders_for(options.text, options.file)));
  compile::OptimizeRequest request{
      .source = *source,
      .control = chosen->control,
      .cost = app::cost_model_of(chosen->control, chosen->profile ? &*chosen->profile : nullptr)};
  request.library = &library;
  auto settings = app::settings_of(options.words);
  if (!settings) {
    print_error(settings.error().text);
    return kWrongUse;
  }
  request.settings = std::move(*settings);
  const compile::OptimizeResult result = compile::optimize_text(request);
  if (options.text.json) {
    if (!write_output(options.text.output, json::optimized(result, request.cost, *source) + "\n")) return kWrongUse;
    return text::has_error(result.diagnostics) ? kFailed : kDone;
  }
  print_diagnostics(result.diagnostics, *source, chosen->control.title);
  if (text::has_error(result.diagnostics)) return kFailed;
  print_changes(result, source->name());
  print_saving(result, source->name(), request.cost);
  return write_output(options.text.output, result.text) ? kDone : kWrongUse;
}

std::string rules_help() {
  std::string out = "Rules:\n";
  for (const optimize::RuleRow& row : optimize::kRuleRows)
    out += fmt::format("  {:<12}{}{}\n", row.name, row.what, row.is_standard ? "" : " (off unless asked for)");
  return out;
}

}  // namespace

void add_optimize(CLI::App& app, int& exit_code) {
  CLI::App* command = app.add_subcommand("optimize", "rewrites a program so that its control computes it faster");
  const auto options = std::make_shared<OptimizeOptions>();
  command->add_option("FILE", options->file, "program, - for standard input")->required();
  command->add_option("--with", options->words.with, "a rule that is off (may be repeated)");
  command->add_option("--without", options->words.without, "a rule that is on (may be repeated)");
  command->add_option("--own", options->words.own, "variables that no other program reads: R0-R99, #100-#149");
  command->add_option("--free", options->words.free, "variables that the program may begin to use: R100-R199");
  command
      ->add_option("--tolerance", options->words.tolerance_mm,
                   "mm that the path may be changed by: for the rules table, lines and arcs")
      ->check(CLI::Range(0.0, 1.0));
  add_text_options(*command, options->text);
  command->footer(rules_help());
  command->callback([options, &exit_code] { exit_code = optimize_file(*options); });
}

}  // namespace dripfeed::cli
