// What computing a block costs a control: counts of what was done, and the milliseconds of each (G. Nikiel, "execution
// speed of parametric programs", tables 1-4: a block, a read of an R parameter or LUD variable, an operator, a
// function).
#pragma once

#include <cstdint>
#include <string_view>

namespace dripfeed::ir {

// Work done since the last motion. Saturating: a count never wraps.
struct ComputeCounts {
  std::uint32_t blocks = 0;
  std::uint32_t number_reads = 0;  // R, #
  std::uint32_t named_reads = 0;   // LUD, PUD, GUD
  std::uint32_t operators = 0;
  std::uint32_t functions = 0;
};

struct CostModel {
  double block_ms = 0.0;
  double number_read_ms = 0.0;
  double named_read_ms = 0.0;
  double operator_ms = 0.0;
  double function_ms = 0.0;
  bool measured = false;    // fitted to measurements; otherwise an assumption, and reports say so
  std::string_view origin;  // where the figures are from
};

constexpr double compute_ms(const CostModel& m, const ComputeCounts& n) {
  return m.block_ms * n.blocks + m.number_read_ms * n.number_reads + m.named_read_ms * n.named_reads +
         m.operator_ms * n.operators + m.function_ms * n.functions;
}

}  // namespace dripfeed::ir
