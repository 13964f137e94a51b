// Where one block leaves the axes, and the words of a turning cycle, which are positions.
#pragma once

#include <cstdint>
#include <optional>

#include "dialects/facts/block_values.h"
#include "dialects/facts/modal_facts.h"
#include "dialects/ir/control.h"

namespace dripfeed::facts {

// The block's codes, tool and feed have taken effect. All must outlive it.
struct PositionEffects {
  const ir::Control& control;
  std::uint32_t statement;
  const BlockValues& values;
  Facts& facts;

  void run();
  // In the program's unit; nothing where it is computed, or counts increments of an unknown unit.
  [[nodiscard]] std::optional<double> coordinate(const ir::Word& word, Number axis) const;
  // A word for X or Z.
  [[nodiscard]] bool turns(const ir::Word& word) const;
  struct AxisTarget {
    Number axis;
    bool by_letter;  // the letter itself says that it is an increment
  };
  [[nodiscard]] std::optional<bool> is_increment(const ir::Word& word, const AxisTarget& target) const;

 private:
  [[nodiscard]] std::optional<AxisTarget> target_of(const ir::Word& word) const;
  void take_turning_words(std::int32_t cycle);
  void keep(Kept which, std::optional<double> number, const ir::Word& word);
  [[nodiscard]] bool halves(Number axis) const;
  void take_drilling();
  void take_name(const ir::Word& word, Number axis);
  void take_axis(const ir::Word& word);
};

}  // namespace dripfeed::facts
