// The lines that mean something are compared with each other as texts are, and shown as they are written.
#include "server/app/library/compare.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "dialects/compile/translate/meant_lines.h"
#include "server/app/base/line_changes.h"
#include "server/app/shop/catalog.h"

namespace dripfeed::app {

namespace {

// `show` gives the line at an index of either list.
template <class ShowFirst, class ShowSecond>
LinesAnswer answer_of(const std::vector<LineChange>& changes, ShowFirst show_first, ShowSecond show_second) {
  LinesAnswer answer;
  answer.likeness = changes.empty() ? Likeness::equal : Likeness::differs;
  answer.change_count = changes.size();
  for (const LineChange& one : changes) {
    if (answer.changes.size() == Comparison::kMostChanges) break;
    ChangedLines lines;
    for (std::size_t i = one.first; i < one.first_end && lines.first.size() < Comparison::kMostLines; ++i)
      lines.first.push_back(show_first(i));
    for (std::size_t i = one.second; i < one.second_end && lines.second.size() < Comparison::kMostLines; ++i)
      lines.second.push_back(show_second(i));
    answer.changes.push_back(std::move(lines));
  }
  return answer;
}

LinesAnswer compare_texts(const text::Source& first, const text::Source& second) {
  const std::vector<NumberedLine> left = numbered_lines(first.text());
  const std::vector<NumberedLine> right = numbered_lines(second.text());
  const auto texts = [](const std::vector<NumberedLine>& lines) {
    std::vector<std::string_view> out;
    out.reserve(lines.size());
    for (const NumberedLine& line : lines) out.push_back(line.text);
    return out;
  };
  return answer_of(
      line_changes(texts(left), texts(right)), [&](std::size_t i) { return left[i]; },
      [&](std::size_t i) { return right[i]; });
}

// One text as its dialect's reader understands it.
struct Understood {
  explicit Understood(const ComparedText& of)
      : read(of.dialect->read(of.source, of.control)), meaning(compile::meaning_of(read, of.control)) {}
  ir::ReadResult read;
  compile::Meaning meaning;
};

LinesAnswer not_compared(std::string why) {
  LinesAnswer answer;
  answer.why = std::move(why);
  return answer;
}

std::string_view name_of(ir::GSystem system) {
  constexpr std::array<std::string_view, 3> kNames = {"A", "B", "C"};
  return kNames[static_cast<std::size_t>(system)];
}

// Why the same words may mean another thing in the other program; "" where they mean the same.
std::string unlike_controls(const ComparedText& first, const ComparedText& second) {
  if (first.dialect != second.dialect)
    return fmt::format("the first is {}, the second {}", first.dialect->title, second.dialect->title);
  for (const ComparedText* one : {&first, &second})
    if (one->control.contradiction.size() > 1)
      return fmt::format("line {} of {} speaks for another G-code system than line {}",
                         one->control.contradiction[1].line, one == &first ? "the first" : "the second",
                         one->control.contradiction[0].line);
  if (first.control.kind != second.control.kind)
    return fmt::format("the first looks like a program of a {}, the second like one of a {}: name the machine",
                       ir::name_of(first.control.kind), ir::name_of(second.control.kind));
  if (first.control.g_system != second.control.g_system)
    return fmt::format("the first looks like G-code system {}, the second like {}: name the machine",
                       name_of(first.control.g_system), name_of(second.control.g_system));
  return {};
}

// Both number their blocks alike, line for line.
bool same_numbers(const compile::Meaning& first, const compile::Meaning& second) {
  return std::ranges::equal(first.lines, second.lines, {}, &compile::MeantLine::number, &compile::MeantLine::number);
}

LinesAnswer compare_meanings(const ComparedText& first, const Understood& left, const ComparedText& second,
                             const Understood& right) {
  if (std::string why = unlike_controls(first, second); !why.empty()) return not_compared(std::move(why));
  for (const Understood* one : {&left, &right})
    if (!one->meaning.not_understood.empty())
      return not_compared(
          fmt::format("{}: {}", one == &left ? "the first" : "the second", one->meaning.not_understood));
  const auto words = [](const compile::Meaning& meaning) {
    std::vector<std::string_view> out;
    out.reserve(meaning.lines.size());
    for (const compile::MeantLine& line : meaning.lines) out.push_back(line.words);
    return out;
  };
  const auto shown = [](const ComparedText& of, const compile::MeantLine& line) {
    return NumberedLine{line.line, std::string(of.source.line(line.line))};
  };
  LinesAnswer answer = answer_of(
      line_changes(words(left.meaning), words(right.meaning)),
      [&](std::size_t i) { return shown(first, left.meaning.lines[i]); },
      [&](std::size_t i) { return shown(second, right.meaning.lines[i]); });
  if (answer.likeness != Likeness::equal || same_numbers(left.meaning, right.meaning)) return answer;
  for (const Understood* one : {&left, &right})
    if (!one->meaning.numbers_matter.empty())
      return not_compared(fmt::format("their block numbers differ, and {} of {} may refer to them",
                                      one->meaning.numbers_matter, one == &left ? "the first" : "the second"));
  return answer;
}

}  // namespace

Comparison compare(const ComparedText& first, const ComparedText& second, const std::function<std::string()>& used_up) {
  Comparison out;
  out.text = compare_texts(first.source, second.source);
  const Understood left(first);
  const Understood right(second);
  out.meaning = compare_meanings(first, left, second, right);
  compile::ProgramLibrary called_by_first(first.control, first.find_called);
  compile::ProgramLibrary called_by_second(second.control, second.find_called);
  if (const std::string why = unlike_controls(first, second); !why.empty()) {
    out.moves.why = why;
    return out;
  }
  out.moves = compile::compare_moves({left.read.program, first.control, left.meaning, called_by_first},
                                     {right.read.program, second.control, right.meaning, called_by_second}, used_up);
  return out;
}

Result<Comparison> compare_case(const CompareOrder& order, const Documents& documents, const CheckBudget& budget) {
  std::optional<ir::Control> control;
  std::string dialect_of_machine;
  if (!order.profile.empty()) {
    const auto profile = documents.read_profile(order.profile);
    if (!profile) return std::unexpected(profile.error());
    auto of_machine = control_of(*profile);
    if (!of_machine) return std::unexpected(of_machine.error());
    control = std::move(*of_machine);
    dialect_of_machine = profile->control.dialect;
  }
  const auto open = [&](const CompareOrder::Side& side) -> Result<ComparedText> {
    ComparedText text{
        .source = text::Source(side.name, side.text), .dialect = compile::find_dialect(side.dialect), .control = {}};
    if (text.dialect == nullptr)
      return fail(ErrorCode::invalid, fmt::format("dialect \"{}\" is not known", side.dialect));
    if (control && side.dialect != dialect_of_machine)
      return fail(ErrorCode::invalid,
                  fmt::format("program {} is {}, the machine is {}", side.name, side.dialect, dialect_of_machine));
    text.control = control ? *control : text.dialect->infer_control(text.source);
    return text;
  };
  const auto first = open(order.first);
  if (!first) return std::unexpected(first.error());
  const auto second = open(order.second);
  if (!second) return std::unexpected(second.error());
  return compare(*first, *second, time_budget(budget.seconds));
}

}  // namespace dripfeed::app
