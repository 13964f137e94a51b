// What the variables of a rendered macro mean, as data: for who shows their live values.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "dialects/family/bind.h"
#include "dialects/ir/control.h"
#include "dialects/ir/stage.h"

namespace dripfeed::compile {

// parameter: people may change it at the control; derived: it follows from parameters, before the first move;
// computed: the program changes it while it runs.
enum class LegendKind : std::uint8_t { parameter, derived, computed };
inline constexpr std::array<std::string_view, 3> kLegendKindNames = {"parameter", "derived", "computed"};

struct LegendEntry {
  std::string variable;     // "#100", "R8": the first of `count` in a row
  std::uint32_t count = 1;  // more: a list
  std::string name;         // in the family
  std::string meaning;      // the parameter's text; may be empty
  std::string unit;         // of the number in the variable, "mm"; empty: none, or not known
  LegendKind kind = LegendKind::computed;
  std::optional<double> value = {};  // as it was rendered; nothing for lists and for what is computed
};

// In the order of their numbers. A variable that two names share, one after the other, has an entry for each.
std::vector<LegendEntry> legend_of(const family::BoundFamily& bound, const ir::RaiseResult& raised);
// Of a native program that is kept: what its parameters are bound to.
std::vector<LegendEntry> legend_of_bindings(const family::BoundFamily& bound);

// After the text was rewritten: only parameters stay where they were, and those that it still names. The number of
// another name may have become another value's. The text is read as a program of that control.
void keep_parameters(std::vector<LegendEntry>& legend, const std::string& text, const ir::Control& control);

}  // namespace dripfeed::compile
