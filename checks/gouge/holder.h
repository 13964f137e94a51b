// The shank and holder of the mill in the spindle against what is left of the stock. They cut nothing: where they meet
// material the tool breaks, in a cut as in a rapid.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "checks/gouge/cutter.h"
#include "checks/gouge/height_map.h"
#include "checks/machine.h"

namespace dripfeed::gouge {

struct HolderTouch {
  Depth depth;  // 0: none
  checks::HolderStep step;
};

class Holder {
 public:
  // Of no tool: nothing is known of it.
  Holder() = default;
  explicit Holder(std::span<const checks::HolderStep> steps) : steps_(steps.begin(), steps.end()) {}

  [[nodiscard]] bool is_known() const { return !steps_.empty(); }
  // Whether any of it is as low as the stock is high while the tip is at this height.
  [[nodiscard]] bool may_touch(const HeightMap& map, double tip_z) const {
    return is_known() && tip_z + steps_.front().from_mm < map.top_mm();
  }
  // The deepest touch of a move that takes nothing away, or of a cut that was taken off the map already.
  [[nodiscard]] HolderTouch touch(const HeightMap& map, const Point3& from, const Point3& to, double slack) const;
  // The same of a cut that is still to be taken off the map: what the cutter itself removes first does not count.
  [[nodiscard]] HolderTouch touch_ahead(const HeightMap& map, const Cutter& cutter, const Point3& from,
                                        const Point3& to, double slack) const;
  // Both of a flat cutter, along a level line or around a full circle that is still to be taken off.
  [[nodiscard]] HolderTouch touch_level(const HeightMap& map, const Cutter& cutter, const Point3& from,
                                        const Point3& to, double slack) const;
  [[nodiscard]] HolderTouch touch_around(const HeightMap& map, const Cutter& cutter, const Point3& start,
                                         double center_x, double center_y, double slack) const;

 private:
  std::vector<checks::HolderStep> steps_;
};

}  // namespace dripfeed::gouge
