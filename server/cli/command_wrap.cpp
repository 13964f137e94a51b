// dripfeed wrap: a family proposed from a program, which stays in it byte for byte.
#include <memory>
#include <utility>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "dialects/compile/propose/propose_family.h"
#include "server/cli/cli.h"
#include "server/cli/inputs.h"
#include "server/cli/output.h"

namespace dripfeed::cli {

namespace {

struct WrapOptions {
  TextOptions text;
  std::string file;
  std::string name;
};

void print_notes(const compile::FamilyProposal& proposal, const text::Source& source) {
  for (const compile::ProposalNote& note : proposal.notes) {
    if (note.line == 0)
      fmt::print(stderr, "{}: {}\n", source.name(), note.text);
    else
      fmt::print(stderr, "{}:{}: {}\n", source.name(), note.line, note.text);
  }
}

int wrap(const WrapOptions& options) {
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
  const compile::FamilyProposal proposal = compile::propose_family(*source, *chosen->dialect, chosen->control,
                                                                   options.name.empty() ? options.file : options.name);
  print_notes(proposal, *source);
  if (proposal.text.empty()) return kFailed;
  fmt::print(stderr, "{}: {} parameter{} proposed for {}: look at each before the family is used\n", source->name(),
             proposal.parameters, proposal.parameters == 1 ? "" : "s", chosen->control.title);
  return write_output(options.text.output, proposal.text) ? kDone : kWrongUse;
}

}  // namespace

void add_wrap(CLI::App& app, int& exit_code) {
  CLI::App* command = app.add_subcommand("wrap", "proposes a part family from a program, which stays unchanged");
  const auto options = std::make_shared<WrapOptions>();
  command->add_option("FILE", options->file, "program, - for standard input")->required();
  command->add_option("--name", options->name, "name of the family; otherwise the file's");
  add_text_options(*command, options->text);
  command->callback([options, &exit_code] { exit_code = wrap(*options); });
}

}  // namespace dripfeed::cli
