// Single values that the control refuses: numbers of passes, a feed of nothing, indices beyond an array, constants with
// too many digits, sections without their labels, a block skip before a control structure, frames in the block of a
// motion.
#include <algorithm>

#include "dialects/sinumerik/tables/name_index.h"
#include "dialects/sinumerik/validator/validate.h"

namespace dripfeed::sinumerik {

namespace {

using ir::StatementKind;
using text::DiagnosticId;

constexpr double kMostPasses = 9999.0;

// A constant; nullptr for what is computed or left out.
const ir::Expression* constant_of(const ir::Program& program, ir::ExpressionId id) {
  if (id == ir::ExpressionId::none || program.at(id).op != ir::Operator::constant) return nullptr;
  return &program.at(id);
}

void check_passes(const Check& check, ir::ExpressionId times, double least) {
  const ir::Expression* number = constant_of(check.program, times);
  if (number == nullptr || (number->value >= least && number->value <= kMostPasses)) return;
  check
      .report(DiagnosticId::argument_out_of_domain, number->span,
              {"the number of passes", std::string(check.text_of(number->span))})
      .alarm = "12100";
}

bool has_label(const ir::Program& program, ir::StringId name, std::uint32_t number) {
  return std::ranges::any_of(program.labels, [&](const ir::Label& label) {
    return name != ir::StringId::none ? label.name == name : label.name == ir::StringId::none && label.number == number;
  });
}

void check_section(const Check& check, const ir::Statement& s) {
  const ir::Repeat& repeat = check.program.repeats[s.payload];
  check_passes(check, repeat.times, 1.0);
  const auto missing = [&](ir::StringId name, std::uint32_t number) {
    if (name == ir::StringId::none && number == ir::kNoIndex) return;
    if (has_label(check.program, name, number)) return;
    check
        .report(
            DiagnosticId::jump_target_missing, s.span,
            {name != ir::StringId::none ? std::string(check.program.strings.at(name)) : "N" + std::to_string(number)})
        .alarm = "14082";
  };
  missing(repeat.first, repeat.first_number);
  missing(repeat.last, repeat.last_number);
}

// G4 F0 is a dwell of nothing; elsewhere a path needs a speed.
void check_feed(const Check& check, const ir::Block& block) {
  const auto codes = check.program.codes_of(block);
  if (std::ranges::find(codes, ir::Function::dwell, &ir::Code::function) != codes.end()) return;
  for (const ir::Word& word : check.program.words_of(block)) {
    if (word.address != ir::Address::f) continue;
    const ir::Expression* number = constant_of(check.program, word.value);
    if (number != nullptr && number->value <= 0.0) check.report(DiagnosticId::no_feed, word.span).alarm = "14800";
  }
}

// TRANS and its like, and poles, want a block of their own.
void check_frame(const Check& check, const ir::Block& block) {
  const auto codes = check.program.codes_of(block);
  const auto is_frame = [](const ir::Code& c) {
    return c.function == ir::Function::local_shift || c.function == ir::Function::axial_shift ||
           c.function == ir::Function::local_shift_add ||
           (c.function >= ir::Function::rotate && c.function <= ir::Function::mirror) ||
           (c.function >= ir::Function::pole_from_last && c.function <= ir::Function::pole_from_pole);
  };
  const auto frame = std::ranges::find_if(codes, is_frame);
  const auto motion = std::ranges::find(codes, ir::ModalGroup::motion, &ir::Code::group);
  if (frame == codes.end() || motion == codes.end()) return;
  check.report(DiagnosticId::statement_not_alone, frame->span, {std::string(check.text_of(frame->span))}).alarm =
      "12120";
}

void check_indices(const Check& check) {
  const ir::Program& program = check.program;
  for (const ir::Variable& v : program.variables) {
    if (v.bank != ir::Bank::named || v.symbol == ir::SymbolId::none || program.at(v.symbol).is_global) continue;
    const ir::Symbol& symbol = program.at(v.symbol);
    const std::uint16_t sizes[] = {symbol.dimension1, symbol.dimension2, symbol.dimension3};
    const ir::ExpressionId indices[] = {v.index, v.index2, v.index3};
    for (std::size_t i = 0; i < std::size(sizes); ++i) {
      const ir::Expression* index = sizes[i] == 0 ? nullptr : constant_of(program, indices[i]);
      if (index == nullptr || (index->value > -0.5 && index->value < sizes[i] - 0.5)) continue;
      check.report(DiagnosticId::variable_out_of_range, v.span, {std::string(check.text_of(v.span))}).alarm = "12430";
      break;
    }
  }
}

// 'H…' has at most eight digits, 'B…' at most 32.
void check_based_numbers(const Check& check) {
  for (const ir::Token& token : check.program.tokens) {
    if (token.kind != ir::TokenKind::number) continue;
    const std::string_view written = check.text_of(token.span);
    if (written.size() < 3 || written.front() != '\'') continue;
    const std::size_t digits = written.size() - 3;
    const bool hex = to_upper(written[1]) == 'H';
    const bool binary = to_upper(written[1]) == 'B';
    if ((hex && digits > 8) || (binary && digits > 32))
      check.report(DiagnosticId::malformed_number, token.span, {std::string(written)}).alarm = hex ? "12230" : "12220";
  }
}

// The value of an address has at most eight digits before its point (PG, "Values"); those of variables are doubles.
void check_digits(const Check& check, const ir::Block& block) {
  constexpr std::size_t kWholeDigits = 8;
  for (const ir::Word& word : check.program.words_of(block)) {
    const ir::Expression* number = constant_of(check.program, word.value);
    if (number == nullptr || number->span.empty()) continue;
    std::string_view written = check.text_of(number->span);
    written.remove_prefix(std::min(written.find_first_not_of("+-0 "), written.size()));
    // What is kept as it is written has another text than a number.
    const std::size_t digits = written.find_first_not_of("0123456789");
    if (digits == std::string_view::npos || digits <= kWholeDigits || written[digits] != '.') continue;
    check.report(DiagnosticId::too_many_digits, number->span,
                 {std::string(check.text_of(number->span)), std::to_string(digits), std::to_string(kWholeDigits)});
  }
}

}  // namespace

void check_limits(const Check& check) {
  for (const ir::Statement& s : check.program.statements) {
    if (s.kind == StatementKind::repeat_section) check_section(check, s);
    if (s.kind == StatementKind::call || s.kind == StatementKind::modal_call)
      check_passes(check, check.program.calls[s.payload].repeats, 1.0);
    if (ir::is_structure(s.kind) && s.skip_level > 0)
      check.report(DiagnosticId::syntax_error, s.span, {"a control structure cannot be skipped"}).alarm = "12630";
    if (s.kind != StatementKind::block) continue;
    check_feed(check, check.block_of(s));
    check_frame(check, check.block_of(s));
    check_digits(check, check.block_of(s));
  }
  check_indices(check);
  check_based_numbers(check);
}

}  // namespace dripfeed::sinumerik
