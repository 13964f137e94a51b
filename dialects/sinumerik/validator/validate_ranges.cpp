// Words with a value or a companion that the control refuses: AC and IC on addresses that are no positions, corners
// that are both chamfer and rounding, codes that each want the block's words for themselves, and numbers of edges,
// tools, turns and alarms beyond their range.
#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "dialects/sinumerik/tables/codes.h"
#include "dialects/sinumerik/validator/validate.h"
#include "dialects/text/number.h"

namespace dripfeed::sinumerik {

namespace {

using ir::Address;
using ir::StatementKind;
using text::DiagnosticId;

// Modes of values are those of positions: F=IC(5) has no meaning (12020).
constexpr Address kNoPositions[] = {Address::d, Address::f, Address::h, Address::s, Address::t};
constexpr Address kCorners[] = {Address::chamfer, Address::chamfer_length, Address::rounding};

// Alarm numbers that a program may raise: SETAL of cycles from 60000, of the user from 65000 (PGA, SETAL).
constexpr double kFirstAlarm = 60'000.0;
constexpr double kLastAlarm = 69'999.0;

struct RangeRow {
  Address address;
  std::string_view name;
  double first;
  double last;
  std::string_view alarm;
  bool may_be_name = false;  // a number beyond `last` may be a tool's name, with tool management
};
constexpr auto kRanges = std::to_array<RangeRow>({
    {Address::turns, "TURN", 0.0, 999.0, "14048"},
    {Address::d, "D", 0.0, 32'000.0, "14090"},
    {Address::t, "T", 0.0, 32'000.0, "17190", true},
});

void check_range(const Check& check, const ir::Word& word) {
  const auto* const row = std::ranges::find(kRanges, word.address, &RangeRow::address);
  if (row == kRanges.end() || word.value == ir::ExpressionId::none) return;
  const ir::Expression& value = check.program.at(word.value);
  if (value.op != ir::Operator::constant) return;
  if (value.value >= row->first && value.value <= row->last && value.value == std::floor(value.value)) return;
  text::Diagnostic& found = check.report(DiagnosticId::value_out_of_range, word.span,
                                         {std::string(row->name), std::string(check.text_of(value.span)),
                                          text::format_shortest(row->first), text::format_shortest(row->last)});
  found.alarm = row->alarm;
  if (row->may_be_name && value.value > row->last && value.value == std::floor(value.value))
    found.severity = text::Severity::warning;
}

void check_mode(const Check& check, const ir::Word& word) {
  if (word.mode == ir::WordMode::as_modal || std::ranges::find(kNoPositions, word.address) == std::end(kNoPositions))
    return;
  const std::string_view written = check.text_of(word.span);
  const std::size_t equals = written.find('=');
  const std::size_t bracket = written.find('(');
  if (equals == std::string_view::npos || bracket == std::string_view::npos || bracket < equals) return;
  check
      .report(DiagnosticId::addresses_exclude, word.span,
              {std::string(written.substr(equals + 1, bracket - equals - 1)), std::string(written.substr(0, equals))})
      .alarm = "12020";
}

void check_corners(const Check& check, const ir::Block& block) {
  const ir::Word* first = nullptr;
  for (const ir::Word& word : check.program.words_of(block)) {
    if (std::ranges::find(kCorners, word.address) == std::end(kCorners)) continue;
    if (first == nullptr) {
      first = &word;
      continue;
    }
    if (first->address == word.address) continue;  // reported as a duplicate
    check
        .report(DiagnosticId::addresses_exclude, word.span,
                {std::string(check.text_of(first->span)), std::string(check.text_of(word.span))})
        .alarm = "12020";
  }
}

// G4 and TRANS, G110 and G74: each takes the words of the block.
void check_syntax_codes(const Check& check, const ir::Block& block) {
  constexpr std::uint8_t kOwnWords = 2;  // G groups
  constexpr std::uint8_t kFrames = 3;
  const ir::Code* first = nullptr;
  std::uint8_t first_group = 0;
  for (const ir::Code& code : check.program.codes_of(block)) {
    if (code.letter == 'M' || code.span.empty()) continue;
    const GCode* row = find_code_as_written(check.text_of(code.span));
    if (row == nullptr || (row->group != kOwnWords && row->group != kFrames)) continue;
    if (first != nullptr && first_group != row->group) {
      check
          .report(DiagnosticId::code_with_function, code.span,
                  {std::string(check.text_of(first->span)), std::string(check.text_of(code.span))})
          .alarm = "12070";
      return;
    }
    first = &code;
    first_group = row->group;
  }
}

void check_alarm_number(const Check& check, const ir::Statement& s) {
  const ir::ExpressionId number = check.program.messages[s.payload].number;
  if (number == ir::ExpressionId::none) return;
  const ir::Expression& value = check.program.at(number);
  if (value.op != ir::Operator::constant || (value.value >= kFirstAlarm && value.value <= kLastAlarm)) return;
  // Which alarm the control gives instead, the manuals do not say.
  check
      .report(DiagnosticId::value_out_of_range, s.span,
              {"the number of SETAL", std::string(check.text_of(value.span)), text::format_shortest(kFirstAlarm),
               text::format_shortest(kLastAlarm)})
      .severity = text::Severity::warning;
}

}  // namespace

void check_ranges(const Check& check) {
  for (const ir::Statement& s : check.program.statements) {
    if (s.kind == StatementKind::alarm) check_alarm_number(check, s);
    if (s.kind != StatementKind::block) continue;
    const ir::Block& block = check.block_of(s);
    for (const ir::Word& word : check.program.words_of(block)) {
      check_range(check, word);
      check_mode(check, word);
    }
    check_corners(check, block);
    check_syntax_codes(check, block);
  }
}

}  // namespace dripfeed::sinumerik
