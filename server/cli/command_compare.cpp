// dripfeed compare: two programs compared, as texts, by meaning and by their motions.
#include <memory>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "dialects/text/number.h"
#include "server/app/library/compare.h"
#include "server/cli/called_programs.h"
#include "server/cli/cli.h"
#include "server/cli/inputs.h"
#include "server/cli/output.h"
#include "server/json/reports.h"

namespace dripfeed::cli {

namespace {

struct CompareOptions {
  TextOptions text;
  std::string first;
  std::string second;
  std::uint32_t seconds = kCheckSeconds;
};

app::Result<app::ComparedText> open(const CompareOptions& options, const std::string& path) {
  auto source = read_source(path);
  if (!source) return std::unexpected(source.error());
  auto chosen = choose_control(options.text, *source);
  if (!chosen) return std::unexpected(chosen.error());
  return app::ComparedText{.source = std::move(*source),
                           .dialect = chosen->dialect,
                           .control = std::move(chosen->control),
                           .find_called = find_in(folders_for(options.text, path))};
}

// As diff prints it: what goes, then what comes.
std::string changes_text(const app::LinesAnswer& answer) {
  std::string out;
  for (const app::ChangedLines& one : answer.changes) {
    for (const app::NumberedLine& line : one.first) out += fmt::format("  - {:>5}  {}\n", line.number, line.text);
    for (const app::NumberedLine& line : one.second) out += fmt::format("  + {:>5}  {}\n", line.number, line.text);
  }
  if (answer.change_count > answer.changes.size())
    out += fmt::format("  and {} more changes\n", answer.change_count - answer.changes.size());
  return out;
}

std::string lines_text(std::string_view what, const app::LinesAnswer& answer) {
  switch (answer.likeness) {
    case app::Likeness::equal: return fmt::format("{}: equal\n", what);
    case app::Likeness::not_compared: return fmt::format("{}: not compared: {}\n", what, answer.why);
    case app::Likeness::differs: break;
  }
  return fmt::format("{}: differs\n{}", what, changes_text(answer));
}

std::string place_text(std::uint32_t line, const std::string& what) {
  return line == 0 ? what : fmt::format("line {}, {}", line, what);
}

std::string moves_text(const compile::MovesAnswer& moves) {
  if (!moves.why.empty()) return fmt::format("motions: not compared: {}\n", moves.why);
  if (moves.equal) return fmt::format("motions: equal ({} moves)\n", moves.moves);
  std::string out = fmt::format("motions: differ after {} moves\n  - {}\n  + {}\n", moves.moves,
                                place_text(moves.first_line, moves.first), place_text(moves.second_line, moves.second));
  if (moves.deviation_mm)
    out += fmt::format("  largest deviation {} mm{}\n", text::format_fixed(*moves.deviation_mm, 4),
                       *moves.deviation_deg > 0.0
                           ? fmt::format(", {} degrees", text::format_fixed(*moves.deviation_deg, 4))
                           : std::string());
  return out;
}

int compare(const CompareOptions& options) {
  const auto first = open(options, options.first);
  const auto second = first ? open(options, options.second) : first;
  if (!second) {
    print_error(second.error());
    return kWrongUse;
  }
  const app::Comparison found = app::compare(*first, *second, app::time_budget(options.seconds));
  const std::string text = options.text.json ? json::comparison(found)
                                             : lines_text("text", found.text) + lines_text("meaning", found.meaning) +
                                                   moves_text(found.moves);
  return write_output(options.text.output, text) ? kDone : kWrongUse;
}

}  // namespace

void add_compare(CLI::App& app, int& exit_code) {
  CLI::App* command = app.add_subcommand("compare", "compares two programs: text, meaning, motions");
  const auto options = std::make_shared<CompareOptions>();
  command->add_option("A", options->first, "program, - for standard input")->required();
  command->add_option("B", options->second, "the other program")->required();
  add_text_options(*command, options->text);
  add_seconds(*command, options->seconds);
  command->callback([options, &exit_code] { exit_code = compare(*options); });
}

}  // namespace dripfeed::cli
