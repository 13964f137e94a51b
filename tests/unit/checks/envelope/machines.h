// A lathe and a mill, moves on them, and a run of the envelope check.
#pragma once

#include <algorithm>
#include <string_view>
#include <utility>
#include <vector>

#include "checks/envelope/envelope.h"

namespace dripfeed::envelope {

inline checks::Machine lathe() {
  checks::Machine machine;
  machine.kind = ir::MachineKind::lathe;
  machine.axes.push_back({.axis = ir::Axis::x, .is_diameter = true, .min = -5, .max = 150});
  machine.axes.push_back({.axis = ir::Axis::z, .min = -20, .max = 400});
  machine.feed_limit_mm_min = 5000;
  machine.spindle_min_rpm = 30;
  machine.spindle_max_rpm = 3000;
  machine.tools.push_back(
      {.number = 6, .offset = 6, .nose_radius_mm = 0.8, .tip = 3, .length_x_mm = 40.0, .length_z_mm = -25.0});
  machine.tools.push_back({.number = 7, .offset = 7, .nose_radius_mm = 0.4, .tip = 3});
  checks::WorkOffset g55{.number = 2};
  g55.zero[0] = 0;
  g55.zero[2] = 200;
  machine.work_offsets.push_back(g55);
  return machine;
}

// The gauge line of its spindle runs from -500 to 0, the work zero lies at -450.
inline checks::Machine mill() {
  checks::Machine machine;
  machine.axes.push_back({.axis = ir::Axis::x, .min = 0, .max = 800, .feed_limit_mm_min = 3000});
  machine.axes.push_back({.axis = ir::Axis::y, .min = 0, .max = 500});
  machine.axes.push_back({.axis = ir::Axis::z, .min = -500, .max = 0});
  machine.feed_limit_mm_min = 5000;
  machine.spindle_max_rpm = 8000;
  machine.tools.push_back({.number = 1, .offset = 11, .diameter_mm = 10, .length_mm = 120});
  machine.tools.push_back({.number = 1, .offset = 2, .diameter_mm = 10, .length_mm = 60});
  machine.tools.push_back({.number = 3, .offset = 1, .diameter_mm = 10, .length_mm = 100});
  machine.tools.push_back({.number = 4, .offset = 4, .diameter_mm = 10});
  checks::WorkOffset g54{.number = 1};
  g54.zero[0] = 200;
  g54.zero[1] = 200;
  g54.zero[2] = -450;
  machine.work_offsets.push_back(g54);
  return machine;
}

// In X and Z, at line 7.
inline ir::Motion move(ir::MotionKind kind, double from_x, double from_z, double x, double z) {
  ir::Motion motion;
  motion.kind = kind;
  motion.place = {0, 7, 6};
  motion.plane = ir::Plane::zx;
  motion.axes_commanded = 0b101;
  motion.start[0] = from_x;
  motion.start[2] = from_z;
  motion.end[0] = x;
  motion.end[2] = z;
  motion.feed = kind == ir::MotionKind::rapid ? 0 : 100;
  return motion;
}

inline ir::Motion event(ir::MotionKind kind, std::int32_t number = 0) {
  ir::Motion motion;
  motion.kind = kind;
  motion.place = {0, 5, 4};
  motion.number = number;
  return motion;
}

// With tool 6 called before.
inline Report run(const std::vector<ir::Motion>& motions, Settings settings) {
  const int tool = settings.machine.kind == ir::MachineKind::mill ? 1 : 6;
  Envelope check(std::move(settings));
  const std::vector<ir::Motion> call = {event(ir::MotionKind::tool, tool)};
  check.consume(call);
  check.consume(motions);
  return check.finish();
}
inline Report run(const std::vector<ir::Motion>& motions, std::int32_t work_offset = 2, double part_size_mm = 0) {
  return run(motions, {.machine = lathe(), .work_offset = work_offset, .part_size_mm = part_size_mm});
}

inline bool reports(const Report& report, std::string_view sentence) {
  return std::ranges::any_of(report.not_checked.list(), [&](const auto& one) { return one.text == sentence; });
}

}  // namespace dripfeed::envelope
