// Every statement has its own line, except IF … THEN with its one statement. G codes come before the words and M codes
// after them.
#include "dialects/macro_b/writer/print.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "dialects/ir/axis_letters.h"
#include "dialects/ir/hole_pattern.h"
#include "dialects/ir/sections.h"
#include "dialects/macro_b/reader/lower.h"
#include "dialects/macro_b/tables/variables.h"
#include "dialects/passes/walk.h"
#include "dialects/text/number.h"

namespace dripfeed::macro_b {

namespace {

using ir::Address;
using ir::ExpressionId;
using ir::Function;
using ir::Operator;
using ir::StatementKind;

constexpr std::string_view kWholeAddresses = "DHLNOPT";  // take no decimal point

constexpr std::int16_t kLastPlainOffset = 6;  // G59
constexpr int kComputedDecimals = 4;
constexpr int kWrittenDecimals = 6;
constexpr int kLongestFraction = 9;

std::string skip_sign(std::uint8_t level) { return level == 1 ? "/" : fmt::format("/{}", level); }

// Computed values get the decimals that the trace has, and an inch one more than the control has for a millimetre;
// written ones keep theirs.
int decimals_of(double value, bool computed, const ir::Control& control) {
  constexpr double kUnder100 = 99.0;  // two digits before the point: no logarithm for most positions
  const double magnitude = std::abs(value);
  const auto digits = static_cast<int>(control.limits.digits);
  const int wanted = computed ? std::max(kComputedDecimals, control.limits.linear_decimals + 1) : kWrittenDecimals;
  if (magnitude < kUnder100 && digits - 2 >= wanted) return std::min(wanted, kLongestFraction);
  const int whole_digits = magnitude < 1.0 ? 0 : static_cast<int>(std::floor(std::log10(magnitude))) + 1;
  return std::clamp(std::min(digits - whole_digits, wanted), 0, kLongestFraction);
}

std::string_view string_of(const ir::Program& program, ExpressionId id) {
  return id == ExpressionId::none ? std::string_view() : program.strings.at(program.at(id).string);
}

}  // namespace

const ir::CodeRow* find_function(const ir::Control& control, Function function, std::int16_t argument) {
  // Other arguments are shades of meaning that the tables do not distinguish.
  const bool numbered = function == Function::work_offset || function == Function::reference_return ||
                        function == Function::drill || function == Function::turning_cycle ||
                        function == Function::repetitive_cycle || function == Function::rotate ||
                        function == Function::scale || function == Function::mirror ||
                        function == Function::set_coordinates || function == Function::transformation ||
                        function == Function::hole_pattern || function == Function::thread_changing;
  const auto fits = [&](const ir::CodeRow& r) {
    return r.function == function && (!numbered || r.argument == argument);
  };
  for (const auto table : {control.g_codes, control.m_codes}) {
    // G63 goes on without a stop as well, but for taps: without override and feed hold.
    const auto usual = std::ranges::find_if(table, [&](const ir::CodeRow& r) {
      return fits(r) && function == Function::continuous_path && r.name == "G64";
    });
    if (usual != table.end()) return &*usual;
    const auto row = std::ranges::find_if(table, fits);
    if (row != table.end()) return &*row;
  }
  return nullptr;
}

void append_position(std::string& out, Address axis, double value, const ir::Control& control) {
  out.push_back(ir::letter_of(axis));
  text::append_word_number(out, value, decimals_of(value, true, control), false);
}

std::string comment_text(std::string_view text) {
  std::string out;
  for (const char c : text) {
    if (c >= 'a' && c <= 'z') {
      out.push_back(static_cast<char>(c - 'a' + 'A'));
    } else if (c == '(' || c == ')' || c == '%' || c < ' ' || c == '\x7F') {
      out.push_back(' ');
    } else {
      out.push_back(c);
    }
  }
  return out;
}

namespace {

// As it may stand between < and > (0i-F operator's manual, program name).
bool is_file_name(std::string_view name) {
  constexpr std::size_t kLongest = 32;
  return !name.empty() && name.size() <= kLongest && std::ranges::all_of(name, [](char c) {
    return (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' || c == '+' || c == '_' || c == '.';
  });
}

}  // namespace

std::string program_head(const ir::Program& program) {
  const std::string_view name = program.name;
  const bool is_number = name.size() > 1 && name.size() <= 9 && name.front() == 'O' &&
                         name.find_first_not_of("0123456789", 1) == std::string_view::npos;
  // No control stores a program under the number 0.
  const bool is_zero = is_number && name.find_first_not_of('0', 1) == std::string_view::npos;
  if (is_number && !is_zero) return std::string(name);
  if (!is_number && is_file_name(name) && ir::is_subprogram(program)) return fmt::format("<{}>", name);
  return name.empty() ? "O0001" : fmt::format("O0001({})", comment_text(name));
}

void ProgramPrinter::frame_line(std::string_view line) {
  result_.text += line;
  result_.text += '\n';
  result_.origin_lines.push_back(0);
}

void ProgramPrinter::line(const ir::Statement& statement, const std::string& text) {
  if (text.empty()) return;
  result_.text += text;
  result_.text += '\n';
  result_.origin_lines.push_back(statement.line);
}

void ProgramPrinter::statements() {
  for (std::uint32_t i = 0; i < program_.statements.size(); ++i) statement(i);
}

ir::PrintResult ProgramPrinter::take() {
  result_.variables = count_variables();
  return std::move(result_);
}

// Labels are in the order of their statements. Two at one place: the first gets a line of its own.
std::string ProgramPrinter::labels_at(std::uint32_t index) {
  std::string head;
  while (next_label_ < program_.labels.size() && program_.labels[next_label_].statement <= index) {
    if (!head.empty()) line(program_.statements[index], head);
    head = fmt::format("N{}", program_.labels[next_label_++].number);
  }
  return head;
}

void ProgramPrinter::statement(std::uint32_t index) {
  const ir::Statement& s = program_.statements[index];
  const std::string label = labels_at(index);
  std::string text;
  switch (s.kind) {
    case StatementKind::block:
    case StatementKind::program_end:
      if (!is_stop_of_message(index)) text = block(program_.blocks[s.payload]);
      break;
    case StatementKind::assign: text = assignment(program_.assigns[s.payload]); break;
    case StatementKind::go_to: text = jump(program_.jumps[s.payload]); break;
    case StatementKind::if_begin:
      text = fmt::format("IF{}THEN", expressions_.condition(program_.structures[s.payload].condition));
      break;
    case StatementKind::while_begin:
      text = fmt::format("WHILE{}DO{}", expressions_.condition(program_.structures[s.payload].condition),
                         program_.structures[s.payload].loop_number);
      break;
    case StatementKind::loop_begin: text = fmt::format("DO{}", program_.structures[s.payload].loop_number); break;
    case StatementKind::while_end:
    case StatementKind::loop_end: text = fmt::format("END{}", program_.structures[s.payload].loop_number); break;
    case StatementKind::call: text = call(program_.calls[s.payload], call_word(program_.calls[s.payload])); break;
    case StatementKind::message: text = message(program_.messages[s.payload]); break;
    case StatementKind::alarm: text = alarm(program_.messages[s.payload], kAlarmVariable); break;
    case StatementKind::native: text = native(s); break;
    case StatementKind::subprogram_return: text = "M99"; break;
    case StatementKind::return_to: {
      const ir::Jump& to = program_.jumps[s.payload];
      text = to.computed != ExpressionId::none ? "M99 P" + expressions_.word_value(to.computed)
                                               : fmt::format("M99 P{}", to.number);
      break;
    }
    case StatementKind::modal_call: text = call(program_.calls[s.payload], "G66"); break;
    case StatementKind::modal_call_end: text = "G67"; break;
    case StatementKind::output: text = output(program_.outputs[s.payload]); break;
    case StatementKind::repeat_section:
    case StatementKind::execute_text:
    case StatementKind::empty:
    case StatementKind::if_end:
    case StatementKind::else_begin:
    case StatementKind::repeat_begin:
    case StatementKind::repeat_end:
    case StatementKind::for_begin:
    case StatementKind::for_end:
    case StatementKind::define:
    case StatementKind::procedure:
    case StatementKind::declaration: break;
  }
  // IF … THEN and what follows it share a line.
  const bool continues = index > 0 && program_.statements[index - 1].kind == StatementKind::if_begin;
  if (continues && !text.empty() && label.empty()) {
    result_.text.back() = ' ';
    result_.text += text;
    result_.text += '\n';
    return;
  }
  std::string head;
  if (s.skip_level != 0) head = skip_sign(s.skip_level);
  if (s.skip_level > 1) head += ' ';
  head += label;
  if (!label.empty() && !text.empty()) head += ' ';
  if (!text.empty() || !label.empty()) line(s, head + text);
}

std::string ProgramPrinter::block(const ir::Block& block) const {
  std::string out;
  const auto add = [&](const std::string& part) {
    if (part.empty()) return;
    if (!out.empty()) out += ' ';
    out += part;
  };
  const auto codes = program_.codes_of(block);
  const bool p_is_angle = std::ranges::any_of(
      codes, [](const ir::Code& c) { return c.function == Function::hole_pattern && c.argument == ir::kHolesOnArc; });
  const auto add_part = [&](bool rest) {
    for (const ir::Code& c : codes) {
      if (in_rest(block, c.span) != rest) continue;
      if (const std::string written = code(c); !written.starts_with('M')) add(written);
    }
    for (const ir::Word& w : program_.words_of(block))
      if (in_rest(block, w.span) == rest) add(word(w, p_is_angle));
    for (const ir::Code& c : codes) {
      if (in_rest(block, c.span) != rest) continue;
      if (const std::string written = code(c); written.starts_with('M')) add(written);
    }
  };
  add_part(false);
  if (block.rest_level == 0) return out;
  add(skip_sign(block.rest_level));
  add_part(true);
  return out;
}

std::string ProgramPrinter::code(const ir::Code& code) const {
  if (code.number != ExpressionId::none) return fmt::format("{}{}", code.letter, expressions_.word_value(code.number));
  if (code.function == Function::machine_function) return fmt::format("M{:02}", code.argument);
  if (code.function == Function::not_modelled || code.function == Function::no_effect ||
      code.function == Function::approach) {
    return std::string(program_.strings.at(code.name));
  }
  if (code.function == Function::work_offset && code.argument > kLastPlainOffset) {
    const ir::CodeRow* extended = find_function(control_, Function::extended_offset, 0);
    return fmt::format("{} P{}", extended == nullptr ? "G54.1" : extended->name, code.argument - kExtendedOffset);
  }
  if ((code.function == Function::drill || code.function == Function::continuous_path) &&
      code.name != ir::StringId::none)
    return std::string(program_.strings.at(code.name));
  const ir::CodeRow* row = find_function(control_, code.function, code.argument);
  return row == nullptr ? std::string() : std::string(row->name);
}

std::string ProgramPrinter::word(const ir::Word& word, bool p_is_angle) const {
  std::string out;
  if (word.address <= Address::z) {
    out.push_back(static_cast<char>('A' + static_cast<int>(word.address)));
  } else if (word.address == Address::chamfer || word.address == Address::rounding) {
    out = word.address == Address::chamfer ? ",C" : ",R";
  } else if (word.address == Address::direct_angle) {
    out = ",A";
  } else {
    out = program_.strings.at(word.name);
  }
  const ir::Expression& value = program_.at(word.value);
  if (value.op != Operator::constant) return out + expressions_.word_value(word.value);
  const bool is_axis = word.address == Address::h && ir::incremented_axis(control_, 'H').has_value();
  const bool counts = (kWholeAddresses.contains(out.front()) && !is_axis) || out == "S";
  const bool whole = counts && !(p_is_angle && word.address == Address::p) && value.value == std::floor(value.value);
  // T0606: two digits each for the tool and its offset.
  const bool pairs = out == "T" && control_.semantics.tool_word == ir::ToolWord::number_and_offset;
  if (whole) return out + fmt::format("{:0{}}", std::llround(value.value), pairs ? 4 : 0);
  text::append_word_number(out, value.value, decimals_of(value.value, value.span.empty(), control_), !value.has_point);
  return out;
}

std::string ProgramPrinter::assignment(const ir::Assign& assign) const {
  return fmt::format("{}={}", expressions_.variable(program_.at(assign.target)), expressions_.expression(assign.value));
}

std::string ProgramPrinter::jump(const ir::Jump& jump) const {
  std::string out;
  if (jump.condition != ExpressionId::none) out = "IF" + expressions_.condition(jump.condition);
  out += "GOTO";
  if (jump.computed != ExpressionId::none) return out + expressions_.word_value(jump.computed);
  return out + fmt::format(" {}", jump.number);
}

std::string_view ProgramPrinter::call_word(const ir::Call& call) const {
  if (call.kind == ir::CallKind::macro) return "G65";
  const bool is_local = call.name == ir::StringId::none && call.number == ExpressionId::none;
  if (is_local && has_local_calls_) return kLocalCall;
  return call.kind == ir::CallKind::external ? "M198" : "M98";
}

std::string ProgramPrinter::output(const ir::Output& output) const {
  if (output.kind == ir::OutputKind::open) return "POPEN";
  if (output.kind == ir::OutputKind::close) return "PCLOS";
  std::string out = "DPRNT[";
  for (std::uint32_t i = 0; i < output.part_count; ++i) {
    const ir::OutputPart& part = program_.output_parts[output.first_part + i];
    std::string words(program_.strings.at(part.text));
    std::ranges::replace(words, ' ', '*');
    out += words;
    if (part.value != ExpressionId::none)
      out += fmt::format("{}[{}{}]", expressions_.expression(part.value), part.whole_digits, part.decimals);
  }
  return out + "]";
}

std::string ProgramPrinter::call(const ir::Call& call, std::string_view word) const {
  std::string out(word);
  out += ' ';
  const std::string_view name = program_.strings.at(call.name);
  if (call.name == ir::StringId::none && call.number == ExpressionId::none) {
    out.pop_back();
  } else if (call.number != ExpressionId::none) {
    out += "P" + expressions_.word_value(call.number);
  } else if (name.size() > 1 && name.front() == 'O' &&
             name.find_first_not_of("0123456789", 1) == std::string_view::npos) {
    out += fmt::format("P{}", name.substr(1));
  } else {
    out += fmt::format("<{}>", name);
  }
  if (call.start != ExpressionId::none) {
    const ir::Expression& start = program_.at(call.start);
    out += fmt::format(" {}{}", word == kLocalCall ? 'P' : start_letter_,
                       start.op == Operator::constant ? fmt::format("{}", std::llround(start.value))
                                                      : expressions_.word_value(call.start));
  }
  if (call.repeats != ExpressionId::none) {
    const ir::Expression& repeats = program_.at(call.repeats);
    out += repeats.op == Operator::constant ? fmt::format(" L{}", std::llround(repeats.value))
                                            : " L" + expressions_.word_value(call.repeats);
  }
  for (const ir::Argument& argument : program_.arguments_of(call)) {
    if (argument.value == ExpressionId::none || argument.letter == 0) continue;
    out += fmt::format(" {}{}", argument.letter, expressions_.word_value(argument.value));
  }
  return out;
}

std::string ProgramPrinter::alarm(const ir::Message& message, std::uint32_t variable) const {
  const std::string number = message.number == ExpressionId::none ? "1" : expressions_.expression(message.number);
  const std::string_view text = string_of(program_, message.text);
  return fmt::format("#{}={}{}", variable, number, text.empty() ? "" : fmt::format("({})", comment_text(text)));
}

// A message that does not stop is a comment: these controls have nothing nearer. One with a number is #3006, which
// stops.
std::string ProgramPrinter::message(const ir::Message& message) const {
  if (message.number != ExpressionId::none) return alarm(message, kMessageVariable);
  const std::string_view text = string_of(program_, message.text);
  return text.empty() ? std::string() : fmt::format("({})", comment_text(text));
}

// #3006 is read as a message and a stop; the stop is in it.
bool ProgramPrinter::is_stop_of_message(std::uint32_t index) const {
  if (index == 0 || program_.statements[index - 1].kind != StatementKind::message) return false;
  const ir::Statement& message = program_.statements[index - 1];
  const ir::Statement& s = program_.statements[index];
  if (program_.messages[message.payload].number == ExpressionId::none || message.line != s.line) return false;
  const auto codes = program_.codes_of(program_.blocks[s.payload]);
  return codes.size() == 1 && codes.front().function == Function::program_stop;
}

// As it was written, without its block number and EOB.
std::string ProgramPrinter::native(const ir::Statement& statement) const {
  std::string out;
  for (std::uint32_t i = statement.tokens.first; i < statement.tokens.last; ++i) {
    const ir::Token& token = program_.tokens[i];
    const bool counts = token.kind != ir::TokenKind::eob && token.kind != ir::TokenKind::tape_mark;
    if (token.span.begin >= statement.span.begin && counts) out += token.span.in(program_.source.text());
  }
  while (!out.empty() && (out.back() == ' ' || out.back() == '\t')) out.pop_back();
  return out;
}

std::uint32_t ProgramPrinter::count_variables() const {
  std::set<std::uint32_t> numbers;
  for (const ir::Statement& statement : program_.statements) {
    for (const passes::VariableUseAt& use : passes::variables_of(program_, statement)) {
      const ir::Variable& v = program_.at(use.variable);
      if (v.bank != ir::Bank::hash || v.index != ExpressionId::none) continue;
      const ir::VariableRange* range = ir::find_variable(control_, ir::Bank::hash, v.number);
      if (range != nullptr && range->use != ir::VariableUse::system) numbers.insert(v.number);
    }
  }
  return static_cast<std::uint32_t>(numbers.size());
}

}  // namespace dripfeed::macro_b
