// dripfeed renumber: new block numbers, and everything that names a block follows.
#include <algorithm>
#include <iterator>
#include <memory>
#include <string_view>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "dialects/compile/renumber/renumber.h"
#include "server/app/library/rewriting.h"
#include "server/cli/cli.h"
#include "server/cli/documents.h"
#include "server/cli/inputs.h"
#include "server/cli/output.h"
#include "server/json/translation.h"

namespace dripfeed::cli {

namespace {

struct RenumberOptions {
  TextOptions text;
  std::string file;
  std::string blocks = "numbered";
  std::uint32_t first = 10;
  std::uint32_t step = 10;
};

compile::Numbering numbering_of(std::string_view name) {
  const auto found = std::ranges::find(compile::kNumberingNames, name);
  return static_cast<compile::Numbering>(found - std::begin(compile::kNumberingNames));
}

int renumber(const RenumberOptions& options) {
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
  const app::Rewritten made = app::renumber_text({.source = *source,
                                                  .control = chosen->control,
                                                  .numbering = numbering_of(options.blocks),
                                                  .first = options.first,
                                                  .step = options.step});
  const bool refused = !made.refused.empty();
  if (options.text.json)
    return !write_output(options.text.output, json::rewritten(made)) ? kWrongUse : refused ? kFailed : kDone;
  for (const compile::RenumberRefusal& one : made.refused)
    fmt::print(stderr, "{}:{}: not renumbered: {}\n", source->name(), one.line, one.text);
  if (refused) return kFailed;
  for (const std::string& one : made.assumptions) fmt::print(stderr, "{}: assumed: {}\n", source->name(), one);
  fmt::print(stderr, "{}: {} block numbers, {} places that name one\n", source->name(), made.numbers, made.references);
  return write_output(options.text.output, made.text) ? kDone : kWrongUse;
}

}  // namespace

void add_renumber(CLI::App& app, int& exit_code) {
  CLI::App* command = app.add_subcommand("renumber", "new block numbers; jumps and contours follow them");
  const auto options = std::make_shared<RenumberOptions>();
  command->add_option("FILE", options->file, "program, - for standard input")->required();
  command
      ->add_option("--blocks", options->blocks,
                   "which blocks have a number afterwards: those that have one now, all, or only those that are named")
      ->check(CLI::IsMember(
          std::vector<std::string>(std::begin(compile::kNumberingNames), std::end(compile::kNumberingNames))))
      ->capture_default_str();
  command->add_option("--first", options->first, "first number of a program")
      ->check(CLI::Range(1U, app::kMostNumberStep))
      ->capture_default_str();
  command->add_option("--step", options->step, "from one number to the next")
      ->check(CLI::Range(1U, app::kMostNumberStep))
      ->capture_default_str();
  add_text_options(*command, options->text);
  command->callback([options, &exit_code] { exit_code = renumber(*options); });
}

}  // namespace dripfeed::cli
