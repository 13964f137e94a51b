// Speeds: the feed of each mode against the machine's and each axis' highest, the spindle's speed, also where constant
// surface speed makes it.
#pragma once

#include "checks/envelope/report.h"
#include "checks/envelope/travel.h"

namespace dripfeed::envelope {

class Speeds {
 public:
  Speeds(const Settings& settings, const Travel& travel, Report& report)
      : settings_(settings), travel_(travel), report_(report) {}
  void check_spindle_event(const ir::Motion& event);
  void check_cut(const ir::Motion& cut);
  // mm/min, the highest of cuts with a feed per minute.
  [[nodiscard]] double highest_per_min() const { return highest_per_min_; }

 private:
  void check_spindle(const ir::Motion& motion, double diameter_mm);
  [[nodiscard]] double smallest_diameter_mm(const ir::Motion& cut) const;
  [[nodiscard]] double feed_of_turns(const ir::Motion& cut, double diameter_mm);
  [[nodiscard]] double highest_lead(const ir::Motion& cut) const;
  [[nodiscard]] double distance_mm(const ir::Motion& cut) const;
  void check_axis_feeds(const ir::Motion& cut, double feed_mm_min);

  const Settings& settings_;
  const Travel& travel_;
  Report& report_;
  double highest_per_min_ = 0.0;
};

}  // namespace dripfeed::envelope
