// A family is named by its file, or by its name among the shipped ones.
#include "server/cli/family_options.h"

#include <algorithm>
#include <filesystem>
#include <utility>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "dialects/compile/render/family_lines.h"
#include "dialects/compile/render/list_table.h"
#include "server/app/checks/timed_rendering.h"
#include "server/cli/output.h"

namespace dripfeed::cli {

std::string find_family(const std::string& name) {
  std::error_code error;
  if (name == "-" || std::filesystem::exists(name, error)) return name;
  return find_shared(fmt::format("families/{}.family", name)).value_or(name);
}

namespace {

// FILE or FILE:COLUMN after the @. A file whose name has a colon is named with its column.
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

void add_value_options(CLI::App& command, std::vector<std::string>& values, std::string& mode) {
  command.add_option("--set", values,
                     "parameter: roll_length=\"200 mm\"; a list from a table: xs=@points.csv:x (may be repeated)");
  command.add_option("--mode", mode, "of a family, macro: the control computes; explicit: dripfeed does")
      ->check(CLI::IsMember({"macro", "explicit", "auto"}))
      ->capture_default_str();
}

void add_family_options(CLI::App& command, FamilyOptions& options) {
  command.add_option("FAMILY", options.file, "family file, or the name of a shipped one")->required();
  add_value_options(command, options.values, options.mode);
  command.add_option("--name", options.name, "program name at the control, such as O0100");
  command.add_flag("--drip", options.drip, "for feeding block by block");
  add_text_options(command, options.text);
}

bool is_family(const text::Source& source) {
  std::string_view text = source.text();
  constexpr std::string_view kBlanks = " \t\r\n";
  while (true) {
    text.remove_prefix(std::min(text.find_first_not_of(kBlanks), text.size()));
    if (!text.starts_with('#')) break;
    text.remove_prefix(std::min(text.find('\n'), text.size()));
  }
  constexpr std::string_view kWord = "family";
  return text.starts_with(kWord) && text.size() > kWord.size() && kBlanks.contains(text[kWord.size()]);
}

namespace {

// What a caller wants besides the text, or of it.
struct Wanted {
  bool lines = false;
  compile::TextSink* sink = nullptr;
};

// Whatever the machine takes for it.
bool is_in_blocks(const compile::RenderRequest& request) {
  return request.mode == compile::RenderMode::explicit_blocks ||
         (request.mode == compile::RenderMode::automatic && request.delivery == ir::Delivery::drip);
}

app::Result<RenderedFamily> render_text(const FamilyOptions& options, text::Source family, Wanted wanted) {
  TextOptions text = options.text;
  // The family says what kind of machine it is for.
  if (text.machine.empty() && text.control.empty() && compile::describe_family(family).machine != ir::MachineKind::mill)
    text.control = "kind=lathe";
  auto chosen = choose_control(text);
  if (!chosen) return std::unexpected(chosen.error());
  auto values = overrides_of(options.values, family);
  if (!values) return std::unexpected(values.error());
  const compile::RenderRequest request{
      .family = family,
      .values = *values,
      .target = chosen->control,
      .mode = compile::find_render_mode(options.mode).value_or(compile::RenderMode::automatic),
      .delivery = options.drip ? ir::Delivery::drip : ir::Delivery::memory,
      .program_name = options.name,
      .heading = {}};
  RenderedFamily out{
      .source = std::move(family), .chosen = std::move(*chosen), .values = std::move(*values), .result = {}};
  if (wanted.sink != nullptr && is_in_blocks(request)) {
    compile::StreamedRendering made = compile::render_streamed(request, *wanted.sink);
    out.result = std::move(made.result);
    out.splices = std::move(made.splices);
    return out;
  }
  out.result = app::render_for(request, out.chosen.profile ? &*out.chosen.profile : nullptr);
  if (wanted.lines && !text::has_error(out.result.diagnostics)) out.lines = compile::family_lines(request, out.result);
  return out;
}

app::Result<RenderedFamily> render_file(const FamilyOptions& options, Wanted wanted) {
  auto source = read_source(find_family(options.file));
  if (!source) return std::unexpected(source.error());
  auto rendered = render_text(options, std::move(*source), wanted);
  if (rendered) print_diagnostics(rendered->result.diagnostics, rendered->source, rendered->chosen.control.title);
  return rendered;
}

}  // namespace

app::Result<RenderedFamily> render_family(const FamilyOptions& options) { return render_file(options, {}); }

app::Result<RenderedFamily> render_family(const FamilyOptions& options, compile::TextSink& sink) {
  return render_file(options, {.sink = &sink});
}

app::Result<RenderedFamily> render_family(const FamilyOptions& options, text::Source family) {
  return render_text(options, std::move(family), {.lines = true});
}

text::Source rendered_source(const RenderedFamily& rendered) {
  return text::Source(rendered.source.name() + " (rendered)", rendered.result.text);
}

app::Examination examination_of(const RenderedFamily& rendered, ir::Delivery delivery) {
  return {.source = rendered_source(rendered),
          .dialect = rendered.chosen.dialect,
          .control = rendered.chosen.control,
          .inferred = false,
          .profile = rendered.chosen.profile ? &*rendered.chosen.profile : nullptr,
          .delivery = delivery,
          .find_called = {},
          .geometry = rendered.result.geometry,
          .profile_lines = rendered.result.profile_lines};
}

std::string place_in_family(const RenderedFamily& rendered, std::uint32_t line) {
  const std::vector<std::uint32_t>& lines = rendered.lines;
  if (line == 0 || line > lines.size() || lines[line - 1] == 0) return {};
  return fmt::format("{}:{}", rendered.source.name(), lines[line - 1]);
}

}  // namespace dripfeed::cli
