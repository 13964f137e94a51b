// Values that people write for parameters.
#include <algorithm>
#include <string_view>
#include <unordered_map>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "dialects/family/binder.h"
#include "dialects/family/text_value.h"

namespace dripfeed::family {

using text::DiagnosticId;

void Binder::parameters() {
  std::unordered_map<std::string_view, const Parameter*> by_name;
  for (const Parameter& parameter : family_.parameters) {
    if (parameter.kind == ParameterKind::list) {
      given_lists_.emplace(parameter.symbol, parameter.standards);
    } else {
      know(parameter.symbol, parameter.standard);
    }
    if (parameter.kind == ParameterKind::text) result_.bound.texts.emplace(parameter.symbol, parameter.standard_text);
    by_name.try_emplace(parameter.name, &parameter);
  }
  std::unordered_map<std::string_view, const Override*> given_names;
  const std::vector<Override> overrides = with_axes();
  for (const Override& given : overrides) {
    if (const auto [earlier, is_first] = given_names.try_emplace(given.name, &given); !is_first) {
      const auto of = by_name.find(given.name);
      report(DiagnosticId::family_given_twice, of == by_name.end() ? text::Span{} : of->second->span,
             {given.name, earlier->second->value, given.value});
      continue;
    }
    if (const auto found = by_name.find(given.name); found != by_name.end()) {
      set(*found->second, given.value);
    } else {
      report(DiagnosticId::family_unknown_parameter, {}, {given.name});
    }
  }
  for (const PointParameter& points : family_.points) check_axes(points);
}

std::vector<Override> Binder::with_axes() {
  std::vector<Override> out;
  for (const Override& given : overrides_) {
    const PointParameter* points = family_.find_points(given.name);
    if (points == nullptr) {
      out.push_back(given);
      continue;
    }
    const std::optional<std::vector<std::string>> axes = axes_of_points(given.value, points->axes.size());
    if (!axes)
      report(DiagnosticId::family_syntax, points->span,
             {fmt::format("{}: '{}' are not points of {} numbers, such as ({})", points->name, given.value,
                          points->axes.size(), standard_point(*points))});
    for (std::size_t i = 0; axes && i < axes->size(); ++i)
      out.push_back({family_.parameters[points->first + i].name, (*axes)[i]});
  }
  return out;
}

std::string Binder::standard_point(const PointParameter& points) const {
  std::string out;
  for (std::size_t i = 0; i < points.axes.size(); ++i) {
    const Parameter& axis = family_.parameters[points.first + i];
    out += fmt::format("{}{}", i == 0 ? "" : ", ", format_value(axis, axis.standards.front()));
  }
  return out;
}

void Binder::check_axes(const PointParameter& points) {
  const auto count = [&](std::size_t row) { return given_lists_.at(family_.parameters[row].symbol).size(); };
  for (std::size_t row = points.first + 1; row < points.first + points.axes.size(); ++row)
    if (count(row) != count(points.first))
      report(DiagnosticId::family_syntax, points.span,
             {fmt::format("{} has {} numbers and {} has {}: a point has one of each",
                          family_.parameters[points.first].name, count(points.first), family_.parameters[row].name,
                          count(row))});
}

void Binder::set(const Parameter& parameter, const std::string& written) {
  switch (parameter.kind) {
    case ParameterKind::number:
    case ParameterKind::tool:
      if (const std::optional<double> value = number_of(parameter, written)) know(parameter.symbol, *value);
      return;
    case ParameterKind::choice:
    case ParameterKind::yes_no: return set_choice(parameter, written);
    case ParameterKind::list: return set_list(parameter, written);
    case ParameterKind::text: return set_text(parameter, written);
  }
}

void Binder::set_text(const Parameter& parameter, const std::string& written) {
  std::string fault = fault_of_text(written);
  if (fault.empty() &&
      (std::cmp_less(written.size(), parameter.fewest) || std::cmp_greater(written.size(), parameter.most)))
    fault = fmt::format("the text has {} characters, {} to {} are allowed", written.size(), parameter.fewest,
                        parameter.most);
  if (!fault.empty())
    return report(DiagnosticId::family_syntax, parameter.span, {fmt::format("{}: {}", parameter.name, fault)});
  result_.bound.texts.insert_or_assign(parameter.symbol, written);
}

void Binder::set_choice(const Parameter& parameter, const std::string& written) {
  const auto place = std::ranges::find(parameter.choices, written);
  if (place != parameter.choices.end())
    return know(parameter.symbol, static_cast<double>(place - parameter.choices.begin()));
  report(DiagnosticId::family_syntax, parameter.span,
         {fmt::format("{}: '{}' is none of {}", parameter.name, written, fmt::join(parameter.choices, ", "))});
}

void Binder::set_list(const Parameter& parameter, const std::string& written) {
  std::vector<double> numbers;
  for (std::string_view rest = written; !rest.empty();) {
    const std::string_view one = rest.substr(0, rest.find(','));
    rest.remove_prefix(std::min(rest.size(), one.size() + 1));
    const std::optional<double> number = number_of(parameter, std::string(one));
    if (!number) return;
    numbers.push_back(*number);
  }
  const auto given = static_cast<std::int32_t>(numbers.size());
  if (given >= parameter.fewest && given <= parameter.most) {
    given_lists_.insert_or_assign(parameter.symbol, std::move(numbers));
    return;
  }
  report(DiagnosticId::family_syntax, parameter.span,
         {fmt::format("{} has {} numbers, {} to {} are allowed", parameter.name, given, parameter.fewest,
                      parameter.most)});
}

std::optional<double> Binder::number_of(const Parameter& parameter, const std::string& written) {
  WrittenValue read = read_value(parameter, written);
  if (read.fault) report(read.fault->id, parameter.span, std::move(read.fault->arguments));
  return read.fault ? std::nullopt : std::optional(read.stored);
}

std::optional<std::vector<std::string>> axes_of_points(std::string_view written, std::size_t axes) {
  const auto trim = [&] { written.remove_prefix(std::min(written.find_first_not_of(" \t"), written.size())); };
  std::vector<std::string> out(axes);
  for (trim(); !written.empty(); trim()) {
    const std::size_t close = written.find(')');
    if (written.front() != '(' || close == std::string_view::npos) return std::nullopt;
    std::string_view point = written.substr(1, close - 1);
    if (static_cast<std::size_t>(std::ranges::count(point, ',')) + 1 != axes) return std::nullopt;
    for (std::string& axis : out) {
      const std::string_view number = point.substr(0, point.find(','));
      point.remove_prefix(std::min(point.size(), number.size() + 1));
      axis += fmt::format("{}{}", axis.empty() ? "" : ", ", number);
    }
    written.remove_prefix(close + 1);
    trim();
    if (written.empty()) return out;
    if (written.front() != ',') return std::nullopt;
    written.remove_prefix(1);
  }
  return std::nullopt;  // nothing, or nothing after a comma
}

WrittenValue read_value(const Parameter& parameter, const std::string& written) {
  const auto fault = [](DiagnosticId id, std::vector<std::string> arguments) {
    return WrittenValue{.stored = 0.0, .fault = ValueFault{id, std::move(arguments)}};
  };
  const std::optional<Quantity> quantity = parse_quantity(written);
  if (!quantity)
    return fault(DiagnosticId::family_syntax,
                 {fmt::format("{}: '{}' is not a number with a unit", parameter.name, written)});
  const std::string named = fmt::format("{} = {}", parameter.name, written);
  const Dimension dimension = quantity->unit == nullptr ? kRatio : quantity->unit->dimension;
  if (quantity->unit == nullptr && parameter.dimension != kRatio)
    return fault(
        DiagnosticId::family_missing_unit,
        {named, fmt::format("{}, such as {} {}", describe(parameter.dimension), written, parameter.unit->name)});
  if (dimension != parameter.dimension)
    return fault(DiagnosticId::family_wrong_unit, {named, describe(dimension), describe(parameter.dimension)});
  return {.stored = quantity->stored(), .fault = fault_of_value(parameter, quantity->stored(), written)};
}

}  // namespace dripfeed::family
