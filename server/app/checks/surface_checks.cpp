// Lathes and mill-turns are checked as they turn, mills on a height map and in the x-y plane.
#include "server/app/checks/surface_checks.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>
#include <utility>
#include <variant>

#include <fmt/format.h>

#include "checks/accuracy/picture.h"
#include "checks/accuracy/plane_accuracy.h"
#include "dialects/text/number.h"
#include "server/app/checks/machine_facts.h"

namespace dripfeed::app {

namespace {

// What the machine has counts, because that is what cuts; a family that was written for another tool is not checked.
void report_other_shapes(const Examination& e, checks::NotCheckedList& skipped) {
  if (e.profile == nullptr) return;
  for (const family::ToolShape& shape : e.geometry->tools) {
    const auto known = std::ranges::find(e.profile->machine.tools, shape.number, &checks::Tool::number);
    if (known == e.profile->machine.tools.end()) continue;
    const auto compare = [&](std::string_view what, double wanted, double has) {
      constexpr double kSame_mm = 1e-6;
      if (wanted == 0.0 || has == 0.0 || std::abs(wanted - has) < kSame_mm) return;
      skipped.add(fmt::format("tool {}: the family has the {} {} mm, the machine {} mm, which counts", shape.number,
                              what, text::format_shortest(wanted), text::format_shortest(has)));
    };
    compare("diameter", shape.diameter_mm, known->diameter_mm);
    compare("corner radius", shape.corner_radius_mm, known->corner_radius_mm);
    compare("nose radius", shape.nose_radius_mm, known->nose_radius_mm);
  }
}

double rapid_of(const Examination& e, ir::Axis axis) {
  if (e.profile == nullptr) return 0.0;
  const checks::MachineAxis* known = checks::find_axis(e.profile->machine, axis);
  return known == nullptr ? 0.0 : known->rapid_mm_min;
}

std::vector<accuracy::LineRange> lines_of(const Examination& e) {
  std::vector<accuracy::LineRange> lines;
  for (const family::LineRange& range : e.profile_lines) lines.push_back({range.first, range.last});
  return lines;
}

accuracy::PlaneSettings plane_accuracy(const Examination& e, bool keeps_blocks) {
  accuracy::PlaneSettings settings;
  settings.keeps_blocks = keeps_blocks;
  for (const family::PlaneCurve& curve : e.geometry->curves) {
    settings.nominal.push_back({curve.curve, curve.tolerance_mm, curve.of_center});
  }
  settings.lines = lines_of(e);
  settings.tools = tools_of(e);
  return settings;
}

accuracy::Settings turning_accuracy(const Examination& e, bool keeps_blocks) {
  accuracy::Settings settings;
  settings.keeps_blocks = keeps_blocks;
  settings.nominal = e.geometry->nominal;
  settings.x_is_diameter = x_is_diameter(e.control, e.profile);
  settings.lines = lines_of(e);
  settings.tools = tools_of(e);
  return settings;
}

}  // namespace

std::vector<checks::Tool> tools_of(const Examination& e) {
  std::vector<checks::Tool> tools;
  if (e.profile != nullptr) tools = e.profile->machine.tools;
  if (!e.geometry) return tools;
  for (const family::ToolShape& shape : e.geometry->tools) {
    auto known = std::ranges::find(tools, shape.number, &checks::Tool::number);
    if (known == tools.end()) {
      tools.push_back({.number = shape.number,
                       .offset = shape.number,
                       .nose_radius_mm = shape.nose_radius_mm,
                       .tip = shape.tip,
                       .diameter_mm = shape.diameter_mm,
                       .length_mm = {},
                       .corner_radius_mm = shape.corner_radius_mm});
    } else if (known->diameter_mm == 0.0) {
      known->diameter_mm = shape.diameter_mm;
      known->corner_radius_mm = shape.corner_radius_mm;
    }
  }
  return tools;
}

gouge::Settings turning_gouge(const Examination& e) {
  gouge::Settings settings;
  if (e.geometry->stock) {
    if (const auto* bar = std::get_if<family::CylinderStock>(&*e.geometry->stock)) {
      settings.stock =
          gouge::Cylinder{.diameter_mm = bar->diameter_mm, .z_low_mm = bar->z_mm.low, .z_high_mm = bar->z_mm.high};
    }
  }
  settings.nominal = e.geometry->nominal;
  settings.x_is_diameter = x_is_diameter(e.control, e.profile);
  settings.needs_spindle = true;
  settings.tools = tools_of(e);
  settings.rapid_x_mm_min = rapid_of(e, ir::Axis::x);
  settings.rapid_z_mm_min = rapid_of(e, ir::Axis::z);
  return settings;
}

gouge::MillingSettings milling_gouge(const Examination& e) {
  gouge::MillingSettings settings;
  if (e.geometry->stock) {
    if (const auto* bar = std::get_if<family::CylinderStock>(&*e.geometry->stock)) {
      const curves::Range across{-0.5 * bar->diameter_mm, 0.5 * bar->diameter_mm};
      settings.stock = gouge::Blank{across, across, bar->z_mm, bar->diameter_mm, bar->bore_mm};
    } else {
      const auto& box = std::get<family::BoxStock>(*e.geometry->stock);
      settings.stock = gouge::Blank{box.x_mm, box.y_mm, box.z_mm};
    }
  }
  settings.nominal = e.geometry->surfaces;
  settings.tools = tools_of(e);
  settings.rapid_mm_min = {rapid_of(e, ir::Axis::x), rapid_of(e, ir::Axis::y), rapid_of(e, ir::Axis::z)};
  // SINUMERIK's D is an edge of the tool; Mazak takes its tool data where no D is programmed.
  const bool has_edges = e.control.semantics.d_selects_edge;
  settings.outer_corner = has_edges ? gouge::OuterCorner::arc : gouge::OuterCorner::straight;
  settings.comp_radius = has_edges                      ? gouge::CompRadius::of_tool
                         : e.control.dialect == "mazak" ? gouge::CompRadius::of_number_or_tool
                                                        : gouge::CompRadius::of_number;
  return settings;
}

struct SurfaceChecks::Made {
  std::optional<gouge::Gouge> turning;
  std::optional<gouge::Milling> milling;
  std::optional<accuracy::Accuracy> profile;
  std::optional<accuracy::PlaneAccuracy> plane;
};

SurfaceChecks::~SurfaceChecks() = default;

SurfaceChecks::SurfaceChecks(const Examination& e, SurfaceScope scope, checks::NotCheckedList& skipped)
    : made_(std::make_unique<Made>()) {
  if (!e.geometry) {
    skipped.add("gouges and accuracy: stock and nominal are not known");
    return;
  }
  const family::Geometry& g = *e.geometry;
  if (!ir::serves(e.control.kind, g.machine)) {
    skipped.add("gouges and accuracy: stock and nominal are of a family for another kind of machine");
    return;
  }
  report_other_shapes(e, skipped);
  const bool turns = e.control.kind != ir::MachineKind::mill;
  const bool has_surface = g.stock || (turns ? !g.nominal.empty() : !g.surfaces.empty());
  if (scope == SurfaceScope::all) {
    if (!has_surface) skipped.add("gouges: stock and nominal are not known");
    if (has_surface && turns) made_->turning.emplace(turning_gouge(e));
    if (has_surface && !turns) made_->milling.emplace(milling_gouge(e));
  }
  const bool keeps_blocks = scope == SurfaceScope::of_each_block;
  if (turns && !g.nominal.empty()) made_->profile.emplace(turning_accuracy(e, keeps_blocks));
  if (!turns && !g.curves.empty()) made_->plane.emplace(plane_accuracy(e, keeps_blocks));
  if (!made_->profile && !made_->plane) skipped.add("accuracy: no nominal is known");
}

std::vector<ir::MotionSink*> SurfaceChecks::sinks() const {
  std::vector<ir::MotionSink*> all;
  if (made_->turning) all.push_back(&*made_->turning);
  if (made_->milling) all.push_back(&*made_->milling);
  if (made_->profile) all.push_back(&*made_->profile);
  if (made_->plane) all.push_back(&*made_->plane);
  return all;
}

void SurfaceChecks::finish(checks::CheckReport& report, Pictures& pictures) {
  if (made_->turning) {
    report.gouge = made_->turning->finish();
    pictures.gouge = made_->turning->picture();
  }
  if (made_->milling) {
    report.gouge = made_->milling->finish();
    pictures.gouge = made_->milling->picture();
  }
  if (made_->profile) report.accuracy = made_->profile->finish();
  if (made_->plane) report.accuracy = made_->plane->finish();
  if (report.accuracy) pictures.accuracy = accuracy::deviation_plot(*report.accuracy);
}

}  // namespace dripfeed::app
