// Looking at the budget every few thousand motions or steps.
#include "dialects/interpreter/state/run_budget.h"

#include <algorithm>
#include <utility>

namespace dripfeed::interpreter {

// How many motions may be made before the next look.
std::uint32_t RunBudget::stride() {
  const std::uint64_t left = options_.limits.motions - std::min(options_.limits.motions, taken_);
  const auto next = static_cast<std::uint32_t>(std::min<std::uint64_t>(left, kAskEvery));
  taken_ += next;
  return next;
}

void RunBudget::refill() {
  const std::uint32_t next = is_open_ ? stride() : kAskEvery;
  if (next == 0) throw BudgetUsedUp{"motions"};
  ask();
  until_full_ = next - 1;  // this one is the first of them
}

void RunBudget::ask() {
  until_asked_ = kAskEvery;
  if (!is_open_ || !options_.used_up) return;
  std::string what = options_.used_up();
  if (!what.empty()) throw BudgetUsedUp{std::move(what)};
}

}  // namespace dripfeed::interpreter
