// What computing costs a control: counts of what was done, and the milliseconds of each. kCostTerms names every figure
// once: profiles, fits and reports go through it.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace dripfeed::ir {

// Work done since the last motion. Saturating: a count never wraps.
struct ComputeCounts {
  std::uint32_t blocks = 0;
  std::uint32_t number_reads = 0;  // R, #
  std::uint32_t number_writes = 0;
  std::uint32_t named_reads = 0;  // LUD, PUD, GUD, system variables
  std::uint32_t named_writes = 0;
  std::uint32_t operators = 0;
  std::uint32_t functions = 0;
  std::uint32_t jumps = 0;    // taken: GOTO, and UNTIL that goes back
  std::uint32_t rounds = 0;   // ends of WHILE, FOR and LOOP that were reached; that of WHILE and LOOP is no block
  std::uint32_t calls = 0;    // of programs; call and return are blocks of their own
  std::uint32_t indexed = 0;  // of the reads and writes: R[R1], #[#1], V[2]
};

// Where the figures of a cost model are from. An assumption may be a good one; no one measured it.
enum class CostSource : std::uint8_t { assumed, paper, calibrated };
inline constexpr std::array<std::string_view, 3> kCostSourceNames = {"assumed", "paper", "calibrated"};
constexpr std::string_view name_of(CostSource source) { return kCostSourceNames[static_cast<std::size_t>(source)]; }

// By how much an assumption may be off, up or down: a model that fitted a paper's tables within 1.4 % was off by as
// much at that paper's own programs (G. Nikiel, "Optimization of execution speed of the CNC parametric part programs").
inline constexpr double kAssumedSpread = 5.0;

struct CostModel {
  double block_ms = 0.0;
  double number_read_ms = 0.0;
  double number_write_ms = 0.0;
  double named_read_ms = 0.0;
  double named_write_ms = 0.0;
  double operator_ms = 0.0;
  double function_ms = 0.0;
  double jump_ms = 0.0;
  double round_ms = 0.0;
  double call_ms = 0.0;
  double indexed_ms = 0.0;         // next to the read or write
  double spread = kAssumedSpread;  // a prediction lies between time / spread and time · spread; at least 1
  CostSource source = CostSource::assumed;
  std::string_view origin;  // in words: which paper, which timing program and when
};

struct CostTerm {
  std::string_view name;  // as profiles have it
  std::string_view what;  // of which it is the time
  double CostModel::* ms;
  std::uint32_t ComputeCounts::* count;
};

inline constexpr std::array<CostTerm, 11> kCostTerms = {{
    {"block_ms", "a block", &CostModel::block_ms, &ComputeCounts::blocks},
    {"number_read_ms", "reading a numbered variable: R, #", &CostModel::number_read_ms, &ComputeCounts::number_reads},
    {"number_write_ms", "writing a numbered variable", &CostModel::number_write_ms, &ComputeCounts::number_writes},
    {"named_read_ms", "reading a variable with a name: LUD, PUD, GUD, system", &CostModel::named_read_ms,
     &ComputeCounts::named_reads},
    {"named_write_ms", "writing a variable with a name", &CostModel::named_write_ms, &ComputeCounts::named_writes},
    {"operator_ms", "an operator", &CostModel::operator_ms, &ComputeCounts::operators},
    {"function_ms", "a function", &CostModel::function_ms, &ComputeCounts::functions},
    {"jump_ms", "a jump that is taken, in addition to its block", &CostModel::jump_ms, &ComputeCounts::jumps},
    {"round_ms", "the end of a loop's round", &CostModel::round_ms, &ComputeCounts::rounds},
    {"call_ms", "calling a program and returning, in addition to the two blocks", &CostModel::call_ms,
     &ComputeCounts::calls},
    {"indexed_ms", "finding a variable by a computed number, in addition to reading or writing it",
     &CostModel::indexed_ms, &ComputeCounts::indexed},
}};

constexpr double compute_ms(const CostModel& m, const ComputeCounts& n) {
  double ms = 0.0;
  for (const CostTerm& term : kCostTerms) ms += m.*term.ms * n.*term.count;
  return ms;
}

// The same control, slower or faster by a factor.
constexpr CostModel scaled(CostModel m, double factor) {
  for (const CostTerm& term : kCostTerms) m.*term.ms *= factor;
  return m;
}

}  // namespace dripfeed::ir
