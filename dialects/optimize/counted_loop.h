// Loops that count: a number that begins at a constant and grows by a constant each round up to a constant.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "dialects/ir/program.h"
#include "dialects/optimize/accesses.h"
#include "dialects/optimize/places.h"

namespace dripfeed::optimize {

struct CountedLoop {
  std::uint32_t first = 0;                 // its head
  std::uint32_t last = 0;                  // its end
  std::uint32_t init = ir::kNoIndex;       // the assignment before it; none of FOR, which has it in its head
  std::uint32_t increment = ir::kNoIndex;  // the assignment in it; none of FOR
  Place counter = kNoPlace;
  double start = 0.0;
  double step = 1.0;  // above zero
  std::uint32_t rounds = 0;

  [[nodiscard]] double span() const { return step * (rounds - 1); }  // from the first value to that of the last round
};

// The loop with its head at `head` as one that counts; nothing where it is none, or where that is in doubt.
// `is_target`: by statement, whether a jump leads there.
std::optional<CountedLoop> counted_loop(const ir::Program& program, const Places& places,
                                        const std::vector<Access>& accesses, const std::vector<bool>& is_target,
                                        std::uint32_t head);

// The number of a constant, with its sign; nothing for any other expression.
std::optional<double> number_of(const ir::Program& program, ir::ExpressionId id);

// By statement: the head of the innermost IF or loop around it, kNoIndex outside of all.
std::vector<std::uint32_t> heads_around(const ir::Program& program);

}  // namespace dripfeed::optimize
