// checks/gouge: does the tool touch what it must not, for turning in the z-x plane: a rapid that enters the stock as it
// is left at that moment, or the finished part, and a cut below the nominal beyond its tolerance. The nose radius
// counts, the tool's holder and the chuck do not. Milling on a height map is milling.h.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "checks/finding.h"
#include "checks/gouge/remaining_stock.h"
#include "checks/machine.h"
#include "checks/plot/plot.h"
#include "dialects/curves/deviation.h"
#include "dialects/curves/nose.h"
#include "dialects/curves/path.h"
#include "dialects/curves/profile.h"
#include "dialects/ir/motion.h"

namespace dripfeed::gouge {

// A bar around the z axis of the active work offset.
struct Cylinder {
  double diameter_mm = 0.0;
  double z_low_mm = 0.0;
  double z_high_mm = 0.0;
};

struct Settings {
  std::optional<Cylinder> stock = {};    // nothing: rapids are checked against the nominal only
  curves::Profile nominal = {};          // x as radius; may be empty
  bool x_is_diameter = true;             // the motions' x
  bool needs_spindle = false;            // a cut while it stands is no turning
  std::vector<checks::Tool> tools = {};  // a tool that is not here is taken as a point, and the report states that
  double depth_mm = 0.001;               // a rapid may touch by this much
  // Of the slides. Axes that run at their own speed bend off the line, and that path is checked, too. 0: not known,
  // then rapids are taken as lines.
  double rapid_x_mm_min = 0.0;
  double rapid_z_mm_min = 0.0;
  double step_mm = 0.02;      // between the places at which the stock's height is kept
  RemovalLog* log = nullptr;  // gets what the cuts take away; it must outlive the check
};

struct Report {
  std::uint64_t rapids = 0;  // that were checked
  std::uint64_t cuts = 0;
  double deepest_rapid_mm = 0.0;   // into stock or nominal
  double deepest_cut_mm = 0.0;     // below the nominal, tolerance not counted
  bool has_unjudged_cuts = false;  // of a kind that the check does not know: nothing passes with them
  checks::FindingList findings;
  checks::NotCheckedList not_checked;
};

class Gouge final : public ir::MotionSink {
 public:
  explicit Gouge(Settings settings);
  void consume(std::span<const ir::Motion> motions) override;
  // After the last motion; once.
  [[nodiscard]] Report finish();
  // What is left of the bar over the nominal, as radii.
  [[nodiscard]] plot::Plot picture() const;
  // The stock as it is left so far; nullptr: there is none, or it is not known any more.
  [[nodiscard]] const RemainingStock* stock() const { return stock_ ? &*stock_ : nullptr; }

 private:
  void follow_tool(const ir::Motion& motion);
  void note(const ir::Motion& motion, double z_mm);
  [[nodiscard]] std::string_view why_not_judged(const ir::Motion& motion) const;
  void check_rapid(const ir::Motion& motion, const curves::Segment& path);
  void check_cut(const ir::Motion& motion, const curves::PathPiece& tip_path);
  // Signed distance of the nose from the nominal where it is lowest; nothing outside it.
  [[nodiscard]] std::optional<curves::Extreme> lowest(const curves::Nose& nose,
                                                      const curves::PathPiece& tip_path) const;

  Settings settings_;
  Report report_;
  std::optional<RemainingStock> stock_;
  curves::Nose nose_;
  std::vector<plot::Note> notes_;
  bool is_bore_ = false;  // the tool cuts inside: nothing here knows bores
};

}  // namespace dripfeed::gouge
