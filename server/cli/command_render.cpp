// dripfeed render: a family with values to the text of one control.
#include <memory>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "server/cli/cli.h"
#include "server/cli/documents.h"
#include "server/cli/family_options.h"
#include "server/cli/output.h"

namespace dripfeed::cli {

namespace {

int render(const FamilyOptions& options) {
  const auto rendered = render_family(options);
  if (!rendered) {
    print_error(rendered.error());
    return kWrongUse;
  }
  const compile::RenderResult& result = rendered->result;
  if (text::has_error(result.diagnostics)) return kFailed;
  if (options.text.json) return write_output(options.text.output, render_document(result)) ? kDone : kWrongUse;
  fmt::print(stderr, "{}: {}; {} blocks, {} bytes, {} variables\n", compile::name_of(result.mode), result.because,
             result.blocks, result.bytes, result.variables);
  return write_output(options.text.output, result.text) ? kDone : kWrongUse;
}

}  // namespace

void add_render(CLI::App& app, int& exit_code) {
  CLI::App* command = app.add_subcommand("render", "renders a part family for a control");
  const auto options = std::make_shared<FamilyOptions>();
  add_family_options(*command, *options);
  command->callback([options, &exit_code] { exit_code = render(*options); });
}

}  // namespace dripfeed::cli
