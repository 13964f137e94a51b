// What the text states counts first; what holds at power-on counts where somebody has looked at the machine.
#include "dialects/compile/native_unit.h"

#include <algorithm>

#include <fmt/format.h>

namespace dripfeed::compile {

namespace {

using family::Dimension;
using ir::Function;

// What one of the program's units is worth when it is in inches.
struct InchRow {
  Dimension dimension;
  double factor;
  bool is_feed;
};
constexpr double kInch = 25.4;
constexpr InchRow kInches[] = {
    {family::kLength, kInch, false},
    {family::kFeedPerMin, kInch, true},
    {family::kFeedPerRev, kInch, true},
    {family::kSurfaceSpeed, 0.3048, true},  // feet per minute
};

bool is_unit(const ir::Code& code) {
  return code.function == Function::unit_inch || code.function == Function::unit_mm;
}

}  // namespace

// In effect at the statement by the text's own words. A header stands before the first code: then the only unit that
// the text states anywhere is meant.
std::optional<facts::Setting> NativeUnits::stated(std::uint32_t statement) const {
  const facts::Facts* facts = resolved_.before(statement);
  if (facts != nullptr) {
    const facts::Known<facts::Setting>& unit = (*facts)[facts::Mode::unit];
    if (unit.is_certain() && unit.origin != facts::kPowerOn) return unit.value;
    // Stated differently on the paths that lead here.
    if (unit.other_origin != facts::kNobody && unit.value.function != unit.other.function) return std::nullopt;
  }
  std::optional<facts::Setting> only;
  for (const ir::Code& code : program_.codes) {
    if (!is_unit(code)) continue;
    const facts::Setting setting{.function = code.function, .argument = code.argument};
    if (only && *only != setting) return std::nullopt;
    only = setting;
  }
  return only;
}

std::optional<bool> NativeUnits::inches(std::uint32_t statement, bool of_feeds) const {
  const ir::Semantics& s = control_.semantics;
  const std::optional<facts::Setting> unit = stated(statement);
  // G70 and G71 of SINUMERIK leave feeds in the basic system, which the machine has.
  if (unit && (!of_feeds || unit->argument == 0)) return unit->function == Function::unit_inch;
  const bool changes = std::ranges::any_of(
      program_.codes, [of_feeds](const ir::Code& code) { return is_unit(code) && (!of_feeds || code.argument == 0); });
  if (changes || !s.power_on_known) return std::nullopt;
  const facts::Facts* facts = resolved_.before(statement);
  const bool inherited = facts == nullptr || (*facts)[facts::Mode::unit].inherited;
  return inherited ? std::nullopt : std::optional(s.power_on_unit == Function::unit_inch);
}

NativeUnit NativeUnits::of(Dimension dimension, const family::Unit* written, std::uint32_t statement) const {
  const auto row = std::ranges::find(kInches, dimension, &InchRow::dimension);
  if (row == std::end(kInches)) {
    if (dimension == family::kTime) return {.factor = written == nullptr ? 1.0 : written->factor, .why = {}};
    if (dimension == family::kRatio || !family::stored_unit(dimension).empty()) return {.factor = 1.0, .why = {}};
    return {.factor = std::nullopt, .why = fmt::format("a value in {} has no form in a program", describe(dimension))};
  }
  const std::optional<bool> inch = inches(statement, row->is_feed);
  if (inch) return {.factor = *inch ? row->factor : 1.0, .why = {}};
  return {
      .factor = std::nullopt,
      .why = fmt::format("neither the program nor the machine's profile says whether {} of its line {} are in inches",
                         row->is_feed ? "feeds" : "lengths", program_.statements[statement].line)};
}

}  // namespace dripfeed::compile
