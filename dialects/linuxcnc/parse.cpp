// The frame: lines one after the other, and the order of the programs of the text.
#include "dialects/linuxcnc/parse.h"

#include <algorithm>
#include <utility>

#include "dialects/linuxcnc/tables.h"
#include "dialects/text/upper_case.h"

namespace dripfeed::linuxcnc {

using ir::StatementKind;
using enum text::DiagnosticId;

Parser::Parser(ir::Program& program, const ir::Control& control, std::vector<text::Diagnostic>& diagnostics)
    : program_(program),
      faults_(control, diagnostics),
      expressions_(program, faults_),
      lowering_(program, control, grammar(), faults_) {}

void Parser::run() {
  const std::string_view text = program_.source.text();
  asks_existence_ = text::upper_case(text).contains("EXISTS");
  for (std::uint32_t at = 0; at < text.size();) {
    const auto first_token = static_cast<std::uint32_t>(program_.tokens.size());
    const auto first_statement = static_cast<std::uint32_t>(program_.statements.size());
    at = read_line(text, at, line_, program_.tokens);
    ++number_;
    faults_.begin_block();
    skip_level_ = 0;
    line();
    finish_line(first_statement, first_token);
  }
  for (const Open& open : open_) faults_.report(missing_end, {}, {"O-word " + open.name, "end"});
  check_styles();
  put_sections_in_order();
  ir::match_structures(program_);
}

macro_b::BlockPlace Parser::place() const {
  return {number_, skip_level_,
          line_.text.empty() ? text::Span{line_.offsets[0], line_.offsets[0]} : line_.span(0, line_.text.size())};
}

void Parser::line() {
  if (ended_) return;
  const bool is_first = !std::exchange(began_, began_ || line_.is_tape_mark || !line_.text.empty());
  if (line_.is_tape_mark) {
    ended_ = !is_first;
    if (ended_ && section_ == 0) lowering_.emit(StatementKind::program_end, ir::kNoIndex, place());
    return;
  }
  std::size_t at = 0;
  if (line_.at(0) == '/') {
    at = 1;
    skip_level_ = 1;
  }
  expressions_.begin(line_, at);
  if (line_.at(at) == 'n') block_number();
  if (!line_.comments.empty()) comments();
  if (faults_.failed() || line_.at(expressions_.at()) == '\0') return;
  line_.at(expressions_.at()) == 'o' ? o_word() : words();
}

// Numbers of blocks are never jumped to.
void Parser::block_number() {
  std::size_t digits = 1;
  const auto is_digit = [](char c) { return (c >= '0' && c <= '9') || c == '.'; };
  while (is_digit(line_.at(expressions_.at() + digits))) ++digits;
  if (digits == 1) faults_.fail(address_without_value, place().span, {"N"});
  expressions_.skip(digits);
}

void Parser::finish_line(std::uint32_t first_statement, std::uint32_t first_token) {
  if (faults_.failed() || !faults_.native().empty()) {
    program_.statements.resize(first_statement);
    std::erase_if(program_.labels, [&](const ir::Label& label) { return label.statement >= first_statement; });
    lowering_.emit_native(faults_.failed() ? macro_b::kNotUnderstood : faults_.native(), false, place(), true);
  }
  if (program_.statements.size() == first_statement) lowering_.emit(StatementKind::empty, ir::kNoIndex, place());
  program_.statements[first_statement].tokens = {first_token, static_cast<std::uint32_t>(program_.tokens.size())};
  section_of_.resize(program_.statements.size(), section_);
}

// The main program first, then each subprogram, wherever its lines stand.
void Parser::put_sections_in_order() {
  if (sections_.size() == 1) return;
  std::vector<std::uint32_t> order(program_.statements.size());
  for (std::uint32_t i = 0; i < order.size(); ++i) order[i] = i;
  std::ranges::stable_sort(order, {}, [&](std::uint32_t i) { return section_of_[i]; });
  std::vector<std::uint32_t> place_of(order.size());
  std::vector<ir::Statement> statements(order.size());
  for (std::uint32_t i = 0; i < order.size(); ++i) {
    place_of[order[i]] = i;
    statements[i] = program_.statements[order[i]];
  }
  program_.statements = std::move(statements);
  for (ir::Label& label : program_.labels) label.statement = place_of[label.statement];
  for (std::uint32_t section = 0; section < sections_.size(); ++section) {
    const auto range = std::ranges::equal_range(order, section, {}, [&](std::uint32_t i) { return section_of_[i]; });
    program_.sections.push_back({.name = program_.strings.add(sections_[section]),
                                 .first = static_cast<std::uint32_t>(range.begin() - order.begin()),
                                 .last = static_cast<std::uint32_t>(range.end() - order.begin())});
  }
}

}  // namespace dripfeed::linuxcnc
