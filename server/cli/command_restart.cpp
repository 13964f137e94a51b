// dripfeed restart: a program that goes on in the middle, with a preamble that states what the blocks before have set.
// It prints a text for a person to read; nothing is sent.
#include <memory>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "dialects/compile/restart/restart.h"
#include "server/cli/called_programs.h"
#include "server/cli/cli.h"
#include "server/cli/documents.h"
#include "server/cli/inputs.h"
#include "server/cli/output.h"

namespace dripfeed::cli {

namespace {

struct RestartOptions {
  TextOptions text;
  std::string file;
  std::uint32_t line = 0;
  double clearance_mm = compile::kRestartClearance_mm;
};

void print_around(const compile::Restart& made, std::string_view name) {
  const auto place = [&](std::uint32_t line, std::string_view side) {
    if (line != 0)
      fmt::print(stderr, "{}:{}: a restart is possible here, the nearest {} that line\n", name, line, side);
  };
  place(made.safe_before, "before");
  place(made.safe_after, "after");
}

int restart(const RestartOptions& options) {
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
  if (options.line > source->line_count()) {
    print_error(fmt::format("{} has {} lines", source->name(), source->line_count()));
    return kWrongUse;
  }
  compile::ProgramLibrary library(chosen->control, find_in(folders_for(options.text, options.file)));
  const compile::Restart made = compile::restart_at({.source = *source,
                                                     .control = chosen->control,
                                                     .line = options.line,
                                                     .library = &library,
                                                     .clearance_mm = options.clearance_mm});
  const bool refused = made.text.empty();
  if (options.text.json)
    return !write_output(options.text.output, restart_document(made, *source)) ? kWrongUse : refused ? kFailed : kDone;
  print_diagnostics(made.diagnostics, *source, chosen->control.title);
  print_around(made, source->name());
  if (refused) return kFailed;
  for (const std::string& one : made.assumptions) fmt::print(stderr, "{}: assumed: {}\n", source->name(), one);
  fmt::print(stderr, "{}: lines {} to {} are new; {} moves of the rest are those of the whole program\n",
             source->name(), made.preamble_line, made.rest_line - 1, made.compared_moves);
  return write_output(options.text.output, made.text) ? kDone : kWrongUse;
}

}  // namespace

void add_restart(CLI::App& app, int& exit_code) {
  CLI::App* command =
      app.add_subcommand("restart", "writes the restart of a program at a line, with a preamble to read");
  const auto options = std::make_shared<RestartOptions>();
  command->add_option("FILE", options->file, "program, - for standard input")->required();
  command->add_option("--line", options->line, "line of the file that is to be the first")
      ->required()
      ->check(CLI::PositiveNumber);
  command->add_option("--clearance", options->clearance_mm, "mm above the start, where the program has no level above")
      ->check(CLI::Range(0.1, 1000.0))
      ->capture_default_str();
  add_text_options(*command, options->text);
  command->callback([options, &exit_code] { exit_code = restart(*options); });
}

}  // namespace dripfeed::cli
