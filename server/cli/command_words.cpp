// dripfeed words: what a control's language consists of, and what a check makes of each word.
#include <algorithm>
#include <memory>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "dialects/compile/dialect/dialect.h"
#include "server/cli/cli.h"
#include "server/cli/output.h"
#include "server/cli/words.h"

namespace dripfeed::cli {

namespace {

struct WordsOptions {
  std::string dialect;
  std::string kind = "mill";
  std::string system = "A";
  bool markdown = false;
};

int words(const WordsOptions& options) {
  if (options.markdown && options.dialect.empty()) return write_output("", words_in_markdown()) ? kDone : kWrongUse;
  const compile::Dialect* dialect = compile::find_dialect(options.dialect);
  if (dialect == nullptr) {
    print_error(options.dialect.empty() ? "name a control's language with --dialect, or --markdown for all of them"
                                        : fmt::format("no dialect \"{}\" is known", options.dialect));
    return kWrongUse;
  }
  if (options.markdown) return write_output("", words_in_markdown(*dialect)) ? kDone : kWrongUse;
  const auto kind = static_cast<ir::MachineKind>(std::ranges::find(ir::kMachineKindNames, options.kind) -
                                                 ir::kMachineKindNames.begin());
  const ir::Control control = dialect->control(kind, static_cast<ir::GSystem>(options.system.front() - 'A'));
  return write_output("", list_of_words(compile::language_of(*dialect, control))) ? kDone : kWrongUse;
}

}  // namespace

void add_words(CLI::App& app, int& exit_code) {
  CLI::App* command =
      app.add_subcommand("words", "the words of a control's language: interpreted, without effect, reported");
  const auto options = std::make_shared<WordsOptions>();
  command->add_option("--dialect", options->dialect, "fanuc, haas, mazak, mitsubishi-m80 or sinumerik-840d");
  command->add_option("--kind", options->kind, "mill, lathe or mill-turn")
      ->check(CLI::IsMember({"mill", "lathe", "mill-turn"}));
  command->add_option("--g-system", options->system, "of lathes: A, B or C")->check(CLI::IsMember({"A", "B", "C"}));
  command->add_flag("--markdown", options->markdown, "as docs/words.md; with --dialect as the page of that dialect");
  command->callback([options, &exit_code] { exit_code = words(*options); });
}

}  // namespace dripfeed::cli
