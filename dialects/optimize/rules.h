// What the optimizer may do, one row a rule: those of G. Nikiel, "Optimization of execution speed of the CNC parametric
// part programs", chapter 2, and what a compiler adds. Each can be switched off by itself. The last three change the
// path, within a tolerance; compile/render/merged_blocks has two of them, and compile/translate/inlined_calls the first
// rule of the table, which needs the texts of other programs.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

namespace dripfeed::optimize {

enum class Rule : std::uint8_t {
  inlined,
  numbered,
  loops,
  branches,
  values,
  invariants,
  merge,
  join,
  comments,
  numbers,
  table,
  lines,
  arcs,
  count_
};
inline constexpr std::size_t kRules = static_cast<std::size_t>(Rule::count_);

struct RuleRow {
  std::string_view name;  // as options and reports have it
  std::string_view what;
  bool is_standard;  // on unless it is switched off
};

inline constexpr std::array<RuleRow, kRules> kRuleRows = {{
    {"inline", "the blocks of a subprogram take the place of its call", true},
    {"numbered", "variables with a name become numbered ones, in the numbers that are stated to be free", true},
    {"loops", "jumps back become loops, where that makes the program faster", true},
    {"branches", "jumps over parts become IF with ELSE, where the control has them and it makes the program faster",
     true},
    {"values", "values that are known already are not computed again, and what no block reads is not computed", true},
    {"invariants", "what a loop does not change is computed before it", true},
    {"merge", "a value that one expression reads moves into it", true},
    {"join", "assignments that do not need each other share a block, where the control allows it", true},
    {"comments", "comments are dropped", false},
    {"numbers", "block numbers that no jump names are dropped", false},
    {"table", "a value that a loop computes is interpolated in a table that is filled before it, within the tolerance",
     false},
    {"lines", "straight cuts near one line become one block, within the tolerance", false},
    {"arcs", "arcs of one circle become one block, within the tolerance", false},
}};
constexpr const RuleRow& row_of(Rule rule) { return kRuleRows[static_cast<std::size_t>(rule)]; }
std::optional<Rule> find_rule(std::string_view name);
constexpr bool changes_path(Rule rule) { return rule == Rule::table || rule == Rule::lines || rule == Rule::arcs; }

class Rules {
 public:
  constexpr Rules() {
    for (std::size_t i = 0; i < kRules; ++i) on_[i] = kRuleRows[i].is_standard;
  }
  static constexpr Rules none() {
    Rules out;
    out.on_.fill(false);
    return out;
  }
  constexpr void set(Rule rule, bool on) { on_[static_cast<std::size_t>(rule)] = on; }
  [[nodiscard]] constexpr bool has(Rule rule) const { return on_[static_cast<std::size_t>(rule)]; }

 private:
  std::array<bool, kRules> on_{};
};

}  // namespace dripfeed::optimize
