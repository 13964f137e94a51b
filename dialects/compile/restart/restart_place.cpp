// All by the text and its structure; what a run would say is asked elsewhere.
#include "dialects/compile/restart/restart_place.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "dialects/facts/calls.h"
#include "dialects/ir/sections.h"

namespace dripfeed::compile {

namespace {

using ir::StatementKind;

bool declares(StatementKind kind) {
  return kind == StatementKind::define || kind == StatementKind::declaration || kind == StatementKind::procedure;
}

bool ends_structure(StatementKind kind) {
  using enum StatementKind;
  return kind == if_end || kind == while_end || kind == repeat_end || kind == for_end || kind == loop_end;
}

}  // namespace

RestartPlaces::RestartPlaces(const ir::Program& program) : program_(program), main_{.first = 0, .last = 0} {
  main_ = ir::section_at(program, 0);
  title_end_ = main_.first;
  while (title_end_ < main_.last && program.statements[title_end_].kind == StatementKind::empty) ++title_end_;
  never_ = why_no_restart_at_all();
}

std::string RestartPlaces::why_no_restart_at_all() const {
  if (!program_.foreign_parts.empty()) return "a part of the program is in the control's other language";
  if (ir::is_subprogram(program_, main_)) return "it is a subprogram, which takes its modes from its caller";
  for (std::uint32_t i = main_.first; i < main_.last; ++i) {
    const ir::Statement& s = program_.statements[i];
    if (s.kind == StatementKind::procedure && program_.structures[s.payload].symbol_count > 0)
      return "it is a subprogram with arguments";
    if (s.kind == StatementKind::execute_text) return "it executes texts that are computed";
  }
  return {};
}

std::uint32_t RestartPlaces::statement_at(std::uint32_t line) const {
  for (std::uint32_t i = main_.first; i < main_.last; ++i) {
    const ir::Statement& s = program_.statements[i];
    if (s.line > line) break;
    if (s.line == line && s.kind != StatementKind::empty) return i;
  }
  return ir::kNoIndex;
}

std::vector<std::uint32_t> RestartPlaces::head_lines(std::uint32_t line) const {
  std::vector<std::uint32_t> out;
  const std::uint32_t title_end = title_end_ < program_.statements.size() ? program_.statements[title_end_].line : line;
  for (std::uint32_t i = 1; i < std::min(title_end, line); ++i) out.push_back(i);
  for (std::uint32_t i = title_end_; i < main_.last && program_.statements[i].line < line; ++i) {
    const ir::Statement& s = program_.statements[i];
    if (declares(s.kind) && (out.empty() || out.back() != s.line)) out.push_back(s.line);
  }
  return out;
}

std::string RestartPlaces::why_not(std::uint32_t line) const {
  if (!never_.empty()) return never_;
  const std::uint32_t at = statement_at(line);
  if (at == ir::kNoIndex) return "the main program has no block in this line";
  if (declares(program_.statements[at].kind)) return "names are declared in this line";
  for (std::uint32_t i = main_.first; i < at; ++i) {
    const ir::Statement& s = program_.statements[i];
    const bool shares_line = (i > main_.first && program_.statements[i - 1].line == s.line) ||
                             (i + 1 < main_.last && program_.statements[i + 1].line == s.line);
    if (!declares(s.kind) || !shares_line) continue;
    const auto other = [&](const ir::Statement& one) { return one.line == s.line && !declares(one.kind); };
    if (std::any_of(program_.statements.begin() + main_.first, program_.statements.begin() + main_.last, other))
      return fmt::format("line {} declares names and does something else, too", s.line);
  }
  if (std::string why = why_inside(at); !why.empty()) return why;
  return why_leads_back(at);
}

std::string RestartPlaces::why_inside(std::uint32_t statement) const {
  for (std::uint32_t end = statement; end < main_.last; ++end) {
    const ir::Statement& s = program_.statements[end];
    if (!ends_structure(s.kind)) continue;
    const std::uint32_t begin = program_.structures[s.payload].partner;
    if (begin != ir::kNoIndex && begin < statement && statement <= end)
      return fmt::format("the line stands in a loop or branch that begins in line {}", program_.statements[begin].line);
  }
  return {};
}

bool RestartPlaces::has_label(std::uint32_t from, ir::StringId name, std::uint32_t number) const {
  return std::ranges::any_of(program_.labels, [&](const ir::Label& label) {
    if (label.statement < from || label.statement >= main_.last) return false;
    return name != ir::StringId::none ? label.name == name : label.number == number;
  });
}

// M97 P100: the block is of the same program.
bool RestartPlaces::block_leads_back(const ir::Block& block, std::uint32_t from) const {
  const auto codes = program_.codes_of(block);
  if (!std::ranges::any_of(codes, [](const ir::Code& c) { return c.function == ir::Function::local_call; }))
    return false;
  for (const ir::Word& word : program_.words_of(block)) {
    if (word.address != ir::Address::p) continue;
    const ir::Expression& value = program_.at(word.value);
    return value.op != ir::Operator::constant || value.value < 0.0 || value.value > 1e8 ||
           !has_label(from, ir::StringId::none, static_cast<std::uint32_t>(value.value));
  }
  return true;
}

// Also where the run does not come along: what is not taken now may be taken at the machine.
std::string RestartPlaces::why_leads_back(std::uint32_t statement) const {
  const auto back = [](const ir::Statement& s, std::string_view what) {
    return fmt::format("{} in line {} leads to before it", what, s.line);
  };
  for (std::uint32_t i = statement; i < main_.last; ++i) {
    const ir::Statement& s = program_.statements[i];
    if (s.kind == StatementKind::go_to) {
      const ir::Jump& jump = program_.jumps[s.payload];
      if (jump.restart) return back(s, "the jump");
      if (jump.label == ir::StringId::none && jump.number == ir::kNoIndex)
        return fmt::format("where the jump in line {} leads is computed", s.line);
      if (!has_label(statement, jump.label, jump.number)) return back(s, "the jump");
    } else if (s.kind == StatementKind::repeat_section) {
      const ir::Repeat& repeat = program_.repeats[s.payload];
      if (!has_label(statement, repeat.first, repeat.first_number)) return back(s, "the repeated part");
    } else if (facts::is_call(s.kind)) {
      const ir::Call& call = program_.calls[s.payload];
      const bool own = call.name == ir::StringId::none && call.number == ir::ExpressionId::none &&
                       call.computed == ir::ExpressionId::none;
      if (own) return back(s, "the call of a part of the program");
    } else if (s.kind == StatementKind::block && block_leads_back(program_.blocks[s.payload], statement)) {
      return back(s, "the call of a part of the program");
    }
  }
  return {};
}

}  // namespace dripfeed::compile
