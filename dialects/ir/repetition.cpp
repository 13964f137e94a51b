// Labels are in the order of the text.
#include "dialects/ir/repetition.h"

#include "dialects/text/number.h"

namespace dripfeed::ir {

namespace {

std::uint32_t find_label(const Program& program, std::uint32_t from, StringId name, std::uint32_t number) {
  std::uint32_t below = kNoIndex;
  std::uint32_t above = kNoIndex;
  for (const Label& label : program.labels) {
    if (name != StringId::none ? label.name != name : label.name != StringId::none || label.number != number) continue;
    if (label.statement <= from)
      above = label.statement;
    else if (below == kNoIndex)
      below = label.statement;
  }
  return above != kNoIndex ? above : below;
}

// ENDLABEL: after the first label, and above the REPEAT when that stands below the label.
std::uint32_t find_end_label(const Program& program, std::uint32_t first, std::uint32_t repeat) {
  const StringId name = program.strings.find("ENDLABEL");
  if (name == StringId::none) return kNoIndex;
  for (const Label& label : program.labels)
    if (label.name == name && label.statement > first && (first > repeat || label.statement < repeat))
      return label.statement;
  return kNoIndex;
}

std::uint32_t last_of_block(const Program& program, std::uint32_t first) {
  std::uint32_t last = first;
  while (last + 1 < program.statements.size() && !begins_block(program, last + 1)) ++last;
  return last;
}

RepeatedPart part_of(const Program& program, std::uint32_t statement) {
  const Repeat& repeat = program.repeats[program.statements[statement].payload];
  const bool names_last = repeat.last != StringId::none || repeat.last_number != kNoIndex;
  RepeatedPart part{.repeat = statement, .is_open = !names_last && !repeat.one_block};
  part.first = find_label(program, statement, repeat.first, repeat.first_number);
  if (repeat.one_block)
    part.last = part.first;
  else if (names_last)
    part.last = find_label(program, statement, repeat.last, repeat.last_number);
  else if (part.first != kNoIndex)
    part.last = find_end_label(program, part.first, statement);
  if (part.last != kNoIndex) part.last = last_of_block(program, part.last);
  return part;
}

}  // namespace

std::optional<LabelledBlock> labelled_block(const Program& program, Section range, std::string_view name) {
  const auto number = name.starts_with('N') ? text::parse_integer(name.substr(1)) : std::nullopt;
  for (const Label& label : program.labels) {
    const bool is_after_all = label.statement == range.last && range.last == program.statements.size();
    if (!is_after_all && (label.statement < range.first || label.statement >= range.last)) continue;
    const bool meant = label.name == StringId::none ? number == label.number : program.strings.at(label.name) == name;
    if (!meant) continue;
    if (is_after_all) return LabelledBlock{range.last - 1, range.last - 1, true};
    const std::uint32_t last = last_of_block(program, label.statement);
    const bool is_bare = last == label.statement && program.statements[last].kind == StatementKind::empty;
    return LabelledBlock{label.statement, last, is_bare};
  }
  return std::nullopt;
}

bool begins_block(const Program& program, std::uint32_t statement) {
  const Statement& s = program.statements[statement];
  if (program.tokens.empty()) return true;
  return s.tokens.first != s.tokens.last || statement == 0 || program.statements[statement - 1].line != s.line;
}

std::vector<RepeatedPart> repeated_parts(const Program& program) {
  std::vector<RepeatedPart> parts;
  for (std::uint32_t i = 0; i < program.statements.size(); ++i)
    if (program.statements[i].kind == StatementKind::repeat_section) parts.push_back(part_of(program, i));
  return parts;
}

}  // namespace dripfeed::ir
