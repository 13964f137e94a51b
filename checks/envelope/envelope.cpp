// Each move is looked at once: its end, the extremes of an arc, its speeds. What a missing figure would be needed for
// is reported once and not guessed. The limits of a machine are a box: a rapid whose axes run one by one instead of in
// a line stays in the box of its ends, so that their check holds for it, too.
#include "checks/envelope/envelope.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "checks/arcs.h"

namespace dripfeed::envelope {

namespace {

constexpr double kSameAngle = 1e-9;
constexpr double kInch_mm = 25.4;

// Which of the move's figures is none; empty: all are numbers.
std::string_view no_number_in(const ir::Motion& motion) {
  const auto finite = [](double value) { return std::isfinite(value); };
  if (!std::ranges::all_of(motion.end, finite)) return "where it ends";
  if (!std::ranges::all_of(motion.start, finite)) return "where it begins";
  if (!std::ranges::all_of(motion.center, finite)) return "its centre";
  if (!finite(motion.feed)) return "its feed";
  return finite(motion.spindle_rpm) && finite(motion.surface_speed_m_min) ? "" : "its speed";
}

}  // namespace

Envelope::Envelope(Settings settings)
    : settings_(std::move(settings)), travel_(settings_, report_), speeds_(settings_, travel_, report_) {
  report_unknowns();
}

void Envelope::report_unknowns() {
  const checks::Machine& machine = settings_.machine;
  if (machine.axes.empty()) report_.not_checked.add("the machine's axes are not known: no travel was checked");
  if (machine.tools.empty()) report_.not_checked.add("the machine's tools are not known");
  if (!(machine.feed_limit_mm_min > 0.0)) report_.not_checked.add("the machine's highest feed is not known");
  if (!(machine.spindle_max_rpm > 0.0)) report_.not_checked.add("the machine's highest spindle speed is not known");
}

void Envelope::consume(std::span<const ir::Motion> motions) {
  for (const ir::Motion& motion : motions) {
    if (ir::is_move(motion.kind)) {
      check_move(motion);
    } else if (motion.kind == ir::MotionKind::offset) {
      travel_.select_offset(motion.number);
    } else if (motion.kind == ir::MotionKind::tool) {
      take_tool(motion);
    } else if (motion.kind == ir::MotionKind::spindle) {
      spindle_ran_ = spindle_ran_ || motion.spindle != ir::SpindleState::stopped;
      speeds_.check_spindle_event(motion);
    }
  }
}

void Envelope::take_tool(const ir::Motion& motion) {
  constexpr std::uint32_t kNoName = 0xFFFFFFFFU;
  has_tool_ = motion.number > 0 || motion.text != kNoName;
  travel_.select_tool(motion);
  // One by a name that the profile does not have has the number 0: the run reports it.
  if (settings_.machine.tools.empty() || motion.number <= 0) return;
  if (checks::find_tool(settings_.machine, motion.number) == nullptr)
    report_.findings.add(text::DiagnosticId::tool_missing, motion.place, motion.number, 0.0,
                         [&] { return std::vector<std::string>{fmt::format("{}", motion.number)}; });
}

void Envelope::check_move(const ir::Motion& motion) {
  ++report_.moves;
  if (const std::string_view what = no_number_in(motion); !what.empty()) {
    report_.findings.add(text::DiagnosticId::value_not_finite, motion.place, 0.0, 0.0,
                         [&] { return std::vector<std::string>{std::string(what)}; });
    return;
  }
  const bool cuts = motion.kind != ir::MotionKind::rapid;
  travel_.begin(motion);
  for (std::size_t i = 0; i < ir::kAxisCount; ++i) {
    const bool moves = (motion.axes_commanded >> i & 1U) != 0 || motion.end[i] != motion.start[i];
    if (!moves) continue;
    const double value = travel_.slide(i, motion.end[i]);
    travel_.check(motion, static_cast<ir::Axis>(i), value);
    if (motion.machine_coordinates || is_rotary(i)) continue;
    if (i < spans_.size()) {
      spans_[i].include(value);
      if ((motion.axes_unknown >> i & 1U) == 0) spans_[i].include(travel_.slide(i, motion.start[i]));
    }
    if (cuts) include_cut(motion, value);
  }
  if (checks::is_arc(motion)) check_arc(motion);
  if (motion.kind == ir::MotionKind::spline)
    report_.not_checked.add("a spline was checked at its points only", motion.place.line);
  if (cuts) check_cut(motion);
}

void Envelope::include_cut(const ir::Motion& motion, double value) {
  const double before = cut_.empty() ? -1.0 : std::max(std::fabs(cut_.low), std::fabs(cut_.high));
  cut_.include(value);
  if (std::fabs(value) > before) cut_place_ = motion.place;
}

void Envelope::check_cut(const ir::Motion& motion) {
  speeds_.check_cut(motion);
  if (motion.comp != ir::CompSide::off)
    report_.not_checked.add("with tool radius compensation the travel is that of the programmed path",
                            motion.place.line);
  if (!has_tool_ && !has_reported_no_tool_) {
    has_reported_no_tool_ = true;
    report_.findings.add(text::DiagnosticId::tool_not_called, motion.place, 0.0, 0.0,
                         [] { return std::vector<std::string>{}; });
  }
  // A tap turns with its feed, also from a spindle that stands; driven tools have codes of the machine's builder.
  const bool turns = motion.spindle != ir::SpindleState::stopped || motion.kind == ir::MotionKind::thread;
  const bool may_be_driven = settings_.machine.kind != ir::MachineKind::mill && travel_.axis(5) != nullptr;
  if (turns || may_be_driven) {
    has_reported_standing_ = has_reported_standing_ && motion.spindle == ir::SpindleState::stopped;
  } else if (!spindle_ran_) {
    report_.not_checked.add("no spindle is started before the first cut: whether it turns is not known",
                            motion.place.line);
  } else if (!has_reported_standing_) {
    has_reported_standing_ = true;  // until it turns again
    report_.findings.add(text::DiagnosticId::spindle_not_turning, motion.place, 0.0, 0.0,
                         [] { return std::vector<std::string>{}; });
  }
}

// The radius at both ends, and the places where the arc reaches farther than its ends. A helix moves along its axis
// between its ends only.
void Envelope::check_arc(const ir::Motion& motion) {
  const checks::PlaneAxes plane = checks::axes_of(motion.plane);
  const auto a = static_cast<ir::Axis>(plane.abscissa);
  const auto o = static_cast<ir::Axis>(plane.ordinate);
  const double start_a = travel_.slide(plane.abscissa, motion.start[plane.abscissa]);
  const double start_o = travel_.slide(plane.ordinate, motion.start[plane.ordinate]);
  const double end_a = travel_.slide(plane.abscissa, motion.end[plane.abscissa]);
  const double end_o = travel_.slide(plane.ordinate, motion.end[plane.ordinate]);
  const double center_a = start_a + motion.center[plane.abscissa];
  const double center_o = start_o + motion.center[plane.ordinate];
  const double start_radius = std::hypot(start_a - center_a, start_o - center_o);
  const double end_radius = std::hypot(end_a - center_a, end_o - center_o);
  const double allowed = std::max(settings_.arc_tolerance_mm, settings_.arc_tolerance_factor * start_radius);
  if (std::fabs(start_radius - end_radius) > allowed) {
    report_.findings.add(text::DiagnosticId::arc_radius_mismatch, motion.place, end_radius, start_radius,
                         [&] { return std::vector<std::string>{figure(start_radius), figure(end_radius)}; });
  }
  const double turn = motion.kind == ir::MotionKind::arc_ccw ? 1.0 : -1.0;
  const double start_angle = std::atan2(start_o - center_o, start_a - center_a);
  const auto turn_to = [&](double angle) {
    const double full = 2.0 * std::numbers::pi;
    const double rest = std::fmod(turn * (angle - start_angle), full);
    return rest < 0.0 ? rest + full : rest;
  };
  const bool full_circle = std::hypot(end_a - start_a, end_o - start_o) < checks::kSamePoint_mm;
  const double sweep = full_circle ? 2.0 * std::numbers::pi : turn_to(std::atan2(end_o - center_o, end_a - center_a));
  const auto reach = [&](std::size_t i, ir::Axis axis, double value) {
    travel_.check(motion, axis, value);
    if (!motion.machine_coordinates && i < spans_.size()) spans_[i].include(value);
  };
  for (int quarter = 0; quarter < 4; ++quarter) {
    const double reached = turn_to(quarter * 0.5 * std::numbers::pi);
    if (reached < kSameAngle || reached > sweep - kSameAngle) continue;  // the ends are looked at already
    const double sign = quarter < 2 ? 1.0 : -1.0;
    if (quarter % 2 == 0) {
      reach(plane.abscissa, a, center_a + sign * start_radius);
    } else {
      reach(plane.ordinate, o, center_o + sign * start_radius);
    }
  }
}

// A factor of 25.4 between the cuts' reach and the part's size, or a travel that would fit if the reach were inches.
void Envelope::check_units() {
  constexpr double kLow = 0.5;
  constexpr double kHigh = 2.0;
  if (cut_.empty()) return;
  const double size = std::max(std::fabs(cut_.low), std::fabs(cut_.high));
  const auto add = [&](double value, double limit, std::string_view what, std::string how) {
    report_.findings.add(text::DiagnosticId::unit_suspicion, cut_place_, value, limit,
                         [&] { return std::vector<std::string>{std::string(what), std::move(how)}; });
  };
  if (settings_.part_size_mm > 0.0) {
    const double ratio = size / settings_.part_size_mm;
    const auto near = [&](double wanted) { return ratio > kLow * wanted && ratio < kHigh * wanted; };
    if (near(kInch_mm) || near(1.0 / kInch_mm)) {
      add(size, settings_.part_size_mm, "reach",
          fmt::format("it cuts up to {} mm from its zero, and the part measures {} mm", figure(size),
                      figure(settings_.part_size_mm)));
    }
  }
  const double limit = settings_.machine.feed_limit_mm_min;
  const double feed = speeds_.highest_per_min();
  if (limit > 0.0 && feed > limit && feed <= limit * kInch_mm &&
      report_.findings.count(text::DiagnosticId::travel_exceeded) > 0) {
    add(feed, limit, "feed and travel", "both are beyond the machine, and neither would be if divided by 25.4");
  }
  // Far longer than the whole travel of an axis: no work offset can make it fit.
  constexpr double kFar = 2.0;
  for (std::size_t i = 0; i < spans_.size(); ++i) {
    const checks::MachineAxis* axis = travel_.axis(i);
    if (axis == nullptr || !axis->min || !axis->max) continue;
    const double travel = *axis->max - *axis->min;
    const double span = spans_[i].span();
    if (span <= kFar * travel || span / kInch_mm > travel) continue;
    add(span, travel, fmt::format("distance along {}", ir::kAxisLetters[i]),
        fmt::format("it is {} mm long, the machine's {} mm, and it would fit if divided by 25.4", figure(span),
                    figure(travel)));
  }
}

Report Envelope::finish() {
  check_units();
  return std::move(report_);
}

}  // namespace dripfeed::envelope
