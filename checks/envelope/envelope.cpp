// Each move is looked at once: its end, the extremes of an arc, its speeds. What a missing figure would be needed for
// is said once and not guessed.
#include "checks/envelope/envelope.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "dialects/text/number.h"

namespace dripfeed::envelope {

namespace {

constexpr std::string_view kLetters = "XYZABCUVW";
constexpr double kTravelSlack = 1e-6;  // mm or degrees: rounding, not a limit
constexpr double kSpeedSlack = 1e-9;   // relative
constexpr double kSamePoint_mm = 1e-9;
constexpr double kInch_mm = 25.4;

struct PlaneAxes {
  std::size_t abscissa;
  std::size_t ordinate;
};
// Indexed by ir::Plane: xy, zx, yz.
constexpr std::array<PlaneAxes, 3> kPlanes = {PlaneAxes{0, 1}, {2, 0}, {1, 2}};

bool is_rotary(std::size_t axis) { return axis >= 3 && axis <= 5; }
bool is_arc(const ir::Motion& motion) {
  return motion.kind == ir::MotionKind::arc_cw || motion.kind == ir::MotionKind::arc_ccw;
}
std::string figure(double value) {
  std::string out;
  text::append_word_number(out, value, 4, true);
  return out;
}

}  // namespace

Envelope::Envelope(Settings settings) : settings_(std::move(settings)), offset_number_(settings_.work_offset) {
  for (const checks::MachineAxis& axis : settings_.machine.axes) axes_[static_cast<std::size_t>(axis.axis)] = &axis;
  offset_ = checks::find_work_offset(settings_.machine, offset_number_);
  if (settings_.machine.axes.empty())
    report_.not_checked.add("the machine's axes are not known: no travel was checked");
  if (settings_.machine.tools.empty()) report_.not_checked.add("the machine's tools are not known");
  if (!(settings_.machine.feed_limit_mm_min > 0.0)) report_.not_checked.add("the machine's highest feed is not known");
  if (!(settings_.machine.spindle_max_rpm > 0.0)) {
    report_.not_checked.add("the machine's highest spindle speed is not known");
  }
  for (const checks::MachineAxis& axis : settings_.machine.axes) {
    if (axis.min || axis.max) continue;
    const char letter = kLetters[static_cast<std::size_t>(axis.axis)];
    report_.not_checked.add(fmt::format("the travel of {} is not known", letter));
  }
  report_.not_checked.add("tool lengths are not counted in the travel");
}

void Envelope::consume(std::span<const ir::Motion> motions) {
  for (const ir::Motion& motion : motions) {
    if (ir::is_move(motion.kind)) {
      check_move(motion);
    } else if (motion.kind == ir::MotionKind::offset) {
      offset_number_ = motion.number;
      said_ = 0;
      offset_ = checks::find_work_offset(settings_.machine, offset_number_);
    } else if (motion.kind == ir::MotionKind::tool && !settings_.machine.tools.empty() && motion.number > 0 &&
               checks::find_tool(settings_.machine, motion.number) == nullptr) {
      report_.findings.add(text::DiagnosticId::tool_missing, motion.place, motion.number, 0.0,
                           [&] { return std::vector<std::string>{fmt::format("{}", motion.number)}; });
    } else if (motion.kind == ir::MotionKind::spindle && !(motion.surface_speed_m_min > 0.0)) {
      check_spindle(motion, 0.0);
    }
  }
}

double Envelope::slide(ir::Axis axis, double programmed) const {
  const checks::MachineAxis* known = axes_[static_cast<std::size_t>(axis)];
  return known != nullptr && known->is_diameter ? 0.5 * programmed : programmed;
}

// One coordinate in the frame of the motion: travel in machine coordinates, and what was reached.
void Envelope::check_place(const ir::Motion& motion, ir::Axis axis, double value) {
  const auto i = static_cast<std::size_t>(axis);
  const checks::MachineAxis* known = axes_[i];
  double at = value;
  if (!motion.machine_coordinates) {
    report_.work[i].include(value);
    if (known == nullptr) return;
    const bool has_zero = offset_number_ == 0 || (offset_ != nullptr && offset_->zero[i]);
    if (!has_zero) {
      if ((known->min || known->max) && (said_ >> i & 1U) == 0) {
        said_ = static_cast<std::uint16_t>(said_ | 1U << i);
        report_.not_checked.add(
            fmt::format("work offset {} is not known for {}: its travel was not checked", offset_number_, kLetters[i]),
            motion.place.line);
      }
      return;
    }
    if (offset_number_ != 0) at += *offset_->zero[i];
  } else if (known == nullptr) {
    return;
  }
  report_.machine[i].include(at);
  if (!known->min && !known->max) return;
  const bool below = known->min && at < *known->min - kTravelSlack;
  const bool above = known->max && at > *known->max + kTravelSlack;
  if (!below && !above) return;
  const double limit = below ? *known->min : *known->max;
  report_.findings.add(text::DiagnosticId::travel_exceeded, motion.place, at, limit, [&] {
    const auto bound = [](const std::optional<double>& end) { return end ? figure(*end) : std::string("anything"); };
    return std::vector<std::string>{std::string(1, kLetters[i]), figure(at),
                                    fmt::format("{} to {}", bound(known->min), bound(known->max))};
  });
}

void Envelope::check_move(const ir::Motion& motion) {
  ++report_.moves;
  const bool cuts = motion.kind != ir::MotionKind::rapid;
  for (std::size_t i = 0; i < ir::kAxisCount; ++i) {
    const bool moves = (motion.axes_commanded >> i & 1U) != 0 || motion.end[i] != motion.start[i];
    if (!moves) continue;
    const auto axis = static_cast<ir::Axis>(i);
    const double value = slide(axis, motion.end[i]);
    check_place(motion, axis, value);
    if (cuts && !is_rotary(i) && !motion.machine_coordinates) cut_.include(value);
  }
  if (is_arc(motion)) check_arc(motion);
  if (!cuts) return;
  cut_place_ = motion.place;
  check_speeds(motion);
}

// The radius at both ends, and the places where the arc reaches farther than its ends.
void Envelope::check_arc(const ir::Motion& motion) {
  const PlaneAxes plane = kPlanes[static_cast<std::size_t>(motion.plane)];
  const auto a = static_cast<ir::Axis>(plane.abscissa);
  const auto o = static_cast<ir::Axis>(plane.ordinate);
  const double start_a = slide(a, motion.start[plane.abscissa]);
  const double start_o = slide(o, motion.start[plane.ordinate]);
  const double end_a = slide(a, motion.end[plane.abscissa]);
  const double end_o = slide(o, motion.end[plane.ordinate]);
  const double center_a = start_a + motion.center[plane.abscissa];
  const double center_o = start_o + motion.center[plane.ordinate];
  const double start_radius = std::hypot(start_a - center_a, start_o - center_o);
  const double end_radius = std::hypot(end_a - center_a, end_o - center_o);
  if (std::fabs(start_radius - end_radius) > settings_.arc_tolerance_mm) {
    report_.findings.add(text::DiagnosticId::arc_radius_mismatch, motion.place, end_radius, start_radius,
                         [&] { return std::vector<std::string>{figure(start_radius), figure(end_radius)}; });
  }
  const double turn = motion.kind == ir::MotionKind::arc_ccw ? 1.0 : -1.0;
  const double start_angle = std::atan2(start_o - center_o, start_a - center_a);
  const auto behind = [&](double angle) {
    const double full = 2.0 * std::numbers::pi;
    const double rest = std::fmod(turn * (angle - start_angle), full);
    return rest < 0.0 ? rest + full : rest;
  };
  const bool full_circle = std::hypot(end_a - start_a, end_o - start_o) < kSamePoint_mm;
  const double sweep = full_circle ? 2.0 * std::numbers::pi : behind(std::atan2(end_o - center_o, end_a - center_a));
  for (int quarter = 0; quarter < 4; ++quarter) {
    if (behind(quarter * 0.5 * std::numbers::pi) > sweep) continue;
    const double sign = quarter < 2 ? 1.0 : -1.0;
    if (quarter % 2 == 0) {
      check_place(motion, a, center_a + sign * start_radius);
    } else {
      check_place(motion, o, center_o + sign * start_radius);
    }
  }
}

void Envelope::check_spindle(const ir::Motion& motion, double diameter_mm) {
  const double highest = settings_.machine.spindle_max_rpm;
  double rpm = motion.spindle_rpm;
  if (motion.surface_speed_m_min > 0.0) {
    if (!(diameter_mm > 0.0)) return;
    const double asked = 1000.0 * motion.surface_speed_m_min / (std::numbers::pi * diameter_mm);
    if (!(motion.spindle_rpm > 0.0)) {
      report_.spindle_max_rpm = std::max(report_.spindle_max_rpm, asked);
      if (!(highest > 0.0) || asked <= highest * (1.0 + kSpeedSlack)) return;
      report_.findings.add(text::DiagnosticId::surface_speed_unlimited, motion.place, asked, highest, [&] {
        return std::vector<std::string>{text::format_fixed(asked, 0), figure(diameter_mm), figure(highest)};
      });
      return;
    }
    rpm = std::min(asked, motion.spindle_rpm);
  }
  report_.spindle_max_rpm = std::max(report_.spindle_max_rpm, rpm);
  if (!(highest > 0.0) || rpm <= highest * (1.0 + kSpeedSlack)) return;
  report_.findings.add(text::DiagnosticId::spindle_too_fast, motion.place, rpm, highest,
                       [&] { return std::vector<std::string>{text::format_fixed(rpm, 0), figure(highest)}; });
}

void Envelope::check_speeds(const ir::Motion& motion) {
  const checks::MachineAxis* x = axes_[0];
  const double factor = x != nullptr && x->is_diameter ? 1.0 : 2.0;
  // The smallest diameter of the move, where constant surface speed turns fastest.
  const bool from_known = (motion.axes_unknown & 1U) == 0;
  const double start_mm = factor * (from_known ? motion.start[0] : motion.end[0]);
  const double end_mm = factor * motion.end[0];
  const double diameter_mm = start_mm * end_mm <= 0.0 ? 0.01 : std::min(std::fabs(start_mm), std::fabs(end_mm));
  if (motion.spindle != ir::SpindleState::stopped) check_spindle(motion, diameter_mm);

  double feed_mm_min = 0.0;
  switch (motion.feed_mode) {
    case ir::FeedMode::per_min:
      feed_mm_min = motion.feed;
      cut_feed_ = std::max(cut_feed_, motion.feed);
      break;
    case ir::FeedMode::per_rev: {
      double rpm = motion.spindle_rpm;
      if (motion.surface_speed_m_min > 0.0) {
        const double asked = 1000.0 * motion.surface_speed_m_min / (std::numbers::pi * diameter_mm);
        rpm = rpm > 0.0 ? std::min(asked, rpm) : asked;
        if (settings_.machine.spindle_max_rpm > 0.0) rpm = std::min(rpm, settings_.machine.spindle_max_rpm);
      }
      if (!(rpm > 0.0)) {
        report_.not_checked.add("a feed per revolution has no spindle speed: its feed was not checked",
                                motion.place.line);
      }
      feed_mm_min = motion.feed * rpm;
      break;
    }
    case ir::FeedMode::inverse_time: {
      double square = 0.0;
      for (std::size_t i = 0; i < ir::kAxisCount; ++i) {
        if ((motion.axes_unknown >> i & 1U) != 0) continue;
        const double way = slide(static_cast<ir::Axis>(i), motion.end[i] - motion.start[i]);
        square += way * way;
      }
      feed_mm_min = std::sqrt(square) * motion.feed;
      break;
    }
  }
  report_.feed_max_mm_min = std::max(report_.feed_max_mm_min, feed_mm_min);
  const double limit = settings_.machine.feed_limit_mm_min;
  if (!(limit > 0.0) || feed_mm_min <= limit * (1.0 + kSpeedSlack)) return;
  report_.findings.add(text::DiagnosticId::feed_too_high, motion.place, feed_mm_min, limit,
                       [&] { return std::vector<std::string>{text::format_fixed(feed_mm_min, 0), figure(limit)}; });
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
  if (limit > 0.0 && cut_feed_ > limit && cut_feed_ <= limit * kInch_mm &&
      report_.findings.count(text::DiagnosticId::travel_exceeded) > 0) {
    add(cut_feed_, limit, "feed and travel", "both are beyond the machine, and neither would be if divided by 25.4");
  }
}

Report Envelope::finish() {
  check_units();
  return std::move(report_);
}

}  // namespace dripfeed::envelope
