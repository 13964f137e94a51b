// What one block does to the tool in the spindle, its length and its cutting edge.
#pragma once

#include <cstdint>
#include <optional>

#include "dialects/facts/block_values.h"
#include "dialects/facts/modal_facts.h"
#include "dialects/ir/control.h"

namespace dripfeed::facts {

// All must outlive it.
struct ToolEffects {
  const ir::Control& control;
  std::uint32_t statement;
  bool tool_at_once;  // T brings a tool in, without M6
  const BlockValues& values;
  Facts& facts;

  void run();

 private:
  void name_tool(const ir::Word& word);
  void bring_in();
  void take_edge();
  void take_length();
  void take_length_of_edge();
  void set_length_number(std::optional<double> number);
  [[nodiscard]] bool comes_in() const;
  [[nodiscard]] bool turns_length_on() const;
};

}  // namespace dripfeed::facts
