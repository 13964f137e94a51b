// checks/accuracy: how far the surface that is cut lies from the nominal, normal to it, in radius geometry, for turning
// in the z-x plane. Without compensation a nose radius leaves an error of its own, so two paths are measured: the
// programmed one (its error is that of the chords) and the surface that the nose leaves. What enters the stock or goes
// below a tolerance by rapids is left to gouge.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "checks/accuracy/chord.h"
#include "checks/accuracy/figures.h"
#include "checks/finding.h"
#include "checks/machine.h"
#include "dialects/curves/deviation.h"
#include "dialects/curves/nose.h"
#include "dialects/curves/path.h"
#include "dialects/curves/profile.h"
#include "dialects/ir/motion.h"

namespace dripfeed::accuracy {

struct Settings {
  curves::Profile nominal = {};  // x as radius, z in the active work offset
  bool x_is_diameter = true;     // the motions' x
  // Of the main program, the lines whose moves make the profile; empty: every cutting move.
  std::vector<LineRange> lines = {};
  // Nose radii and tips; a tool that is not here is taken as a point, and the report states that.
  std::vector<checks::Tool> tools = {};
  double coverage_mm = 0.001;  // a gap up to this is none
  bool keeps_blocks = false;   // the report has the deviation of each block
};

class Accuracy final : public ir::MotionSink {
 public:
  explicit Accuracy(Settings settings);
  void consume(std::span<const ir::Motion> motions) override;
  // After the last motion; once.
  [[nodiscard]] Report finish();

 private:
  // A piece of cut surface waits for the next one, which may trim its end.
  struct Pending {
    curves::PathPiece tip_path;
    ir::Place place;
    double trimmed_start = 0.0;  // mm
  };

  void follow_tool(const ir::Motion& motion);
  void add_move(const ir::Motion& motion);
  void add_surface(const ir::Motion& motion, const curves::PathPiece& tip_path);
  void close_pending(double trimmed_end);
  void judge(const curves::Deviation& deviation, const ir::Place& place);
  void measure_corner(const curves::Corner& corner);
  void cover(curves::Range z);
  void find_gaps();

  Settings settings_;
  Report report_;
  Sums path_;
  Trace trace_;
  Sums surface_;
  ChordBound bound_;
  std::vector<curves::Range> covered_;  // disjoint, in order
  curves::Nose nose_;
  bool nose_known_ = false;
  bool surface_known_ = true;
  std::optional<Pending> pending_;
  ir::Place last_place_;
};

}  // namespace dripfeed::accuracy
