// Looking parameters up and saying their values.
#include "dialects/family/model.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "dialects/ir/cycle.h"
#include "dialects/text/number.h"

namespace dripfeed::family {

namespace {

// A value that went to stored units and back (4.7244 in) is shown without the last bits of that conversion.
constexpr int kShownDecimals = 9;
constexpr double kStepTolerance = 1e-6;  // of a step: values are decimals

std::string in_unit(const Parameter& parameter, double stored) {
  std::string out =
      text::format_fixed(parameter.unit == nullptr ? stored : stored / parameter.unit->factor, kShownDecimals);
  out.erase(out.find_last_not_of('0') + 1);
  if (out.ends_with('.')) out.pop_back();
  return out;
}

}  // namespace

bool begins_taps(const Step& step) {
  const auto is = [&](ir::DrillCycle cycle) { return step.number == static_cast<std::int32_t>(cycle); };
  return step.kind == StepKind::drill_begin && (is(ir::DrillCycle::tap_right) || is(ir::DrillCycle::tap_left));
}

const NativeVerb::Row* NativeVerb::find(std::string_view dialect) const {
  const auto row = std::ranges::find(rows, dialect, &Row::dialect);
  return row == rows.end() ? nullptr : &*row;
}

bool takes_feed_away(const Step& step) { return step.kind == StepKind::thread || begins_taps(step); }

bool is_number_of_cycle(ir::Address address) { return address == ir::Address::f || address == ir::Address::p; }

const Parameter* Family::find_parameter(std::string_view parameter_name) const {
  const auto found = std::ranges::find(parameters, parameter_name, &Parameter::name);
  return found == parameters.end() ? nullptr : &*found;
}

const PointParameter* Family::find_points(std::string_view points_name) const {
  const auto found = std::ranges::find(points, points_name, &PointParameter::name);
  return found == points.end() ? nullptr : &*found;
}

const UserFunction* Family::find_function(std::string_view routine_name) const {
  const auto row = function_rows.find(routine_name);
  return row == function_rows.end() ? nullptr : &functions[row->second];
}

const Subprogram* Family::find_subprogram(std::string_view routine_name) const {
  const auto row = subprogram_rows.find(routine_name);
  return row == subprogram_rows.end() ? nullptr : &subprograms[row->second];
}

void Family::add(UserFunction function) {
  function_rows.emplace(function.name, functions.size());
  functions.push_back(std::move(function));
}

void Family::add(Subprogram subprogram) {
  subprogram_rows.emplace(subprogram.name, subprograms.size());
  subprograms.push_back(std::move(subprogram));
}

const List* Family::find_list(ir::SymbolId symbol) const {
  const auto found = std::ranges::find(lists, symbol, &List::symbol);
  return found == lists.end() ? nullptr : &*found;
}

std::string kind_of(const Parameter& parameter) {
  switch (parameter.kind) {
    case ParameterKind::number: return std::string(parameter.quantity);
    case ParameterKind::list: return fmt::format("list of {}", parameter.quantity);
    case ParameterKind::choice: return "choice";
    case ParameterKind::yes_no: return "yes_no";
    case ParameterKind::tool: return "tool";
    case ParameterKind::text: return "text";
  }
  return {};
}

std::string format_standard(const Parameter& parameter) {
  if (!parameter.choices.empty()) return parameter.choices[static_cast<std::size_t>(parameter.standard)];
  if (parameter.kind == ParameterKind::text) return parameter.standard_text;
  if (parameter.kind != ParameterKind::list) return format_value(parameter, parameter.standard);
  std::string out;
  for (const double one : parameter.standards) out += (out.empty() ? "" : ", ") + format_value(parameter, one);
  return out;
}

std::string format_value(const Parameter& parameter, double stored) {
  const std::string number = in_unit(parameter, stored);
  return parameter.unit == nullptr ? number : fmt::format("{} {}", number, parameter.unit->name);
}

std::optional<ValueFault> fault_of_value(const Parameter& parameter, double stored, const std::string& written) {
  if (!(stored >= parameter.low && stored <= parameter.high))
    return ValueFault{text::DiagnosticId::family_value_out_of_range,
                      {parameter.name, format_value(parameter, stored), in_unit(parameter, parameter.low),
                       format_value(parameter, parameter.high)}};
  if (parameter.whole && !is_whole(stored))
    return ValueFault{text::DiagnosticId::family_wrong_unit,
                      {fmt::format("{} = {}", parameter.name, written), "a fraction", "a whole number"}};
  if (parameter.step == 0.0) return std::nullopt;
  const double steps = (stored - parameter.low) / parameter.step;
  if (std::abs(steps - std::round(steps)) <= kStepTolerance) return std::nullopt;
  return ValueFault{text::DiagnosticId::family_value_between_steps,
                    {parameter.name, format_value(parameter, stored), format_value(parameter, parameter.step),
                     format_value(parameter, parameter.low)}};
}

bool is_whole(double value) { return std::trunc(value) == value; }

}  // namespace dripfeed::family
