// The frame around a program, its length of blocks, how it is delivered, and what is not interpreted.
#include <algorithm>
#include <set>
#include <string>
#include <unordered_set>
#include <vector>

#include "dialects/macro_b/reader/lower.h"
#include "dialects/macro_b/reader/tape_marks.h"
#include "dialects/macro_b/validator/validate.h"
#include "dialects/text/upper_case.h"

namespace dripfeed::macro_b {

namespace {

using ir::StatementKind;
using ir::TokenKind;
using enum text::DiagnosticId;

// The first token that is no blank, no EOB and no leader, and where the last one ends.
const ir::Token* first_token(const ir::Program& program) {
  const auto counts = [](const ir::Token& t) {
    return t.kind != TokenKind::white && t.kind != TokenKind::eob && t.kind != TokenKind::invalid;
  };
  const auto found = std::ranges::find_if(program.tokens, counts);
  return found == program.tokens.end() ? nullptr : &*found;
}

std::uint32_t last_token_end(const ir::Program& program) {
  const auto counts = [](const ir::Token& t) { return t.kind != TokenKind::white && t.kind != TokenKind::eob; };
  const auto found = std::find_if(program.tokens.rbegin(), program.tokens.rend(), counts);
  return found == program.tokens.rend() ? 0 : found->span.end;
}

// Whether the % that closes the program is there: one after the first, or any when the text does not begin with one.
bool has_closing_mark(const ir::Program& program, bool opened) {
  return std::ranges::count(program.tokens, TokenKind::tape_mark, &ir::Token::kind) > (opened ? 1 : 0);
}

bool ends_flow(const ir::Program& program, const ir::Statement& s) {
  const bool jumps = s.kind == StatementKind::go_to && program.jumps[s.payload].condition == ir::ExpressionId::none;
  return jumps || is_end_of_program(s.kind) || s.kind == StatementKind::alarm;
}

// The statements of a section that a jump of it leads to, in order; every label where a jump is calculated.
std::vector<std::uint32_t> jump_targets(const ir::Program& program, const Section& section) {
  std::unordered_set<std::uint32_t> numbers;
  bool calculated = false;
  for (std::uint32_t i = section.first; i < section.last; ++i) {
    const ir::Statement& s = program.statements[i];
    if (s.kind != StatementKind::go_to) continue;
    calculated |= program.jumps[s.payload].number == ir::kNoIndex;
    numbers.insert(program.jumps[s.payload].number);
  }
  std::vector<std::uint32_t> targets;
  for (const ir::Label& label : program.labels) {
    if (calculated || numbers.contains(label.number)) targets.push_back(label.statement);
  }
  return targets;
}

// The last block that does something must end the program, or jump, or lie after a block that does and be reached by
// no jump.
bool is_ended(const ir::Program& program, const Section& section) {
  const std::vector<std::uint32_t> targets = jump_targets(program, section);
  bool open_end = true;
  bool any_end = false;
  for (std::uint32_t i = section.first; i < section.last; ++i) {
    const ir::Statement& s = program.statements[i];
    if (s.is_label && std::ranges::binary_search(targets, i)) open_end = true;
    if (s.kind == StatementKind::empty || is_folder_line(program, s)) continue;
    any_end |= is_end_of_program(s.kind);
    if (ends_flow(program, s)) open_end = false;
  }
  return any_end && !open_end;
}

void check_end(const ir::Program& program, const Section& section, std::size_t section_count, Findings& findings) {
  if (is_ended(program, section)) return;
  const ir::Statement* last = nullptr;
  for (std::uint32_t i = section.first; i < section.last; ++i) {
    const ir::Statement& s = program.statements[i];
    if (s.kind != StatementKind::empty && !is_folder_line(program, s)) last = &s;
  }
  // A number alone (O0100 and again O0100, as folders keep it) runs nothing.
  if (last == nullptr && section_count > 1) return;
  findings.add(missing_program_end, last != nullptr ? last->span : section.number);
}

std::string written_native(const ir::Program& program, const ir::Statement& s) {
  return std::string(native_name(program, s));
}

bool is_output(const ir::Program& program, const ir::Statement& s) {
  return s.kind == StatementKind::output || native_name(program, s).ends_with("PRNT");
}

// G200 to G202, where the control has an alarm for them; "" when there is none.
std::string code_refused_in_drip(const ir::Program& program, const ir::Control& control, const ir::Statement& s) {
  constexpr auto kDetail = ir::AlarmDetail::code_in_drip;
  if (s.kind != StatementKind::block) return {};
  if (ir::alarm_of(control, not_in_drip_mode, kDetail) == ir::alarm_of(control, not_in_drip_mode)) return {};
  for (const ir::Code& code : program.codes_of(program.blocks[s.payload])) {
    if (code.function != ir::Function::not_modelled) continue;
    const std::string_view name = program.strings.at(code.name);
    if (name == "G200" || name == "G201" || name == "G202") return std::string(name);
  }
  return {};
}

// A code of the control's table; others were reported as unknown.
bool is_in_table(const ir::Control& control, std::string_view name) {
  return std::ranges::find(control.g_codes, name, &ir::CodeRow::name) != control.g_codes.end();
}

}  // namespace

namespace {

// A file of the control's own disc is called by its name, and has no marks of a tape.
bool is_named_by_file(const ir::Program& program) {
  constexpr std::string_view kExtension = ".EIA";
  const std::string& name = program.source.name();
  return name.size() > kExtension.size() && text::upper_case(name).ends_with(kExtension);
}

}  // namespace

void check_frame(const ir::Program& program, const ir::Control& control, const std::vector<Section>& sections,
                 Findings& findings) {
  const ir::Token* first = first_token(program);
  const bool opened = begins_with_tape_mark(program);
  const std::uint32_t begin = first == nullptr ? 0 : first->span.begin;
  const bool named_by_file = is_named_by_file(program);
  if (!opened && !named_by_file) findings.add(missing_tape_mark, {begin, begin}, {"first"});
  if (!has_closing_mark(program, opened) && (opened || !named_by_file)) {
    const std::uint32_t end = last_token_end(program);
    findings.add(missing_tape_mark, {end, end}, {"last"});
  }
  if (sections.front().number.empty() && !named_by_file) {
    const auto content =
        std::ranges::find_if(program.statements, [](const ir::Statement& s) { return s.kind != StatementKind::empty; });
    findings.add(missing_program_number,
                 content == program.statements.end() ? text::Span{begin, begin} : content->span);
  }
  for (const Section& section : sections) check_end(program, section, sections.size(), findings);
  const std::uint32_t most = control.limits.block_length_bytes;
  for (const ir::Statement& s : program.statements) {
    if (most == 0 || s.tokens.first == s.tokens.last) continue;
    const ir::Token& last = program.tokens[s.tokens.last - 1];
    const std::uint32_t stop = last.kind == TokenKind::eob ? last.span.begin : last.span.end;
    const text::Span block = {program.tokens[s.tokens.first].span.begin, stop};
    if (block.size() > most) findings.add(block_too_long, block, {std::to_string(block.size()), std::to_string(most)});
  }
}

void check_drip(const ir::Program& program, const ir::Control& control, const Grammar& grammar, Findings& findings) {
  const auto forbid = [&](const ir::Statement& s, std::string_view what,
                          ir::AlarmDetail detail = ir::AlarmDetail::none) {
    findings.add(not_in_drip_mode, s.span, {std::string(what)}, detail);
  };
  for (const ir::Statement& s : program.statements) {
    if (const std::string code = code_refused_in_drip(program, control, s); !code.empty())
      forbid(s, code, ir::AlarmDetail::code_in_drip);
    if (s.kind == StatementKind::go_to) {
      const bool conditional = program.jumps[s.payload].condition != ir::ExpressionId::none;
      forbid(s, conditional ? "IF GOTO" : "GOTO");
    } else if (s.kind == StatementKind::while_begin || s.kind == StatementKind::loop_begin) {
      forbid(s, s.kind == StatementKind::while_begin ? "WHILE" : "DO");
    } else if (s.kind == StatementKind::if_begin && grammar.drip_forbids_conditions) {
      forbid(s, "IF");
    } else if (grammar.drip_forbids_output && is_output(program, s)) {
      forbid(s, "POPEN, DPRNT, PCLOS");
    } else if (s.kind == StatementKind::return_to) {
      forbid(s, "M99 P", ir::AlarmDetail::subprogram_in_drip);
    } else if (s.kind == StatementKind::call && program.calls[s.payload].kind == ir::CallKind::external) {
      forbid(s, "M198", ir::AlarmDetail::subprogram_in_drip);
    } else if (s.kind == StatementKind::call && program.calls[s.payload].start != ir::ExpressionId::none &&
               program.calls[s.payload].name == ir::StringId::none) {
      forbid(s, "a call of a block of this program");
    }
  }
}

void check_not_interpreted(const ir::Program& program, const ir::Control& control, Findings& findings) {
  std::set<std::string, std::less<>> reported;
  const auto report = [&](std::string_view name, text::Span span) {
    if (reported.emplace(name).second) findings.add(not_interpreted, span, {std::string(name)});
  };
  for (const ir::Statement& s : program.statements) {
    // The bytes of BPRNT are not made here; nothing moves by it.
    const bool is_binary_output =
        s.kind == StatementKind::native && program.strings.at(program.natives[s.payload].name) == "BPRNT";
    if (is_binary_output) report("BPRNT", s.span);
    if (s.kind == StatementKind::native && !program.natives[s.payload].effects_known) {
      const std::string name = written_native(program, s);
      if (name != kNotUnderstood) report(name, s.span);
    }
    if (s.kind != StatementKind::block) continue;
    for (const ir::Code& code : program.codes_of(program.blocks[s.payload])) {
      if (code.function != ir::Function::not_modelled) continue;
      const std::string_view name = program.strings.at(code.name);
      if (is_in_table(control, name)) report(name, code.span);
    }
  }
}

}  // namespace dripfeed::macro_b
