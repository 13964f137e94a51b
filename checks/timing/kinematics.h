// What one motion asks of the machine: how long its path is, in which directions it begins and ends, how fast it may go
// and how hard it may be accelerated, given each axis' limits.
#pragma once

#include <array>
#include <cstddef>

#include "checks/machine.h"
#include "checks/timing/piece_arrays.h"
#include "dialects/ir/motion.h"

namespace dripfeed::timing {

using AxisVector = std::array<double, ir::kAxisCount>;

// Per axis, mm/s and mm/s² (degrees for rotary ones); kNoLimit where the machine does not say.
struct AxisRates {
  AxisVector rapid;
  AxisVector feed;
  AxisVector acceleration;
  AxisVector jerk;                    // per s³; kNoLimit: acceleration may jump
  double feed_limit = kNoLimit;       // mm/s, along the path
  double sample_s = 0.0;              // 0: not known
  double contour_tolerance_mm = 0.0;  // 0: corners are not rounded
  bool rapid_known = false;           // of every axis
  bool acceleration_known = false;
};
AxisRates rates_of(const checks::Machine& machine);

// A path's geometry; x as radius. Length in mm; of a purely rotary move in degrees.
struct PathShape {
  double length = 0.0;
  AxisVector start_direction{};  // unit
  AxisVector end_direction{};
  double plane_share = 0.0;  // arcs: share of the speed that runs in the plane; 0: straight
  double radius = 0.0;       // arcs, mm
  std::size_t abscissa = 0;  // arcs: axes of the plane
  std::size_t ordinate = 1;
};
// Axes whose start is not known stand still in it.
PathShape shape_of(const ir::Motion& motion, bool x_is_diameter);

// Highest speed along the path that no axis' rapid (or feed) limit forbids, mm/s; on arcs that the centripetal
// acceleration allows, too, which gets half of the square of what the axes can do, the other half is for the path.
double speed_limit(const PathShape& shape, const AxisRates& rates, bool is_rapid);
double path_acceleration(const PathShape& shape, const AxisRates& rates);

// The acceleration that takes as long, over as much path, as the ramp from rest to `speed` that is limited by
// acceleration and jerk (acceleration rises and falls evenly): a long move has its exact time, shorter changes of speed
// have it nearly. kNoLimit as jerk: the acceleration itself.
double mean_acceleration(double acceleration, double jerk, double speed);
// Of the axes' jerk along the path, as path_acceleration.
double path_jerk(const PathShape& shape, const AxisRates& rates);

// Square of the highest speed at a corner, mm²/s²: within one sample time each axis can change its speed by its
// acceleration times that time (V1 of the look-ahead in A. Keinert, A. Verl). kNoLimit when a figure is missing. With a
// contour tolerance the control may round it: on the arc that touches both moves, leaves the corner by the tolerance at
// most, and begins no farther than `room_mm` before it (half of the shorter move), with the centripetal acceleration
// that each axis that turns can do.
double corner_speed2(const AxisVector& before, const AxisVector& after, const AxisRates& rates, double room_mm);

// mm/s of a cutting feed along the path; 0 where it cannot be known (no feed, or per revolution without a speed).
// With constant surface speed the time is exact: the mean of 1/rpm over the diameters that the move passes. Of a thread
// whose lead changes it is the mean over its length.
double feed_speed(const ir::Motion& motion, const PathShape& shape, bool x_is_diameter, double spindle_max_rpm);

}  // namespace dripfeed::timing
