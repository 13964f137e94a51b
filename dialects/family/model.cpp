// Looking parameters up and saying their values.
#include "dialects/family/model.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "dialects/text/number.h"

namespace dripfeed::family {

namespace {

// A value that went to stored units and back (4.7244 in) is shown without the last bits of that way.
constexpr int kShownDecimals = 9;

std::string in_unit(const Parameter& parameter, double stored) {
  std::string out =
      text::format_fixed(parameter.unit == nullptr ? stored : stored / parameter.unit->factor, kShownDecimals);
  out.erase(out.find_last_not_of('0') + 1);
  if (out.ends_with('.')) out.pop_back();
  return out;
}

}  // namespace

const Parameter* Family::find_parameter(std::string_view parameter_name) const {
  const auto found = std::ranges::find(parameters, parameter_name, &Parameter::name);
  return found == parameters.end() ? nullptr : &*found;
}

std::string format_value(const Parameter& parameter, double stored) {
  const std::string number = in_unit(parameter, stored);
  return parameter.unit == nullptr ? number : fmt::format("{} {}", number, parameter.unit->name);
}

std::vector<std::string> range_arguments(const Parameter& parameter, double stored) {
  return {parameter.name, format_value(parameter, stored), in_unit(parameter, parameter.low),
          format_value(parameter, parameter.high)};
}

bool is_whole(double value) { return std::trunc(value) == value; }

}  // namespace dripfeed::family
