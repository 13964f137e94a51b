// Loops are structures and jumps back; those that overlap count as one.
#include "dialects/passes/live_ranges.h"

#include <algorithm>

#include "dialects/passes/structure_parts.h"

namespace dripfeed::passes {

namespace {

using ir::StatementKind;

// The statement that a jump goes to; kNoIndex when that is not known.
std::uint32_t target_of(const ir::Program& program, const ir::Jump& jump) {
  const auto label = std::ranges::find_if(program.labels, [&](const ir::Label& l) {
    return jump.label != ir::StringId::none ? l.name == jump.label : l.number == jump.number;
  });
  return jump.computed != ir::ExpressionId::none || label == program.labels.end() ? ir::kNoIndex : label->statement;
}

// Loops as ranges; one over everything where control flow is not known.
std::vector<LiveRange> loops_of(const ir::Program& program) {
  std::vector<LiveRange> loops;
  for (std::uint32_t i = 0; i < program.statements.size(); ++i) {
    const ir::Statement& s = program.statements[i];
    if (s.kind == StatementKind::call || s.kind == StatementKind::modal_call || s.kind == StatementKind::native)
      return {LiveRange::always()};
    if (begins_loop(s.kind)) {
      const std::uint32_t partner = program.structures[s.payload].partner;
      if (partner == ir::kNoIndex) return {LiveRange::always()};
      loops.push_back({i, partner});
    }
    if (s.kind == StatementKind::go_to) {
      const std::uint32_t target = target_of(program, program.jumps[s.payload]);
      if (target == ir::kNoIndex) return {LiveRange::always()};
      if (target <= i) loops.push_back({target, i});
    }
  }
  return loops;
}

}  // namespace

LiveRanges::LiveRanges(const ir::Program& program) : loop_of_(program.statements.size()) {
  std::vector<LiveRange> loops = loops_of(program);
  std::ranges::sort(loops, {}, &LiveRange::first);
  std::vector<LiveRange> joined;
  for (const LiveRange& loop : loops) {
    if (!joined.empty() && loop.first <= joined.back().last) {
      joined.back().last = std::max(joined.back().last, loop.last);
    } else {
      joined.push_back(loop);
    }
  }
  for (const LiveRange& loop : joined) {
    for (std::uint32_t i = loop.first; i <= loop.last && i < loop_of_.size(); ++i) loop_of_[i] = loop;
  }
}

void LiveRanges::extend(LiveRange& range, std::uint32_t statement) const {
  const LiveRange& loop = loop_of_[statement];
  range.first = std::min({range.first, statement, loop.empty() ? statement : loop.first});
  range.last = std::max({range.last, statement, loop.empty() ? statement : loop.last});
}

}  // namespace dripfeed::passes
