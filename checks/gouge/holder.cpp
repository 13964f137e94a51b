// Each step is a flat disk at its height above the tip.
#include "checks/gouge/holder.h"

namespace dripfeed::gouge {

namespace {

// `depth_of` asks how deep one step enters.
template <class DepthOf>
HolderTouch deepest_of(std::span<const checks::HolderStep> steps, DepthOf depth_of) {
  HolderTouch deepest;
  for (const checks::HolderStep& step : steps) {
    const Depth depth = depth_of(step);
    if (depth.mm > deepest.depth.mm) deepest = {depth, step};
  }
  return deepest;
}

}  // namespace

HolderTouch Holder::touch(const HeightMap& map, const Point3& from, const Point3& to, double slack) const {
  return deepest_of(steps_, [&](const checks::HolderStep& step) {
    const Cutter disk{0.5 * step.diameter_mm, 0.0};
    return map.touch(disk, {from.x, from.y, from.z + step.from_mm}, {to.x, to.y, to.z + step.from_mm}, slack).stock;
  });
}

HolderTouch Holder::touch_ahead(const HeightMap& map, const Cutter& cutter, const Point3& from, const Point3& to,
                                double slack) const {
  return deepest_of(steps_,
                    [&](const checks::HolderStep& step) { return map.touch_ahead(cutter, step, from, to, slack); });
}

HolderTouch Holder::touch_level(const HeightMap& map, const Cutter& cutter, const Point3& from, const Point3& to,
                                double slack) const {
  return deepest_of(steps_,
                    [&](const checks::HolderStep& step) { return map.touch_level(cutter, step, from, to, slack); });
}

HolderTouch Holder::touch_around(const HeightMap& map, const Cutter& cutter, const Point3& start, double center_x,
                                 double center_y, double slack) const {
  return deepest_of(steps_, [&](const checks::HolderStep& step) {
    return map.touch_around(cutter, step, start, center_x, center_y, slack);
  });
}

}  // namespace dripfeed::gouge
