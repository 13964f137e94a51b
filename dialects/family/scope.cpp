// A list with an index: families have tens of names, but a text with thousands must not hold up who reads it.
#include "dialects/family/scope.h"

#include "dialects/text/nearest.h"

namespace dripfeed::family {

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
  std::size_t best_distance = text::far_from(name);
  for (const Name& candidate : names_) {
    if (!candidate.visible) continue;
    compared_letters_ += name.size() * candidate.name.size();
    if (compared_letters_ > kMostLetters) return best;
    const std::size_t distance = text::edit_distance(name, candidate.name);
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

void Scope::seal() {
  const std::size_t first = marks_.back();
  close();
  std::erase_if(last_, [first](const auto& one) { return one.second >= first; });
}

}  // namespace dripfeed::family
