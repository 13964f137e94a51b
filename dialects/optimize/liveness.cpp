// Backwards over the flow graph until nothing changes: as often as loops are nested, and twice.
#include "dialects/optimize/liveness.h"

#include "dialects/facts/flow_graph.h"

namespace dripfeed::optimize {

namespace {

PlaceSet left_to_others(const Places& places) {
  PlaceSet out(places.count());
  for (Place p = 0; p < places.count(); ++p)
    if (!places.at(p).is_own) out.add(p);
  return out;
}
PlaceSet shared(const Places& places) {
  PlaceSet out(places.count());
  for (Place p = 0; p < places.count(); ++p)
    if (places.is_shared(p)) out.add(p);
  return out;
}

}  // namespace

Liveness::Liveness(const ir::Program& program, const Places& places, const std::vector<Access>& accesses)
    : before_(program.statements.size(), PlaceSet(places.count())), after_(before_) {
  const auto count = static_cast<std::uint32_t>(program.statements.size());
  const PlaceSet others = left_to_others(places);
  const PlaceSet numbered = shared(places);
  facts::FlowGraph graph(program);
  std::vector<std::vector<std::uint32_t>> next(count);
  for (std::uint32_t i = 0; i < count; ++i) next[i] = graph.after(i);
  for (bool changed = true; changed;) {
    changed = false;
    for (std::uint32_t i = count; i-- > 0;) {
      PlaceSet& after = after_[i];
      if (next[i].empty()) after.add_all(others);
      for (const std::uint32_t n : next[i]) after.add_all(n < count ? before_[n] : others);
      PlaceSet before = after;
      const Access& access = accesses[i];
      if (access.sets_for_sure)
        for (const Place p : access.sets) before.remove(p);
      for (const Place p : access.reads) before.add(p);
      if (access.reads_shared) before.add_all(numbered);
      changed = before_[i].add_all(before) || changed;
    }
  }
}

}  // namespace dripfeed::optimize
