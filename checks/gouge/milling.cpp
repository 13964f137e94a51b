// Order matters: each move meets the stock as the moves before have left it. Arcs and helices are taken as chords.
#include "checks/gouge/milling.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "checks/arcs.h"
#include "dialects/text/number.h"

namespace dripfeed::gouge {

namespace {

constexpr double kArcError_mm = 2e-3;
constexpr std::size_t kMostNotes = 8;
constexpr std::size_t kPictureColumns = 240;

Point3 point_of(const checks::AxisValues& at) { return {at[0], at[1], at[2]}; }

std::string place_text(const Depth& depth) {
  return fmt::format("x {} y {}", text::format_fixed(depth.x, 3), text::format_fixed(depth.y, 3));
}

}  // namespace

Milling::Milling(MillingSettings settings)
    : settings_(std::move(settings)), compensation_(settings_.outer_corner, report_.not_checked) {
  const bool has_stock = settings_.stock && settings_.stock->x.width() > 0.0 && settings_.stock->y.width() > 0.0;
  if (has_stock) {
    map_.emplace(*settings_.stock, settings_.step_mm);
    if (!settings_.nominal.empty()) map_->set_nominal(settings_.nominal);
  } else {
    report_.not_checked.add("no stock is given: rapid moves were checked against the nominal only");
    if (!settings_.nominal.empty()) map_.emplace(settings_.nominal, settings_.step_mm);
  }
  if (map_) map_->log_to(settings_.log);
  if (settings_.nominal.empty()) report_.not_checked.add("no nominal is given: cuts were not checked against it");
  knows_speeds_ = std::ranges::all_of(settings_.rapid_mm_min, [](double speed) { return speed > 0.0; });
  if (!knows_speeds_) {
    report_.not_checked.add("the rapid speeds of x, y and z are not known: rapid moves were taken as straight lines");
  }
}

void Milling::follow_tool(const ir::Motion& motion) {
  cutter_.reset();
  holder_ = {};
  tool_ = motion.number;
  const auto tool = std::ranges::find(settings_.tools, motion.number, &checks::Tool::number);
  if (tool == settings_.tools.end() || !(tool->diameter_mm > 0.0)) {
    report_.not_checked.add(
        fmt::format("the diameter of {} is not known: its moves were not checked", checks::called(motion)),
        motion.place.line);
    return;
  }
  const double radius = 0.5 * tool->diameter_mm;
  cutter_ = Cutter{radius, std::clamp(tool->corner_radius_mm, 0.0, radius)};
  holder_ = Holder(tool->holder);
}

// Stock and nominal are given in the work offset. A program that changes it cuts several parts or turns the part over.
void Milling::follow_offset(const ir::Motion& motion) {
  if (offset_ && *offset_ != motion.number && has_cut_) {
    report_.not_checked.add(
        "the work offset changes after a cut: stock and nominal were taken to lie in each of them alike",
        motion.place.line);
  }
  offset_ = motion.number;
}

void Milling::consume(std::span<const ir::Motion> motions) {
  for (const ir::Motion& motion : motions) {
    if (motion.kind == ir::MotionKind::tool || motion.kind == ir::MotionKind::offset) {
      compensation_.flush();
      check_led();
    }
    if (motion.kind == ir::MotionKind::tool) follow_tool(motion);
    if (motion.kind == ir::MotionKind::offset) follow_offset(motion);
    if (ir::is_move(motion.kind)) lead(motion);
  }
}

// The radius in the control's register; what the spindle holds may be another.
double Milling::comp_radius_of(const ir::Motion& motion) {
  if (motion.comp == ir::CompSide::off) return 0.0;
  if ((motion.gaps & ir::kRadiiChanged) != 0) {
    report_.not_checked.add(
        "the program changes the radius of a tool: compensation was checked with that of the profile",
        motion.place.line);
    report_.has_unjudged_cuts = true;
  }
  if (settings_.comp_radius == CompRadius::of_tool) return cutter_->radius;
  const std::int32_t number = motion.tool_offset;
  if (number == 0 && settings_.comp_radius == CompRadius::of_number) {
    report_.not_checked.add("cutter compensation by D0, or by no D, was taken as none", motion.place.line);
    return 0.0;
  }
  if (number == 0) return cutter_->radius;
  const checks::Tool* found = nullptr;
  for (const checks::Tool& tool : settings_.tools) {
    if (tool.offset != number || !(tool.diameter_mm > 0.0)) continue;
    if (found == nullptr || tool.number == tool_) found = &tool;
  }
  if (found != nullptr) return 0.5 * found->diameter_mm;
  report_.not_checked.add(
      fmt::format("D{} is the offset of no tool that is known: the radius of tool {} was taken", number, tool_),
      motion.place.line);
  return cutter_->radius;
}

// A compensated move waits for the next one, which decides where it ends.
void Milling::lead(const ir::Motion& motion) {
  const bool compensated = motion.comp != ir::CompSide::off;
  if (!compensated && compensation_.is_idle()) return check_move(motion);
  const bool in_plane = !compensated || motion.plane == ir::Plane::xy;
  if (motion.machine_coordinates || !cutter_ || !in_plane) {
    compensation_.forget();
    check_led();
    if (in_plane) return check_move(motion);
    return report_.not_checked.add("a move with cutter compensation in another plane than x-y was not checked",
                                   motion.place.line);
  }
  compensation_.add(motion, comp_radius_of(motion));
  check_led();
}

void Milling::check_led() {
  for (const ir::Motion& motion : compensation_.known()) check_move(motion);
  compensation_.clear_known();
}

// Of the chords of an arc, the one where the holder is deepest is reported.
void Milling::check_move(const ir::Motion& motion) {
  met_ = {};
  check_path(motion);
  report_holder(motion);
}

void Milling::check_path(const ir::Motion& motion) {
  const std::uint32_t line = motion.place.line;
  constexpr std::uint16_t kLinear = 7U;
  if (!checks::has_places(motion)) return report_.not_checked.add("a move beyond 1000 km was not checked", line);
  if (motion.machine_coordinates) return report_.not_checked.add("a move in machine coordinates was not checked", line);
  if (!map_) return;
  if (!cutter_) return report_.not_checked.add("a move without a known tool was not checked", line);
  if ((motion.gaps & ir::kFrameLost) != 0) {
    knows_stock_ = knows_stock_ && motion.kind == ir::MotionKind::rapid;
    report_.has_unjudged_cuts |= motion.kind != ir::MotionKind::rapid;
    return report_.not_checked.add("a move in a swivelled plane or under a transformation was not checked", line);
  }
  if (checks::is_turned(motion)) {
    knows_stock_ = knows_stock_ && motion.kind == ir::MotionKind::rapid;
    report_.has_unjudged_cuts |= motion.kind != ir::MotionKind::rapid;
    return report_.not_checked.add("a move with a turned rotary axis was not checked", line);
  }
  const Point3 end = point_of(motion.end);
  if ((motion.axes_unknown & kLinear) != 0) {
    report_.not_checked.add("a move starts at a position that is not known: its end alone was checked", line);
    // An axis that was never commanded is not at its end either.
    const auto unknown_end = static_cast<std::uint16_t>(motion.axes_unknown & ~motion.axes_commanded & kLinear);
    if (unknown_end != 0) return;
    if (motion.kind == ir::MotionKind::rapid) {
      check_rapid(motion, end, end);
    } else {
      log_part(motion, 1.0, 1.0);
      check_cut(motion, end, end);
    }
    return;
  }
  const Point3 start = point_of(motion.start);
  if (motion.kind == ir::MotionKind::rapid) {
    check_rapid(motion, start, end);
  } else if (checks::is_arc(motion)) {
    check_arc(motion);
  } else {
    log_part(motion, 0.0, 1.0);
    check_cut(motion, start, end);
  }
}

void Milling::log_part(const ir::Motion& motion, double from, double to) {
  if (settings_.log != nullptr) settings_.log->begin(motion, from, to);
}

// A flat cutter on a level circle leaves a ring, which takes no chords. The log has a time for each part of an arc.
bool Milling::is_ring(const ir::Motion& motion) const {
  return settings_.log == nullptr && cutter_->corner == 0.0 && motion.plane == ir::Plane::xy &&
         motion.start[2] == motion.end[2] && checks::is_full_circle(motion);
}

void Milling::check_ring(const ir::Motion& motion) {
  const Point3 start = point_of(motion.start);
  const double x = motion.start[0] + motion.center[0];
  const double y = motion.start[1] + motion.center[1];
  if (holder_.may_touch(*map_, start.z)) meet(holder_.touch_around(*map_, *cutter_, start, x, y, settings_.depth_mm));
  judge_cut(motion, map_->cut_circle(*cutter_, start, x, y));
}

void Milling::check_arc(const ir::Motion& motion) {
  if (is_ring(motion)) return check_ring(motion);
  double chords = 0.0;
  if (settings_.log != nullptr)
    checks::for_chords(motion, kArcError_mm, [&](const checks::AxisValues&, const checks::AxisValues&) { ++chords; });
  double done = 0.0;
  checks::for_chords(motion, kArcError_mm, [&](const checks::AxisValues& from, const checks::AxisValues& to) {
    log_part(motion, done / chords, (done + 1.0) / chords);
    ++done;
    check_cut(motion, point_of(from), point_of(to));
  });
}

void Milling::add(text::DiagnosticId id, const ir::Motion& motion, const Depth& depth) {
  report_.findings.add(id, motion.place, depth.mm, 0.0,
                       [&] { return std::vector<std::string>{text::format_fixed(depth.mm, 3), place_text(depth)}; });
  note(motion, depth);
}

void Milling::note(const ir::Motion& motion, const Depth& depth) {
  if (notes_.size() < kMostNotes) notes_.push_back({{depth.x, depth.y}, fmt::format("line {}", motion.place.line)});
}

void Milling::meet(const HolderTouch& touch) {
  if (touch.depth.mm > met_.depth.mm) met_ = touch;
}

void Milling::report_holder(const ir::Motion& motion) {
  if (!(met_.depth.mm > 0.0) || !knows_stock_) return;
  report_.findings.add(text::DiagnosticId::holder_in_workpiece, motion.place, met_.depth.mm, 0.0, [&] {
    return std::vector<std::string>{fmt::to_string(tool_), text::format_fixed(met_.depth.mm, 3), place_text(met_.depth),
                                    text::format_shortest(met_.step.diameter_mm),
                                    text::format_shortest(met_.step.from_mm)};
  });
  note(motion, met_.depth);
}

void Milling::check_rapid(const ir::Motion& motion, const Point3& from, const Point3& to) {
  ++report_.rapids;
  if (holder_.may_touch(*map_, std::min(from.z, to.z))) meet(holder_.touch(*map_, from, to, settings_.depth_mm));
  const HeightMap::Touch touch = map_->touch(*cutter_, from, to, settings_.depth_mm);
  const bool is_nominal = touch.nominal.mm > 0.0;
  if (!knows_stock_ && !is_nominal)
    return report_.not_checked.add("rapids were not checked against the stock after a cut with a turned rotary axis",
                                   motion.place.line);
  if (touch.stock.mm > 0.0) {
    const Depth& depth = is_nominal ? touch.nominal : touch.stock;
    report_.deepest_rapid_mm = std::max(report_.deepest_rapid_mm, depth.mm);
    return add(is_nominal ? text::DiagnosticId::rapid_into_nominal : text::DiagnosticId::rapid_into_stock, motion,
               depth);
  }
  if (!knows_speeds_) return;
  // Each axis at its own speed until it is there: up to three straight pieces.
  const std::array<double, 3> by = {to.x - from.x, to.y - from.y, to.z - from.z};
  std::array<double, 3> times{};
  for (std::size_t i = 0; i < 3; ++i) times[i] = std::fabs(by[i]) / settings_.rapid_mm_min[i];
  std::array<double, 3> stops = times;
  std::ranges::sort(stops);
  Point3 before = from;
  Depth deepest;
  for (const double stop : stops) {
    const auto at = [&](std::size_t i) { return times[i] > 0.0 ? std::min(1.0, stop / times[i]) : 1.0; };
    const Point3 here{from.x + at(0) * by[0], from.y + at(1) * by[1], from.z + at(2) * by[2]};
    const Depth depth = map_->touch(*cutter_, before, here, settings_.depth_mm).stock;
    if (depth.mm > deepest.mm) deepest = depth;
    before = here;
  }
  if (deepest.mm > 0.0) add(text::DiagnosticId::rapid_may_enter_stock, motion, deepest);
}

void Milling::check_cut(const ir::Motion& motion, const Point3& from, const Point3& to) {
  if (!holder_.may_touch(*map_, std::min(from.z, to.z))) return judge_cut(motion, map_->cut(*cutter_, from, to));
  if (cutter_->corner == 0.0 && from.z == to.z) {
    meet(holder_.touch_level(*map_, *cutter_, from, to, settings_.depth_mm));
    return judge_cut(motion, map_->cut(*cutter_, from, to));
  }
  meet(holder_.touch_ahead(*map_, *cutter_, from, to, settings_.depth_mm));
  judge_cut(motion, map_->cut(*cutter_, from, to));
  meet(holder_.touch(*map_, from, to, settings_.depth_mm));
}

void Milling::judge_cut(const ir::Motion& motion, const Depth& depth) {
  ++report_.cuts;
  has_cut_ = true;
  if (!(depth.mm > 0.0)) return;
  report_.deepest_cut_mm = std::max(report_.deepest_cut_mm, depth.mm);
  const auto place = curves::surface_at(settings_.nominal, depth.x, depth.y);
  const double tolerance = place ? place->tolerance : 0.0;
  report_.findings.add(text::DiagnosticId::cut_below_nominal, motion.place, depth.mm, tolerance, [&] {
    return std::vector<std::string>{text::format_fixed(depth.mm, 3), place_text(depth),
                                    text::format_shortest(tolerance)};
  });
  note(motion, depth);
}

Report Milling::finish() {
  compensation_.flush();
  check_led();
  return std::move(report_);
}

plot::Plot Milling::picture() const {
  plot::Plot picture{.title = "height of what is left", .x = {"x, mm"}, .y = {"y, mm"}, .equal_scale = true};
  if (map_) picture.map = map_->picture(kPictureColumns);
  if (picture.map) picture.map->title = "z, mm";
  picture.notes = notes_;
  return picture;
}

}  // namespace dripfeed::gouge
