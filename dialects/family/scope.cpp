// A list with an index: families have tens of names, but a text with thousands must not hold up who reads it.
#include "dialects/family/scope.h"

#include <algorithm>
#include <numeric>

namespace dripfeed::family {

namespace {

// Words with fewer changes are near: one in three letters, and one more.
std::size_t furthest(std::string_view word) { return word.size() / 3 + 2; }

}  // namespace

const Scope::Name* Scope::find(std::string_view name) const {
  // The last of this name: one is defined only where no earlier one is visible.
  const auto found = last_.find(name);
  return found == last_.end() || !names_[found->second].visible ? nullptr : &names_[found->second];
}

ir::SymbolId Scope::define(ir::Program& arena, std::string_view name, Dimension dimension, text::Span span,
                           NameKind kind) {
  Name added{std::string(name), ir::SymbolId::none, dimension, span, true, kind};
  // Two loops over `t` are one variable at the control.
  const auto closed = last_.find(name);
  if (closed != last_.end() && kind != NameKind::list && names_[closed->second].kind != NameKind::list) {
    added.symbol = names_[closed->second].symbol;
  } else {
    ir::Symbol symbol;
    symbol.name = arena.strings.add(name);
    symbol.span = span;
    added.symbol = arena.add(symbol);
  }
  last_.insert_or_assign(added.name, names_.size());
  names_.push_back(added);
  return added.symbol;
}

std::string_view Scope::nearest(std::string_view name) {
  constexpr std::uint64_t kMostLetters = 10'000'000;  // pairs of them, in a family: a few hundredths of a second
  std::string_view best;
  std::size_t best_distance = furthest(name);
  for (const Name& candidate : names_) {
    if (!candidate.visible) continue;
    compared_letters_ += name.size() * candidate.name.size();
    if (compared_letters_ > kMostLetters) return best;
    const std::size_t distance = edit_distance(name, candidate.name);
    if (distance < best_distance) {
      best_distance = distance;
      best = candidate.name;
    }
  }
  return best;
}

std::string_view nearest_of(std::string_view word, std::span<const std::string_view> words) {
  std::string_view best;
  std::size_t best_distance = furthest(word);
  for (const std::string_view candidate : words) {
    const std::size_t distance = edit_distance(word, candidate);
    if (distance >= best_distance) continue;
    best_distance = distance;
    best = candidate;
  }
  return best;
}

void Scope::close() {
  for (std::size_t i = marks_.back(); i < names_.size(); ++i) names_[i].visible = false;
  marks_.pop_back();
}

void Scope::seal() {
  const std::size_t first = marks_.back();
  close();
  std::erase_if(last_, [first](const auto& one) { return one.second >= first; });
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
