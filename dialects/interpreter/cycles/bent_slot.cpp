// An arc of more than a half circle is made of two, because a whole circle has no end of its own.
#include "dialects/interpreter/cycles/bent_slot.h"

#include <cmath>

#include "dialects/interpreter/arithmetic/arithmetic.h"

namespace dripfeed::interpreter {

namespace {

PlanePoint on_circle(double radius, double angle_deg) {
  return {radius * cosine_deg(angle_deg), radius * sine_deg(angle_deg)};
}

void cut_arc(double radius, double from_deg, double to_deg, double feed, MillTool& tool) {
  const Turn turn = to_deg > from_deg ? Turn::counterclockwise : Turn::clockwise;
  if (std::abs(to_deg - from_deg) > 180.0)
    tool.arc(on_circle(radius, (from_deg + to_deg) / 2.0), {0.0, 0.0}, turn, feed);
  tool.arc(on_circle(radius, to_deg), {0.0, 0.0}, turn, feed);
}

void cut_ring(const BentSlot& slot, Turn turn, double feed, MillTool& tool) {
  const bool is_left = turn == Turn::counterclockwise;
  const double inside = slot.radius - slot.off;
  cut_arc(slot.radius + slot.off, is_left ? 0.0 : 360.0, is_left ? 360.0 : 0.0, feed, tool);
  tool.cut({inside, 0.0}, feed);
  cut_arc(inside, is_left ? 360.0 : 0.0, is_left ? 0.0 : 360.0, feed, tool);
  tool.cut(slot.start(), feed);
}

}  // namespace

void cut_along(const BentSlot& slot, double feed, MillTool& tool) {
  cut_arc(slot.radius, 0.0, slot.angle_deg, feed, tool);
  if (!slot.is_ring()) cut_arc(slot.radius, slot.angle_deg, 0.0, feed, tool);
}

void cut_around(const BentSlot& slot, Turn turn, double feed, MillTool& tool) {
  if (slot.is_ring()) return cut_ring(slot, turn, feed, tool);
  const double outside = slot.radius + slot.off;
  const double inside = slot.radius - slot.off;
  const double end = slot.angle_deg;
  const PlanePoint last = on_circle(slot.radius, end);
  if (turn == Turn::counterclockwise) {
    cut_arc(outside, 0.0, end, feed, tool);
    tool.arc(on_circle(inside, end), last, turn, feed);
    cut_arc(inside, end, 0.0, feed, tool);
    tool.arc(slot.start(), slot.middle(), turn, feed);
  } else {
    tool.arc({inside, 0.0}, slot.middle(), turn, feed);
    cut_arc(inside, 0.0, end, feed, tool);
    tool.arc(on_circle(outside, end), last, turn, feed);
    cut_arc(outside, end, 0.0, feed, tool);
  }
}

}  // namespace dripfeed::interpreter
