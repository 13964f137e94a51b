// Counts are added up term by term, so that the interval of a difference can be stated.
#include "dialects/compile/render/compute_cost.h"

namespace dripfeed::compile {

ComputeCost compute_cost(const RecordedRun& run, const ir::CostModel& model) {
  ComputeCost out;
  out.blocks = run.result.blocks;
  double since_ms = 0.0;
  for (const ir::Motion& m : run.motions) {
    const double ms = ir::compute_ms(model, m.compute);
    for (std::size_t i = 0; i < ir::kCostTerms.size(); ++i) out.counts[i] += m.compute.*ir::kCostTerms[i].count;
    out.total_ms += ms;
    since_ms += ms;
    if (!ir::is_move(m.kind)) continue;
    ++out.moves;
    if (since_ms > out.longest_ms) out.longest_ms = since_ms, out.longest_line = m.place.line;
    since_ms = 0.0;
  }
  return out;
}

Saving saving_between(const ComputeCost& before, const ComputeCost& after, const ir::CostModel& model) {
  Saving out{.ms = before.total_ms - after.total_ms};
  for (std::size_t i = 0; i < ir::kCostTerms.size(); ++i) {
    const double ms =
        model.*ir::kCostTerms[i].ms * (static_cast<double>(before.counts[i]) - static_cast<double>(after.counts[i]));
    out.least_ms += ms > 0.0 ? ms / model.spread : ms * model.spread;
    out.most_ms += ms > 0.0 ? ms * model.spread : ms / model.spread;
  }
  return out;
}

}  // namespace dripfeed::compile
