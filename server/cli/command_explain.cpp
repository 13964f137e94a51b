// dripfeed explain: what a diagnostic means, what to do about it, and which programs have it.
#include <memory>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "server/cli/cli.h"
#include "server/cli/explain.h"
#include "server/cli/output.h"

namespace dripfeed::cli {

namespace {

struct ExplainOptions {
  std::string id;
  bool all = false;
  bool markdown = false;
};

int explain(const ExplainOptions& options) {
  if (options.all)
    return write_output("", options.markdown ? all_in_markdown() : list_of_diagnostics()) ? kDone : kWrongUse;
  if (options.id.empty() || options.markdown) {
    print_error("name a diagnostic, as missing-end, or list them with --all (--markdown: as the page of the docs)");
    return kWrongUse;
  }
  const text::DiagnosticRow* row = text::find_diagnostic(options.id);
  if (row != nullptr) return write_output("", explanation_of(*row)) ? kDone : kWrongUse;
  const std::vector<std::string_view> near = near_names(options.id);
  print_error(fmt::format("there is no diagnostic {}{}{}", options.id,
                          near.empty() ? "; --all lists them" : ": did you mean ", fmt::join(near, ", ")));
  return kWrongUse;
}

}  // namespace

void add_explain(CLI::App& app, int& exit_code) {
  CLI::App* command =
      app.add_subcommand("explain", "describes a diagnostic: cause, cure, alarms of the controls, examples");
  const auto options = std::make_shared<ExplainOptions>();
  command->add_option("ID", options->id, "the diagnostic, as missing-end");
  command->add_flag("--all", options->all, "lists all of them");
  command->add_flag("--markdown", options->markdown, "with --all: in full, as docs/diagnostics.md");
  command->callback([options, &exit_code] { exit_code = explain(*options); });
}

}  // namespace dripfeed::cli
