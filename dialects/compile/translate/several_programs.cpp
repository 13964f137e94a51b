// The printers frame one program each: of '#'-controls all but the first and last tape mark go; SINUMERIK's get the
// heads of a punched tape, so that each becomes a file again.
#include "dialects/compile/translate/several_programs.h"

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <string_view>

#include <fmt/format.h>

#include "dialects/ir/sections.h"
#include "dialects/passes/refusal.h"
#include "dialects/passes/walk.h"

namespace dripfeed::compile {

namespace {

using ir::StatementKind;

constexpr std::string_view kTapeMark = "%\n";

bool is_numbered(std::string_view name, char letter) {
  return name.size() > 1 && name.front() == letter && name.find_first_not_of("0123456789", 1) == std::string_view::npos;
}

bool has(const ir::Program& program, StatementKind kind) {
  return std::ranges::find(program.statements, kind, &ir::Statement::kind) != program.statements.end();
}

}  // namespace

ir::Program program_of(const ir::Program& text, const ir::Section& section) {
  ir::Program out = text;
  out.sections.clear();
  out.name = text.strings.at(section.name);
  const auto begin = text.statements.begin();
  out.statements.assign(begin + section.first, begin + section.last);
  std::erase_if(out.labels,
                [&](const ir::Label& l) { return l.statement < section.first || l.statement >= section.last; });
  for (ir::Label& label : out.labels) label.statement -= section.first;
  std::erase_if(out.foreign_parts,
                [&](const ir::ForeignPart& part) { return part.first < section.first || part.last > section.last; });
  for (ir::ForeignPart& part : out.foreign_parts) {
    part.first -= section.first;
    part.last -= section.first;
  }
  for (ir::Structure& structure : out.structures) structure.partner = ir::kNoIndex;
  (void)ir::match_structures(out);  // the reader has reported halves
  return out;
}

void JoinedPrograms::cannot(passes::Refusal what, text::Span span) {
  diagnostics_.push_back(passes::diagnose(std::move(what), span, control_.title));
}

text::Span JoinedPrograms::span_of(const ir::Program& program) const {
  return program.statements.empty() ? text::Span{} : program.statements.front().span;
}

bool JoinedPrograms::is_called(const ir::Program& program) const {
  const ir::StringId name = text_.strings.find(program.name);
  return std::ranges::any_of(text_.statements, [&](const ir::Statement& s) {
    const bool calls = s.kind == StatementKind::call || s.kind == StatementKind::modal_call;
    return calls && text_.calls[s.payload].name == name;
  });
}

std::string JoinedPrograms::name_there(const ir::Program& program) {
  const bool tape_of_files = control_.semantics.feed_code_ends_surface_speed;
  const bool called = is_called(program);
  std::string name = program.name;
  if (tape_of_files && is_numbered(name, 'O') && (called || !has(program, StatementKind::program_end)))
    name = "L" + name.substr(1);
  if (!tape_of_files && is_numbered(name, 'L')) name = fmt::format("O{:0>4}", name.substr(1));
  // A subprogram can be called by a file's name; two main programs would both be O0001.
  const bool by_name = ir::is_subprogram(program);
  const bool findable = tape_of_files || is_numbered(name, 'O') || by_name || names_.empty();
  if (!findable) cannot(passes::of_call("the name of the program " + name), span_of(program));
  // An end of the program in a called one ends all; SINUMERIK's goes back to the caller.
  if (tape_of_files && called && has(program, StatementKind::program_end))
    cannot(passes::of_call("the end of the whole program in the called program " + program.name), span_of(program));
  if (std::ranges::find(names_, name) != names_.end())
    cannot(passes::of_call("a second program " + name), span_of(program));
  names_.push_back(name);
  return findable ? name : std::string();
}

// A number that they share must stay one number, and two must stay two.
void JoinedPrograms::compare_variables(const ir::Program& program, const ir::Program& raised) {
  for (const ir::Statement& s : program.statements) {
    for (const passes::VariableUseAt& use : passes::variables_of(program, s)) {
      const ir::Variable& before = program.at(use.variable);
      const ir::Variable& after = raised.at(use.variable);
      const bool plain = before.index == ir::ExpressionId::none && after.index == ir::ExpressionId::none;
      if (!plain || before.bank == ir::Bank::named || before.bank == after.bank || after.bank == ir::Bank::system)
        continue;
      const std::pair<Place, Place> now{{before.bank, before.number}, {after.bank, after.number}};
      const auto clash = std::ranges::find_if(
          variables_, [&](const auto& known) { return (known.first == now.first) != (known.second == now.second); });
      if (clash != variables_.end())
        return cannot(passes::of_value(fmt::format("the variable {}, another number in another program of the text,",
                                                   before.span.in(program.source.text()))),
                      before.span);
      if (std::ranges::find(variables_, now) == variables_.end()) variables_.push_back(now);
    }
  }
}

// A macro has its arguments from G65; M98 would hand on the caller's own local variables.
void JoinedPrograms::refuse_sharing(const ir::Program& program, const ir::Program& raised) {
  if (!has(raised, StatementKind::procedure) || has(program, StatementKind::procedure)) return;
  const ir::StringId name = text_.strings.find(program.name);
  for (const ir::Statement& s : text_.statements) {
    if (s.kind != StatementKind::call || text_.calls[s.payload].name != name) continue;
    if (text_.calls[s.payload].kind != ir::CallKind::macro)
      cannot(passes::kept_value("a subprogram (M98) that reads the local variables of its caller"), s.span);
  }
}

void JoinedPrograms::add(const ir::Program& program, const ir::Program& raised, ir::PrintResult printed) {
  compare_variables(program, raised);
  refuse_sharing(program, raised);
  std::string_view text = printed.text;
  auto first = printed.origin_lines.begin();
  auto last = printed.origin_lines.end();
  const bool framed = text.starts_with(kTapeMark) && text.ends_with(kTapeMark) && text.size() > kTapeMark.size();
  if (framed) {
    text.remove_prefix(kTapeMark.size());
    text.remove_suffix(kTapeMark.size());
    ++first;
    --last;
    if (joined_.text.empty()) {
      joined_.text = kTapeMark;
      joined_.origin_lines.push_back(0);
    }
  } else {
    const std::string_view kind = has(program, StatementKind::program_end) ? "MPF" : "SPF";
    joined_.text += fmt::format("%_N_{}_{}\n;$PATH=/_N_{}_DIR\n", names_.back(), kind, kind);
    joined_.origin_lines.insert(joined_.origin_lines.end(), 2, 0);
  }
  joined_.text += text;
  joined_.origin_lines.insert(joined_.origin_lines.end(), first, last);
  joined_.variables = std::max(joined_.variables, printed.variables);
}

ir::PrintResult JoinedPrograms::take() {
  joined_.text += kTapeMark;
  joined_.origin_lines.push_back(0);
  return std::move(joined_);
}

}  // namespace dripfeed::compile
