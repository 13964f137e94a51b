// Verbs that the library writes as subprograms, copied into a family with the arguments in place of the parameters.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "dialects/family/model.h"
#include "dialects/family/scope.h"

namespace dripfeed::family {

// The library, read once.
const Family& verb_library();

// The feed of an entry, after which the one before it is in effect again. None: the copy has no feeds.
struct VerbFeeds {
  ir::ExpressionId entry = ir::ExpressionId::none;
  Dimension dimension = kFeedPerMin;
};

class VerbCopy {
 public:
  // `like`: line and span of what is copied. Names are defined in the open block of `scope`.
  VerbCopy(Family& to, Scope& scope, const Step& like) : to_(to), scope_(scope), like_(like) {}

  // x becomes y and the reverse, in words of axes.
  void swap_axes() { swaps_axes_ = true; }
  // The value of a library's function.
  ir::ExpressionId value(std::string_view function, std::span<const ir::ExpressionId> arguments);
  // The steps of a library's subprogram, whose last two parameters are the feed of its entry and the one before it
  // where `feeds` is given. Arguments are numbers or names that no step changes.
  std::vector<Step> steps(std::string_view subprogram, std::span<const ir::ExpressionId> arguments,
                          const std::optional<VerbFeeds>& feeds = std::nullopt);

  // A number or a name: what may stand wherever it is used.
  [[nodiscard]] bool is_simple(ir::ExpressionId id) const;
  // a op b without what changes nothing, and of numbers as a number where it has few decimals.
  ir::ExpressionId calculated(ir::Operator op, ir::ExpressionId a, ir::ExpressionId b);

 private:
  ir::ExpressionId copy(ir::ExpressionId id);
  ir::ExpressionId constant(double value) { return to_.arena.add_constant(value, like_.span); }
  [[nodiscard]] std::optional<double> number(ir::ExpressionId id) const;
  [[nodiscard]] bool is_set(ir::ExpressionId name) const;
  ir::SymbolId symbol_of(ir::SymbolId own);
  std::optional<Step> copy(const Step& own);
  std::optional<Step> copy_feed(Step out);

  Family& to_;
  Scope& scope_;
  const Step& like_;
  bool swaps_axes_ = false;
  std::map<ir::SymbolId, ir::ExpressionId> values_;  // of names of the library
  std::map<ir::SymbolId, ir::SymbolId> symbols_;     // of names of the library: theirs in the copy
  std::set<ir::SymbolId> set_;                       // of those of the library, what a step sets
  std::set<ir::SymbolId> changing_;                  // their symbols in the copy
  ir::ExpressionId entry_ = ir::ExpressionId::none;  // stand for the feeds
  ir::ExpressionId before_ = ir::ExpressionId::none;
  std::optional<VerbFeeds> feeds_;
};

}  // namespace dripfeed::family
