// Codes are looked up by number in a flat index, because most of the time of reading a long program is spent here.
#include "dialects/macro_b/reader/lower.h"

#include <algorithm>
#include <cmath>

#include "dialects/ir/offset_words.h"

namespace dripfeed::macro_b {

namespace {

using ir::ExpressionId;
using ir::Function;
using ir::Operator;
using ir::StatementKind;
using enum text::DiagnosticId;

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

// Ten times a written number; -1 for a computed one, -2 for one that is not a code number (G1.25).
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

void BlockLowering::emit_native(std::string_view name, bool effects_known, const BlockPlace& place, bool moves) {
  program_.natives.push_back({.name = program_.strings.add(name), .effects_known = effects_known, .moves = moves});
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

void BlockLowering::add_code(const RawWord& word, std::int32_t number10) {
  ir::Code code;
  code.letter = word.letter;
  code.span = word.span;
  const ir::CodeRow* row = row_of(word.letter, number10);
  if (row != nullptr) {
    code.function = row->function;
    code.argument = row->argument;
    code.group = row->group;
    const bool is_variant = row->function == Function::continuous_path && row->name != "G64";
    if (row->function == Function::not_modelled || row->function == Function::no_effect || is_variant ||
        row->function == Function::approach || row->function == Function::stroke_check) {
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
    // Where the text's lines contradict each other, another G-code system than the one that was taken may have it.
    const bool may_be_other = !control_.contradiction.empty() && word.letter == 'G';
    if (fault != nullptr && (may_be_macro || may_be_other)) fault->severity = text::Severity::warning;
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
    if (raw.letter == 'A') word.address = ir::Address::direct_angle;
    if (raw.letter != 'R' && raw.letter != 'C' && raw.letter != 'A') {
      word.address = ir::Address::other;
      word.name = program_.strings.add(std::string{',', raw.letter});
    }
  } else {
    word.address = address_of(raw.letter);
  }
  const bool counts = !grammar_.rounds_words_whole;
  if (counts && is_linear(raw.letter)) word.value = in_increments(word.value, control_.semantics.least_increment_mm);
  if (counts && is_rotary(raw.letter)) word.value = in_increments(word.value, control_.semantics.least_increment_deg);
  if (raw.letter == 'T') word.value = with_short_offset(word);
  program_.words.push_back(word);
}

// T001001 is T0101: the number itself does not show how it was written.
ExpressionId BlockLowering::with_short_offset(const ir::Word& word) {
  constexpr double kLong = 1000.0;
  constexpr double kShort = 100.0;
  constexpr std::ptrdiff_t kLongDigits = 6;
  if (!grammar_.long_tool_words || control_.semantics.tool_word != ir::ToolWord::number_and_offset) return word.value;
  const std::string_view written = word.span.in(program_.source.text());
  const ir::Expression e = program_.at(word.value);
  if (e.op != Operator::constant ||
      std::ranges::count_if(written, [](char c) { return c >= '0' && c <= '9'; }) != kLongDigits)
    return word.value;
  const double tool = std::floor(e.value / kLong);
  const double offset = e.value - tool * kLong;
  return offset < kShort ? program_.add_constant(tool * kShort + offset, e.span, e.has_point) : word.value;
}

void BlockLowering::emit_block(std::uint32_t first_code, std::uint32_t first_word, const BlockPlace& place) {
  const auto code_count = static_cast<std::uint32_t>(program_.codes.size()) - first_code;
  const auto word_count = static_cast<std::uint32_t>(program_.words.size()) - first_word;
  if (code_count + word_count == 0) return;
  program_.blocks.push_back({first_code, code_count, first_word, word_count, place.rest_level, place.rest_begin});
  emit(StatementKind::block, static_cast<std::uint32_t>(program_.blocks.size() - 1), place);
}

// A without a comma on a lathe that has no such axis is the angle of a line, in a block that only moves (3405#4).
void BlockLowering::name_direct_angle(std::uint32_t first_code, std::uint32_t first_word) {
  if (control_.kind != ir::MachineKind::lathe || control_.axes.contains('A')) return;
  const auto codes = std::span(program_.codes).subspan(first_code);
  const bool only_moves = std::ranges::all_of(codes, [](const ir::Code& c) {
    return c.letter == 'M' || c.function == Function::linear || c.group == ir::ModalGroup::feed;
  });
  for (std::uint32_t i = first_word; only_moves && i < program_.words.size(); ++i)
    if (program_.words[i].address == ir::Address::a) program_.words[i].address = ir::Address::direct_angle;
}

// G54.1 Pn is a work offset of its own: its argument is kExtendedOffset + n. A computed P is looked at while running.
void BlockLowering::number_extended_offset(std::uint32_t first_code, std::uint32_t first_word) {
  for (std::uint32_t i = first_code; i < program_.codes.size(); ++i) {
    ir::Code& code = program_.codes[i];
    const bool by_first = code.function == Function::work_offset && code.argument == ir::kFirstWorkOffset &&
                          control_.semantics.g54_takes_p &&
                          std::none_of(program_.codes.begin() + static_cast<std::ptrdiff_t>(first_code),
                                       program_.codes.end(), [](const ir::Code& c) { return ir::takes_p(c.function); });
    if (code.function != Function::extended_offset && !by_first) continue;
    const auto first = program_.words.begin() + static_cast<std::ptrdiff_t>(first_word);
    const auto p =
        std::find_if(first, program_.words.end(), [](const ir::Word& w) { return w.address == ir::Address::p; });
    if (p == program_.words.end() || program_.at(p->value).op != Operator::constant) continue;
    const double number = program_.at(p->value).value;
    if (number < 1.0 || number > ir::kLastExtendedOffset) {
      code.function = Function::extended_offset;  // … and its P is refused
      continue;
    }
    code.function = Function::work_offset;
    code.argument = static_cast<std::int16_t>(kExtendedOffset + static_cast<std::int16_t>(number));
    program_.words.erase(p);
  }
}

// G05 P10000 and P0 switch high-speed contour control, which neither moves nor changes what is programmed. Other P
// begin data that are no program (P2) or are a machine's own.
void BlockLowering::name_contour_control(std::uint32_t first_code, std::uint32_t first_word) {
  constexpr double kOn = 10'000.0;
  for (std::uint32_t i = first_code; i < program_.codes.size(); ++i) {
    ir::Code& code = program_.codes[i];
    if (code.function != Function::not_modelled || program_.strings.at(code.name) != "G05") continue;
    const auto first = program_.words.begin() + static_cast<std::ptrdiff_t>(first_word);
    const auto p = std::ranges::find(first, program_.words.end(), ir::Address::p, &ir::Word::address);
    if (p == program_.words.end() || program_.at(p->value).op != Operator::constant) continue;
    const double value = program_.at(p->value).value;
    if (value == kOn || value == 0.0) code.function = Function::no_effect;
  }
}

// M[3.5] is M4, as it is where the number comes from a variable; M3.5 is not a code.
std::int32_t BlockLowering::whole_m_number10(const RawWord& word, std::int32_t number10) const {
  const bool calculated = word.span.in(program_.source.text()).substr(1).starts_with('[');
  const ir::Expression* value = calculated && number10 != -1 ? &program_.at(word.value) : nullptr;
  const bool fits = value != nullptr && value->value >= 0.0 && value->value <= kHighestCode10 / 10.0;
  return fits ? static_cast<std::int32_t>(std::lround(value->value)) * 10 : number10;
}

void BlockLowering::lower(std::span<const RawWord> words, const BlockPlace& place) {
  const auto first_code = static_cast<std::uint32_t>(program_.codes.size());
  const auto first_word = static_cast<std::uint32_t>(program_.words.size());
  bool ends = false;
  if (each_block_ && is_under_each_block(words)) [[unlikely]]
    return emit_each_block(words, place);
  for (std::size_t i = 0; i < words.size(); ++i) {
    const RawWord& word = words[i];
    if ((word.letter != 'G' && word.letter != 'M') || word.comma) {
      if (word.letter != '<') add_word(word);
      continue;
    }
    std::int32_t number10 = number10_of(word.value);
    if (word.letter == 'M' && number10 % 10 != 0) number10 = whole_m_number10(word, number10);
    const CallWord kind = call_word(control_, word.letter, number10);
    const bool data = kind == CallWord::data_input || kind == CallWord::data_end;
    if (data ? begins_data(kind, words, place) : kind != CallWord::none) {
      program_.codes.resize(first_code);
      program_.words.resize(first_word);
      if (data) return;
      if (place.rest_level != 0) return emit_native(kRestNotModelled, false, place);
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
  take_other_forms(first_code, first_word);
  number_extended_offset(first_code, first_word);
  name_contour_control(first_code, first_word);
  if (ends && place.rest_level != 0) {
    program_.codes.resize(first_code);
    program_.words.resize(first_word);
    return emit_native(kRestNotModelled, false, place);
  }
  name_direct_angle(first_code, first_word);
  if (ends) return emit_ending_block(first_code, first_word, place);
  if (grammar_.second_tool_is_next && changes_tool(first_code)) return emit_tool_change(first_code, first_word, place);
  emit_block(first_code, first_word, place);
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

}  // namespace dripfeed::macro_b
