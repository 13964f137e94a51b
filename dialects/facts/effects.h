// What one statement does to the facts, calls of programs of the same text left out: those are followed by whoever
// walks the program.
#pragma once

#include <bitset>
#include <cstdint>
#include <vector>

#include "dialects/facts/modal_facts.h"
#include "dialects/ir/control.h"
#include "dialects/ir/program.h"

namespace dripfeed::facts {

// A bit for each mode, then one for each number, then one for each word.
using FactSet = std::bitset<kModes + kNumbers + kKept>;
FactSet differing(const Facts& a, const Facts& b);

// What brings a tool in: what the control does by itself; or M6 where the text has one and T otherwise, for whoever
// must name the tool of a text that leaves M6 to a parameter of the machine (MD22550) or to what it calls.
enum class ToolChange : std::uint8_t { as_the_control, as_the_text };

enum class Moving : std::uint8_t { no, perhaps, yes };

class Effects {
 public:
  // Both must outlive it.
  Effects(const ir::Program& program, const ir::Control& control, ToolChange change = ToolChange::as_the_control);

  // The facts after the statement. A call counts as one of a program that is not in the text, or of a cycle.
  void apply(std::uint32_t statement, Facts& facts) const;
  // … where block skip does not leave it out.
  void carry_out(std::uint32_t statement, Facts& facts) const;
  // Everything that the statement may set or change, whatever holds before it.
  [[nodiscard]] FactSet touched(std::uint32_t statement) const;
  // Whether it moves so that what is called modally follows.
  [[nodiscard]] Moving moving(const ir::Statement& statement) const;
  [[nodiscard]] bool tool_comes_by_t() const { return tool_at_once_; }

 private:
  struct Walk;  // one block
  void block(std::uint32_t statement, Facts& facts) const;
  void native(std::uint32_t statement, Facts& facts) const;
  static void set_modal_call(std::uint32_t statement, Facts& facts);

  const ir::Program& program_;
  const ir::Control& control_;
  bool tool_at_once_;                  // T brings a tool in, without M6
  bool changes_leads_;                 // has a thread whose lead changes
  std::vector<bool> may_be_left_out_;  // by statement: a shape that something other than its cycle leads to
};

}  // namespace dripfeed::facts
