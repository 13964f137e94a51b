// Work offsets by L2 and L20, tool offsets by L10 to L13 on mills and by P alone on lathes.
#include "dialects/interpreter/block/data_setting.h"

#include <cmath>

#include "dialects/interpreter/state/axis_words.h"
#include "dialects/ir/axis_letters.h"
#include "dialects/text/number.h"

namespace dripfeed::interpreter {

namespace {

using ir::Address;

constexpr std::uint32_t kFirstOffset = 5201;    // external; G54 … follow
constexpr std::uint32_t kFirstExtended = 7001;  // G54.1 P1
constexpr std::uint32_t kOffsetStep = 20;

// L of a mill's tool offset memory, and the number before that of tool 1.
struct ToolRow {
  int l;
  std::uint32_t before;
};
constexpr ToolRow kToolRows[] = {{1, 2000}, {10, 11000}, {11, 10000}, {12, 13000}, {13, 12000}};

// Of a lathe: wear, then geometry (P from 10001).
struct LatheRow {
  Address address;
  std::uint32_t wear;
  std::uint32_t geometry;
};
constexpr LatheRow kLatheRows[] = {{Address::x, 2000, 2700}, {Address::z, 2100, 2800}, {Address::r, 2200, 2900},
                                   {Address::q, 2300, 2300}, {Address::u, 2000, 2700}, {Address::w, 2100, 2800},
                                   {Address::c, 2200, 2900}};
constexpr std::uint32_t kGeometry = 10000;

double written(const PlainBlock& block, const BlockRules& rules, Address address) {
  const bool counted = (block.in_increments & bit_of(address)) != 0;
  return counted ? block.at(address) / rules.increments_per_mm : block.at(address);
}

std::uint32_t number_in(const PlainBlock& block, Address address, double last) {
  const double value = block.has(address) ? block.at(address) : 0.0;
  return value >= 0.0 && value <= last ? static_cast<std::uint32_t>(value) : 0;
}

// Axes are counted as the control has them; that order is the trace's, with gaps closed.
std::uint32_t axis_index(const BlockRules& rules, std::size_t axis) {
  std::uint32_t index = 0;
  for (std::size_t before = 0; before < axis; ++before) {
    const auto address = static_cast<Address>(ir::kAxisLetters[before] - 'A');
    const bool has = (rules.axis_addresses & bit_of(address)) != 0 && !rules.axis_words[index_of(address)].incremental;
    if (has) ++index;
  }
  return index;
}

}  // namespace

DataValues data_values(const PlainBlock& block, const BlockRules& rules, const ModalState& state, bool lathe) {
  DataValues result;
  const bool has_l = block.has(Address::l);
  const int l = has_l ? static_cast<int>(block.at(Address::l)) : 0;
  result.name = has_l ? "G10 L" + text::format_shortest(block.at(Address::l)) : "G10 P";
  const std::uint32_t p = number_in(block, Address::p, 99999.0);
  if (l == 2 || l == 20) {
    if (l == 2 ? p > 6 : p < 1 || p > 300) return result;
    const std::uint32_t first = l == 2 ? kFirstOffset + kOffsetStep * p : kFirstExtended + kOffsetStep * (p - 1);
    for_each_axis_word(block, rules, state.modes, !state.modes.absolute,
                       [&](std::size_t axis, double value, bool incremental) {
                         const bool rotary = axis >= 3 && axis <= 5;
                         const double own = state.modes.inch && !rotary ? value / 25.4 : value;
                         result.values.push_back({first + axis_index(rules, axis), own, incremental, l == 20});
                       });
    return result;
  }
  if (lathe && !has_l && p > 0) {
    const bool geometry = p > kGeometry;
    for (const LatheRow& row : kLatheRows) {
      if (!block.has(row.address)) continue;
      const bool adds = row.address == Address::u || row.address == Address::w || row.address == Address::c;
      const double value = row.address == Address::q ? block.at(row.address) : written(block, rules, row.address);
      result.values.push_back({(geometry ? row.geometry + p - kGeometry : row.wear + p), value, adds});
    }
    return result;
  }
  for (const ToolRow& row : kToolRows)
    if (row.l == l && p > 0 && block.has(Address::r))
      result.values.push_back({row.before + p, written(block, rules, Address::r), !state.modes.absolute});
  return result;
}

}  // namespace dripfeed::interpreter
