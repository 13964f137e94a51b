// Every path that is looked at is named in the error when nothing was found.
#include "server/cli/inputs.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "dialects/compile/dialect/readers.h"
#include "dialects/compile/dialect/shared_definitions.h"
#include "dialects/compile/translate/caller_modes.h"
#include "server/app/shop/catalog.h"
#include "server/cli/called_programs.h"
#include "server/cli/memory_budget.h"
#include "server/json/profile_document.h"

namespace dripfeed::cli {

namespace {

namespace fs = std::filesystem;

// In large pieces: an iterator over the stream takes as long for a long program as reading its blocks.
std::string read_all(std::istream& stream) {
  constexpr std::size_t kPieceBytes = std::size_t{1} << 20U;
  std::string text;
  while (stream) {
    const std::size_t size = text.size();
    text.resize(size + kPieceBytes);
    stream.read(text.data() + size, static_cast<std::streamsize>(kPieceBytes));
    text.resize(size + static_cast<std::size_t>(stream.gcount()));
  }
  return text;
}

app::Result<std::string> read_file(const std::string& path) {
  if (path == "-") {
    std::string text = read_all(std::cin);
    grant_memory(text.size());
    return text;
  }
  std::error_code error;
  if (fs::is_directory(path, error))
    return app::fail(app::ErrorCode::unavailable, fmt::format("{}: is a folder", path));
  if (const auto size = fs::file_size(path, error); !error) grant_memory(size);
  std::ifstream file(path, std::ios::binary);
  if (!file) return app::fail(app::ErrorCode::unavailable, fmt::format("{}: {}", path, std::strerror(errno)));
  std::string text = read_all(file);
  if (file.bad()) return app::fail(app::ErrorCode::unavailable, fmt::format("{}: cannot be read to its end", path));
  return text;
}

struct Settings {
  ir::MachineKind kind = ir::MachineKind::mill;
  ir::GSystem g_system = ir::GSystem::a;
  bool kind_given = false;
  bool system_given = false;
};

// kind=mill|lathe|mill-turn,g_system=A|B|C
app::Result<Settings> read_control_option(std::string_view text) {
  Settings settings;
  while (!text.empty()) {
    const std::string_view item = text.substr(0, text.find(','));
    text.remove_prefix(std::min(text.size(), item.size() + 1));
    const std::size_t equals = item.find('=');
    const std::string_view name = item.substr(0, equals);
    const std::string_view value = equals == std::string_view::npos ? std::string_view() : item.substr(equals + 1);
    const auto kind = std::ranges::find(ir::kMachineKindNames, value);
    if (name == "kind" && kind != ir::kMachineKindNames.end()) {
      settings.kind = static_cast<ir::MachineKind>(kind - ir::kMachineKindNames.begin());
      settings.kind_given = true;
    } else if (name == "g_system" && value.size() == 1 && value[0] >= 'A' && value[0] <= 'C') {
      settings.g_system = static_cast<ir::GSystem>(value[0] - 'A');
      settings.system_given = true;
    } else {
      return app::fail(app::ErrorCode::invalid,
                       fmt::format("--control \"{}\": use kind=mill|lathe|mill-turn and g_system=A|B|C", item));
    }
  }
  return settings;
}

// `option` is the one that named it.
app::Result<const compile::Dialect*> named_dialect(const std::string& name, std::string_view option) {
  if (const compile::Dialect* dialect = compile::find_dialect(name)) return dialect;
  if (compile::find_reader(name) != nullptr)
    return app::fail(app::ErrorCode::invalid,
                     fmt::format("{} \"{}\" can only be run (dripfeed run); there is no writer for it", option, name));
  std::string known;
  for (const compile::Dialect& one : compile::dialects()) known += fmt::format(" {}", one.name);
  return app::fail(app::ErrorCode::invalid, fmt::format("{} \"{}\" is not known; known are{}", option, name, known));
}

app::Result<ChosenControl> control_of_machine(const std::string& machine) {
  auto profile = read_machine(machine);
  if (!profile) return std::unexpected(profile.error());
  auto control = app::control_of(*profile);
  if (!control) return std::unexpected(control.error());
  ChosenControl chosen{.dialect = compile::find_dialect(profile->control.dialect),
                       .control = std::move(*control),
                       .profile = {},
                       .inferred = false};
  chosen.profile = std::move(*profile);
  return chosen;
}

}  // namespace

void add_text_options(CLI::App& command, TextOptions& options) {
  command.add_option("--machine", options.machine, "machine profile: a file or the name of a preset");
  command.add_option("--dialect", options.dialect, "control language, when no machine is named");
  command.add_option("--control", options.control, "what the machine decides: kind=lathe,g_system=A");
  command.add_option("--modes", options.modes,
                     "of a subprogram by itself: the codes that its caller has in effect, as \"G97 G18 G95\"");
  command.add_option("--path", options.paths, "folder with called programs (may be repeated)");
  command.add_option("--output", options.output, "write the text there instead of to standard output");
  command.add_flag("--json", options.json, "one JSON object on standard output");
  command.preparse_callback([](std::size_t) { begin_text_budget(); });
}

void add_seconds(CLI::App& command, std::uint32_t& seconds) {
  command
      .add_option("--seconds", seconds,
                  "a run that takes longer is stopped, and what follows is not known; 0: as long as it takes")
      ->capture_default_str();
}

app::Result<text::Source> read_source(const std::string& path) {
  auto text = read_file(path);
  if (!text) return std::unexpected(text.error());
  if (text->size() > UINT32_MAX)
    return app::fail(app::ErrorCode::unavailable,
                     fmt::format("{}: a text of 4 GiB or more cannot be held whole", path));
  return text::Source(path == "-" ? "<stdin>" : path, std::move(*text));
}

std::optional<std::string> find_shared(std::string_view relative) {
  std::vector<fs::path> roots;
  if (const char* share = std::getenv("DRIPFEED_SHARE")) roots.emplace_back(share);
  std::error_code error;
  const fs::path binary = fs::read_symlink("/proc/self/exe", error);
  if (!error) {
    roots.push_back(binary.parent_path() / "../../deploy");       // build/<preset>/dripfeed
    roots.push_back(binary.parent_path() / "../share/dripfeed");  // installed
  }
  for (const fs::path& root : roots) {
    if (fs::exists(root / relative, error)) return (root / relative).lexically_normal().string();
  }
  return std::nullopt;
}

app::Result<text::Source> read_machine_document(const std::string& name_or_path) {
  std::string path = name_or_path;
  if (!path.ends_with(".json") && path.find('/') == std::string::npos) {
    const auto preset = find_shared(fmt::format("machines/{}.json", path));
    if (!preset)
      return app::fail(app::ErrorCode::invalid,
                       fmt::format("--machine \"{}\" is not a preset, and no file (*.json)", path));
    path = *preset;
  }
  auto text = read_file(path);
  if (!text) return std::unexpected(text.error());
  return text::Source(path, std::move(*text));
}

app::Result<machine::Profile> read_machine(const std::string& name_or_path) {
  const auto document = read_machine_document(name_or_path);
  if (!document) return std::unexpected(document.error());
  auto profile = json::read_profile(document->text());
  if (!profile) profile.error().text = fmt::format("{}: {}", document->name(), profile.error().text);
  return profile;
}

app::Result<machine::Profile> read_machine_at(const std::string& link, const std::string& name_or_path) {
  auto url = machine::parse_link_url(link);
  if (!url) return app::fail(app::ErrorCode::invalid, url.error());
  machine::Profile profile;
  if (!name_or_path.empty()) {
    auto read = read_machine(name_or_path);
    if (!read) return read;
    profile = std::move(*read);
  }
  profile.line.link = std::move(*url);
  auto line = machine::effective_line(profile.line);
  if (!line) return app::fail(app::ErrorCode::invalid, line.error());
  profile.line = std::move(*line);
  return profile;
}

namespace {

app::Result<ChosenControl> with_modes(const TextOptions& options, app::Result<ChosenControl> chosen) {
  if (!chosen || options.modes.empty()) return chosen;
  auto modes = compile::read_caller_modes(*chosen->dialect, chosen->control, options.modes);
  if (!modes) return app::fail(app::ErrorCode::invalid, "--modes: " + modes.error());
  chosen->control.caller_modes = std::move(*modes);
  return chosen;
}

app::Result<ChosenControl> plain_control(const TextOptions& options) {
  if (!options.machine.empty()) return control_of_machine(options.machine);
  if (options.dialect.empty())
    return app::fail(app::ErrorCode::invalid, "name the control with --machine or --dialect");
  const auto dialect = named_dialect(options.dialect, options.dialect_option);
  if (!dialect) return std::unexpected(dialect.error());
  const auto settings = read_control_option(options.control);
  if (!settings) return std::unexpected(settings.error());
  return ChosenControl{.dialect = *dialect,
                       .control = (*dialect)->control(settings->kind, settings->g_system),
                       .profile = {},
                       .inferred = false};
}

app::Result<ChosenControl> plain_control(const TextOptions& options, const text::Source& source) {
  if (!options.machine.empty()) return control_of_machine(options.machine);
  const compile::Dialect* dialect = &compile::infer_dialect(source);
  if (!options.dialect.empty()) {
    const auto named = named_dialect(options.dialect, options.dialect_option);
    if (!named) return std::unexpected(named.error());
    dialect = *named;
  }
  const auto settings = read_control_option(options.control);
  if (!settings) return std::unexpected(settings.error());
  if (settings->kind_given) {
    ir::Control control = dialect->control(settings->kind, settings->g_system);
    // The text says the system of a lathe, if no one else does.
    if (settings->kind == ir::MachineKind::lathe && !settings->system_given) {
      const ir::Control inferred = dialect->infer_control(source);
      if (inferred.kind == settings->kind) {
        control = dialect->control(settings->kind, inferred.g_system);
        control.contradiction = inferred.contradiction;
        control.because_line = inferred.because_line;
      }
    }
    return ChosenControl{.dialect = dialect, .control = std::move(control), .profile = {}, .inferred = false};
  }
  return ChosenControl{.dialect = dialect, .control = dialect->infer_control(source), .profile = {}, .inferred = true};
}

}  // namespace

app::Result<ChosenControl> choose_control(const TextOptions& options) {
  return with_modes(options, plain_control(options));
}

app::Result<ChosenControl> choose_control(const TextOptions& options, const text::Source& source) {
  auto chosen = with_modes(options, plain_control(options, source));
  if (chosen)
    chosen->control =
        compile::with_definitions(std::move(chosen->control), find_in(folders_for(options, source.name())));
  return chosen;
}

}  // namespace dripfeed::cli
