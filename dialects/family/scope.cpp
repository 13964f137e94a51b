// A short list searched from its end: families have tens of names, not thousands.
#include "dialects/family/scope.h"

#include <algorithm>
#include <numeric>

namespace dripfeed::family {

const Scope::Name* Scope::find(std::string_view name) const {
  const auto found = std::ranges::find_if(names_, [name](const Name& n) { return n.visible && n.name == name; });
  return found == names_.end() ? nullptr : &*found;
}

ir::SymbolId Scope::define(ir::Program& arena, std::string_view name, Dimension dimension, text::Span span) {
  Name added{std::string(name), ir::SymbolId::none, dimension, span, true};
  // Two loops over `t` are one variable at the control.
  const auto closed = std::ranges::find(names_, name, &Name::name);
  if (closed != names_.end()) {
    added.symbol = closed->symbol;
  } else {
    ir::Symbol symbol;
    symbol.name = arena.strings.add(name);
    symbol.span = span;
    added.symbol = arena.add(symbol);
  }
  names_.push_back(added);
  return added.symbol;
}

std::string_view Scope::nearest(std::string_view name) const {
  std::string_view best;
  std::size_t best_distance = name.size() / 3 + 2;  // one change in three letters, and one more
  for (const Name& candidate : names_) {
    if (!candidate.visible) continue;
    const std::size_t distance = edit_distance(name, candidate.name);
    if (distance < best_distance) {
      best_distance = distance;
      best = candidate.name;
    }
  }
  return best;
}

void Scope::close() {
  for (std::size_t i = marks_.back(); i < names_.size(); ++i) names_[i].visible = false;
  marks_.pop_back();
}

std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i + 1;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({replaced, row[j] + 1, row[j + 1] + 1});
    }
  }
  return row[b.size()];
}

}  // namespace dripfeed::family
