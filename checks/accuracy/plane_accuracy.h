// How far what a mill leaves in the x-y plane lies from nominal curves, normal to them. With cutter compensation, or
// for nominals of the tool's centre, that is the path itself; without, the cutter's edge, a radius next to its centre.
// What is cut too deep is left to gouge.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "checks/accuracy/figures.h"
#include "checks/finding.h"
#include "checks/machine.h"
#include "dialects/curves/deviation.h"
#include "dialects/curves/parametric_curve.h"
#include "dialects/curves/path.h"
#include "dialects/ir/motion.h"

namespace dripfeed::accuracy {

// Points as x and y of the work offset, in this order.
struct PlaneNominal {
  curves::ParametricCurve curve;
  double tolerance_mm = 0.0;
  bool of_center = false;
};

struct PlaneSettings {
  std::vector<PlaneNominal> nominal = {};
  std::vector<LineRange> lines = {};  // as in Settings
  std::vector<checks::Tool> tools =
      {};                     // by diameter; one that is not here is taken as a point, and the report states that
  double coverage_mm = 0.01;  // a gap up to this is none
  bool keeps_blocks = false;  // the report has the deviation of each block
};

class PlaneAccuracy final : public ir::MotionSink {
 public:
  explicit PlaneAccuracy(PlaneSettings settings);
  void consume(std::span<const ir::Motion> motions) override;
  // After the last motion; once.
  [[nodiscard]] Report finish();

 private:
  // A place of the path and its foot.
  struct Place {
    curves::Point at;
    std::size_t curve = 0;
    curves::ParametricFoot foot;
    bool on = false;      // on the nominal, not beyond an end
    bool sought = false;  // its foot does not follow from the one before
  };
  // The place at `part` of a piece, 0 at its start, 1 at its end.
  struct Visit {
    double part = 0.0;
    Place place;
  };
  // An end of a nominal curve; joined where another curve's end lies on it, or its own.
  struct End {
    curves::Point at;
    bool joined = false;
  };
  struct Side {
    double offset_mm = 0.0;  // the edge's distance from the path: the radius, or 0
    double left = 1.0;       // what lies to the left of the path is material that is left (1) or missing (-1)
  };

  void add_move(const ir::Motion& motion);
  void add_piece(const ir::Motion& motion, const curves::PathPiece& piece);
  [[nodiscard]] Side side_of(const ir::Motion& motion, const PlaneNominal& nominal);
  [[nodiscard]] Place place_of(curves::Point at, const Place* near, double step_mm) const;
  // How far the cutter's center should be from it.
  [[nodiscard]] double expected(const PlaneNominal& nominal) const {
    return compensated_ || nominal.of_center ? 0.0 : radius_;
  }
  [[nodiscard]] double value_of(const Place& place, curves::Point direction, const Side& side) const;
  void add_corner(const ir::Motion& motion, curves::Point at, curves::Point direction);
  void add_bound(const curves::PathPiece& piece, const Place& first, const Place& last, const Side& side,
                 double largest);
  void judge(const curves::Deviation& deviation, const ir::Place& place);
  // Of a place next to an end of its curve: whether the contour goes on there.
  [[nodiscard]] bool is_joined(const Place& place) const;
  // The last place on the curve of `inside` on the path towards the part `outside`, where it is on it no more.
  [[nodiscard]] Visit last_on(const curves::PathPiece& piece, Visit inside, double outside, double step_mm) const;
  // What lies between two neighbouring places on one curve.
  void cover_between(const Place& a, const Place& b);
  void cover(std::size_t curve, curves::Range t);
  // What following the path has lost is compared with all of it: whether no point of that part is too far from it.
  [[nodiscard]] bool is_passed(std::size_t curve, curves::Range t) const;
  void find_gaps();

  PlaneSettings settings_;
  Report report_;
  Sums path_;
  Sums surface_;
  Trace trace_;
  std::vector<std::vector<curves::Range>> covered_;  // by curve, disjoint, in order
  std::vector<bool> closed_;                         // by curve
  std::vector<End> ends_;                            // by curve, low and high
  double radius_ = 0.0;
  bool radius_known_ = false;
  bool compensated_ = false;  // the present move
  bool surface_known_ = true;
  bool proved_ = true;
  double bound_ = 0.0;
  double along_ = 0.0;
  std::vector<curves::PathPiece> passed_;  // the path, as far as there is room for it
  std::optional<Place> last_;              // where the last piece ended
  std::optional<curves::Point> heading_;   // and in which direction
  ir::Place last_place_;
};

}  // namespace dripfeed::accuracy
