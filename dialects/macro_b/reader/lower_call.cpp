// Blocks that call: which words are the block's own, which name the program, and which are arguments.
#include <cmath>

#include <fmt/format.h>

#include "dialects/macro_b/reader/lower.h"
#include "dialects/text/number.h"

namespace dripfeed::macro_b {

namespace {

using ir::ExpressionId;
using ir::Operator;
using ir::StatementKind;
using enum text::DiagnosticId;

constexpr double kPackedProgram = 10'000.0;  // M98 P51234: five times O1234

}  // namespace

std::string program_name(double number) { return fmt::format("O{:04}", std::llround(number)); }

// Before a macro call all words are the block's, after it all are the call's. M98 takes P, L, the start block and a
// name from anywhere in its block, and the rest moves first.
void BlockLowering::lower_call_block(CallWord kind, std::size_t at, std::span<const RawWord> words,
                                     const BlockPlace& place) {
  if (kind == CallWord::by_code) return emit_code_call(words[at], words, place);
  if (kind == CallWord::modal_end) {
    each_block_.reset();
    emit(StatementKind::modal_call_end, ir::kNoIndex, place);
    std::vector<RawWord> others(words.begin(), words.end());
    others.erase(others.begin() + static_cast<std::ptrdiff_t>(at));
    return lower(others, place);
  }
  const bool by_letter = kind == CallWord::subprogram || kind == CallWord::external || kind == CallWord::local;
  const std::string of_subprogram = std::string("PL<") + grammar_.start_letter;
  const auto first_code = static_cast<std::uint32_t>(program_.codes.size());
  const auto first_word = static_cast<std::uint32_t>(program_.words.size());
  std::vector<RawWord> of_call;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (i == at) continue;
    const RawWord& word = words[i];
    const bool code = (word.letter == 'G' || word.letter == 'M') && !word.comma;
    if (by_letter ? of_subprogram.contains(word.letter) && !word.comma : i > at) {
      of_call.push_back(word);
    } else if (code) {
      if (call_word(control_, word.letter, number10_of(word.value)) != CallWord::none) {
        faults_.report(statement_not_alone, word.span, {std::string(word.span.in(program_.source.text()))},
                       ir::AlarmDetail::second_call);
        continue;
      }
      add_code(word, number10_of(word.value));
    } else {
      add_word(word);
    }
  }
  emit_block(first_code, first_word, place);
  switch (kind) {
    case CallWord::subprogram:
    case CallWord::external:
    case CallWord::local:
    case CallWord::macro:
    case CallWord::modal: return emit_call(kind, words[at], of_call, place);
    case CallWord::modal_each_block: return begin_each_block(words[at], of_call, place);
    case CallWord::modal_end:
    case CallWord::by_code:
    case CallWord::data_input:
    case CallWord::data_end:
    case CallWord::none: return;
  }
}

// A block of a code that calls: the other words are arguments, or stay the block's where it calls as M98 does.
void BlockLowering::emit_code_call(const RawWord& code, std::span<const RawWord> words, const BlockPlace& place) {
  const ir::CodeCall& made = *code_call(control_, code.letter, number10_of(code.value));
  std::vector<RawWord> others;
  for (const RawWord& word : words) {
    if (word.span.begin != code.span.begin) others.push_back(word);
  }
  if (!made.macro) lower(others, place);
  ir::Call call;
  call.kind = made.macro ? ir::CallKind::macro : ir::CallKind::subprogram;
  call.name = program_.strings.add(program_name(made.program));
  call.first_argument = static_cast<std::uint32_t>(program_.arguments.size());
  for (const RawWord& word : others) {
    if (made.macro && word.letter == 'L') call.repeats = word.value;
    if (made.macro && word.letter != 'L') program_.arguments.push_back({word.letter, word.value});
  }
  call.argument_count = static_cast<std::uint32_t>(program_.arguments.size()) - call.first_argument;
  program_.calls.push_back(call);
  emit(StatementKind::call, static_cast<std::uint32_t>(program_.calls.size() - 1), place);
}

