// The words of a preamble as one control writes them: codes by its own tables, lengths in the unit and numbers in the
// digits that are in effect.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "dialects/interpreter/state/block_rules.h"
#include "dialects/interpreter/state/modal_state.h"
#include "dialects/ir/control.h"

namespace dripfeed::compile {

class RestartWords {
 public:
  RestartWords(const ir::Control& control, const interpreter::Modes& modes)
      : control_(control), rules_(control), modes_(modes), by_number_(ir::has_numbered_variables(control)) {}

  // "G54", "M08"; "" where the control has no such code.
  [[nodiscard]] std::string code(ir::Function function, std::int16_t argument = 0) const;
  // "X10.5": of a position as ModalState has it.
  [[nodiscard]] std::string axis(std::size_t axis, double position) const;
  // "F200.": of a feed as ModalState has it.
  [[nodiscard]] std::string feed(double feed) const;
  // "T5", "S1200": a number that is whole as a rule.
  [[nodiscard]] std::string count(char letter, double value) const;
  [[nodiscard]] std::string comment(std::string_view words) const;
  // "#100=5.", "R1=5", "NAME=5"
  [[nodiscard]] std::string assignment(std::string_view name, double value) const;
  // How far a coordinate is rounded at most, mm or degrees.
  [[nodiscard]] double rounding_mm() const;

  [[nodiscard]] const ir::Control& control() const { return control_; }
  [[nodiscard]] const interpreter::BlockRules& rules() const { return rules_; }
  // One of the controls whose variables are numbers.
  [[nodiscard]] bool by_number() const { return by_number_; }
  [[nodiscard]] double unit_mm() const { return modes_.inch ? 25.4 : 1.0; }

 private:
  [[nodiscard]] int decimals() const { return control_.limits.linear_decimals + (modes_.inch ? 1 : 0); }
  [[nodiscard]] std::string number(double value, int decimals) const;

  const ir::Control& control_;
  interpreter::BlockRules rules_;
  const interpreter::Modes& modes_;
  bool by_number_;
};

// The words of one block with blanks between; words that are "" are left out.
std::string block_of(const std::vector<std::string>& words);

}  // namespace dripfeed::compile
