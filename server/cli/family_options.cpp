// A family is named by its file, or by its name among the shipped ones.
#include "server/cli/family_options.h"

#include <filesystem>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "dialects/compile/list_table.h"
#include "server/app/timed_rendering.h"
#include "server/cli/output.h"

namespace dripfeed::cli {

std::string find_family(const std::string& name) {
  std::error_code error;
  if (name == "-" || std::filesystem::exists(name, error)) return name;
  return find_shared(fmt::format("families/{}.family", name)).value_or(name);
}

namespace {

// FILE or FILE:COLUMN behind the @. A file whose name has a colon is named with its column.
app::Result<std::string> list_of_file(std::string_view written, const text::Source& family,
                                      std::string_view parameter) {
  const std::size_t colon = written.rfind(':');
  const std::string path(written.substr(0, colon));
  const std::string_view column = colon == std::string_view::npos ? std::string_view() : written.substr(colon + 1);
  const auto table = read_source(path);
  if (!table) return std::unexpected(table.error());
  const compile::TableColumn read = compile::list_of_column(*table, column, family, parameter);
  print_diagnostics(read.diagnostics, *table, "");
  if (text::has_error(read.diagnostics))
    return app::fail(app::ErrorCode::refused, fmt::format("{}: no list is made of {}", parameter, path));
  return read.value.empty() ? fmt::format("@{}", written) : read.value;  // no list: left to who binds it
}

}  // namespace

app::Result<std::vector<family::Override>> overrides_of(const std::vector<std::string>& set,
                                                        const text::Source& family) {
  std::vector<family::Override> values;
  for (const std::string& one : set) {
    const std::size_t equals = one.find('=');
    if (equals == std::string::npos)
      return app::fail(app::ErrorCode::invalid, fmt::format("--set \"{}\" is not name=value", one));
    const std::string name = one.substr(0, equals);
    app::Result<std::string> value = one.substr(equals + 1);
    if (value->starts_with('@')) value = list_of_file(std::string_view(*value).substr(1), family, name);
    if (!value) return std::unexpected(value.error());
    values.push_back({.name = name, .value = std::move(*value)});
  }
  return values;
}

void add_family_options(CLI::App& command, FamilyOptions& options) {
  command.add_option("FAMILY", options.file, "family file, or the name of a shipped one")->required();
  command.add_option("--set", options.values,
                     "parameter: roll_length=\"200 mm\"; a list from a table: xs=@points.csv:x (may be repeated)");
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
  auto values = overrides_of(options.values, *source);
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
