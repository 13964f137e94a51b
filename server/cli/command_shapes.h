// What each command takes, read from the tables of CLI11: for completion and the manual page, which so never differ
// from the program.
#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;  // included only where it is needed: it takes seconds to compile
}

namespace dripfeed::cli {

struct OptionShape {
  std::vector<std::string> names;  // "--data"; of a positional one: "FILE"
  std::string about;
  bool takes_value = false;
  bool is_positional = false;
  bool is_required = false;
  bool is_repeated = false;  // takes several
};

struct CommandShape {
  std::string path;  // "ledger verify"; "" for the program itself
  std::string about;
  std::string footer;
  std::vector<OptionShape> options;
  std::vector<std::string> commands;  // words that go on from it
};

// All that people use, the program first, each command before those below it.
std::vector<CommandShape> shapes_of(const CLI::App& program);

// command_completion.cpp, command_man.cpp
std::string bash_completion(const std::vector<CommandShape>& commands);
std::string man_page(const std::vector<CommandShape>& commands);

}  // namespace dripfeed::cli
