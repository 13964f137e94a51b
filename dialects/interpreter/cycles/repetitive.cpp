// The words of the cycles, and those without a shape.
//
// Pecking (G74 along Z, G75 along X): in by a peck, back by the retract, again to the end; then sideways by the step,
// and so on to the block's end point. Threading (G76): pass n lies dd·√n deep, no step being less than the least one,
// down to the finishing allowance; the last depth is cut as often as asked for.
#include "dialects/interpreter/cycles/repetitive.h"

#include <algorithm>
#include <cmath>

#include "dialects/interpreter/arithmetic/arithmetic.h"
#include "dialects/interpreter/motion/move.h"
#include "dialects/interpreter/state/axis_words.h"

namespace dripfeed::interpreter {

namespace {

using ir::Address;
using ir::MotionKind;

constexpr std::size_t kX = 0;
constexpr std::size_t kZ = 2;
constexpr double kStepsAtMost = 100'000.0;

class Words {
 public:
  Words(const PlainBlock& block, const BlockRules& rules, const ModalState& state)
      : block_(block), rules_(rules), inch_(state.modes.inch) {}

  [[nodiscard]] bool has(Address address) const { return block_.has(address); }
  [[nodiscard]] double length(Address address) const { return rules_.length_mm(block_, address, inch_); }
  // P and Q count least increments, whatever other words do without a point. A fraction was written with one.
  [[nodiscard]] double counted(Address address) const {
    const bool flagged = (block_.in_increments & bit_of(address)) != 0;
    const bool counting = flagged || address == Address::p || address == Address::d ||
                          rules_.semantics.decimal_mode == ir::DecimalMode::calculator;
    const bool counts = counting && block_.at(address) == std::trunc(block_.at(address));
    const double per_mm = rules_.increments_per_mm * (inch_ ? 10.0 : 1.0);
    const double value = counts ? block_.at(address) / per_mm : block_.at(address);
    return std::abs(inch_ ? value * 25.4 : value);
  }
  [[nodiscard]] double raw(Address address) const { return block_.at(address); }

 private:
  const PlainBlock& block_;
  const BlockRules& rules_;
  bool inch_;
};

// Straight moves in X (radius) and Z from where the tool is.
class Pen {
 public:
  Pen(const BlockRules& rules, ModalState& state, MotionBuffer& out, BlockResult& result)
      : factor_(rules.x_is_diameter ? 2.0 : 1.0), state_(state), out_(out), result_(result) {}

  [[nodiscard]] double x() const { return state_.position[kX] / factor_; }
  [[nodiscard]] double z() const { return state_.position[kZ]; }
  [[nodiscard]] bool known() const { return (state_.unknown & (1U << kX | 1U << kZ)) == 0; }
  [[nodiscard]] double radius(double kept) const { return kept / factor_; }

  void to(MotionKind kind, double x_radius, double z_to) {
    Target target{.end = state_.position};
    target.end[kX] = x_radius * factor_;
    target.end[kZ] = z_to;
    if (target.end[kX] != state_.position[kX]) target.commanded |= 1U << kX;
    if (z_to != state_.position[kZ]) target.commanded |= 1U << kZ;
    if (target.commanded == 0) return;
    emit_move(kind, target, kind == MotionKind::rapid ? 0.0 : state_.feed, {}, state_, out_, result_);
  }

