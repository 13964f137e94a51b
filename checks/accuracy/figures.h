// What both checks of accuracy report, for turning in the z-x plane and for milling in the x-y plane.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "checks/finding.h"
#include "dialects/curves/deviation.h"
#include "dialects/curves/point.h"

namespace dripfeed::accuracy {

struct LineRange {
  std::uint32_t first = 0;  // 1-based, both included
  std::uint32_t last = 0;
};

// Said of a nominal with gaps where cuts were not measured.
inline constexpr std::string_view kCoverageNotChecked =
    "whether the cuts cover the nominal: some of them were not measured";

// Whether a motion makes the profile: it cuts, in work coordinates, and stands in one of these lines of the main
// program (none given: anywhere).
bool is_profile(const ir::Motion& motion, const std::vector<LineRange>& lines);

struct Figures {
  std::uint64_t points = 0;    // places measured
  double max_mm = 0.0;         // largest deviation in size, refined between the places
  double max_signed_mm = 0.0;  // the same with its sign: positive, material is left; negative, too much is taken
  std::uint32_t max_line = 0;
  curves::Point max_at;     // turning: z and radius; milling: x and y, in this order
  double highest_mm = 0.0;  // signed extremes
  double lowest_mm = 0.0;
  double mean_mm = 0.0;  // of the size, along the path's length
  double rmse_mm = 0.0;
  double length_mm = 0.0;  // of path on the nominal
};

// Figures while they are added up.
class Sums {
 public:
  void add(const curves::Deviation& deviation, std::uint32_t line);
  [[nodiscard]] Figures result() const;
  [[nodiscard]] double max_mm() const { return figures_.max_mm; }

 private:
  Figures figures_;
  double integral_ = 0.0;
  double integral_square_ = 0.0;
};

// A stretch of the nominal that nothing passes: turning, by z; milling, by the path's length along its curve.
struct Gap {
  double low_mm = 0.0;
  double high_mm = 0.0;
};

// A deviation along the path, for plots: thinned to a bounded number, the larger ones kept.
struct TracePoint {
  double along_mm = 0.0;  // z in turning, length of path in milling
  double value_mm = 0.0;
};

// Keeps at most kMost points: of two neighbours the larger one stays when there are too many.
class Trace {
 public:
  static constexpr std::size_t kMost = 4096;

  void add(double along_mm, double value_mm);
  [[nodiscard]] const std::vector<TracePoint>& points() const { return points_; }

 private:
  std::vector<TracePoint> points_;
  std::uint32_t every_ = 1;  // that many are taken as one
  std::uint32_t pending_ = 0;
  TracePoint best_;
};

// The largest deviation of what one block cuts, with its sign.
struct BlockDeviation {
  std::uint64_t ordinal = 0;  // as in ir::Place
  double value_mm = 0.0;
};

struct Report {
  std::uint64_t blocks = 0;        // moves that make the profile
  bool in_plane = false;           // milling in x-y
  Figures path;                    // as programmed
  std::optional<Figures> surface;  // as cut; nothing where no nose or cutter was known and uncompensated
  // No point of any chord lies farther from the nominal along its normal, end points included; nothing where the
  // nominal's second derivative is not bounded. Holds for the programmed path, in milling for the path of the surface.
  std::optional<double> chord_bound_mm;
  double overrun_mm = 0.0;           // farthest reach of the path beyond the nominal's ends; not in the figures
  bool has_unmeasured_cuts = false;  // nothing passes with them
  bool covered = false;              // the path passes all of the nominal
  std::vector<Gap> gaps;             // where it does not
  std::vector<TracePoint> trace;
  std::vector<BlockDeviation> of_blocks;  // in the order of the run; where the settings ask for them
  checks::FindingList findings;
  checks::NotCheckedList not_checked;

  // What counts: the surface where it is known, otherwise the path.
  [[nodiscard]] const Figures& figures() const { return surface ? *surface : path; }
};

}  // namespace dripfeed::accuracy
