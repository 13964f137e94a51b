// The numbers come from the pass that gave them, the meanings from the family.
#include "dialects/compile/render/legend.h"

#include <algorithm>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "dialects/compile/dialect/dialect.h"
#include "dialects/family/unit.h"

namespace dripfeed::compile {

namespace {

// By bank and number, as a program writes them.
std::string written(ir::Bank bank, std::uint32_t number) {
  return fmt::format("{}{}", bank == ir::Bank::r ? "R" : "#", number);
}

// A name that the family declares; nothing for those of its program.
std::optional<LegendEntry> declared(const family::BoundFamily& bound, ir::SymbolId symbol) {
  const family::Family& family = *bound.family;
  LegendEntry out;
  const auto parameter = std::ranges::find(family.parameters, symbol, &family::Parameter::symbol);
  if (parameter != family.parameters.end()) {
    out = {.variable = {},
           .name = parameter->name,
           .meaning = parameter->text,
           .unit = std::string(family::stored_unit(parameter->dimension)),
           .kind = LegendKind::parameter};
  } else {
    const auto named = std::ranges::find(family.definitions, symbol, &family::Definition::symbol);
    if (named == family.definitions.end()) return std::nullopt;
    out = {.variable = {},
           .name = std::string(family.arena.strings.at(family.arena.at(symbol).name)),
           .meaning = {},
           .unit = {},
           .kind = LegendKind::derived};
  }
  if (family.find_list(symbol) == nullptr) out.value = bound.values[static_cast<std::size_t>(symbol)];
  return out;
}

}  // namespace

std::vector<LegendEntry> legend_of(const family::BoundFamily& bound, const ir::RaiseResult& raised) {
  std::vector<ir::PlacedName> placed = raised.placed;
  std::ranges::sort(placed, {}, [](const ir::PlacedName& one) { return std::pair(one.first, one.symbol); });
  std::vector<LegendEntry> out;
  for (const ir::PlacedName& one : placed) {
    LegendEntry entry = declared(bound, one.symbol).value_or(LegendEntry{});
    if (entry.name.empty()) entry.name = raised.program.strings.at(raised.program.at(one.symbol).name);
    entry.variable = written(one.bank, one.first);
    entry.count = one.count;
    out.push_back(std::move(entry));
  }
  return out;
}

std::vector<LegendEntry> legend_of_bindings(const family::BoundFamily& bound) {
  std::vector<LegendEntry> out;
  for (const family::Binding& one : bound.family->bindings) {
    std::optional<LegendEntry> entry = declared(bound, one.symbol);
    if (!entry) continue;
    entry->variable = one.target;
    // The program may take the number in another unit than the family's: it stands in the text as it was written.
    entry->unit.clear();
    entry->value.reset();
    out.push_back(std::move(*entry));
  }
  return out;
}

void keep_parameters(std::vector<LegendEntry>& legend, const std::string& text, const ir::Control& control) {
  const ir::ReadResult read = find_dialect(control.dialect)->read(text::Source("rendered", text), control);
  std::set<std::string> named;
  for (const ir::Variable& v : read.program.variables)
    if (v.bank != ir::Bank::named && v.index == ir::ExpressionId::none) named.insert(written(v.bank, v.number));
  std::erase_if(legend, [&](const LegendEntry& one) {
    return one.kind != LegendKind::parameter || (one.count == 1 && !named.contains(one.variable));
  });
}

}  // namespace dripfeed::compile
