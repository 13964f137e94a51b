// What computing a run cost its control, by a cost model, and what the difference of two runs is worth.
#pragma once

#include <array>
#include <cstdint>

#include "dialects/compile/translate/recorded_run.h"
#include "dialects/ir/cost_model.h"

namespace dripfeed::compile {

// In all, and for the move before which most was computed.
struct ComputeCost {
  double total_ms = 0.0;
  double longest_ms = 0.0;
  std::uint32_t longest_line = 0;
  std::uint64_t moves = 0;
  std::uint64_t blocks = 0;
  std::array<std::uint64_t, ir::kCostTerms.size()> counts{};  // of the whole run, by the model's terms
};
ComputeCost compute_cost(const RecordedRun& run, const ir::CostModel& model);

// What one run costs less than another; below zero: more.
struct Saving {
  double ms = 0.0;
  double least_ms = 0.0;
  double most_ms = 0.0;
};
// Each figure of the model may be off by its spread, up or down and each for itself. What is no longer computed and
// what is computed in its place may be of different figures, so the least saving takes the low ones of the former and
// the high ones of the latter. It may be below zero.
Saving saving_between(const ComputeCost& before, const ComputeCost& after, const ir::CostModel& model);

}  // namespace dripfeed::compile
