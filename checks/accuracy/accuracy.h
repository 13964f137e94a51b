// checks/accuracy: how far the surface that is cut lies from the nominal, normal to it, in radius geometry, for turning
// in the z-x plane. Without compensation a nose radius leaves an error of its own, so two paths are measured: the
// programmed one (its error is that of the chords) and the surface that the nose leaves. What enters the stock or goes
// below a tolerance by rapids is left to gouge.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "checks/finding.h"
#include "checks/machine.h"
#include "dialects/curves/deviation.h"
#include "dialects/curves/nose.h"
#include "dialects/curves/path.h"
#include "dialects/curves/profile.h"
#include "dialects/ir/motion.h"

namespace dripfeed::accuracy {

struct LineRange {
  std::uint32_t first = 0;  // 1-based, both included
  std::uint32_t last = 0;
};

struct Settings {
  curves::Profile nominal = {};  // x as radius, z in the active work offset
  bool x_is_diameter = true;     // the motions' x
  // Of the main program, the lines whose moves make the profile; empty: every cutting move.
  std::vector<LineRange> lines = {};
  // Nose radii and tips; a tool that is not here is taken as a point, and that is said.
  std::vector<checks::Tool> tools = {};
  double coverage_mm = 0.001;  // a gap up to this is none
};

struct Figures {
  std::uint64_t points = 0;    // places measured
  double max_mm = 0.0;         // largest deviation in size, refined between the places
  double max_signed_mm = 0.0;  // the same with its sign: positive, material is left; negative, too much is taken
  std::uint32_t max_line = 0;
  double max_z_mm = 0.0;
  double highest_mm = 0.0;  // signed extremes
  double lowest_mm = 0.0;
  double mean_mm = 0.0;  // of the size, along the path's length
  double rmse_mm = 0.0;
  double length_mm = 0.0;  // of path on the nominal
};

struct Gap {
  double low_mm = 0.0;  // z
  double high_mm = 0.0;
};

struct Report {
  std::uint64_t blocks = 0;        // moves that make the profile
  Figures path;                    // as programmed
  std::optional<Figures> surface;  // as cut; nothing where no nose was known and uncompensated
  // No point of any chord lies farther from the nominal along its normal, end points included; nothing where the
  // nominal's second derivative is not bounded or an arc turns over. Holds for the programmed path.
  std::optional<double> chord_bound_mm;
  double overrun_mm = 0.0;  // farthest reach of the path beyond the nominal's ends; not in the figures
  bool covered = false;     // the path passes all of the nominal
  std::vector<Gap> gaps;    // where it does not
  checks::FindingList findings;
  checks::NotCheckedList not_checked;

  // What counts: the surface where it is known, otherwise the path.
  [[nodiscard]] const Figures& figures() const { return surface ? *surface : path; }
};

class Accuracy final : public ir::MotionSink {
 public:
  explicit Accuracy(Settings settings);
  void consume(std::span<const ir::Motion> motions) override;
  // After the last motion; once.
  [[nodiscard]] Report finish();

 private:
  struct Sums {
    Figures figures;
    double integral = 0.0;
    double integral_square = 0.0;

    void add(const curves::Deviation& deviation, std::uint32_t line);
    [[nodiscard]] Figures result() const;
  };
  // A piece of cut surface waits for the next one, which may trim its end.
  struct Pending {
    curves::PathPiece tip_path;
    ir::Place place;
    double trimmed_start = 0.0;  // mm
  };

  [[nodiscard]] bool is_profile(const ir::Motion& motion) const;
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
  Sums surface_;
  bool bounded_ = true;
  double bound_ = 0.0;
  std::vector<curves::Range> covered_;  // disjoint, in order
  curves::Nose nose_;
  bool nose_known_ = false;
  bool surface_known_ = true;
  std::optional<Pending> pending_;
  ir::Place last_place_;
};

}  // namespace dripfeed::accuracy
