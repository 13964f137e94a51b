// Reading the registers of the main program's frame after the run; frames of called programs are gone.
#include "dialects/interpreter/machine/variable_listing.h"

#include <algorithm>

#include "dialects/interpreter/arithmetic/arithmetic.h"

namespace dripfeed::interpreter {

namespace {

std::optional<double> shown(double value) {
  if (is_vacant(value)) return std::nullopt;
  return value + 0.0;  // never -0
}

std::string element_name(std::string_view name, const ir::Symbol& symbol, std::uint32_t element) {
  std::string result(name);
  if (symbol.dimension1 == 0) return result;
  const std::uint32_t columns = std::max<std::uint32_t>(symbol.dimension2, 1);
  const std::uint32_t layers = std::max<std::uint32_t>(symbol.dimension3, 1);
  result += '[' + std::to_string(element / layers / columns);
  if (symbol.dimension2 > 0) result += ',' + std::to_string(element / layers % columns);
  if (symbol.dimension3 > 0) result += ',' + std::to_string(element % layers);
  return result + ']';
}

}  // namespace

std::vector<VariableValue> list_variables(const VariableMap& variables, const CompiledProgram& main, Storage& storage,
                                          SharedData& shared) {
  std::vector<VariableValue> result;
  std::vector<std::pair<ir::Bank, std::uint32_t>> named = main.named_variables;
  std::ranges::sort(named);
  for (const VariableMap::Named& entry : variables.list()) {
    const double value = entry.kind == SlotKind::local ? storage.local_at(entry.index) : storage.global_at(entry.index);
    const bool is_named = std::ranges::binary_search(named, std::pair(entry.bank, entry.number));
    if (is_named || (!is_vacant(value) && value != 0.0))
      result.push_back({variable_name(entry.bank, entry.number), shown(value), std::nullopt});
  }
  for (std::size_t s = 0; s < main.symbols.size(); ++s) {
    const ir::Symbol& symbol = main.source->symbols[s];
    const std::string_view name = main.source->strings.at(symbol.name);
    const std::uint32_t count = std::max<std::uint32_t>(symbol.dimension1, 1) *
                                std::max<std::uint32_t>(symbol.dimension2, 1) *
                                std::max<std::uint32_t>(symbol.dimension3, 1);
    if (symbol.is_global) continue;
    for (std::uint32_t n = 0; n < count; ++n) {
      const std::uint32_t slot = main.symbols[s].slot + n;
      if (symbol.type == ir::ValueType::string)
        result.push_back({element_name(name, symbol, n), std::nullopt, storage.string_at(slot)});
      else
        result.push_back({element_name(name, symbol, n), shown(storage.frame_at(slot)), std::nullopt});
    }
  }
  for (const SharedData::Entry& entry : shared.entries()) {
    SharedValue& value = shared.at(entry.place);
    if (!value.has_text && is_vacant(value.number)) continue;
    const std::string name = shared.name_of_element(entry.id, entry.indices, shared.index_count_of(entry.id));
    if (value.has_text)
      result.push_back({name, std::nullopt, value.text});
    else
      result.push_back({name, shown(value.number), std::nullopt});
  }
  return result;
}

}  // namespace dripfeed::interpreter
