// A family is named by its file, or by its name among the shipped ones.
#include "server/cli/family_options.h"

#include <filesystem>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "server/app/timed_rendering.h"
#include "server/cli/output.h"

namespace dripfeed::cli {

std::string find_family(const std::string& name) {
  std::error_code error;
  if (name == "-" || std::filesystem::exists(name, error)) return name;
  return find_shared(fmt::format("families/{}.family", name)).value_or(name);
}

app::Result<std::vector<family::Override>> overrides_of(const FamilyOptions& options) {
  std::vector<family::Override> values;
  for (const std::string& value : options.values) {
    const std::size_t equals = value.find('=');
    if (equals == std::string::npos)
      return app::fail(app::ErrorCode::invalid, fmt::format("--set \"{}\" is not name=value", value));
    values.push_back({.name = value.substr(0, equals), .value = value.substr(equals + 1)});
  }
  return values;
}

void add_family_options(CLI::App& command, FamilyOptions& options) {
  command.add_option("FAMILY", options.file, "family file, or the name of a shipped one")->required();
  command.add_option("--set", options.values, "parameter: roll_length=\"200 mm\" (may be repeated)");
  command.add_option("--mode", options.mode, "macro: the control computes; explicit: dripfeed does")
      ->check(CLI::IsMember({"macro", "explicit", "auto"}))
      ->capture_default_str();
  command.add_option("--name", options.name, "program name at the control, such as O0100");
  command.add_flag("--drip", options.drip, "for feeding block by block");
  add_text_options(command, options.text);
}

app::Result<RenderedFamily> render_family(const FamilyOptions& options) {
  auto source = read_source(find_family(options.file));
  if (!source) return std::unexpected(source.error());
  TextOptions text = options.text;
  // The family says what kind of machine it is for.
  if (text.machine.empty() && text.control.empty() &&
      compile::describe_family(*source).machine != ir::MachineKind::mill)
    text.control = "kind=lathe";
  auto chosen = choose_control(text);
  if (!chosen) return std::unexpected(chosen.error());
  auto values = overrides_of(options);
  if (!values) return std::unexpected(values.error());
  compile::RenderResult result =
      app::render_for({.family = *source,
                       .values = *values,
                       .target = chosen->control,
                       .mode = compile::find_render_mode(options.mode).value_or(compile::RenderMode::automatic),
                       .delivery = options.drip ? ir::Delivery::drip : ir::Delivery::memory,
                       .program_name = options.name,
                       .heading = {}},
                      chosen->profile ? &*chosen->profile : nullptr);
  print_diagnostics(result.diagnostics, *source, chosen->control.title);
  return RenderedFamily{.source = std::move(*source),
                        .chosen = std::move(*chosen),
                        .values = std::move(*values),
                        .result = std::move(result)};
}

}  // namespace dripfeed::cli
