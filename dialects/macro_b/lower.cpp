// Codes are looked up by number in a flat index, because most of the time of reading a long program is spent here.
#include "dialects/macro_b/lower.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "dialects/text/number.h"

namespace dripfeed::macro_b {

namespace {

using ir::ExpressionId;
using ir::Function;
using ir::Operator;
using ir::StatementKind;
using enum text::DiagnosticId;

constexpr std::int32_t kSubprogramCall = 980;  // M98
constexpr std::int32_t kExternalCall = 1980;   // M198
constexpr std::int32_t kMacroCall = 650;       // G65
constexpr std::int32_t kModalCall = 660;       // G66, G66.1, G67
constexpr std::int32_t kModalCallEachBlock = 661;
constexpr std::int32_t kModalCallEnd = 670;
constexpr std::int32_t kDataInput = 100;  // G10
constexpr std::int32_t kDataInputEnd = 110;
constexpr double kPackedProgram = 10'000.0;  // M98 P51234: five times O1234

// Codes as ten times their number: more decimals or digits than any table has are unknown codes.
constexpr std::int32_t kHighestCode10 = 99'999;
constexpr std::int32_t kFirstBuilderCode = 1000;  // G100

std::vector<std::int16_t> index_rows(std::span<const ir::CodeRow> table) {
  std::vector<std::int16_t> index;
  for (std::size_t i = 0; i < table.size(); ++i) {
    if (table[i].number10 < 0) continue;
    const auto at = static_cast<std::size_t>(table[i].number10);
    if (index.size() <= at) index.resize(at + 1, -1);
    index[at] = static_cast<std::int16_t>(i);
  }
  return index;
}

ir::Address address_of(char letter) { return static_cast<ir::Address>(letter - 'A'); }

bool is_rotary(char letter) { return letter == 'A' || letter == 'B' || letter == 'C'; }
bool is_linear(char letter) { return std::string_view("XYZUVWIJKR").contains(letter); }

}  // namespace

std::string program_name(double number) { return fmt::format("O{:04}", std::llround(number)); }

BlockLowering::BlockLowering(ir::Program& program, const ir::Control& control, const Grammar& grammar, Faults& faults)
    : program_(program),
      control_(control),
      grammar_(grammar),
      faults_(faults),
      rows_{index_rows(control.g_codes), index_rows(control.m_codes)} {}

const ir::CodeRow* BlockLowering::row_of(char letter, std::int32_t number10) const {
  const std::vector<std::int16_t>& index = rows_[letter == 'G' ? 0 : 1];
  const auto at = static_cast<std::size_t>(number10);
  if (number10 < 0 || at >= index.size() || index[at] < 0) return nullptr;
  return &(letter == 'G' ? control_.g_codes : control_.m_codes)[static_cast<std::size_t>(index[at])];
}

// Ten times a written number; -1 for a computed one, -2 for one that is no code number (G1.25).
std::int32_t BlockLowering::number10_of(ExpressionId value) const {
  const ir::Expression& e = program_.at(value);
  if (e.op != Operator::constant) return -1;
  const double scaled = e.value * 10.0;
  const double whole = std::nearbyint(scaled);
  if (whole < 0.0 || whole > kHighestCode10 || std::abs(scaled - whole) > 1e-6) return -2;
  return static_cast<std::int32_t>(whole);
}

ir::Statement& BlockLowering::emit(StatementKind kind, std::uint32_t payload, const BlockPlace& place) {
  ir::Statement statement;
  statement.kind = kind;
  statement.skip_level = place.skip_level;
  statement.payload = payload;
  statement.line = place.line;
  statement.span = place.span;
  program_.statements.push_back(statement);
  return program_.statements.back();
}

void BlockLowering::emit_native(std::string_view name, bool effects_known, const BlockPlace& place) {
  program_.natives.push_back({program_.strings.add(name), effects_known});
  emit(StatementKind::native, static_cast<std::uint32_t>(program_.natives.size() - 1), place);
}

void BlockLowering::emit_assign(const ir::Variable& target, ExpressionId value, const BlockPlace& place) {
  program_.assigns.push_back({program_.add(target), value});
  emit(StatementKind::assign, static_cast<std::uint32_t>(program_.assigns.size() - 1), place);
}

void BlockLowering::emit_code(Function function, ir::ModalGroup group, const BlockPlace& place) {
  const auto first_code = static_cast<std::uint32_t>(program_.codes.size());
  ir::Code code;
  code.function = function;
  code.group = group;
  code.letter = 'M';
  code.span = place.span;
  program_.codes.push_back(code);
  emit_block(first_code, static_cast<std::uint32_t>(program_.words.size()), place);
}

BlockLowering::CallWord BlockLowering::call_word(char letter, std::int32_t number10) const {
  if (code_call(letter, number10) != nullptr) return CallWord::by_code;
  if (letter == 'M') {
    if (number10 == kSubprogramCall) return CallWord::subprogram;
    return number10 == kExternalCall ? CallWord::external : CallWord::none;
  }
  if (number10 == kMacroCall) return CallWord::macro;
  if (number10 == kModalCall) return CallWord::modal;
  if (number10 == kModalCallEachBlock) return CallWord::modal_each_block;
  if (number10 == kModalCallEnd) return CallWord::modal_end;
  if (number10 == kDataInput) return CallWord::data_input;
  return number10 == kDataInputEnd ? CallWord::data_end : CallWord::none;
}

const ir::CodeCall* BlockLowering::code_call(char letter, std::int32_t number10) const {
  const auto found = std::ranges::find_if(
      control_.code_calls, [&](const ir::CodeCall& c) { return c.letter == letter && c.number10 == number10; });
  return found == control_.code_calls.end() ? nullptr : &*found;
}

void BlockLowering::add_code(const RawWord& word, std::int32_t number10) {
  ir::Code code;
  code.letter = word.letter;
  code.span = word.span;
  const ir::CodeRow* row = row_of(word.letter, number10);
  if (row != nullptr) {
    code.function = row->function;
    code.argument = row->argument;
    code.group = row->group;
    if (row->function == Function::not_modelled || row->function == Function::no_effect) {
      code.name = program_.strings.add(row->name);
    }
  } else if (number10 == -1) {
    code.function = Function::none;
    code.number = word.value;
  } else if (word.letter == 'M' && number10 >= 0 && number10 % 10 == 0 && number10 / 10 <= 9999) {
    code.function = Function::machine_function;
    code.argument = static_cast<std::int16_t>(number10 / 10);
  } else {
    const std::string_view written = word.span.in(program_.source.text());
    text::Diagnostic* fault = faults_.report(unknown_code, word.span, {std::string(written)});
    // Which macros a machine has as G codes, only its parameters know (6050 to 6059); they are given three digits.
    const bool may_be_macro = number10 >= kFirstBuilderCode && !control_.from_profile;
    if (fault != nullptr && may_be_macro) fault->severity = text::Severity::warning;
    code.function = Function::not_modelled;
    code.name = program_.strings.add(written);
  }
  program_.codes.push_back(code);
}

// ROUND in an address rounds to the least increment of the address, not to a whole number.
ExpressionId BlockLowering::in_increments(ExpressionId value, double increment) {
  const ir::Expression e = program_.at(value);
  if (e.op == Operator::constant || e.op == Operator::variable || e.op == Operator::vacant) return value;
  ir::Expression changed = e;
  if (ir::operand_count(e.op) >= 1) changed.a = in_increments(e.a, increment);
  if (ir::operand_count(e.op) >= 2) changed.b = in_increments(e.b, increment);
  if (e.op == Operator::round) {
    const double scale = std::nearbyint(1.0 / increment);
    changed.a = program_.add_operator(Operator::multiply, changed.a, program_.add_constant(scale, e.span), e.span);
    const ExpressionId rounded = program_.add(changed);
    return program_.add_operator(Operator::divide, rounded, program_.add_constant(scale, e.span), e.span);
  }
  return changed.a == e.a && changed.b == e.b ? value : program_.add(changed);
}

void BlockLowering::add_word(const RawWord& raw) {
  ir::Word word;
  word.span = raw.span;
  word.value = raw.value;
  if (raw.comma) {
    word.address = raw.letter == 'R' ? ir::Address::rounding : ir::Address::chamfer;
    if (raw.letter != 'R' && raw.letter != 'C') {
      word.address = ir::Address::other;
      word.name = program_.strings.add(std::string{',', raw.letter});
    }
  } else {
    word.address = address_of(raw.letter);
  }
  if (is_linear(raw.letter)) word.value = in_increments(word.value, control_.semantics.least_increment_mm);
  if (is_rotary(raw.letter)) word.value = in_increments(word.value, control_.semantics.least_increment_deg);
  program_.words.push_back(word);
}

void BlockLowering::emit_block(std::uint32_t first_code, std::uint32_t first_word, const BlockPlace& place) {
  const auto code_count = static_cast<std::uint32_t>(program_.codes.size()) - first_code;
  const auto word_count = static_cast<std::uint32_t>(program_.words.size()) - first_word;
  if (code_count + word_count == 0) return;
  program_.blocks.push_back({first_code, code_count, first_word, word_count});
  emit(StatementKind::block, static_cast<std::uint32_t>(program_.blocks.size() - 1), place);
}

// The end of a program or subprogram is the last effect of its block, wherever its code stands. Its statement's
// payload, for the end of a program, is a block that holds the code alone.
void BlockLowering::emit_ending_block(std::uint32_t first_code, std::uint32_t first_word, const BlockPlace& place) {
  const auto is_end = [](const ir::Code& c) {
    return c.function == Function::program_end || c.function == Function::program_end_rewind ||
           c.function == Function::subprogram_end;
  };
  const auto begin = program_.codes.begin() + static_cast<std::ptrdiff_t>(first_code);
  const auto end_code = std::find_if(begin, program_.codes.end(), is_end);
  const ir::Code end = *end_code;
  program_.codes.erase(end_code);
  const bool is_return = end.function == Function::subprogram_end;
  const auto first = program_.words.begin() + static_cast<std::ptrdiff_t>(first_word);
  const auto target =
      std::find_if(first, program_.words.end(), [](const ir::Word& w) { return w.address == ir::Address::p; });
  const bool returns_to_block = is_return && target != program_.words.end();
  const ExpressionId block = returns_to_block ? target->value : ExpressionId::none;
  if (returns_to_block) program_.words.erase(target);
  emit_block(first_code, first_word, place);
  if (returns_to_block) return emit_return_jump(block, place);
  if (is_return) {
    emit(StatementKind::subprogram_return, ir::kNoIndex, place);
    return;
  }
  program_.codes.push_back(end);
  program_.blocks.push_back(
      {static_cast<std::uint32_t>(program_.codes.size() - 1), 1, static_cast<std::uint32_t>(program_.words.size()), 0});
  emit(StatementKind::program_end, static_cast<std::uint32_t>(program_.blocks.size() - 1), place);
}

// M99 P100: the block in the caller that is next.
void BlockLowering::emit_return_jump(ExpressionId target, const BlockPlace& place) {
  ir::Jump jump;
  const ir::Expression& e = program_.at(target);
  if (e.op == Operator::constant && e.value >= 1.0 && e.value <= grammar_.highest_block_number) {
    jump.number = static_cast<std::uint32_t>(e.value);
  } else {
    jump.computed = target;
  }
  program_.jumps.push_back(jump);
  emit(StatementKind::return_to, static_cast<std::uint32_t>(program_.jumps.size() - 1), place);
}

// G54.1 Pn is a work offset of its own: its argument is kExtendedOffset + n. A computed P is looked at while running.
void BlockLowering::number_extended_offset(std::uint32_t first_code, std::uint32_t first_word) {
  for (std::uint32_t i = first_code; i < program_.codes.size(); ++i) {
    ir::Code& code = program_.codes[i];
    if (code.function != Function::extended_offset) continue;
    const auto first = program_.words.begin() + static_cast<std::ptrdiff_t>(first_word);
    const auto p =
        std::find_if(first, program_.words.end(), [](const ir::Word& w) { return w.address == ir::Address::p; });
    if (p == program_.words.end() || program_.at(p->value).op != Operator::constant) continue;
    const double number = program_.at(p->value).value;
    if (number < 1.0 || number > 300.0) continue;
    code.function = Function::work_offset;
    code.argument = static_cast<std::int16_t>(kExtendedOffset + static_cast<std::int16_t>(number));
    program_.words.erase(p);
  }
}

void BlockLowering::lower(std::span<const RawWord> words, const BlockPlace& place) {
  const auto first_code = static_cast<std::uint32_t>(program_.codes.size());
  const auto first_word = static_cast<std::uint32_t>(program_.words.size());
  bool ends = false;
  for (std::size_t i = 0; i < words.size(); ++i) {
    const RawWord& word = words[i];
    if ((word.letter != 'G' && word.letter != 'M') || word.comma) {
      if (word.letter != '<') add_word(word);
      continue;
    }
    const std::int32_t number10 = number10_of(word.value);
    const CallWord kind = call_word(word.letter, number10);
    const bool data = kind == CallWord::data_input || kind == CallWord::data_end;
    if (data ? begins_data(kind, words, place) : kind != CallWord::none) {
      program_.codes.resize(first_code);
      program_.words.resize(first_word);
      if (data) return;
      return lower_call_block(kind, i, words, place);
    }
    add_code(word, number10);
    const Function function = program_.codes.back().function;
    ends |= function == Function::program_end || function == Function::program_end_rewind ||
            function == Function::subprogram_end;
  }
  if (in_data_input_) {
    program_.codes.resize(first_code);
    program_.words.resize(first_word);
    return emit_native("data of G10", true, place);
  }
  number_extended_offset(first_code, first_word);
  if (ends) return emit_ending_block(first_code, first_word, place);
  emit_block(first_code, first_word, place);
}

// Before a macro call all words are the block's, after it all are the call's. M98 takes P, L, the start block and a
// name from anywhere in its block, and the rest moves first.
void BlockLowering::lower_call_block(CallWord kind, std::size_t at, std::span<const RawWord> words,
                                     const BlockPlace& place) {
  if (kind == CallWord::by_code) return emit_code_call(words[at], words, place);
  const bool by_letter = kind == CallWord::subprogram || kind == CallWord::external;
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
      add_code(word, number10_of(word.value));
    } else {
      add_word(word);
    }
  }
  emit_block(first_code, first_word, place);
  switch (kind) {
    case CallWord::subprogram:
    case CallWord::external:
    case CallWord::macro:
    case CallWord::modal: return emit_call(kind, words[at], of_call, place);
    case CallWord::modal_each_block: return emit_native(words[at].span.in(program_.source.text()), false, place);
    case CallWord::modal_end: emit(StatementKind::modal_call_end, ir::kNoIndex, place); return;
    case CallWord::by_code:
    case CallWord::data_input:
    case CallWord::data_end:
    case CallWord::none: return;
  }
}

