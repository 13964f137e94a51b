// Everything is read from the tables of diagnostics and alarms; nothing is written here a second time.
#include "server/cli/explain.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "dialects/compile/dialect/dialect.h"
#include "dialects/text/nearest.h"
#include "server/cli/diagnostic_examples.h"

namespace dripfeed::cli {

namespace {

std::vector<const text::DiagnosticRow*> all_rows() {
  std::vector<const text::DiagnosticRow*> rows;
  constexpr auto kCount = static_cast<std::size_t>(text::DiagnosticId::count_);
  rows.reserve(kCount);
  for (std::size_t i = 0; i < kCount; ++i) rows.push_back(&text::row_of(static_cast<text::DiagnosticId>(i)));
  return rows;
}

// The sentence, with a mark where the arguments stand.
std::string sentence_of(const text::DiagnosticRow& row) {
  if (row.text == "{}") return "… (the message names the fault)";
  std::string sentence;
  std::string_view rest = row.text;
  for (std::size_t hole = 0; (hole = rest.find("{}")) != std::string_view::npos; rest.remove_prefix(hole + 2))
    sentence.append(rest.substr(0, hole)).append("…");
  return sentence.append(rest);
}

// The numbers by which a control may name it: several where it depends on the place.
std::vector<std::string_view> alarms_of(const compile::Dialect& dialect, text::DiagnosticId id) {
  std::vector<std::string_view> alarms;
  for (const ir::MachineKind kind : {ir::MachineKind::mill, ir::MachineKind::lathe})
    for (const ir::AlarmRow& row : dialect.control(kind, ir::GSystem::a).alarms)
      if (row.id == id && !row.alarm.empty() && std::ranges::find(alarms, row.alarm) == alarms.end())
        alarms.push_back(row.alarm);
  return alarms;
}

std::vector<std::pair<std::string_view, std::string>> alarms_of(text::DiagnosticId id) {
  std::vector<std::pair<std::string_view, std::string>> all;
  for (const compile::Dialect& dialect : compile::dialects())
    if (const auto alarms = alarms_of(dialect, id); !alarms.empty())
      all.emplace_back(dialect.title, fmt::format("{}", fmt::join(alarms, ", ")));
  return all;
}

const DiagnosticExample* example_of(std::string_view id) {
  const auto found = std::ranges::lower_bound(diagnostic_examples(), id, {}, &DiagnosticExample::id);
  return found == diagnostic_examples().end() || found->id != id ? nullptr : &*found;
}

std::string indented(std::string_view text) {
  std::string out = "  ";
  for (const char c : text.substr(0, text.find_last_not_of('\n') + 1)) {
    out += c;
    if (c == '\n') out += "  ";
  }
  return out;
}

std::string fenced(std::string_view title, std::string_view program) {
  const std::string_view end = program.ends_with('\n') ? "" : "\n";
  return fmt::format("\n{}\n\n```nc\n{}{}```\n", title, program, end);
}

std::string markdown_of(const text::DiagnosticRow& row) {
  std::string out =
      fmt::format("## {}\n\n*{}*: {}\n\n{}\n", row.name, name_of(row.severity), sentence_of(row), row.help);
  std::vector<std::string> alarms;
  for (const auto& [control, numbers] : alarms_of(row.id)) alarms.push_back(fmt::format("{} {}", control, numbers));
  if (!alarms.empty()) out += fmt::format("\nAlarm: {}.\n", fmt::join(alarms, "; "));
  const DiagnosticExample* example = example_of(row.name);
  if (example == nullptr) return out;
  out += fenced(fmt::format("This program has it ({}):", example->dialect), example->trigger);
  if (!example->near_miss.empty()) out += fenced("This one does not:", example->near_miss);
  return out;
}

}  // namespace

std::string explanation_of(const text::DiagnosticRow& row) {
  std::string out = fmt::format("{}[{}]: {}\n\n{}\n", name_of(row.severity), row.name, sentence_of(row), row.help);
  const auto alarms = alarms_of(row.id);
  if (!alarms.empty()) out += "\nalarm\n";
  for (const auto& [control, numbers] : alarms) out += fmt::format("  {:24} {}\n", control, numbers);
  const DiagnosticExample* example = example_of(row.name);
  if (example == nullptr) return out;
  out += fmt::format("\nexample ({})\n{}\n", example->dialect, indented(example->trigger));
  if (!example->near_miss.empty()) out += fmt::format("\nwithout it\n{}\n", indented(example->near_miss));
  return out;
}

std::string all_in_markdown() {
  std::string out =
      "# Diagnostics\n\nEach message about a program has an id. `dripfeed explain ID` prints what stands here of it. "
      "`dripfeed "
      "explain --all --markdown`\nwrites this page from the tables of the binary.\n\nAn *error* is what the control "
      "would "
      "certainly alarm on, or a limit of the machine or a gouge. A *warning* is a likely fault, or\nwhat depends on "
      "things "
      "that were not given. `…` stands for what a message names. The programs are tests of this project.\n\n"
      "| id | severity | message |\n|---|---|---|\n";
  for (const text::DiagnosticRow* row : all_rows())
    out += fmt::format("| [{0}](#{0}) | {1} | {2} |\n", row->name, name_of(row->severity), sentence_of(*row));
  for (const text::DiagnosticRow* row : all_rows()) out += "\n" + markdown_of(*row);
  return out;
}

std::string list_of_diagnostics() {
  std::string out;
  for (const text::DiagnosticRow* row : all_rows())
    out += fmt::format("{:32} {:8} {}\n", row->name, name_of(row->severity), sentence_of(*row));
  return out;
}

std::vector<std::string_view> near_names(std::string_view name) {
  constexpr std::size_t kMost = 5;
  std::vector<std::pair<std::size_t, std::string_view>> found;
  for (const text::DiagnosticRow* row : all_rows()) {
    const bool is_part = name.size() >= 3 && row->name.contains(name);
    const std::size_t distance = is_part ? 0 : text::edit_distance(name, row->name);
    if (distance < text::far_from(name)) found.emplace_back(distance, row->name);
  }
  std::ranges::stable_sort(found, {}, &std::pair<std::size_t, std::string_view>::first);
  found.resize(std::min(found.size(), kMost));
  std::vector<std::string_view> names;
  names.reserve(found.size());
  for (const auto& one : found) names.push_back(one.second);
  return names;
}

}  // namespace dripfeed::cli