bool BlockLowering::is_macro_call(const RawWord& word) const {
  const CallWord kind = call_word(control_, word.letter, number10_of(word.value));
  return kind == CallWord::macro || kind == CallWord::modal || kind == CallWord::modal_each_block;
}

void BlockLowering::emit_call(CallWord kind, const RawWord& code, std::span<const RawWord> words,
                              const BlockPlace& place) {
  ir::Call call;
  const bool macro = kind == CallWord::macro || kind == CallWord::modal;
  if (macro) call.kind = ir::CallKind::macro;
  if (kind == CallWord::external) call.kind = ir::CallKind::external;
  call.first_argument = static_cast<std::uint32_t>(program_.arguments.size());
  const RawWord* program = nullptr;
  for (const RawWord& word : words) {
    if (kind == CallWord::local && word.letter == 'P') {
      call.start = word.value;
    } else if (word.letter == '<' || (word.letter == 'P' && program == nullptr)) {
      program = &word;
    } else if (word.letter == 'L') {
      call.repeats = word.value;
    } else if (!macro && word.letter == grammar_.start_letter) {
      call.start = word.value;
    } else if (macro) {
      if (word.letter == 'G' && is_macro_call(word)) {
        faults_.report(statement_not_alone, word.span, {std::string(word.span.in(program_.source.text()))},
                       ir::AlarmDetail::second_macro);
        break;
      }
      if (word.letter == 'G' || word.letter == 'N' || word.letter == 'O' || word.letter == 'P') {
        faults_.report(wrong_type, word.span,
                       {std::string(word.span.in(program_.source.text())), "a code", "an argument"},
                       ir::AlarmDetail::code_as_argument);
      }
      program_.arguments.push_back({word.letter, word.value});
    }
  }
  call.argument_count = static_cast<std::uint32_t>(program_.arguments.size()) - call.first_argument;
  // Without a program, a start block means one of this program.
  if (program == nullptr && call.start == ExpressionId::none) {
    const std::string_view written = code.span.in(program_.source.text());
    faults_.report(address_without_value, code.span, {fmt::format("P of {}", written)}, ir::AlarmDetail::macro_program);
    return emit_native(written, false, place);
  }
  if (program != nullptr) set_called_program(call, *program);
  program_.calls.push_back(call);
  emit(kind == CallWord::modal ? StatementKind::modal_call : StatementKind::call,
       static_cast<std::uint32_t>(program_.calls.size() - 1), place);
}

void BlockLowering::set_called_program(ir::Call& call, const RawWord& word) {
  const std::string_view written = word.span.in(program_.source.text());
  if (word.letter == '<') {
    const std::string_view name = written.substr(1, written.size() - 2);
    constexpr std::size_t kMost = 32;
    if (name.size() > kMost)
      faults_.report(name_too_long, word.span, {std::string(name), std::to_string(name.size()), std::to_string(kMost)},
                     ir::AlarmDetail::by_name);
    const bool is_number =
        name.size() > 1 && name.front() == 'O' && name.find_first_not_of("0123456789", 1) == std::string_view::npos;
    const auto number = is_number ? text::parse_number(name.substr(1)) : std::nullopt;
    call.name = program_.strings.add(number ? program_name(*number) : std::string(name));
    return;
  }
  const ir::Expression& value = program_.at(word.value);
  if (value.op != Operator::constant) {
    call.number = word.value;
    return;
  }
  double number = value.value;
  const bool packed = grammar_.packed_calls && call.kind == ir::CallKind::subprogram &&
                      call.repeats == ExpressionId::none && number >= kPackedProgram;
  if (packed) {
    call.repeats = program_.add_constant(std::floor(number / kPackedProgram), word.span, false);
    number = std::fmod(number, kPackedProgram);
  }
  call.name = program_.strings.add(program_name(number));
}

}  // namespace dripfeed::macro_b
