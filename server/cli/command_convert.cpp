// dripfeed convert: from one control's language to another's; to its own it prints the program back, byte for byte.
#include <memory>
#include <utility>

#include <CLI/CLI.hpp>

#include "dialects/compile/translate/convert.h"
#include "server/app/library/translation.h"
#include "server/cli/called_programs.h"
#include "server/cli/cli.h"
#include "server/cli/inputs.h"
#include "server/cli/output.h"
#include "server/json/translation.h"

namespace dripfeed::cli {

namespace {

struct ConvertOptions {
  TextOptions text;
  std::string file;
  std::string from;
  std::string to;
  std::string mode = "macro";
};

// The control for one side: its dialect, with --control and --machine as far as they fit it.
app::Result<ChosenControl> control_for(const ConvertOptions& options, const std::string& dialect,
                                       const text::Source* source) {
  TextOptions text = options.text;
  if (!text.machine.empty()) {
    auto machine = choose_control(text);
    if (!machine || machine->dialect->name == dialect) return machine;
    text.machine.clear();
  }
  text.dialect = dialect;
  text.dialect_option = source == nullptr ? "--to" : "--from";
  return source == nullptr ? choose_control(text) : choose_control(text, *source);
}

int convert(const ConvertOptions& options) {
  auto source = read_source(options.file);
  if (!source) {
    print_error(source.error());
    return kWrongUse;
  }
  const auto from = control_for(options, options.from, &*source);
  if (!from) {
    print_error(from.error());
    return kWrongUse;
  }
  ConvertOptions target = options;
  target.text.modes.clear();  // they are the source's
  // A lathe's program goes to a lathe: what was found out about the source holds for the other side.
  if (target.text.control.empty() && from->control.kind != ir::MachineKind::mill) target.text.control = "kind=lathe";
  const auto to = options.to == options.from ? from : control_for(target, options.to, nullptr);
  if (!to) {
    print_error(to.error());
    return kWrongUse;
  }
  if (const auto clear = app::refuse_contradiction(*source, from->control); !clear) {
    print_error(clear.error());
    return kWrongUse;
  }
  compile::ProgramLibrary library(from->control, find_in(folders_for(options.text, options.file)));
  const auto mode = options.mode == "macro" ? compile::ConvertMode::macro : compile::ConvertMode::explicit_blocks;
  // A long text has a long table of lines: moved, not copied.
  const compile::ConvertRequest request = {
      .source = std::move(*source), .from = from->control, .to = to->control, .mode = mode, .library = &library};
  const compile::ConvertResult result = compile::convert(request);
  if (options.text.json && !write_output(options.text.output, json::translation(result, request.source) + "\n"))
    return kWrongUse;
  if (!options.text.json) print_diagnostics(result.diagnostics, request.source, from->control.title);
  const bool own_bytes = options.from == options.to && mode == compile::ConvertMode::macro;
  if (!own_bytes && text::has_error(result.diagnostics)) return kFailed;
  if (options.text.json) return kDone;
  if (!result.not_verified.empty()) print_error("not verified by running it: " + result.not_verified);
  return write_output(options.text.output, result.text) ? kDone : kWrongUse;
}

}  // namespace

void add_convert(CLI::App& app, int& exit_code) {
  CLI::App* command = app.add_subcommand("convert", "translates a program to another control");
  const auto options = std::make_shared<ConvertOptions>();
  command->add_option("FILE", options->file, "program, - for standard input")->required();
  command->add_option("--from", options->from, "dialect of the program")->required();
  command->add_option("--to", options->to, "dialect to translate to")->required();
  command->add_option("--mode", options->mode, "macro keeps variables and loops, explicit computes them")
      ->check(CLI::IsMember({"macro", "explicit"}))
      ->capture_default_str();
  add_text_options(*command, options->text);
  command->callback([options, &exit_code] { exit_code = convert(*options); });
}

}  // namespace dripfeed::cli
