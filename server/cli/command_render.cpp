// dripfeed render: a family with values to the text of one control.
#include <memory>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "dialects/compile/render/optimized_render.h"
#include "server/app/checks/timed_rendering.h"
#include "server/cli/cli.h"
#include "server/cli/documents.h"
#include "server/cli/family_options.h"
#include "server/cli/optimize_report.h"
#include "server/cli/output.h"
#include "server/cli/text_spool.h"

namespace dripfeed::cli {

namespace {

struct RenderOptions {
  FamilyOptions family;
  bool optimize = false;
};

// Says on standard error what was gained, or why nothing was.
void optimize(RenderedFamily& rendered) {
  const ChosenControl& chosen = rendered.chosen;
  const ir::CostModel cost = app::cost_model_of(chosen.control, chosen.profile ? &*chosen.profile : nullptr);
  const compile::OptimizeResult made = compile::optimize_rendered(rendered.result, rendered.chosen.control, cost);
  print_saving(made, rendered.source.name(), cost);
}

int render(const RenderOptions& asked) {
  const FamilyOptions& options = asked.family;
  TextSpool spool;
  // JSON has the text in one piece, and its place index; the optimizer reads it.
  auto rendered = options.text.json || asked.optimize ? render_family(options) : render_family(options, spool);
  if (!rendered) {
    print_error(rendered.error());
    return rendered.error().code == app::ErrorCode::refused ? kFailed : kWrongUse;
  }
  const compile::RenderResult& result = rendered->result;
  if (text::has_error(result.diagnostics)) {
    if (!options.text.json) return kFailed;
    return write_output(options.text.output, render_document(result, rendered->source)) ? kFailed : kWrongUse;
  }
  if (asked.optimize) optimize(*rendered);
  if (options.text.json)
    return write_output(options.text.output, render_document(result, rendered->source)) ? kDone : kWrongUse;
  fmt::print(stderr, "{}: {}; {} blocks, {} bytes, {} variables\n", compile::name_of(result.mode), result.because,
             result.blocks, result.bytes, result.variables);
  return spool.write_output(options.text.output, result.text, rendered->splices) ? kDone : kWrongUse;
}

}  // namespace

void add_render(CLI::App& app, int& exit_code) {
  CLI::App* command = app.add_subcommand("render", "renders a part family for a control");
  const auto options = std::make_shared<RenderOptions>();
  add_family_options(*command, options->family);
  command->add_flag("--optimize", options->optimize, "a macro is rewritten so that the control computes it faster");
  command->callback([options, &exit_code] { exit_code = render(*options); });
}

}  // namespace dripfeed::cli
