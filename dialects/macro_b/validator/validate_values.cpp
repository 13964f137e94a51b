// Values and words that the control refuses whatever came before them: variables whose number is calculated of
// constants, corners that are two at once, offsets beyond their table, arguments of too many groups; and M functions
// that the machine's list does not have.
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "dialects/ir/offset_words.h"
#include "dialects/macro_b/validator/validate.h"
#include "dialects/text/number.h"

namespace dripfeed::macro_b {

namespace {

using ir::Address;
using ir::Function;
using ir::StatementKind;
using enum text::DiagnosticId;

constexpr double kLargestOffset_mm = 9999.999;
constexpr std::ptrdiff_t kMostTriplets = 10;
constexpr std::array<std::uint32_t, 2> kOnlyWritten = {3000, 3006};  // alarm, stop with a message

// What an expression of constants alone gives.
std::optional<double> folded(const ir::Program& program, ir::ExpressionId id) {
  if (id == ir::ExpressionId::none) return std::nullopt;
  const ir::Expression& e = program.at(id);
  if (e.op == ir::Operator::constant) return e.value;
  const bool two = e.op == ir::Operator::add || e.op == ir::Operator::subtract || e.op == ir::Operator::multiply;
  if (!two) return std::nullopt;
  const auto a = folded(program, e.a);
  const auto b = folded(program, e.b);
  if (!a || !b) return std::nullopt;
  return e.op == ir::Operator::add ? *a + *b : e.op == ir::Operator::subtract ? *a - *b : *a * *b;
}

// #[5000+21], as if its number were written: 4294967295 for one that no control has.
std::optional<std::uint32_t> computed_number(const ir::Program& program, const ir::Variable& variable) {
  if (variable.bank != ir::Bank::hash || variable.index == ir::ExpressionId::none) return std::nullopt;
  const auto value = folded(program, variable.index);
  if (!value) return std::nullopt;
  const double whole = std::round(*value);
  return whole >= 0.0 && whole < 4e9 ? static_cast<std::uint32_t>(whole) : 0xFFFFFFFFU;
}

class ValueCheck {
 public:
  ValueCheck(const ir::Program& program, const ir::Control& control, Findings& findings)
      : program_(program), control_(control), findings_(findings) {}

  void variables() {
    if (control_.variables.empty()) return;
    for (const ir::Variable& v : program_.variables) {
      const auto number = computed_number(program_, v);
      if (number && *number != 0 && ir::find_variable(control_, ir::Bank::hash, *number) == nullptr)
        findings_.add_variable(*number, v.span);
    }
    for (const ir::Expression& e : program_.expressions)
      if (e.op == ir::Operator::variable) read(program_.at(e.variable));
  }

  void statement(const ir::Statement& s) {
    if (s.kind == StatementKind::assign) return written(program_.at(program_.assigns[s.payload].target));
    if (s.kind == StatementKind::call || s.kind == StatementKind::modal_call) return call(program_.calls[s.payload], s);
    if (s.kind != StatementKind::block) return;
    const ir::Block& block = program_.blocks[s.payload];
    corners(block);
    offset_value(block);
    for (const ir::Code& code : program_.codes_of(block)) machine_function(code);
    extended_offset(block);
    signs(block);
  }

 private:
  void written(const ir::Variable& target) {
    const auto number = computed_number(program_, target);
    if (!number) return;
    const ir::VariableRange* range = ir::find_variable(control_, ir::Bank::hash, *number);
    if (*number == 0 || (range != nullptr && !range->writable))
      findings_.add(variable_write_protected, target.span, {fmt::format("#{}", *number)});
  }

  void read(const ir::Variable& v) {
    if (v.bank != ir::Bank::hash) return;
    const std::uint32_t number =
        v.index == ir::ExpressionId::none ? v.number : computed_number(program_, v).value_or(0);
    if (std::ranges::find(kOnlyWritten, number) == kOnlyWritten.end()) return;
    findings_.add_own(syntax_error, v.span, {fmt::format("#{} can only be written", number)},
                      ir::AlarmDetail::write_only);
  }

  // I J K of type II: at most ten of each letter.
  void call(const ir::Call& call, const ir::Statement& s) {
    if (call.kind != ir::CallKind::macro) return;
    const auto arguments = program_.arguments_of(call);
    for (const char letter : {'I', 'J', 'K'}) {
      const auto count = std::ranges::count(arguments, letter, &ir::Argument::letter);
      if (count <= kMostTriplets) continue;
      findings_.add(wrong_argument_count, s.span,
                    {"the macro", std::to_string(kMostTriplets) + " groups of I J K", std::to_string(count)},
                    ir::AlarmDetail::second_type);
      return;
    }
  }

