// Every profile move is measured twice: as it is programmed, and as the nose cuts it. The cut surface of a move is
// known only when the next one is, because corners trim both: so it waits one move.
#include "checks/accuracy/accuracy.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "checks/arcs.h"
#include "dialects/text/number.h"

namespace dripfeed::accuracy {

namespace {

constexpr std::size_t kX = 0;
constexpr std::size_t kZ = 2;
constexpr double kSamePlace_mm = 1e-6;
constexpr double kSmallCorner_mm = 1e-7;  // a corner's own arc matters less than this

// In radius geometry.
curves::PathPiece piece_of(const ir::Motion& motion, bool x_is_diameter) {
  const double factor = x_is_diameter ? 0.5 : 1.0;
  const curves::Point start{motion.start[kZ], factor * motion.start[kX]};
  const curves::Point end{motion.end[kZ], factor * motion.end[kX]};
  if (!checks::is_arc(motion)) return curves::Segment{start, end};
  const curves::Point center{start.z + motion.center[2], start.x + motion.center[0]};
  const auto turn = motion.kind == ir::MotionKind::arc_ccw ? curves::Turn::counterclockwise : curves::Turn::clockwise;
  return curves::arc_between(start, end, center, turn);
}

// "" for a cutting move that can be measured.
std::string why_unmeasured(const ir::Motion& motion) {
  constexpr std::uint16_t kBoth = 1U << kX | 1U << kZ;
  if (!checks::has_places(motion)) return "a cutting move leads beyond 1000 km";
  if ((motion.axes_unknown & kBoth) != 0) return "a cutting move starts at a position that is not known";
  if (const std::string_view other = checks::why_no_turning(motion); !other.empty())
    return fmt::format("{} was not measured", other);
  if (checks::is_arc(motion) && motion.plane != ir::Plane::zx) return "an arc lies in another plane than z-x";
  return {};
}

}  // namespace

Accuracy::Accuracy(Settings settings) : settings_(std::move(settings)), bound_(settings_.nominal) {}

void Accuracy::consume(std::span<const ir::Motion> motions) {
  for (const ir::Motion& motion : motions) {
    if (motion.kind == ir::MotionKind::tool) follow_tool(motion);
    if (settings_.nominal.empty() || !is_profile(motion, settings_.lines)) continue;
    if (const std::string why = why_unmeasured(motion); !why.empty()) {
      report_.not_checked.add(why, motion.place.line);
      report_.has_unmeasured_cuts = true;
    } else {
      add_move(motion);
    }
  }
}

void Accuracy::follow_tool(const ir::Motion& motion) {
  close_pending(0.0);
  nose_ = {};
  const auto tool = std::ranges::find(settings_.tools, motion.number, &checks::Tool::number);
  const auto tip = tool != settings_.tools.end() ? curves::tip_of(tool->tip) : std::nullopt;
  nose_known_ = tip.has_value();
  if (nose_known_) nose_ = {tool->nose_radius_mm, *tip};
}

void Accuracy::add_move(const ir::Motion& motion) {
  ++report_.blocks;
  last_place_ = motion.place;
  const curves::PathPiece piece = piece_of(motion, settings_.x_is_diameter);
  if (!(curves::length_of(piece) > 0.0)) return;
  const curves::Deviation deviation = curves::measure(settings_.nominal, piece, path_.max_mm());
  path_.add(deviation, motion.place.line);
  report_.overrun_mm = std::max(report_.overrun_mm, deviation.overhang);
  if (deviation.points > 0) {
    // By the feet, and by z itself: a path next to the nominal ends where it does, not where its last foot is.
    const curves::Range own = curves::box_of(piece).z;
    cover({std::min(own.low, deviation.z.low), std::max(own.high, deviation.z.high)});
  }
  bound_.add(piece, deviation);

  const bool compensated = motion.comp != ir::CompSide::off;
  if (!compensated && nose_known_ && nose_.radius > 0.0) {
    add_surface(motion, piece);
    return;
  }
  close_pending(0.0);
  if (!compensated && !nose_known_) {
    surface_known_ = false;
    report_.not_checked.add("the tool's nose is not known: it was taken as a point", motion.place.line);
  }
  surface_.add(deviation, motion.place.line);
  judge(deviation, motion.place);
}

void Accuracy::add_surface(const ir::Motion& motion, const curves::PathPiece& tip_path) {
  double trimmed = 0.0;
  const curves::Point start = curves::point_at(tip_path, 0.0);
  if (pending_ && curves::distance(curves::point_at(pending_->tip_path, 1.0), start) < kSamePlace_mm) {
    const curves::Corner corner = curves::corner_of(nose_, start, curves::direction_at(pending_->tip_path, 1.0),
                                                    curves::direction_at(tip_path, 0.0));
    trimmed = corner.trimmed;
    if (corner.is_gap) measure_corner(corner);
    close_pending(trimmed);
  } else {
    close_pending(0.0);
  }
  pending_ = Pending{tip_path, motion.place, trimmed};
}

// The nose's own circle at a gap: its lowest point over the nominal, if it lies between both pieces' ends.
void Accuracy::measure_corner(const curves::Corner& corner) {
  const double opening = curves::distance(corner.normal_before, corner.normal_after);
  if (nose_.radius * opening * opening / 8.0 < kSmallCorner_mm) return;
  const curves::ProfileFoot nearest = curves::closest(settings_.nominal, corner.center);
  if (nearest.foot.beyond != curves::Beyond::none) return;
  const double above = nearest.foot.distance >= 0.0 ? 1.0 : -1.0;
  const curves::Point down = above * curves::unit(nearest.foot.point() - corner.center);
  const double turn = curves::cross(corner.normal_before, corner.normal_after);
  const bool between =
      turn * curves::cross(corner.normal_before, down) >= 0.0 && turn * curves::cross(down, corner.normal_after) >= 0.0;
  if (!between) return;
  curves::Deviation deviation;
  deviation.points = 1;
  deviation.highest = {nearest.foot.distance - nose_.radius, corner.center + nose_.radius * down,
                       settings_.nominal.pieces[nearest.piece].tolerance};
  deviation.lowest = deviation.highest;
  surface_.add(deviation, pending_->place.line);
  judge(deviation, pending_->place);
}

void Accuracy::close_pending(double trimmed_end) {
  if (!pending_) return;
  const Pending pending = *std::exchange(pending_, std::nullopt);
  const std::optional<curves::PathPiece> surface = curves::cut_surface(nose_, pending.tip_path);
  if (!surface) {
    report_.not_checked.add("an arc is tighter than the nose: what is cut there was not measured", pending.place.line);
    return;
  }
  const double length = curves::length_of(*surface);
  if (length <= pending.trimmed_start + trimmed_end) return;  // its neighbours cut all of it away
  const curves::PathPiece rest = curves::part_of(*surface, pending.trimmed_start / length, 1.0 - trimmed_end / length);
  const curves::Deviation deviation = curves::measure(settings_.nominal, rest, surface_.max_mm());
  surface_.add(deviation, pending.place.line);
  judge(deviation, pending.place);
}

void Accuracy::judge(const curves::Deviation& deviation, const ir::Place& place) {
  if (deviation.points == 0) return;
  const curves::Extreme& worst =
      deviation.highest.value >= -deviation.lowest.value ? deviation.highest : deviation.lowest;
  trace_.add(worst.at.z, worst.value);
  if (settings_.keeps_blocks) report_.of_blocks.push_back({place.ordinal, worst.value});
  const double size = std::fabs(worst.value);
  if (size <= worst.tolerance) return;
  report_.findings.add(text::DiagnosticId::deviation_beyond_tolerance, place, size, worst.tolerance, [&] {
    return std::vector<std::string>{text::format_fixed(worst.value, 4), "z " + text::format_fixed(worst.at.z, 3),
                                    text::format_shortest(worst.tolerance)};
  });
}

void Accuracy::cover(curves::Range z) {
  // Ranges that touch within the allowed gap become one; those before and after stay.
  const auto first = std::ranges::find_if(
      covered_, [&](const curves::Range& one) { return one.high >= z.low - settings_.coverage_mm; });
  auto last = first;
  for (; last != covered_.end() && last->low <= z.high + settings_.coverage_mm; ++last) {
    z = {std::min(z.low, last->low), std::max(z.high, last->high)};
  }
  covered_.insert(covered_.erase(first, last), z);
}

void Accuracy::find_gaps() {
  const curves::Range whole = settings_.nominal.z();
  double reached = whole.low;
  const auto gap_to = [&](double low) {
    if (low > reached + settings_.coverage_mm) report_.gaps.push_back({reached, low});
  };
  for (const curves::Range& one : covered_) {
    gap_to(one.low);
    reached = std::max(reached, one.high);
  }
  gap_to(whole.high);
  report_.covered = report_.gaps.empty();
  if (report_.has_unmeasured_cuts && !report_.covered) return report_.not_checked.add(kCoverageNotChecked);
  for (const Gap& gap : report_.gaps) {
    report_.findings.add(text::DiagnosticId::nominal_not_covered, last_place_, gap.high_mm - gap.low_mm, 0.0, [&] {
      return std::vector<std::string>{"z " + text::format_fixed(gap.low_mm, 3), text::format_fixed(gap.high_mm, 3)};
    });
  }
}

Report Accuracy::finish() {
  close_pending(0.0);
  report_.path = path_.result();
  report_.trace = trace_.points();
  if (settings_.nominal.empty()) {
    report_.not_checked.add("no nominal is given: the accuracy was not checked");
    return std::move(report_);
  }
  if (report_.blocks > 0 && surface_known_) report_.surface = surface_.result();
  if (report_.blocks > 0) report_.chord_bound_mm = bound_.value();
  if (report_.blocks > 0 && !bound_.value())
    report_.not_checked.add("the chord error is measured, but no bound is proved");
  find_gaps();
  return std::move(report_);
}

}  // namespace dripfeed::accuracy
