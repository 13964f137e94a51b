// Gouges in milling from above, on a height map: a rapid that enters the stock as it is left at that moment, or the
// finished part, a cut below the nominal beyond its tolerance, and a shank or holder that meets material. Flat, ball
// and bull-nose cutters; shank and holder count as far as the tool has them, undercuts do not. Under cutter
// compensation the axis is led as the control leads it.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "checks/gouge/compensation.h"
#include "checks/gouge/cutter.h"
#include "checks/gouge/gouge.h"
#include "checks/gouge/height_map.h"
#include "checks/gouge/holder.h"
#include "checks/machine.h"
#include "checks/plot/plot.h"
#include "dialects/curves/height_field.h"
#include "dialects/ir/motion.h"

namespace dripfeed::gouge {

// Whose radius G41 and G42 take: the tool's in the spindle, that of the offset which the program names by D, or that
// with the tool's own where it names none.
enum class CompRadius : std::uint8_t { of_tool, of_number, of_number_or_tool };

struct MillingSettings {
  std::optional<Blank> stock = {};                // nothing: rapids are checked against the nominal only
  std::vector<curves::HeightField> nominal = {};  // may be empty
  std::vector<checks::Tool> tools = {};           // by diameter and corner radius; one that is not here is not checked
  double depth_mm = 0.001;                        // a rapid may touch by this much
  // Of x, y and z. Axes that run at their own speed bend off the line, and that path is checked, too. 0: not known,
  // then rapids are taken as lines.
  std::array<double, 3> rapid_mm_min = {};
  double step_mm = 0.0;  // between the places of the height map; 0: as fine as its memory allows
  CompRadius comp_radius = CompRadius::of_tool;
  OuterCorner outer_corner = OuterCorner::arc;
  RemovalLog* log = nullptr;  // gets what the cuts take away; it must outlive the check
};

class Milling final : public ir::MotionSink {
 public:
  explicit Milling(MillingSettings settings);
  void consume(std::span<const ir::Motion> motions) override;
  // After the last motion; once.
  [[nodiscard]] Report finish();
  // What is left, and where the first findings lie.
  [[nodiscard]] plot::Plot picture() const;
  // The stock as it is left so far; nullptr: there is none.
  [[nodiscard]] const HeightMap* map() const { return map_ ? &*map_ : nullptr; }

 private:
  void follow_tool(const ir::Motion& motion);
  void follow_offset(const ir::Motion& motion);
  void lead(const ir::Motion& motion);
  void check_led();
  [[nodiscard]] double comp_radius_of(const ir::Motion& motion);
  void check_move(const ir::Motion& motion);
  void check_rapid(const ir::Motion& motion, const Point3& from, const Point3& to);
  void log_part(const ir::Motion& motion, double from, double to);
  void check_ring(const ir::Motion& motion);
  void check_arc(const ir::Motion& motion);
  [[nodiscard]] bool is_ring(const ir::Motion& motion) const;
  void judge_cut(const ir::Motion& motion, const Depth& depth);
  void check_cut(const ir::Motion& motion, const Point3& from, const Point3& to);
  void check_path(const ir::Motion& motion);
  void meet(const HolderTouch& touch);
  void report_holder(const ir::Motion& motion);
  void add(text::DiagnosticId id, const ir::Motion& motion, const Depth& depth);
  void note(const ir::Motion& motion, const Depth& depth);

  MillingSettings settings_;
  Report report_;
  std::optional<HeightMap> map_;
  std::optional<Cutter> cutter_;
  Holder holder_;    // of the same tool
  HolderTouch met_;  // by it, along the present move
  std::int32_t tool_ = 0;
  Compensation compensation_;
  bool knows_speeds_ = false;
  bool has_cut_ = false;
  bool knows_stock_ = true;  // every cut was taken off the map
  std::optional<std::int32_t> offset_;
  std::vector<plot::Note> notes_;
};

}  // namespace dripfeed::gouge
