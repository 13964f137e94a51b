// What the text states counts first; what holds at power-on counts where a person has looked at the machine.
#include "dialects/compile/native/native_unit.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "dialects/compile/native/native_overwritten.h"

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

// In inches by the text's own words; nothing where they do not say it. Calls of programs that are not in the text are
// taken to leave it.
std::optional<bool> inches_stated(const facts::Facts& facts, bool of_feeds) {
  const facts::Known<facts::Setting>& unit = facts[facts::Mode::unit];
  const bool silent = unit.origin == facts::kPowerOn || (of_feeds && unit.value.argument != 0);
  if (!unit.agrees() || silent) return std::nullopt;
  return unit.value.function == Function::unit_inch;
}

bool is_feed(Dimension dimension) { return dimension == family::kFeedPerMin || dimension == family::kFeedPerRev; }

}  // namespace

// What the words that take a number say of it.
struct NativeUnits::UseUnits {
  std::vector<std::uint32_t> inch = {};
  std::vector<std::uint32_t> mm = {};
  std::vector<std::uint32_t> either = {};  // by the path that leads there
};

// In effect at the statement by the text's own words. A header stands before the first code: then the only unit that
// the text states anywhere is meant.
std::optional<facts::Setting> NativeUnits::stated(std::uint32_t statement) const {
  const facts::Facts* facts = resolved_.before(statement);
  if (facts != nullptr) {
    const facts::Known<facts::Setting>& unit = (*facts)[facts::Mode::unit];
    if (unit.is_certain() && unit.origin != facts::kPowerOn) return unit.value;
    // Stated differently on the paths that lead here.
    if (unit.other_origin != facts::kNoStatement && unit.value.function != unit.other.function) return std::nullopt;
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

NativeUnits::UseUnits NativeUnits::units_of(const std::vector<WordUse>& uses) const {
  UseUnits out;
  for (const WordUse& use : uses) {
    const auto row = std::ranges::find(kInches, use.dimension, &InchRow::dimension);
    const std::optional<facts::Facts> facts = resolved_.at(use.statement);
    if (row == std::end(kInches) || !facts) continue;
    const facts::Known<facts::Setting>& unit = (*facts)[facts::Mode::unit];
    const bool differs = unit.origin != facts::kPowerOn && unit.other_origin != facts::kNoStatement &&
                         unit.other_origin != facts::kPowerOn && unit.value.function != unit.other.function;
    const std::optional<bool> inch = inches_stated(*facts, row->is_feed);
    if (differs && !(row->is_feed && (unit.value.argument != 0 || unit.other.argument != 0)))
      out.either.push_back(use.statement);
    else if (inch)
      (*inch ? out.inch : out.mm).push_back(use.statement);
  }
  return out;
}

// One number for two units.
std::optional<NativeUnit> NativeUnits::mixed(std::uint32_t statement, const UseUnits& uses, bool of_feeds) const {
  const auto refused = [](std::string why, std::vector<std::uint32_t> statements) {
    return NativeUnit{.factor = std::nullopt, .why = std::move(why), .statements = std::move(statements)};
  };
  if (!uses.either.empty())
    return refused(fmt::format("{} reads it in inches or in millimetres, by the path that leads there",
                               lines_of(program_, uses.either)),
                   uses.either);
  if (!uses.inch.empty() && !uses.mm.empty())
    return refused(fmt::format("it is read in inches in {} and in millimetres in {}", lines_of(program_, uses.inch),
                               lines_of(program_, uses.mm)),
                   {uses.inch.front(), uses.mm.front()});
  const std::vector<std::uint32_t>& read = uses.inch.empty() ? uses.mm : uses.inch;
  const facts::Facts* facts = resolved_.before(statement);
  const std::optional<bool> set = facts == nullptr ? std::nullopt : inches_stated(*facts, of_feeds);
  if (read.empty() || !set || *set == !uses.inch.empty()) return std::nullopt;
  return refused(
      fmt::format("{} sets it in {}, and {} reads it in {}", lines_of(program_, {statement}),
                  *set ? "inches" : "millimetres", lines_of(program_, read), *set ? "millimetres" : "inches"),
      {statement, read.front()});
}

NativeUnit NativeUnits::of(Dimension dimension, const family::Unit* written, std::uint32_t statement,
                           const std::vector<WordUse>& uses) const {
  const auto row = std::ranges::find(kInches, dimension, &InchRow::dimension);
  if (row == std::end(kInches)) {
    if (dimension == family::kTime) return {.factor = written == nullptr ? 1.0 : written->factor, .why = {}};
    if (dimension == family::kRatio || !family::stored_unit(dimension).empty()) return {.factor = 1.0, .why = {}};
    return {.factor = std::nullopt, .why = fmt::format("a value in {} has no form in a program", describe(dimension))};
  }
  for (const WordUse& use : uses) {
    if (!is_feed(dimension) || !is_feed(use.dimension) || !use.mode_known || use.dimension == dimension) continue;
    return {.factor = std::nullopt,
            .why = fmt::format("it is {}, and {} reads it as {}", describe(dimension),
                               lines_of(program_, {use.statement}), describe(use.dimension)),
            .statements = {use.statement}};
  }
  const UseUnits units = units_of(uses);
  if (std::optional<NativeUnit> fault = mixed(statement, units, row->is_feed)) return *std::move(fault);
  std::optional<bool> inch = inches(statement, row->is_feed);
  if (!units.inch.empty() || !units.mm.empty()) inch = !units.inch.empty();
  if (inch) return {.factor = *inch ? row->factor : 1.0, .why = {}};
  return {
      .factor = std::nullopt,
      .why = fmt::format("neither the program nor the machine's profile states whether {} of its line {} are in inches",
                         row->is_feed ? "feeds" : "lengths", program_.statements[statement].line)};
}

}  // namespace dripfeed::compile
