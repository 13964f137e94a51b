// Variables in all their forms: #1, #[…], [#NAME], [#_ABSIO[n]], and the machine's parameters.
#include <algorithm>
#include <cmath>
#include <string>

#include <fmt/format.h>

#include "dialects/ir/alarm_details.h"
#include "dialects/macro_b/reader/parse_expression.h"
#include "dialects/macro_b/tables/variables.h"
#include "dialects/text/number.h"

namespace dripfeed::macro_b {

namespace {

using ir::ExpressionId;
using ir::Operator;
using ir::TokenKind;
using enum text::DiagnosticId;

constexpr double kHighestNumber = 99'999'999.0;

}  // namespace

std::optional<ir::Variable> ExpressionReader::variable() {
  ir::Variable result;
  const std::uint32_t begin = cursor_.span().begin;
  cursor_.advance();
  if (cursor_.kind() == TokenKind::number) {
    std::string_view digits = cursor_.text();
    if (grammar_.variables_have_parts) digits = digits.substr(0, digits.find('.'));
    if (digits.size() > 1 && digits.ends_with('.')) digits.remove_suffix(1);  // #504. is #504
    const auto written = text::parse_integer(digits);
    if (!written || static_cast<double>(*written) > kHighestNumber) {
      faults_.fail(variable_out_of_range, {begin, cursor_.span().end}, {"#" + std::string(cursor_.text())});
      return std::nullopt;
    }
    result.number = static_cast<std::uint32_t>(*written);
    cursor_.advance();
  } else if (cursor_.is_symbol('[')) {
    result.index = bracketed("#");
    if (faults_.failed()) return std::nullopt;
    const ir::Expression& index = program_.at(result.index);
    if (index.op == Operator::constant && index.value >= 1.0 && index.value <= kHighestNumber) {
      result.number = static_cast<std::uint32_t>(std::lround(index.value));
      result.index = ExpressionId::none;
    }
  } else if (const auto named = cursor_.kind() == TokenKind::name ? names_.find(cursor_.text()) : names_.end();
             named != names_.end()) {
    result.number = named->second;
    cursor_.advance();
  } else if (const NamedVariable* system = system_name(); system != nullptr) {
    if (!named_number(*system, result, begin)) return std::nullopt;
  } else if (cursor_.kind() == TokenKind::name) {
    check_unset_name({begin, cursor_.span().end});
    faults_.make_native("a variable with a name");
    cursor_.advance();
    // [#_ABSIO[n]]: the number belongs to the name.
    if (cursor_.is_symbol('[')) bracketed("#");
    if (faults_.failed()) return std::nullopt;
  } else {
    const bool doubled = cursor_.kind() == TokenKind::variable;
    // [#-A]: a name was to come; #[#] lacks a number.
    const std::string_view before = cursor_.whole_text().substr(0, begin);
    const bool is_name = !doubled && before.ends_with('[') && !before.ends_with("#[");
    faults_.fail(syntax_error, cursor_.span(),
                 {doubled ? "## is not allowed: write #[#…]" : "# needs the number of a variable"},
                 is_name ? ir::kNameOfVariable : ir::AlarmDetail::none);
    return std::nullopt;
  }
  result.span = {begin, cursor_.previous_end()};
  return result;
}

// [#NAME] that no SETVN of the text gave: another program may have done so. Names of the control's own begin with _.
void ExpressionReader::check_unset_name(text::Span span) {
  const std::string_view name = cursor_.text();
  if (name.starts_with('_')) return;
  if (name.size() > kLongestVariableName) {
    faults_.report(name_too_long, span,
                   {std::string(name), std::to_string(name.size()), std::to_string(kLongestVariableName)});
    return;
  }
  if (text::Diagnostic* one = faults_.report(unknown_name, span, {std::string(name)}))
    one->severity = text::Severity::warning;
}

const NamedVariable* ExpressionReader::system_name() const {
  if (cursor_.kind() != TokenKind::name) return nullptr;
  const auto row = std::ranges::find(grammar_.named_variables, cursor_.text(), &NamedVariable::name);
  return row == grammar_.named_variables.end() ? nullptr : &*row;
}

// [#_ABSIO[2]] is #5002.
bool ExpressionReader::named_number(const NamedVariable& system, ir::Variable& result, std::uint32_t begin) {
  cursor_.advance();
  result.number = system.first;
  if (!system.numbered) return true;
  if (!cursor_.is_symbol('[')) {
    faults_.fail(syntax_error, {begin, cursor_.previous_end()},
                 {fmt::format("#{} needs its number in brackets", system.name)}, ir::AlarmDetail::name_in_use);
    return false;
  }
  const ExpressionId index = bracketed("#");
  if (faults_.failed()) return false;
  const ir::Expression& value = program_.at(index);
  if (value.op == Operator::constant && value.value >= 1.0 && value.value <= kHighestNumber) {
    result.number = system.first + static_cast<std::uint32_t>(std::lround(value.value)) - 1;
    return true;
  }
  const text::Span span = {begin, cursor_.previous_end()};
  const ExpressionId before = program_.add_constant(static_cast<double>(system.first) - 1.0, span);
  result.index = program_.add_operator(Operator::add, before, index, span);
  return true;
}

// PRM[n], PRM[n,bit], PRM[n]/[axis], PRM[n,bit]/[axis]: what the machine's parameters hold is an input of a run, by the
// names PRM[n], PRM[n,bit], PRM_OF_AXIS[n,axis] and PRM_OF_AXIS[n,axis,bit].
ExpressionId ExpressionReader::parameter_value(ExpressionId number, ExpressionId bit, std::uint32_t begin) {
  ir::Variable parameter;
  parameter.bank = ir::Bank::system;
  parameter.number = ir::kNoIndex;  // no row of the control's table
  parameter.index = number;
  parameter.index2 = bit;
  const bool of_axis = cursor_.is_symbol('/') && cursor_.peek().kind == TokenKind::symbol &&
                       cursor_.whole_text()[cursor_.peek().span.begin] == '[';
  if (of_axis) {
    cursor_.advance();
    parameter.index2 = bracketed("PRM");
    parameter.index3 = bit;
  }
  if (faults_.failed()) return ExpressionId::none;
  parameter.name = program_.strings.add(of_axis ? kParameterOfAxis : kParameter);
  parameter.span = {begin, cursor_.previous_end()};
  return program_.add_variable(parameter);
}

}  // namespace dripfeed::macro_b
