// parse: expressions of Custom Macro B. Priorities, highest first: functions and brackets; * / AND MOD; + - OR XOR;
// EQ NE GT GE LT LE. Equal ones from the left.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "dialects/ir/control.h"
#include "dialects/ir/program.h"
#include "dialects/macro_b/reader/cursor.h"
#include "dialects/macro_b/tables/grammar.h"
#include "dialects/text/number.h"

namespace dripfeed::macro_b {

inline constexpr std::size_t kLongestVariableName = 8;  // that SETVN gives; some controls take seven

class ExpressionReader {
 public:
  ExpressionReader(ir::Program& program, const ir::Control& control, const Grammar& grammar,
                   const KeywordIndex& keywords, Cursor& cursor, Faults& faults)
      : program_(program),
        control_(control),
        grammar_(grammar),
        keywords_(keywords),
        cursor_(cursor),
        faults_(faults) {}

  // A whole expression from the cursor on; `after` names what it belongs to, for the fault when nothing is there.
  // none after a fault.
  ir::ExpressionId expression(std::string_view after);
  // What may stand after an address: a number, a variable, a bracket or a function, with a sign. none without a fault
  // when nothing of this is there.
  ir::ExpressionId word_value();
  // '[' condition ']', also several joined by AND and OR; none after a fault.
  ir::ExpressionId condition(std::string_view after);
  // From '#' on. For a target #0 is a variable like others.
  std::optional<ir::Variable> variable();
  // The keyword at the cursor, nullptr when there is none.
  [[nodiscard]] const Keyword* keyword() const;
  // SETVN: a name for a variable, used as [#NAME].
  void name_variable(std::string_view name, std::uint32_t number) { names_[std::string(name)] = number; }
  // Whether the name is another variable's already.
  [[nodiscard]] bool names_other(std::string_view name, std::uint32_t number) const {
    const auto known = names_.find(name);
    return known != names_.end() && known->second != number;
  }
  [[nodiscard]] bool has_names() const { return !names_.empty() || !grammar_.named_variables.empty(); }
  void begin_block() { depth_ = 0, operators_ = 0, reported_mixed_logic_ = false; }

 private:
  ir::ExpressionId comparison(std::string_view after);
  ir::ExpressionId sum(std::string_view after);
  ir::ExpressionId product(std::string_view after);
  ir::ExpressionId factor(std::string_view after);
  ir::ExpressionId number(std::uint32_t most_digits, bool negative, std::uint32_t begin);
  void digits_fault(const text::Decimal& decimal, std::uint32_t most_digits);
  ir::ExpressionId variable_value();
  ir::ExpressionId bracketed(std::string_view after);
  [[nodiscard]] const NamedVariable* system_name() const;
  void check_unset_name(text::Span span);
  bool named_number(const NamedVariable& system, ir::Variable& result, std::uint32_t begin);
  ir::ExpressionId function(const Keyword& keyword);
  ir::ExpressionId parameter_value(ir::ExpressionId number, ir::ExpressionId bit, std::uint32_t begin);
  ir::ExpressionId second_argument(const Keyword& keyword, ir::ExpressionId first, std::uint32_t begin);
  ir::ExpressionId calculated(ir::ExpressionId id, std::uint32_t begin);
  ir::ExpressionId combine(ir::Operator op, ir::ExpressionId a, ir::ExpressionId b);
  bool open_bracket(std::string_view after);
  bool close_bracket();
  [[nodiscard]] bool is_condition(ir::ExpressionId id) const;

  ir::Program& program_;
  const ir::Control& control_;
  const Grammar& grammar_;
  const KeywordIndex& keywords_;
  Cursor& cursor_;
  Faults& faults_;
  std::map<std::string, std::uint32_t, std::less<>> names_;
  std::uint32_t depth_ = 0;
  std::uint32_t operators_ = 0;  // of the block
  bool reported_mixed_logic_ = false;
  bool reported_digits_ = false;
  std::uint32_t open_at_ = 0;  // of the innermost bracket that is open
};

}  // namespace dripfeed::macro_b
