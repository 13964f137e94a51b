// One row a change, and one a rule that changed something.
#include "server/json/optimized.h"

#include <array>
#include <utility>

#include "server/json/diagnostics.h"
#include "server/json/parse.h"

namespace dripfeed::json {

namespace {

Document cost_of_run(const std::optional<compile::ComputeCost>& cost) {
  if (!cost) return nullptr;
  return {{"total_ms", cost->total_ms},
          {"longest_ms", cost->longest_ms},
          {"longest_line", cost->longest_line},
          {"moves", cost->moves},
          {"blocks", cost->blocks}};
}

Document passes_of(const std::vector<optimize::Change>& changes) {
  std::array<std::size_t, optimize::kRules> edits{};
  for (const optimize::Change& change : changes) ++edits[static_cast<std::size_t>(change.rule)];
  Document out = Document::array();
  for (std::size_t i = 0; i < optimize::kRules; ++i)
    if (edits[i] > 0) out.push_back({{"rule", optimize::kRuleRows[i].name}, {"edits", edits[i]}});
  return out;
}

}  // namespace

std::string optimized(const compile::OptimizeResult& result, const ir::CostModel& cost, const text::Source& source) {
  Document changes = Document::array();
  for (const optimize::Change& change : result.changes)
    changes.push_back({{"line", change.line}, {"rule", optimize::row_of(change.rule).name}, {"what", change.what}});
  return dump({{"text", text::has_error(result.diagnostics) ? Document(nullptr) : Document(result.text)},
               {"origins", result.origin_lines},
               {"passes", passes_of(result.changes)},
               {"changes", std::move(changes)},
               {"left_because", text_or_null(result.obstacle)},
               {"not_verified", text_or_null(result.not_verified)},
               {"proved_max_mm", result.off_mm ? Document(*result.off_mm) : Document(nullptr)},
               {"not_merged", text_or_null(result.not_merged)},
               {"before", cost_of_run(result.before)},
               {"after", cost_of_run(result.after)},
               {"cost", {{"source", ir::name_of(cost.source)}, {"origin", cost.origin}, {"spread", cost.spread}}},
               {"diagnostics", embedded(diagnostics(result.diagnostics, source))}});
}

}  // namespace dripfeed::json
