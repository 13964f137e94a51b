// Sorting of findings, splitting of a text into programs, and the label index.
#include "dialects/macro_b/validator/findings.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "dialects/ir/axis_letters.h"
#include "dialects/ir/sections.h"
#include "dialects/macro_b/reader/lower.h"
#include "dialects/macro_b/reader/tape_marks.h"

namespace dripfeed::macro_b {

namespace {

// The O number or name at the start of a statement's tokens.
text::Span number_of(const ir::Program& program, const ir::Statement& statement) {
  const std::string_view text = program.source.text();
  for (std::uint32_t i = statement.tokens.first; i < statement.tokens.last; ++i) {
    const ir::Token& token = program.tokens[i];
    const char c = token.span.empty() ? '\0' : text[token.span.begin];
    const bool starts =
        (token.kind == ir::TokenKind::address && c == 'O') || (token.kind == ir::TokenKind::symbol && c == ':');
    const bool more = i + 1 < statement.tokens.last;
    if (starts) return more ? text::join(token.span, program.tokens[i + 1].span) : token.span;
    if (token.kind == ir::TokenKind::string) return token.span;
    if (token.kind != ir::TokenKind::white && token.kind != ir::TokenKind::comment) return {};
  }
  return {};
}

// The statement of the % that closes the tape, or one after the last: what follows is not read by the control.
std::uint32_t end_of_tape(const ir::Program& program) {
  bool opens = begins_with_tape_mark(program);
  for (std::uint32_t i = 0; i < program.statements.size(); ++i) {
    const ir::TokenRange tokens = program.statements[i].tokens;
    for (std::uint32_t t = tokens.first; t < tokens.last; ++t) {
      const bool is_mark = program.tokens[t].kind == ir::TokenKind::tape_mark;
      if (is_mark && !std::exchange(opens, false)) return i;
    }
  }
  return static_cast<std::uint32_t>(program.statements.size());
}

}  // namespace

text::Diagnostic* Findings::add(text::DiagnosticId id, text::Span span, std::vector<std::string> arguments,
                                ir::AlarmDetail detail) {
  std::uint16_t& count = counts_[static_cast<std::size_t>(id)];
  if (count >= kMostOfOneId) return nullptr;
  ++count;
  diagnostics_.push_back(ir::diagnose(control_, id, span, std::move(arguments), detail));
  return &diagnostics_.back();
}

text::Diagnostic* Findings::add_own(text::DiagnosticId id, text::Span span, std::vector<std::string> arguments,
                                    ir::AlarmDetail detail) {
  text::Diagnostic* finding = add(id, span, std::move(arguments), detail);
  if (finding == nullptr || ir::alarm_of(control_, id, detail) != ir::alarm_of(control_, id)) return finding;
  finding->severity = text::Severity::warning;
  finding->alarm.clear();
  return finding;
}

text::Diagnostic* Findings::add_open(text::DiagnosticId id, text::Span span, std::vector<std::string> arguments,
                                     bool confirmed) {
  if (confirmed) return nullptr;
  text::Diagnostic* finding = add(id, span, std::move(arguments));
  if (finding != nullptr) finding->severity = control_.from_profile ? text::Severity::error : text::Severity::warning;
  return finding;
}

void Findings::add_variable(std::uint32_t number, text::Span span) {
  const bool is_option = ir::may_have_variable(control_, ir::Bank::hash, number);
  if (is_option && !options_reported_.insert(number).second) return;
  text::Diagnostic* finding = add(text::DiagnosticId::variable_out_of_range, span, {fmt::format("#{}", number)});
  if (finding == nullptr || !is_option) return;
  finding->severity = text::Severity::warning;
  finding->notes.push_back(
      {span, "some machines have it by an option: \"variables\" of the machine's profile decides this"});
}

std::vector<text::Diagnostic> Findings::take() {
  std::ranges::stable_sort(diagnostics_, {}, [](const text::Diagnostic& d) { return d.span.begin; });
  return std::exchange(diagnostics_, {});
}

std::vector<Section> sections_of(const ir::Program& program) {
  std::vector<Section> sections(1);
  bool has_content = false;
  const std::uint32_t end = end_of_tape(program);
  for (std::uint32_t i = 0; i < end; ++i) {
    const ir::Statement& statement = program.statements[i];
    if (const text::Span number = number_of(program, statement); !number.empty()) {
      if (has_content || !sections.back().number.empty()) {
        sections.back().last = i;
        sections.emplace_back().first = i;
        has_content = false;
      }
      sections.back().number = number;
    }
    // Lines before the first O number that are no program do not make one.
    const bool noise = native_name(program, statement) == kNotUnderstood || is_folder_line(program, statement);
    has_content |= statement.kind != ir::StatementKind::empty && !noise;
  }
  sections.back().last = end;
  for (Section& section : sections) section.is_subprogram = ir::is_subprogram(program, section.first, section.last);
  return sections;
}

bool is_end_of_program(ir::StatementKind kind) {
  return kind == ir::StatementKind::program_end || kind == ir::StatementKind::subprogram_return ||
         kind == ir::StatementKind::return_to;
}

bool is_folder_line(const ir::Program& program, const ir::Statement& statement) {
  return native_name(program, statement) == kFolderLine;
}

std::string_view native_name(const ir::Program& program, const ir::Statement& statement) {
  if (statement.kind != ir::StatementKind::native) return {};
  return program.strings.at(program.natives[statement.payload].name);
}

bool is_axis(const ir::Control& control, ir::Address address) {
  const char letter = letter_of(address);
  if (control.axes.contains(letter)) return true;
  const bool increment = control.semantics.incremental_letters_uvw && letter >= 'U' && letter <= 'W';
  return increment && control.axes.contains(static_cast<char>(letter - 'U' + 'X'));
}

std::string_view text_of(const ir::Program& program, text::Span span) { return span.in(program.source.text()); }

Entries::Entries(const ir::Program& program, const Section& section) : program_(program) {
  for (std::uint32_t i = section.first; i < section.last; ++i) {
    const ir::Statement& s = program.statements[i];
    if (s.kind == ir::StatementKind::go_to) {
      const ir::Jump& jump = program.jumps[s.payload];
      computed_ |= jump.number == ir::kNoIndex;
      targets_.insert(jump.number);
    }
    names_blocks_ |= s.kind == ir::StatementKind::return_to || s.kind == ir::StatementKind::call;
    if (s.kind != ir::StatementKind::block || names_blocks_) continue;
    const ir::Block& block = program.blocks[s.payload];
    const bool names = std::ranges::any_of(program.codes_of(block), [](const ir::Code& c) {
      return c.function == ir::Function::repetitive_cycle || c.function == ir::Function::not_modelled ||
             c.number != ir::ExpressionId::none;
    });
    for (const ir::Word& word : program.words_of(block))
      names_blocks_ |= names && (word.address == ir::Address::p || word.address == ir::Address::q);
  }
}

bool Entries::at(std::uint32_t statement) const {
  if (!program_.statements[statement].is_label) return false;
  if (computed_ || names_blocks_) return true;
  const auto label = std::ranges::lower_bound(program_.labels, statement, {}, &ir::Label::statement);
  return label != program_.labels.end() && label->statement == statement && targets_.contains(label->number);
}

LabelIndex::LabelIndex(const ir::Program& program, const Section& section) {
  // Reading adds labels in the order of the text.
  const auto first = std::ranges::lower_bound(program.labels, section.first, {}, &ir::Label::statement);
  const auto last = std::ranges::lower_bound(program.labels, section.last, {}, &ir::Label::statement);
  labels_.assign(first, last);
  std::ranges::sort(labels_, {}, [](const ir::Label& l) { return std::pair(l.number, l.statement); });
}

const ir::Label* LabelIndex::find(std::uint32_t number, std::uint32_t from_statement) const {
  const auto same = std::ranges::equal_range(labels_, number, {}, &ir::Label::number);
  if (same.empty()) return nullptr;
  const auto after = std::ranges::lower_bound(same, from_statement, {}, &ir::Label::statement);
  return after == same.end() ? &same.front() : &*after;
}

const ir::Label* LabelIndex::other(const ir::Label& label) const {
  const auto same = std::ranges::equal_range(labels_, label.number, {}, &ir::Label::number);
  const auto found = std::ranges::find_if(same, [&](const ir::Label& l) { return l.statement != label.statement; });
  return found == same.end() ? nullptr : &*found;
}

}  // namespace dripfeed::macro_b