 private:
  double factor_;
  ModalState& state_;
  MotionBuffer& out_;
  BlockResult& result_;
};

// Where the block's X and Z (or U and W) lead; what is not named stays.
struct EndPoint {
  double x = 0.0;  // radius
  double z = 0.0;
  bool has_x = false;
  bool has_z = false;
};
EndPoint end_point(const PlainBlock& block, const BlockRules& rules, const ModalState& state, const Pen& pen) {
  EndPoint end{.x = pen.x(), .z = pen.z()};
  for_each_axis_word(
      block, rules, state.modes, !state.modes.absolute, [&](std::size_t axis, double value, bool incremental) {
        if (axis != kX && axis != kZ) return;
        const double from = incremental ? state.position[axis] : state.modes.shift[axis] + state.coordinate_shift[axis];
        (axis == kX ? end.x : end.z) = axis == kX ? pen.radius(from + value) : from + value;
        (axis == kX ? end.has_x : end.has_z) = true;
      });
  return end;
}

// Along: the axis that is drilled; across: the one that is stepped in.
struct PeckRun {
  bool along_z = true;
  double peck = 0.0;
  double step = 0.0;
  double relief = 0.0;
  double retract = 0.0;
};

bool peck(const PeckRun& run, const EndPoint& end, Pen& pen) {
  const double along0 = run.along_z ? pen.z() : pen.x();
  const double across0 = run.along_z ? pen.x() : pen.z();
  const double along1 = run.along_z ? end.z : end.x;
  const double across1 = run.along_z ? end.x : end.z;
  const auto to = [&](MotionKind kind, double along, double across) {
    pen.to(kind, run.along_z ? across : along, run.along_z ? along : across);
  };
  const double sign_along = along1 < along0 ? -1.0 : 1.0;
  const double side = across1 < across0 ? -1.0 : 1.0;
  const double depth = std::abs(along1 - along0);
  const double width = std::abs(across1 - across0);
  const double one = run.peck > 0.0 ? run.peck : std::max(depth, 1e-9);
  const double step_over = run.step > 0.0 ? run.step : std::max(width, 1e-9);
  if ((depth / one + 1.0) * (width / step_over + 1.0) > kStepsAtMost) return false;
  const auto columns = static_cast<int>(std::ceil(width / step_over - 1e-9));
  for (int column = 0; column <= columns; ++column) {
    const double across = across0 + side * std::min(width, step_over * column);
    to(MotionKind::rapid, along0, across);
    for (int n = 1; one * n < depth - 1e-9; ++n) {
      to(MotionKind::linear, along0 + sign_along * one * n, across);
      to(MotionKind::rapid, along0 + sign_along * (one * n - run.retract), across);
    }
    to(MotionKind::linear, along1, across);
    // At the bottom aside, where there is room: the first cut has a wall on that side.
    const double out = run.relief > 0.0 && (column > 0 || width == 0.0) ? across - side * run.relief : across;
    to(MotionKind::rapid, along1, out);
    to(MotionKind::rapid, along0, out);
  }
  to(MotionKind::rapid, along0, across0);
  return true;
}

void pecking(const Words& words, const EndPoint& end, bool along_z, ModalState& state, Pen& pen, BlockResult& result) {
  PeckRun run{.along_z = along_z};
  const bool one_block = words.has(Address::i) || words.has(Address::k);
  const double x_step = one_block ? std::abs(words.has(Address::i) ? words.length(Address::i) : 0.0)
                                  : (words.has(Address::p) ? words.counted(Address::p) : 0.0);
  const double z_step = one_block ? std::abs(words.has(Address::k) ? words.length(Address::k) : 0.0)
                                  : (words.has(Address::q) ? words.counted(Address::q) : 0.0);
  run.peck = along_z ? z_step : x_step;
  run.step = along_z ? x_step : z_step;
  if (words.has(Address::d)) run.relief = words.counted(Address::d);
  if (words.has(Address::r)) run.relief = std::abs(words.length(Address::r));
  run.retract = state.repetitive.peck_retract_mm;
  if (!peck(run, end, pen)) result.fault = text::DiagnosticId::limit_reached;
}

// Depths of the passes, from the first to that of the finishing allowance and the thread's own.
std::vector<double> thread_depths(double height, double first, double least, double allowance, int finishes) {
  std::vector<double> depths;
  const double rough = std::max(0.0, height - allowance);
  double depth = 0.0;
  for (int n = 1; depth < rough - 1e-9; ++n) {
    depth = std::min(rough, std::max(first * std::sqrt(static_cast<double>(n)), depth + least));
    depths.push_back(depth);
  }
  for (int n = 0; n < finishes; ++n)
    if (n > 0 || height > depth + 1e-9) depths.push_back(height);
  return depths;
}

void thread(const Words& words, const EndPoint& end, ModalState& state, Pen& pen, BlockResult& result) {
  const Repetitive& data = state.repetitive;
  const bool one_block = words.has(Address::k);
  const double height = one_block               ? std::abs(words.length(Address::k))
                        : words.has(Address::p) ? words.counted(Address::p)
                                                : 0.0;
  double first = data.first_cut_mm;
  if (words.has(Address::q)) first = words.counted(Address::q);
  if (words.has(Address::d)) first = words.counted(Address::d);
  double taper = 0.0;
  if (words.has(Address::r)) taper = words.length(Address::r);
  if (words.has(Address::i)) taper = words.length(Address::i);
  const double angle = words.has(Address::a) ? words.raw(Address::a) : data.angle_deg;
  const double least = std::max(data.least_cut_mm, 1e-4);
  if (height <= 0.0 || height / least > kStepsAtMost) {
    result.fault = height <= 0.0 ? text::DiagnosticId::cycle_shape_invalid : text::DiagnosticId::limit_reached;
    return;
  }
  const double x0 = pen.x();
  const double z0 = pen.z();
  const double side = end.x < x0 ? -1.0 : 1.0;
  const double sign_z = end.z < z0 ? -1.0 : 1.0;
  // One flank cuts: each depth begins further along by its share of the angle.
  const double slope = sine_deg(angle / 2.0) / cosine_deg(angle / 2.0);
  const double run_out = one_block || state.feed_unknown ? 0.0 : data.run_out_leads * state.feed;
  for (const double depth : thread_depths(height, first, least, data.allowance_mm, data.finishes)) {
    const double x = end.x - side * (height - depth);
    const double z = z0 + sign_z * depth * slope;
    pen.to(MotionKind::rapid, x + taper, z);
    // The tool leaves at 45 degrees over the last leads, as far as there is room.
    const double out = std::min({run_out, std::abs(end.z - z), std::abs(x0 - x)});
    if (out > 0.0) {
      pen.to(MotionKind::thread, x + taper * out / std::abs(end.z - z), end.z - sign_z * out);
      pen.to(MotionKind::thread, x - side * out, end.z);
    } else {
      pen.to(MotionKind::thread, x, end.z);
    }
    pen.to(MotionKind::rapid, x0, end.z);
    pen.to(MotionKind::rapid, x0, z0);
  }
}

// The first of two blocks has no end point and no P with Q: it sets what the next ones use.
void keep_data(const Words& words, RepetitiveCycle cycle, Repetitive& data) {
  switch (cycle) {
    case RepetitiveCycle::rough_along_z:
      if (words.has(Address::u)) data.depth_mm = std::abs(words.length(Address::u));
      if (words.has(Address::r)) data.retract_mm = std::abs(words.length(Address::r));
      return;
    case RepetitiveCycle::rough_along_x:
      if (words.has(Address::w)) data.depth_mm = std::abs(words.length(Address::w));
      if (words.has(Address::r)) data.retract_mm = std::abs(words.length(Address::r));
      return;
    case RepetitiveCycle::pattern:
      if (words.has(Address::u)) data.relief_x_mm = words.length(Address::u);
      if (words.has(Address::w)) data.relief_z_mm = words.length(Address::w);
      if (words.has(Address::r))
        data.passes = static_cast<std::int32_t>(std::clamp(words.raw(Address::r), 1.0, 9999.0));
      return;
    case RepetitiveCycle::peck_z:
    case RepetitiveCycle::peck_x:
      if (words.has(Address::r)) data.peck_retract_mm = std::abs(words.length(Address::r));
      return;
    case RepetitiveCycle::thread:
      if (words.has(Address::p)) {  // mmrraa
        const auto p = static_cast<std::int32_t>(std::clamp(words.raw(Address::p), 0.0, 999999.0));
        data.finishes = std::max(1, p / 10000);
        data.angle_deg = p % 100;
        data.run_out_leads = p / 100 % 100 / 10.0;
      }
      if (words.has(Address::q)) data.least_cut_mm = words.counted(Address::q);
      if (words.has(Address::r)) data.allowance_mm = std::abs(words.length(Address::r));
      return;
    case RepetitiveCycle::finish:
    case RepetitiveCycle::count_: return;
  }
}

std::uint32_t block_number(const Words& words, Address address) {
  const double value = words.raw(address);
  return value >= 0.0 && value <= 99'999'999.0 ? static_cast<std::uint32_t>(value) : 0;
}

}  // namespace

void repetitive_block(const PlainBlock& block, const BlockRules& rules, std::int16_t cycle, ModalState& state,
                      MotionBuffer& out, BlockResult& result) {
  const Words words(block, rules, state);
  Repetitive& data = state.repetitive;
  data.cycle = static_cast<std::uint8_t>(cycle);
  const auto kind = static_cast<RepetitiveCycle>(cycle);
  Pen pen(rules, state, out, result);
  if (kind <= RepetitiveCycle::pattern) {
    if (!words.has(Address::p) || !words.has(Address::q)) return keep_data(words, kind, data);
    data.first_block = block_number(words, Address::p);
    data.last_block = block_number(words, Address::q);
    // U is a diameter.
    data.allowance_x_mm = words.has(Address::u) ? words.length(Address::u) / (rules.x_is_diameter ? 2.0 : 1.0) : 0.0;
    data.allowance_z_mm = words.has(Address::w) ? words.length(Address::w) : 0.0;
    if (words.has(Address::d) && kind != RepetitiveCycle::pattern) data.depth_mm = words.counted(Address::d);
    if (words.has(Address::d) && kind == RepetitiveCycle::pattern)
      data.passes = static_cast<std::int32_t>(std::clamp(words.raw(Address::d), 1.0, 9999.0));
    if (kind == RepetitiveCycle::pattern && words.has(Address::i)) data.relief_x_mm = words.length(Address::i);
    if (kind == RepetitiveCycle::pattern && words.has(Address::k)) data.relief_z_mm = words.length(Address::k);
    result.needs_shape = true;
    return;
  }
  const EndPoint end = end_point(block, rules, state, pen);
  if (!end.has_x && !end.has_z) return keep_data(words, kind, data);
  if (!pen.known()) {
    result.notes |= kNoteLevelUnknown;
    return;
  }
  if (kind == RepetitiveCycle::thread) return thread(words, end, state, pen, result);
  pecking(words, end, kind == RepetitiveCycle::peck_z, state, pen, result);
}

}  // namespace dripfeed::interpreter
