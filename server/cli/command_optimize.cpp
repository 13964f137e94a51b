// dripfeed optimize: the same program, faster for its control to compute.
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "dialects/compile/render/optimized.h"
#include "dialects/text/number.h"
#include "server/app/checks/timed_rendering.h"
#include "server/cli/called_programs.h"
#include "server/cli/cli.h"
#include "server/cli/documents.h"
#include "server/cli/inputs.h"
#include "server/cli/optimize_report.h"
#include "server/cli/output.h"

namespace dripfeed::cli {

namespace {

struct OptimizeOptions {
  TextOptions text;
  std::string file;
  std::vector<std::string> with;
  std::vector<std::string> without;
  std::vector<std::string> own;
  std::vector<std::string> free;
};

// "R100-R199", "#150-#160", "R5"
std::optional<optimize::NumberRange> range_of(const std::string& text) {
  const auto number = [](std::string_view word) -> std::optional<optimize::NumberRange> {
    if (word.size() < 2 || (word[0] != 'R' && word[0] != 'r' && word[0] != '#')) return {};
    const std::optional<std::int64_t> value = text::parse_integer(word.substr(1));
    if (!value || *value < 0 || *value > 99'999) return {};
    const auto n = static_cast<std::uint32_t>(*value);
    return optimize::NumberRange{word[0] == '#' ? ir::Bank::hash : ir::Bank::r, n, n};
  };
  const std::size_t dash = text.find('-');
  const auto first = number(std::string_view(text).substr(0, dash));
  const auto last = dash == std::string::npos ? first : number(std::string_view(text).substr(dash + 1));
  if (!first || !last || first->bank != last->bank || first->first > last->first) return {};
  return optimize::NumberRange{first->bank, first->first, last->last};
}

std::optional<std::string> take_ranges(const std::vector<std::string>& texts, std::vector<optimize::NumberRange>& out) {
  for (const std::string& text : texts) {
    const auto range = range_of(text);
    if (!range) return fmt::format("\"{}\" is no range of variables: write R100-R199 or #150-#160", text);
    out.push_back(*range);
  }
  return {};
}

std::optional<std::string> take_rules(const std::vector<std::string>& names, bool on, optimize::Rules& rules) {
  for (const std::string& name : names) {
    const auto rule = optimize::find_rule(name);
    if (!rule) return fmt::format("there is no rule \"{}\"", name);
    rules.set(*rule, on);
  }
  return {};
}

std::optional<std::string> take(const OptimizeOptions& options, optimize::Settings& settings) {
  if (auto fault = take_rules(options.with, true, settings.rules)) return fault;
  if (auto fault = take_rules(options.without, false, settings.rules)) return fault;
  if (auto fault = take_ranges(options.own, settings.own)) return fault;
  return take_ranges(options.free, settings.free);
}

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
  if (const auto fault = take(options, request.settings)) {
    print_error(*fault);
    return kWrongUse;
  }
  const compile::OptimizeResult result = compile::optimize_text(request);
  if (options.text.json) {
    if (!write_output(options.text.output, optimize_document(result, request.cost, *source))) return kWrongUse;
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
  command->add_option("--with", options->with, "a rule that is off (may be repeated)");
  command->add_option("--without", options->without, "a rule that is on (may be repeated)");
  command->add_option("--own", options->own, "variables that no other program reads: R0-R99, #100-#149");
  command->add_option("--free", options->free, "variables that the program may begin to use: R100-R199");
  add_text_options(*command, options->text);
  command->footer(rules_help());
  command->callback([options, &exit_code] { exit_code = optimize_file(*options); });
}

}  // namespace dripfeed::cli
