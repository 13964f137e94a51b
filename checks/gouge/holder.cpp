// Each step is a flat disk at its height above the tip.
#include "checks/gouge/holder.h"

namespace dripfeed::gouge {

namespace {

void keep_deeper(HolderTouch& deepest, const Depth& depth, const checks::HolderStep& step) {
  if (depth.mm > deepest.depth.mm) deepest = {depth, step};
}

}  // namespace

HolderTouch Holder::touch(const HeightMap& map, const Point3& from, const Point3& to, double slack) const {
  HolderTouch deepest;
  for (const checks::HolderStep& step : steps_) {
    const Cutter disk{0.5 * step.diameter_mm, 0.0};
    const Point3 low{from.x, from.y, from.z + step.from_mm};
    const Point3 high{to.x, to.y, to.z + step.from_mm};
    keep_deeper(deepest, map.touch(disk, low, high, slack).stock, step);
  }
  return deepest;
}

HolderTouch Holder::touch_ahead(const HeightMap& map, const Cutter& cutter, const Point3& from, const Point3& to,
                                double slack) const {
  HolderTouch deepest;
  for (const checks::HolderStep& step : steps_)
    keep_deeper(deepest, map.touch_ahead(cutter, step, from, to, slack), step);
  return deepest;
}

HolderTouch Holder::touch_level(const HeightMap& map, const Cutter& cutter, const Point3& from, const Point3& to,
                                double slack) const {
  HolderTouch deepest;
  for (const checks::HolderStep& step : steps_)
    keep_deeper(deepest, map.touch_level(cutter, step, from, to, slack), step);
  return deepest;
}

HolderTouch Holder::touch_around(const HeightMap& map, const Cutter& cutter, const Point3& start, double center_x,
                                 double center_y, double slack) const {
  HolderTouch deepest;
  for (const checks::HolderStep& step : steps_)
    keep_deeper(deepest, map.touch_around(cutter, step, start, center_x, center_y, slack), step);
  return deepest;
}

}  // namespace dripfeed::gouge