// G10 L50 and L52: parameters follow until G11. All other G10 say everything in their own block.
bool BlockLowering::begins_data(CallWord kind, std::span<const RawWord> words, const BlockPlace& place) {
  if (kind == CallWord::data_end) {
    in_data_input_ = false;
    return false;
  }
  in_data_input_ = std::ranges::any_of(words, [&](const RawWord& w) {
    const double value = w.value == ExpressionId::none ? 0.0 : program_.at(w.value).value;
    return w.letter == 'L' && (value == 50.0 || value == 52.0);
  });
  if (in_data_input_) emit_native("G10 L50", false, place);
  return in_data_input_;
}

// A block of a code that calls: the other words are arguments, or stay the block's where it calls as M98 does.
void BlockLowering::emit_code_call(const RawWord& code, std::span<const RawWord> words, const BlockPlace& place) {
  const ir::CodeCall& made = *code_call(code.letter, number10_of(code.value));
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

void BlockLowering::emit_call(CallWord kind, const RawWord& code, std::span<const RawWord> words,
                              const BlockPlace& place) {
  ir::Call call;
  const bool macro = kind == CallWord::macro || kind == CallWord::modal;
  if (macro) call.kind = ir::CallKind::macro;
  if (kind == CallWord::external) call.kind = ir::CallKind::external;
  call.first_argument = static_cast<std::uint32_t>(program_.arguments.size());
  const RawWord* program = nullptr;
  for (const RawWord& word : words) {
    if (word.letter == '<' || (word.letter == 'P' && program == nullptr)) {
      program = &word;
    } else if (word.letter == 'L') {
      call.repeats = word.value;
    } else if (!macro && word.letter == grammar_.start_letter) {
      call.start = word.value;
    } else if (macro) {
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
