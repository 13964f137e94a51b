// Names are interned; a value is found by one look-up in a hash table.
#include "dialects/interpreter/state/shared_data.h"

#include <algorithm>

#include "dialects/ir/axis_letters.h"
#include "dialects/text/number.h"

namespace dripfeed::interpreter {

std::size_t SharedData::Hash::operator()(const Key& key) const {
  std::uint64_t h = key.id;
  for (const std::uint32_t index : key.indices) h = (h ^ index) * 0x9E37'79B9'7F4A'7C15ULL;
  return static_cast<std::size_t>(h ^ (h >> 32));
}

std::uint32_t SharedData::id_of(std::string_view name) {
  const auto next = static_cast<std::uint32_t>(names_.size());
  const auto [entry, added] = ids_.try_emplace(std::string(name), next);
  if (added) {
    names_.emplace_back(name);
    index_counts_.push_back(0);
  }
  return entry->second;
}

std::string SharedData::name_of_element(std::uint32_t id, const Indices& indices, std::uint32_t used) const {
  std::string name = names_[id];
  for (std::uint32_t i = 0; i < used && i < indices.size(); ++i) {
    name += i == 0 ? '[' : ',';
    name += std::to_string(indices[i]);
  }
  if (used > 0) name += ']';
  return name;
}

void SharedData::define(const ir::Program& program) {
  for (const ir::Statement& statement : program.statements) {
    if (statement.kind != ir::StatementKind::define) continue;
    const ir::Structure& list = program.structures[statement.payload];
    for (std::uint32_t i = 0; i < list.symbol_count; ++i) {
      const ir::Symbol& symbol = program.symbols[list.first_symbol + i];
      definitions_.try_emplace(
          id_of(program.strings.at(symbol.name)),
          SharedDefinition{.type = symbol.type,
                           .dimensions = {symbol.dimension1, symbol.dimension2, symbol.dimension3}});
    }
  }
}

const SharedDefinition* SharedData::definition_of(std::uint32_t id) const {
  const auto found = definitions_.find(id);
  return found == definitions_.end() ? nullptr : &found->second;
}

const SharedValue* SharedData::find(std::uint32_t id, const Indices& indices) const {
  const auto found = places_.find(Key{id, indices});
  return found == places_.end() ? nullptr : &values_[found->second];
}

std::uint32_t SharedData::place_of(std::uint32_t id, const Indices& indices) {
  const auto next = static_cast<std::uint32_t>(values_.size());
  const auto [entry, added] = places_.try_emplace(Key{id, indices}, next);
  if (added) {
    values_.emplace_back();
    entries_.push_back({id, indices, next});
  }
  return entry->second;
}

void SharedData::note_indices(std::uint32_t id, std::uint32_t used) {
  index_counts_[id] = std::max(index_counts_[id], used);
}

std::uint32_t SharedData::nameless() {
  values_.emplace_back();
  return static_cast<std::uint32_t>(values_.size() - 1);
}

void SharedData::set(std::string_view written, double value) {
  constexpr std::array<std::string_view, 5> kParts = {"TR", "FI", "RT", "SC", "MI"};
  const std::size_t bracket = std::min(written.find('['), written.size());
  const std::uint32_t id = id_of(written.substr(0, bracket));
  Indices indices{};
  std::uint32_t used = 0;
  std::string_view rest = written.substr(bracket);
  while (rest.size() > 1 && used < indices.size()) {
    rest.remove_prefix(1);
    const std::string_view part = rest.substr(0, rest.find_first_of(",]"));
    rest.remove_prefix(part.size());
    const std::size_t axis = part.size() == 1 ? ir::kAxisLetters.find(part) : std::string_view::npos;
    const auto named = std::ranges::find(kParts, part);
    if (axis != std::string_view::npos)
      indices[used++] = static_cast<std::uint32_t>(axis);
    else if (named != kParts.end())
      indices[used++] = static_cast<std::uint32_t>(named - kParts.begin());
    else
      indices[used++] = static_cast<std::uint32_t>(text::parse_integer(part).value_or(0));
    if (rest.starts_with(']')) break;
  }
  note_indices(id, used);
  at(place_of(id, indices)) = {.number = value, .text = {}, .has_text = false};
}

void SharedData::forget(std::uint32_t id, std::optional<std::uint32_t> first) {
  for (const Entry& entry : entries_)
    if (entry.id == id && (!first.has_value() || entry.indices[0] == *first)) values_[entry.place] = {};
}

}  // namespace dripfeed::interpreter
