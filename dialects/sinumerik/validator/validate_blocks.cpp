// One block at a time: G groups, addresses that stand twice or too often, length, axes that the machine lacks.
#include <algorithm>
#include <array>
#include <string>
#include <string_view>

#include "dialects/ir/axis_letters.h"
#include "dialects/ir/polynomial_words.h"
#include "dialects/ir/transformation_use.h"
#include "dialects/sinumerik/tables/codes.h"
#include "dialects/sinumerik/tables/name_index.h"
#include "dialects/sinumerik/validator/validate.h"

namespace dripfeed::sinumerik {

namespace {

using ir::StatementKind;
using text::DiagnosticId;

constexpr std::uint32_t kMostMFunctions = 5;
constexpr std::uint32_t kMostHFunctions = 3;
constexpr std::uint32_t kMostSpeeds = 3;

// The control's own group of a code as it is written; 0 for M functions.
std::uint8_t group_of(const Check& check, const ir::Code& code) {
  if (code.letter == 'M' || code.span.empty()) return 0;
  std::array<char, 16> joined{};  // "G 01" is G01
  std::size_t size = 0;
  for (const char c : check.text_of(code.span))
    if (c != ' ' && c != '\t' && size < joined.size()) joined[size++] = c;
  const GCode* row = find_code_as_written({joined.data(), size});
  return row == nullptr ? std::uint8_t{0} : row->group;
}

void check_groups(const Check& check, const ir::Block& block) {
  const auto codes = check.program.codes_of(block);
  if (codes.size() < 2) return;
  for (std::size_t i = 1; i < codes.size(); ++i) {
    const std::uint8_t group = group_of(check, codes[i]);
    if (group == 0) continue;
    for (std::size_t k = 0; k < i; ++k) {
      if (codes[k].span == codes[i].span || group_of(check, codes[k]) != group) continue;  // G96 is two codes
      check.report(DiagnosticId::codes_of_one_group, codes[i].span,
                   {std::string(check.text_of(codes[k].span)), std::string(check.text_of(codes[i].span))});
      break;
    }
  }
}

bool same_address(const Check& check, const ir::Word& a, const ir::Word& b) {
  if (a.address != b.address || a.extension != b.extension) return false;
  if (a.address == ir::Address::named_axis)
    return check.text_of(check.program.at(a.axis).span) == check.text_of(check.program.at(b.axis).span);
  // Other addresses are told apart by their names: X1 and X2, POS[U] and POS[V].
  return a.address != ir::Address::other || a.name == b.name;
}

void check_words(const Check& check, const ir::Block& block) {
  const auto words = check.program.words_of(block);
  for (std::size_t i = 1; i < words.size(); ++i) {
    const auto before = words.first(i);
    if (std::ranges::none_of(before, [&](const ir::Word& w) { return same_address(check, w, words[i]); })) continue;
    if (words[i].address == ir::Address::h || words[i].address == ir::Address::s) continue;  // counted below
    if (ir::is_coefficient(words[i].address)) continue;                                      // with their axis
    const std::string_view written = check.text_of(words[i].span);
    const std::string address(written.substr(0, written.find_first_of("= -+.0123456789", 1)));
    check.report(DiagnosticId::duplicate_address, words[i].span, {address}).severity = text::Severity::error;
  }
}

void too_often(const Check& check, text::Span span, std::size_t count, std::uint32_t most, std::string_view address) {
  if (count > most)
    check.report(DiagnosticId::address_too_often, span,
                 {std::to_string(count), std::string(address), std::to_string(most)});
}

void check_counts(const Check& check, const ir::Statement& s, const ir::Block& block) {
  const auto codes = check.program.codes_of(block);
  const auto words = check.program.words_of(block);
  if (codes.size() + words.size() <= kMostSpeeds) return;
  const auto of = [words](ir::Address a) {
    return static_cast<std::size_t>(std::ranges::count(words, a, &ir::Word::address));
  };
  too_often(check, s.span, static_cast<std::size_t>(std::ranges::count(codes, 'M', &ir::Code::letter)), kMostMFunctions,
            "M");
  too_often(check, s.span, of(ir::Address::h), kMostHFunctions, "H");
  too_often(check, s.span, of(ir::Address::s), kMostSpeeds, "S");
}

// Under TRANSMIT and TRACYL Y is an axis of the channel that C turns for.
bool turns_for_y(const ir::Program& program) {
  return std::ranges::any_of(program.codes, [](const ir::Code& c) {
    return c.function == ir::Function::transformation && (c.argument == ir::kFaceByY || c.argument == ir::kCylinderByY);
  });
}

void check_addresses(const Check& check, const ir::Block& block, std::string_view axes) {
  const auto codes = check.program.codes_of(block);
  const auto dwell = std::ranges::find(codes, ir::Function::dwell, &ir::Code::function);
  for (const ir::Word& word : check.program.words_of(block)) {
    const bool no_address = word.address == ir::Address::o;
    const bool no_axis =
        check.control.from_profile && ir::is_axis(word.address) && !axes.contains(letter_of(word.address));
    if (no_address || no_axis)
      check.report(DiagnosticId::unknown_address, word.span, {std::string(1, letter_of(word.address))});
    // P is how often a subprogram runs; F or S is how long G4 waits.
    if (dwell != codes.end() && word.address == ir::Address::p) {
      text::Diagnostic& d = check.report(DiagnosticId::addresses_exclude, word.span, {"G4", "P"});
      d.severity = text::Severity::warning;
      d.notes.push_back({word.span, "G4 waits F seconds or S revolutions; P is ISO mode's"});
    }
    if (dwell != codes.end() && ir::is_axis(word.address)) {
      check.report(DiagnosticId::statement_not_alone, dwell->span, {"G4"}).alarm = "12120";
      return;
    }
  }
}

void check_lengths(const Check& check) {
  const std::uint32_t limit = check.control.limits.block_length_bytes;
  if (limit == 0) return;
  std::uint32_t start = 0;
  for (const ir::Statement& s : check.program.statements) {
    if (s.tokens.last <= s.tokens.first) continue;
    const std::uint32_t end = check.program.tokens[s.tokens.last - 1].span.end;
    if (end - start > limit)
      check.report_if_machine(DiagnosticId::block_too_long, {start, end},
                              {std::to_string(end - start), std::to_string(limit)});  // versions differ
    start = end;
  }
}

}  // namespace

void check_blocks(const Check& check) {
  check_lengths(check);
  const std::string axes = turns_for_y(check.program) ? check.control.axes + "Y" : check.control.axes;
  for (const ir::Statement& s : check.program.statements) {
    if (s.kind != StatementKind::block) continue;
    const ir::Block& block = check.block_of(s);
    check_groups(check, block);
    check_words(check, block);
    check_counts(check, s, block);
    check_addresses(check, block, axes);
  }
}

}  // namespace dripfeed::sinumerik