  // ,C and ,R in one block. In a hole's block they mean something else.
  void corners(const ir::Block& block) {
    const auto words = program_.words_of(block);
    const auto chamfer = std::ranges::find(words, Address::chamfer, &ir::Word::address);
    const auto rounding = std::ranges::find(words, Address::rounding, &ir::Word::address);
    if (chamfer == words.end() || rounding == words.end()) return;
    if (std::ranges::find(program_.codes_of(block), Function::drill, &ir::Code::function) !=
        program_.codes_of(block).end())
      return;
    text::Diagnostic* finding =
        findings_.add(addresses_exclude, rounding->span,
                      {std::string(text_of(program_, chamfer->span)), std::string(text_of(program_, rounding->span))},
                      ir::AlarmDetail::two_corners);
    if (finding != nullptr && finding->alarm.empty()) finding->severity = text::Severity::warning;
  }

  // G10 L10 to L13: what is set is the length or radius of a tool.
  void offset_value(const ir::Block& block) {
    const auto codes = program_.codes_of(block);
    if (std::ranges::find(codes, Function::data_input, &ir::Code::function) == codes.end()) return;
    const auto number = [&](Address address) -> const ir::Word* {
      const auto words = program_.words_of(block);
      const auto word = std::ranges::find(words, address, &ir::Word::address);
      const bool constant = word != words.end() && word->value != ir::ExpressionId::none &&
                            program_.at(word->value).op == ir::Operator::constant;
      return constant ? &*word : nullptr;
    };
    const ir::Word* kind = number(Address::l);
    const ir::Word* value = number(Address::r);
    if (kind == nullptr || value == nullptr) return;
    const double l = program_.at(kind->value).value;
    const ir::Expression& r = program_.at(value->value);
    const double length = r.has_point || control_.semantics.decimal_mode == ir::DecimalMode::calculator
                              ? r.value
                              : r.value * control_.semantics.least_increment_mm;
    if (l < 10.0 || l > 13.0 || std::abs(length) <= kLargestOffset_mm) return;
    findings_.add(value_out_of_range, value->span,
                  {"R", std::string(text_of(program_, r.span)), text::format_shortest(-kLargestOffset_mm),
                   text::format_shortest(kLargestOffset_mm)},
                  ir::AlarmDetail::value_of_data);
  }

  [[nodiscard]] std::optional<double> constant(const ir::Word& word) const {
    return word.value == ir::ExpressionId::none ? std::nullopt : folded(program_, word.value);
  }

  // G54.1 P0 and P301: there is no such offset.
  void extended_offset(const ir::Block& block) {
    const auto codes = program_.codes_of(block);
    const auto code = std::ranges::find(codes, Function::extended_offset, &ir::Code::function);
    if (code == codes.end()) return;
    for (const ir::Word& word : program_.words_of(block)) {
      const auto p = word.address == Address::p ? constant(word) : std::nullopt;
      if (p && (*p < 1.0 || *p > ir::kLastExtendedOffset))
        findings_.add(value_out_of_range, word.span,
                      {"P", text::format_shortest(*p), "1", text::format_shortest(ir::kLastExtendedOffset)});
    }
  }

  // Speeds and numbers of tools have no sign.
  void signs(const ir::Block& block) {
    constexpr std::array kUnsigned = {Address::s, Address::t};
    for (const ir::Word& word : program_.words_of(block)) {
      if (std::ranges::find(kUnsigned, word.address) == kUnsigned.end()) continue;
      const std::string_view written = text_of(program_, word.span);
      const auto value = written.size() > 1 && written[1] == '-' ? sign_of(word) : std::nullopt;
      if (!value) continue;
      text::Diagnostic* finding =
          findings_.add(value_out_of_range, word.span, {std::string(written.substr(0, 1)), *value, "0", "99999"});
      if (finding != nullptr) finding->alarm.clear();  // the row's alarm is that of offset numbers
    }
  }
  // The value of a word that is a number below 0, as written.
  [[nodiscard]] std::optional<std::string> sign_of(const ir::Word& word) const {
    const ir::Expression& e = program_.at(word.value);
    if (e.op == ir::Operator::negate && program_.at(e.a).op == ir::Operator::constant && program_.at(e.a).value > 0.0)
      return text::format_shortest(-program_.at(e.a).value);
    if (e.op == ir::Operator::constant && e.value < 0.0) return text::format_shortest(e.value);
    return std::nullopt;
  }

  void machine_function(const ir::Code& code) {
    const auto& list = control_.machine_functions;
    if (list.empty() || code.function != Function::machine_function || code.number != ir::ExpressionId::none) return;
    if (std::ranges::find(list, code.argument) == list.end())
      findings_.add(unknown_machine_function, code.span, {fmt::format("M{}", code.argument)});
  }

  const ir::Program& program_;
  const ir::Control& control_;
  Findings& findings_;
};

}  // namespace

void check_values(const ir::Program& program, const ir::Control& control, Findings& findings) {
  ValueCheck check(program, control, findings);
  check.variables();
  for (const ir::Statement& statement : program.statements) check.statement(statement);
}

}  // namespace dripfeed::macro_b
