// dripfeed man: the manual page, as roff with the macros of man(7).
#include <algorithm>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "server/cli/cli.h"
#include "server/cli/command_shapes.h"
#include "server/cli/output.h"

namespace dripfeed::cli {

namespace {

// Text of ours: a backslash begins a request, a dash would be set as a hyphen, a dot at the beginning of a line is a
// request.
std::string roff(std::string_view text) {
  std::string out;
  bool at_begin = true;
  for (const char c : text) {
    if (at_begin && (c == '.' || c == '\'')) out += "\\&";
    if (c == '\\') {
      out += "\\e";
    } else if (c == '-') {
      out += "\\-";
    } else {
      out += c;
    }
    at_begin = c == '\n';
  }
  return out;
}

std::string title_of(const CommandShape& command) {
  return command.path.empty() ? std::string("dripfeed") : "dripfeed " + command.path;
}

// "[options] FILE [DATA]"
std::string synopsis_of(const CommandShape& command) {
  std::string text;
  const bool has_options = std::ranges::any_of(command.options, [](const auto& one) { return !one.is_positional; });
  if (has_options) text += " [options]";
  if (!command.commands.empty()) text += " command";
  for (const OptionShape& option : command.options) {
    if (!option.is_positional) continue;
    text += fmt::format(" {}{}{}{}", option.is_required ? "" : "[", option.names.front(),
                        option.is_repeated ? "..." : "", option.is_required ? "" : "]");
  }
  return text;
}

void append(std::string& page, const CommandShape& command) {
  page += fmt::format(".SS \"{}\"\n.B {}\n{}\n.PP\n{}\n", roff(title_of(command)), roff(title_of(command)),
                      roff(synopsis_of(command)), roff(command.about));
  for (const OptionShape& option : command.options) {
    page += fmt::format(".TP\n.B \"{}{}\"\n{}\n", roff(fmt::format("{}", fmt::join(option.names, ", "))),
                        option.takes_value && !option.is_positional ? " VALUE" : "",
                        option.about.empty() ? "\\&" : roff(option.about));
  }
  if (!command.footer.empty()) page += fmt::format(".PP\n.nf\n{}\n.fi\n", roff(command.footer));
}

constexpr const char* kExit = R"(.SH EXIT STATUS
.TP
.B 0
done; there may be warnings
.TP
.B 1
the verdict is fail, the program ended by an alarm or limit, the transfer failed, a check found a fault
.TP
.B 2
wrong use, or a file or the store cannot be read or written
.TP
.B 3
a block is torn at the control, or may be: nothing leaves on the line before a person confirmed that the control was reset
)";

}  // namespace

std::string man_page(const std::vector<CommandShape>& commands) {
  const CommandShape& program = commands.front();
  std::string page = fmt::format(
      ".TH DRIPFEED 1 \"\" \"dripfeed {}\"\n.ad l\n.nh\n.SH NAME\ndripfeed \\- {}\n.SH SYNOPSIS\n.B dripfeed\n{}\n.SH "
      "COMMANDS\n",
      kVersion, roff(program.about), roff(synopsis_of(program)));
  for (const CommandShape& command : commands) append(page, command);
  return page + kExit;
}

void add_man(CLI::App& app, int& exit_code) {
  CLI::App* command = app.add_subcommand("man", "Print the manual page: dripfeed man | man -l -");
  command->callback(
      [&app, &exit_code] { exit_code = write_output("-", man_page(shapes_of(app))) ? kDone : kWrongUse; });
}

}  // namespace dripfeed::cli
