// WHILE with one increment, and FOR.
#include "dialects/optimize/counted_loop.h"

#include <algorithm>
#include <cmath>

#include "dialects/optimize/expressions.h"
#include "dialects/passes/structure_parts.h"

namespace dripfeed::optimize {

namespace {

using ir::ExpressionId;
using ir::Operator;
using ir::StatementKind;

constexpr double kWhole = 1e-9;      // of a round
constexpr double kMostRounds = 1e6;  // more is no loop whose values a table holds

// counter + constant.
std::optional<double> step_of(const ir::Program& program, const Places& places, const ir::Assign& assign) {
  const Place counter = places.of(program.at(assign.target));
  const ir::Expression& e = program.at(assign.value);
  if (e.op != Operator::add) return {};
  if (place_at(program, places, e.a) == counter) return number_of(program, e.b);
  if (place_at(program, places, e.b) == counter) return number_of(program, e.a);
  return {};
}

// The last assignment before the loop, of a number, which every path to the loop comes from.
std::uint32_t init_before(const ir::Program& program, const Places& places, const std::vector<bool>& is_target,
                          std::uint32_t head, Place counter) {
  for (std::uint32_t i = head; i > 0 && !is_target[i];) {
    const ir::Statement& s = program.statements[--i];
    const bool is_straight =
        s.kind == StatementKind::empty || s.kind == StatementKind::block || s.kind == StatementKind::assign;
    if (!is_straight || s.skip_level != 0) return ir::kNoIndex;
    if (s.kind == StatementKind::assign && places.of(program.at(program.assigns[s.payload].target)) == counter)
      return i;
  }
  return ir::kNoIndex;
}

bool take_rounds(CountedLoop& loop, Operator op, double limit) {
  const double steps = (limit - loop.start) / loop.step;
  const double rounds = op == Operator::less ? std::ceil(steps - kWhole) : std::floor(steps + kWhole) + 1.0;
  if (!(rounds >= 2.0 && rounds <= kMostRounds)) return false;
  loop.rounds = static_cast<std::uint32_t>(rounds);
  return true;
}

// The only statement in the loop that sets the counter, in every round.
std::uint32_t increment_in(const CountedLoop& loop, const std::vector<Access>& accesses,
                           const std::vector<std::uint32_t>& around) {
  std::uint32_t found = ir::kNoIndex;
  for (std::uint32_t i = loop.first; i <= loop.last; ++i) {
    if (std::ranges::find(accesses[i].sets, loop.counter) == accesses[i].sets.end()) continue;
    if (found != ir::kNoIndex || around[i] != loop.first || accesses[i].is_fixed) return ir::kNoIndex;
    found = i;
  }
  return found;
}

std::optional<CountedLoop> counted_while(const ir::Program& program, const Places& places,
                                         const std::vector<Access>& accesses, const std::vector<bool>& is_target,
                                         CountedLoop loop) {
  const ir::Structure& head = program.structures[program.statements[loop.first].payload];
  const ir::Expression& condition = program.at(head.condition);
  if (condition.op != Operator::less && condition.op != Operator::less_equal) return {};
  loop.counter = place_at(program, places, condition.a);
  const std::optional<double> limit = number_of(program, condition.b);
  if (loop.counter == kNoPlace || !places.at(loop.counter).is_plain || !limit) return {};
  loop.increment = increment_in(loop, accesses, heads_around(program));
  loop.init = init_before(program, places, is_target, loop.first, loop.counter);
  if (loop.increment == ir::kNoIndex || loop.init == ir::kNoIndex) return {};
  const ir::Statement& increment = program.statements[loop.increment];
  if (increment.kind != StatementKind::assign) return {};
  const std::optional<double> step = step_of(program, places, program.assigns[increment.payload]);
  const std::optional<double> start = number_of(program, program.assigns[program.statements[loop.init].payload].value);
  if (!step || !(*step > 0.0) || !start) return {};
  loop.step = *step;
  loop.start = *start;
  return take_rounds(loop, condition.op, *limit) ? std::optional(loop) : std::nullopt;
}

std::optional<CountedLoop> counted_for(const ir::Program& program, const Places& places,
                                       const std::vector<Access>& accesses, CountedLoop loop) {
  const ir::Structure& head = program.structures[program.statements[loop.first].payload];
  loop.counter = places.of(program.at(head.counter));
  const std::optional<double> first = number_of(program, head.first), last = number_of(program, head.last);
  if (loop.counter == kNoPlace || !first || !last) return {};
  for (std::uint32_t i = loop.first + 1; i < loop.last; ++i)
    if (std::ranges::find(accesses[i].sets, loop.counter) != accesses[i].sets.end()) return {};
  loop.start = *first;
  return take_rounds(loop, Operator::less_equal, *last) ? std::optional(loop) : std::nullopt;
}

}  // namespace

std::optional<double> number_of(const ir::Program& program, ExpressionId id) {
  if (id == ExpressionId::none) return {};
  const ir::Expression& e = program.at(id);
  if (e.op == Operator::constant) return e.value;
  if (e.op != Operator::negate || program.at(e.a).op != Operator::constant) return {};
  return -program.at(e.a).value;
}

std::vector<std::uint32_t> heads_around(const ir::Program& program) {
  std::vector<std::uint32_t> out(program.statements.size(), ir::kNoIndex);
  std::vector<std::uint32_t> open;
  for (std::uint32_t i = 0; i < out.size(); ++i) {
    const StatementKind kind = program.statements[i].kind;
    const bool ends = kind == StatementKind::if_end || passes::ends_loop(kind);
    if (ends && !open.empty()) open.pop_back();
    if (!open.empty()) out[i] = open.back();
    if (kind == StatementKind::else_begin && !open.empty()) out[i] = out[open.back()];
    if (kind == StatementKind::if_begin || passes::begins_loop(kind)) open.push_back(i);
  }
  return out;
}

std::optional<CountedLoop> counted_loop(const ir::Program& program, const Places& places,
                                        const std::vector<Access>& accesses, const std::vector<bool>& is_target,
                                        std::uint32_t head) {
  const ir::Statement& s = program.statements[head];
  CountedLoop loop{.first = head, .last = program.structures[s.payload].partner};
  if (s.kind == StatementKind::while_begin) return counted_while(program, places, accesses, is_target, loop);
  if (s.kind == StatementKind::for_begin) return counted_for(program, places, accesses, loop);
  return {};
}

}  // namespace dripfeed::optimize
