// dripfeed completion bash: what the shell proposes. The script looks for the longest command among the words, then
// proposes its options after a dash, files after an option that takes a value, else commands that go on, or files.
#include <memory>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "server/cli/cli.h"
#include "server/cli/command_shapes.h"
#include "server/cli/output.h"

namespace dripfeed::cli {

namespace {

constexpr const char* kBegin = R"(# Completion of dripfeed for bash; /usr/share/bash-completion/completions/dripfeed
_dripfeed() {
  local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD-1]} path= i
  for ((i = 1; i < COMP_CWORD; ++i)); do
    case "$path ${COMP_WORDS[i]}" in
)";
constexpr const char* kMiddle = R"(    esac
  done
  local options= values= commands=
  case "$path" in
)";
constexpr const char* kEnd = R"(  esac
  COMPREPLY=()
  if [[ " $values " == *" $before "* ]]; then
    mapfile -t COMPREPLY < <(compgen -f -- "$word")
  elif [[ $word == -* ]]; then
    mapfile -t COMPREPLY < <(compgen -W "$options" -- "$word")
  elif [[ $commands ]]; then
    mapfile -t COMPREPLY < <(compgen -W "$commands" -- "$word")
  else
    mapfile -t COMPREPLY < <(compgen -f -- "$word")
  fi
}
complete -o filenames -F _dripfeed dripfeed
)";

// The script names a path as it grows: a blank before each word.
std::string key_of(const CommandShape& command) {
  return fmt::format("\"{}{}\"", command.path.empty() ? "" : " ", command.path);
}

std::string names_of(const CommandShape& command, bool that_take_a_value) {
  std::string names;
  for (const OptionShape& option : command.options) {
    if (option.is_positional || (that_take_a_value && !option.takes_value)) continue;
    for (const std::string& name : option.names) names += (names.empty() ? "" : " ") + name;
  }
  return names;
}

}  // namespace

std::string bash_completion(const std::vector<CommandShape>& commands) {
  std::string script = kBegin;
  for (const CommandShape& command : commands) {
    if (!command.path.empty())
      script += fmt::format("      {}) path=\"$path ${{COMP_WORDS[i]}}\" ;;\n", key_of(command));
  }
  script += kMiddle;
  for (const CommandShape& command : commands) {
    script += fmt::format("    {}) options=\"{}\" values=\"{}\" commands=\"{}\" ;;\n", key_of(command),
                          names_of(command, false), names_of(command, true), fmt::join(command.commands, " "));
  }
  return script + kEnd;
}

void add_completion(CLI::App& app, int& exit_code) {
  CLI::App* command = app.add_subcommand("completion", "Print what a shell needs to complete this command's words");
  command->require_subcommand(1);
  CLI::App* bash = command->add_subcommand("bash", "for bash: dripfeed completion bash > FILE, then . FILE");
  bash->callback(
      [&app, &exit_code] { exit_code = write_output("-", bash_completion(shapes_of(app))) ? kDone : kWrongUse; });
}

}  // namespace dripfeed::cli
