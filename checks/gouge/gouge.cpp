// Order matters: each move meets the stock as the moves before have left it. How deep a nose enters the nominal is the
// distance of its centre less its radius, at every place of its path; no surface is needed for that.
#include "checks/gouge/gouge.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "checks/arcs.h"
#include "dialects/text/number.h"

namespace dripfeed::gouge {

namespace {

constexpr std::size_t kX = 0;
constexpr std::size_t kZ = 2;
constexpr std::size_t kMostNotes = 8;
constexpr std::size_t kPicturePlaces = 2000;

curves::Point point_of(const std::array<double, ir::kAxisCount>& at, bool x_is_diameter) {
  return {at[kZ], x_is_diameter ? 0.5 * at[kX] : at[kX]};
}

std::vector<std::string> depth_and_place(double depth_mm, double z_mm) {
  return {text::format_fixed(depth_mm, 3), "z " + text::format_fixed(z_mm, 3)};
}

// Where both axes run at their own speed until the nearer end is reached, the path bends here.
curves::Point bend_of(const curves::Segment& path, double rapid_x, double rapid_z) {
  const curves::Point by = path.b - path.a;
  const double time = std::min(std::fabs(by.z) / rapid_z, std::fabs(by.x) / rapid_x);
  return path.a + curves::Point{std::copysign(time * rapid_z, by.z), std::copysign(time * rapid_x, by.x)};
}

}  // namespace

Gouge::Gouge(Settings settings) : settings_(std::move(settings)) {
  if (settings_.stock) {
    const Cylinder& bar = *settings_.stock;
    if (bar.diameter_mm > 0.0 && bar.z_low_mm < bar.z_high_mm) {
      stock_.emplace(0.5 * bar.diameter_mm, curves::Range{bar.z_low_mm, bar.z_high_mm}, settings_.step_mm);
      stock_->log_to(settings_.log);
    }
  }
  if (!stock_) report_.not_checked.add("no stock is given: rapid moves were checked against the nominal only");
  if (settings_.nominal.empty()) report_.not_checked.add("no nominal is given: cuts were not checked against it");
  if (!(settings_.rapid_x_mm_min > 0.0 && settings_.rapid_z_mm_min > 0.0)) {
    report_.not_checked.add("the rapid speeds of x and z are not known: rapid moves were taken as straight lines");
  }
}

void Gouge::follow_tool(const ir::Motion& motion) {
  nose_ = {};
  is_bore_ = false;
  const auto tool = std::ranges::find(settings_.tools, motion.number, &checks::Tool::number);
  const auto tip = tool != settings_.tools.end() ? curves::tip_of(tool->tip) : std::nullopt;
  if (!tip) {
    report_.not_checked.add("a tool's nose is not known: it was taken as a point", motion.place.line);
    return;
  }
  nose_ = {tool->nose_radius_mm, *tip};
  is_bore_ = tip->x > 0.0;
}

void Gouge::consume(std::span<const ir::Motion> motions) {
  for (const ir::Motion& motion : motions) {
    const std::uint32_t line = motion.place.line;
    if (motion.kind == ir::MotionKind::tool) follow_tool(motion);
    if (!ir::is_move(motion.kind)) continue;
    if (!checks::has_places(motion)) {
      report_.not_checked.add("a move beyond 1000 km was not checked", line);
      continue;
    }
    if (motion.machine_coordinates) {
      report_.not_checked.add("a move in machine coordinates was not checked", line);
      continue;
    }
    if (is_bore_) {
      report_.not_checked.add("a tool for bores was not checked", line);
      report_.has_unjudged_cuts |= motion.kind != ir::MotionKind::rapid;
      continue;
    }
    if (const std::string_view other = why_not_judged(motion); !other.empty()) {
      report_.not_checked.add(fmt::format("{} was not checked, nor later rapids against the stock", other), line);
      report_.has_unjudged_cuts = true;
      stock_.reset();
      continue;
    }
    if (motion.kind == ir::MotionKind::rapid && (motion.gaps & ir::kFrameLost) != 0) {
      report_.not_checked.add("a rapid in a swivelled plane or under a transformation was not checked", line);
      continue;
    }
    if (motion.kind == ir::MotionKind::rapid && checks::is_off_axis(motion)) {
      report_.not_checked.add("a rapid off the spindle's axis was not checked", line);
      continue;
    }
    const curves::Point end = point_of(motion.end, settings_.x_is_diameter);
    constexpr std::uint16_t kBoth = 1U << kX | 1U << kZ;
    const bool start_known = (motion.axes_unknown & kBoth) == 0;
    if (!start_known)
      report_.not_checked.add("a move starts at a position that is not known: its end alone was checked", line);
    const curves::Point start = start_known ? point_of(motion.start, settings_.x_is_diameter) : end;
    if (motion.kind == ir::MotionKind::rapid) {
      check_rapid(motion, {start, end});
    } else if (checks::is_arc(motion) && motion.plane != ir::Plane::zx) {
      report_.not_checked.add("an arc in another plane than z-x was not checked", line);
    } else if (checks::is_arc(motion) && start_known) {
      const curves::Point center{start.z + motion.center[2], start.x + motion.center[0]};
      const auto turn =
          motion.kind == ir::MotionKind::arc_ccw ? curves::Turn::counterclockwise : curves::Turn::clockwise;
      check_cut(motion, curves::arc_between(start, end, center, turn));
    } else {
      check_cut(motion, curves::Segment{start, end});
    }
  }
}

// "" for a rapid, and for a cut that turns.
std::string_view Gouge::why_not_judged(const ir::Motion& motion) const {
  if (motion.kind == ir::MotionKind::rapid) return {};
  if (const std::string_view why = checks::why_no_turning(motion); !why.empty()) return why;
  const bool stands = settings_.needs_spindle && motion.spindle == ir::SpindleState::stopped;
  return stands ? "a cut while the spindle stands still" : "";
}

std::optional<curves::Extreme> Gouge::lowest(const curves::Nose& nose, const curves::PathPiece& tip_path) const {
  if (settings_.nominal.empty()) return std::nullopt;
  const curves::Deviation centers =
      curves::measure(settings_.nominal, curves::moved(tip_path, -nose.radius * nose.tip));
  if (centers.points == 0) return std::nullopt;
  curves::Extreme extreme = centers.lowest;
  extreme.value -= nose.radius;
  return extreme;
}

// The first ones are marked in the picture, at the end of their moves.
void Gouge::note(const ir::Motion& motion, double z_mm) {
  if (notes_.size() >= kMostNotes) return;
  const double x = point_of(motion.end, settings_.x_is_diameter).x;
  notes_.push_back({{z_mm, x}, fmt::format("line {}", motion.place.line)});
}

void Gouge::check_rapid(const ir::Motion& motion, const curves::Segment& path) {
  ++report_.rapids;
  const auto add = [&](text::DiagnosticId id, double depth_mm, double z_mm) {
    report_.findings.add(id, motion.place, depth_mm, 0.0, [&] { return depth_and_place(depth_mm, z_mm); });
    note(motion, z_mm);
  };
  const std::optional<curves::Extreme> nominal = lowest(nose_, path);
  if (nominal && -nominal->value > std::max(settings_.depth_mm, nominal->tolerance)) {
    report_.deepest_rapid_mm = std::max(report_.deepest_rapid_mm, -nominal->value);
    add(text::DiagnosticId::rapid_into_nominal, -nominal->value, nominal->at.z);
    return;
  }
  if (!stock_) return;
  const Touch touch = stock_->touch(nose_, path, settings_.depth_mm);
  if (touch.depth_mm > 0.0) {
    report_.deepest_rapid_mm = std::max(report_.deepest_rapid_mm, touch.depth_mm);
    add(text::DiagnosticId::rapid_into_stock, touch.depth_mm, touch.z_mm);
    return;
  }
  if (!(settings_.rapid_x_mm_min > 0.0 && settings_.rapid_z_mm_min > 0.0)) return;
  const curves::Point bend = bend_of(path, settings_.rapid_x_mm_min, settings_.rapid_z_mm_min);
  Touch bent = stock_->touch(nose_, curves::Segment{path.a, bend}, settings_.depth_mm);
  const Touch rest = stock_->touch(nose_, curves::Segment{bend, path.b}, settings_.depth_mm);
  if (rest.depth_mm > bent.depth_mm) bent = rest;
  if (bent.depth_mm > 0.0) add(text::DiagnosticId::rapid_may_enter_stock, bent.depth_mm, bent.z_mm);
}

void Gouge::check_cut(const ir::Motion& motion, const curves::PathPiece& tip_path) {
  ++report_.cuts;
  // Compensated, the surface is the path itself.
  const curves::Nose nose = motion.comp == ir::CompSide::off ? nose_ : curves::Nose{};
  if (stock_ && settings_.log != nullptr) settings_.log->begin(motion, 0.0, 1.0);
  if (stock_) stock_->cut(nose, tip_path);
  if (motion.kind == ir::MotionKind::thread) {
    report_.not_checked.add("a thread was not checked against the nominal", motion.place.line);
    return;
  }
  const std::optional<curves::Extreme> nominal = lowest(nose, tip_path);
  if (!nominal || nominal->value >= 0.0) return;
  const double depth_mm = -nominal->value;
  report_.deepest_cut_mm = std::max(report_.deepest_cut_mm, depth_mm);
  if (depth_mm <= nominal->tolerance) return;
  note(motion, nominal->at.z);
  report_.findings.add(text::DiagnosticId::cut_below_nominal, motion.place, depth_mm, nominal->tolerance, [&] {
    std::vector<std::string> arguments = depth_and_place(depth_mm, nominal->at.z);
    arguments.push_back(text::format_shortest(nominal->tolerance));
    return arguments;
  });
}

Report Gouge::finish() { return std::move(report_); }

plot::Plot Gouge::picture() const {
  plot::Plot figure{
      .title = "what is left of the bar", .x = {"z, mm"}, .y = {"radius, mm"}, .equal_scale = true, .notes = notes_};
  plot::Series left{"left", {}};
  if (stock_) {
    for (const curves::Point at : stock_->outline(kPicturePlaces)) left.points.push_back({at.z, at.x});
  }
  plot::Series nominal{"nominal", {}};
  for (const curves::ProfilePiece& piece : settings_.nominal.pieces) {
    const curves::Range z = piece.curve.z;
    for (std::size_t i = 0; i <= kPicturePlaces; ++i) {
      const double at = z.low + z.width() * static_cast<double>(i) / static_cast<double>(kPicturePlaces);
      nominal.points.push_back({at, piece.curve.at(at).x});
    }
  }
  figure.series = {std::move(left), std::move(nominal)};
  return figure;
}

}  // namespace dripfeed::gouge
