// What the commands read: files (or standard input), machines (a profile file or a preset's name), the control that a
// text is for, called programs in --path.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "dialects/compile/dialect/dialect.h"
#include "dialects/compile/dialect/library.h"
#include "server/app/base/error.h"
#include "server/machine/profile.h"

namespace CLI {
class App;  // included only where options are added: it takes seconds to compile
}

namespace dripfeed::cli {

// The options that every command on a text has.
struct TextOptions {
  std::string machine;  // --machine
  std::string dialect;  // --dialect
  std::string_view dialect_option = "--dialect";
  std::string control;             // --control kind=lathe,g_system=A
  std::string modes;               // --modes "G97 G18 G95"
  std::vector<std::string> paths;  // --path
  std::string output;              // --output
  bool json = false;               // --json
};
void add_text_options(CLI::App& command, TextOptions& options);

// --seconds, of commands that run programs.
inline constexpr std::uint32_t kCheckSeconds = 60;
void add_seconds(CLI::App& command, std::uint32_t& seconds);

// "-" is standard input. Errors: unavailable, with what the system said.
app::Result<text::Source> read_source(const std::string& path);

// The document of a profile: of a file, or of the preset with that name.
app::Result<text::Source> read_machine_document(const std::string& name_or_path);
// The profile of a file, or of the preset with that name.
app::Result<machine::Profile> read_machine(const std::string& name_or_path);

// The profile of that machine, or the usual one for "", reached at this link whose options are laid over its line.
app::Result<machine::Profile> read_machine_at(const std::string& link, const std::string& name_or_path);

// Files of the project that the command finds without an option: presets. $DRIPFEED_SHARE, next to the binary,
// /usr/share/dripfeed.
std::optional<std::string> find_shared(std::string_view relative);

struct ChosenControl {
  const compile::Dialect* dialect = nullptr;
  ir::Control control;
  std::optional<machine::Profile> profile;
  bool inferred = false;  // it was not named: reports state that
};
// For a text: the machine's control, the dialect's usual one with --control laid over it, or what the text looks like.
app::Result<ChosenControl> choose_control(const TextOptions& options, const text::Source& source);
// Without a text: a machine or a dialect must be named.
app::Result<ChosenControl> choose_control(const TextOptions& options);

// program_folders.cpp: --path, the folder of the file, and where that is a directory of a SINUMERIK (MPF.DIR, a
// workpiece) those next to it.
std::vector<std::string> folders_for(const TextOptions& options, const std::string& file);

}  // namespace dripfeed::cli
