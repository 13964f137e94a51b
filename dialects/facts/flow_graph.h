// Where a run can go from a statement: the edges of a program, for whoever follows all control-flow paths. What a
// condition is worth is known here only when it is a constant.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "dialects/ir/program.h"

namespace dripfeed::facts {

// Of the program of a text that holds the statement: all statements where the text is one program.
struct StatementRange {
  std::uint32_t first = 0;
  std::uint32_t last = 0;
};
StatementRange section_of(const ir::Program& program, std::uint32_t statement);

// The first statement with the label that the jump would find in its own program, kNoIndex when there is none or it is
// computed.
std::uint32_t target_of(const ir::Program& program, std::uint32_t jump_statement);

// For each statement whether a jump leads there; a computed one may lead to any label. Numbers that no jump names are
// only numbers.
std::vector<bool> jump_targets(const ir::Program& program);

// Whether a Native of that name may jump to any label or repeat any section.
bool jumps_anywhere(std::string_view native);

class FlowGraph {
 public:
  explicit FlowGraph(const ir::Program& program);

  // Statements that may come after `statement`; the number of statements stands for the end of the text. Nothing
  // follows the last one of a program that others follow in the text.
  [[nodiscard]] const std::vector<std::uint32_t>& after(std::uint32_t statement);
  // Where runs begin: the first statement of each program, and every label when something may jump anywhere.
  [[nodiscard]] std::vector<std::uint32_t> entries() const;
  // The same without parts that are run and come back (REPEAT, contours between labels): from here a run goes on until
  // the program ends.
  [[nodiscard]] std::vector<std::uint32_t> entries_for_good() const;

 private:
  [[nodiscard]] std::vector<std::uint32_t> entries_of(bool with_labels) const;
  [[nodiscard]] bool jumps_to_computed() const;
  [[nodiscard]] int constant_condition(ir::ExpressionId condition) const;
  [[nodiscard]] std::uint32_t partner_of(const ir::Statement& s) const;
  void opener(std::uint32_t i, int enter);
  void jump(std::uint32_t i);

  const ir::Program& program_;
  std::vector<std::uint32_t> after_;
};

}  // namespace dripfeed::facts
