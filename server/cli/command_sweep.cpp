// dripfeed sweep: for which values of its parameters a family passes on a machine, and the smallest example that fails.
#include <algorithm>
#include <memory>
#include <thread>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "dialects/text/number.h"
#include "server/app/checks/family_sweep.h"
#include "server/cli/cli.h"
#include "server/cli/family_options.h"
#include "server/cli/output.h"
#include "server/json/sweep_report.h"

namespace dripfeed::cli {

namespace {

struct SweepOptions {
  FamilyOptions family;
  sweep::Settings settings;
  std::string plot;
};

std::string with_unit(double value, const std::string& unit) {
  return unit.empty() ? text::format_shortest(value) : text::format_shortest(value) + " " + unit;
}

std::string side_text(const sweep::Side& side, const std::string& unit) {
  if (!side.is_bounded) return {};
  return fmt::format("    {} fails: {} ({})\n", with_unit(side.fails_at, unit), side.text, side.check);
}

std::string report_text(const sweep::Report& report) {
  std::string out;
  for (std::size_t i = 0; i < report.ranges.size(); ++i) {
    const sweep::Parameter& one = report.parameters[i];
    const auto& [low, high] = report.ranges[i];
    out +=
        fmt::format("{}: passes from {} to {}, of {} to {}\n", one.name, with_unit(low.reach, one.unit),
                    with_unit(high.reach, one.unit), text::format_shortest(one.low), text::format_shortest(one.high));
    out += side_text(low, one.unit) + side_text(high, one.unit);
  }
  out += fmt::format("corners: {} of {} pass\nsamples: {} of {} pass\n", report.corners.passed, report.corners.tried,
                     report.samples.passed, report.samples.tried);
  if (!report.smallest_failure) return out + "nothing failed\n";
  const sweep::Example& example = *report.smallest_failure;
  out += fmt::format("smallest failure: {} ({})\n", example.trial.text, example.trial.check);
  for (const std::size_t i : example.changed) {
    const sweep::Parameter& one = report.parameters[i];
    out += fmt::format("    --set {}=\"{}\"\n", one.name, with_unit(example.values[i], one.unit));
  }
  return out;
}

int sweep_of(const SweepOptions& options) {
  // The values as they are, for what is wrong with the family itself.
  const auto rendered = render_family(options.family);
  if (!rendered) {
    print_error(rendered.error());
    return kWrongUse;
  }
  const sweep::Report report = app::sweep_family(
      {.family = rendered->source,
       .fixed = rendered->values,
       .control = rendered->chosen.control,
       .profile = rendered->chosen.profile ? &*rendered->chosen.profile : nullptr,
       .mode = compile::find_render_mode(options.family.mode).value_or(compile::RenderMode::automatic),
       .delivery = options.family.drip ? ir::Delivery::drip : ir::Delivery::memory,
       .settings = options.settings});
  if (!options.plot.empty() && !write_output(options.plot, plot::svg(sweep::region_plot(report)))) return kWrongUse;
  const TextOptions& out = options.family.text;
  if (!write_output(out.output, out.json ? json::sweep_report(report) : report_text(report))) return kWrongUse;
  return report.standard.passes ? kDone : kFailed;
}

}  // namespace

void add_sweep(CLI::App& app, int& exit_code) {
  CLI::App* command = app.add_subcommand("sweep", "which values of a family's parameters pass on a machine");
  const auto options = std::make_shared<SweepOptions>();
  options->settings.threads = std::max(1U, std::thread::hardware_concurrency());
  add_family_options(*command, options->family);
  command->add_option("--seed", options->settings.seed, "start of the random samples and corners")
      ->capture_default_str();
  command->add_option("--samples", options->settings.samples, "random sets of values inside all ranges")
      ->check(CLI::Range(0, 100'000))
      ->capture_default_str();
  command->add_option("--threads", options->settings.threads, "the result is the same for any; by default one a core")
      ->check(CLI::Range(1, 256));
  command->add_option("--plot", options->plot, "writes what passes as SVG");
  command->callback([options, &exit_code] { exit_code = sweep_of(*options); });
}

}  // namespace dripfeed::cli
