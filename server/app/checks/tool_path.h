// The toolpath of a text as points, for a picture of it: what the run does and, in addition, what is not known of it.
// The programmed path, without tool radius compensation, in the active work offset.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "checks/finding.h"
#include "checks/machine.h"
#include "dialects/ir/motion.h"
#include "server/app/base/check_budget.h"
#include "server/app/checks/diagnose.h"
#include "server/app/checks/tool_list.h"

namespace dripfeed::app {

// What leads to a point from the one before.
enum class PathKind : std::uint8_t { begin, rapid, cut_per_min, cut_per_rev, cut_inverse_time, thread };
inline constexpr std::array<std::string_view, 6> kPathKindNames = {
    "begin", "rapid", "cut_per_min", "cut_per_rev", "cut_inverse_time", "thread"};

// Moves that the path does not have.
enum class NotDrawn : std::uint8_t { unknown_place, machine_coordinates, no_place };
inline constexpr std::array<std::string_view, 3> kNotDrawnNames = {"unknown_place", "machine_coordinates", "no_place"};
struct NotDrawnMoves {
  std::uint64_t count = 0;
  std::uint64_t cuts = 0;  // of these, that are no rapids
  std::uint32_t first_line = 0;
};

// What one tool does of it.
struct ToolMoves {
  std::string name;              // "T5", or as the program names it; "": before any is taken
  std::int32_t number = 0;       // 0: it has none
  std::uint32_t first_line = 0;  // that takes it; 0: none of the text
  double cut_mm = 0.0;
  double rapid_mm = 0.0;
  std::optional<checks::Tool> shape = {};  // nothing: the machine does not have it, nor its figures
};

// When the points of a path are reached on a machine, by the model that forecasts have. One row a point; NaN: not
// known.
struct PathTimes {
  std::vector<float> times_s;
  std::vector<float> speeds_mm_min;       // mean of the segment that leads to the point
  std::vector<std::uint32_t> buffer;      // bytes in the control when that motion begins; empty: nothing is fed
  double cycle_s = 0.0;                   // of the whole program
  std::vector<checks::NotChecked> notes;  // what the times leave out
};

// How far from the nominal each block cuts.
struct PathDeviations {
  std::vector<float> values_mm;  // one row a point, with its sign: positive, material is left; NaN: not measured
  bool of_surface = false;       // that the tool leaves; otherwise of the programmed path
  std::vector<checks::NotChecked> notes;
};

// Where a point is from: the motion that leads to it, and which part of that.
struct PointOrigin {
  std::uint64_t ordinal = 0;  // of its block, as in ir::Place
  std::uint32_t motion = 0;   // its number among all motions that have places (checks::has_places)
  float from = 0.0F;          // shares of the motion before the point before, and before this one
  float to = 1.0F;
  float length_mm = 0.0F;  // from the point before
};

// From this point on it is this tool that moves.
struct ToolChange {
  std::uint32_t point = 0;
  std::uint32_t tool = 0;  // of ToolPath::tools
};

struct ToolPath {
  static constexpr std::size_t kMostPoints = 1'000'000;
  static constexpr double kArcError_mm = 5e-3;

  // One row a point.
  std::vector<float> points_mm;  // x y z; x as radius
  std::vector<PathKind> kinds;
  std::vector<std::uint32_t> lines;  // of the text; 0: in a called program
  std::vector<float> feeds;          // mm/min, mm/rev or 1/min as the kind says; of a thread its lead
  std::vector<PointOrigin> origins;

  std::uint64_t segments = 0;
  std::array<double, 3> low_mm{};  // of all points; without one: 0
  std::array<double, 3> high_mm{};
  double cut_mm = 0.0;
  double rapid_mm = 0.0;
  std::vector<ToolMoves> tools;  // in the order in which they are taken first
  std::vector<ToolChange> tool_changes;
  std::array<NotDrawnMoves, kNotDrawnNames.size()> not_drawn{};
  std::uint16_t other_axes = 0;         // bit per ir::Axis: moves other than x, y and z
  std::set<std::int32_t> work_offsets;  // as ir::Motion::number, of the moves
  bool compensated = false;             // a move has tool radius compensation
  bool is_cut_off = false;              // it has more points than are kept
  bool x_is_diameter = false;
  std::optional<PathTimes> times;
  std::string why_no_times;  // where there are none
  std::optional<PathDeviations> deviations;
  CheckReport report;  // of reading, validating and running
};

class PathRecorder final : public ir::MotionSink {
 public:
  explicit PathRecorder(bool x_is_diameter, std::size_t most_points = ToolPath::kMostPoints);
  void consume(std::span<const ir::Motion> motions) override;
  [[nodiscard]] bool is_full() const { return path_.is_cut_off; }
  ToolPath finish(const Followed::Run& run);

  // Of one of the last motions of a block: the row of its start and of its end. Of a motion that has none: the last row
  // twice.
  struct RowRange {
    double first = 0.0;
    double last = 0.0;
  };
  [[nodiscard]] RowRange rows_of(std::uint64_t ordinal) const;
  // After finish(): the point at or before a place between rows.
  [[nodiscard]] double point_of(double row) const;

 private:
  struct Spot {
    std::array<double, 3> at{};
    std::uint8_t unknown = 0;  // bit per axis
    friend bool operator==(const Spot&, const Spot&) = default;
  };
  struct Row {
    Spot spot;
    PathKind kind = PathKind::begin;
    std::uint32_t line = 0;
    std::uint32_t program = 0;
    std::uint64_t ordinal = 0;
    std::uint32_t motion = 0;
    float from = 0.0F;
    float to = 0.0F;
    float feed = 0.0F;
    std::uint32_t tool = 0;  // of tools_
    bool ends_move = true;   // it is no chord within an arc
  };
  void add(const ir::Motion& given);
  void leave_out(NotDrawn why, const ir::Motion& motion);
  void add_chords(const ir::Motion& motion, Row row);
  void push(const Row& row);
  void keep(const Row& row, std::uint32_t line, double length_mm);
  void keep_tools(const Followed::Run& run);

  ToolPath path_;
  std::size_t most_points_;
  std::vector<Row> rows_;
  std::optional<Spot> here_;  // where the last point is
  ToolList tools_;
  std::int32_t work_offset_ = 0;
  std::uint8_t commanded_ = 0;  // bit per axis
  std::uint32_t motions_ = 0;   // that have places, so far
  struct LastRows {
    std::uint64_t ordinal = 0;
    RowRange rows;
  };
  static constexpr std::size_t kRecent = 8;
  std::array<LastRows, kRecent> recent_{};
  std::size_t newest_ = 0;
  std::vector<std::uint32_t> points_of_rows_;
};

// Runs an opened text within the budget, and until the recorder is full.
Followed follow_within(Examination& examination, const CheckBudget& budget, const PathRecorder& recorder,
                       ir::MotionSink& sink);

// Of an opened text; those `beside` get the same motions.
ToolPath record_path(Examination& examination, const CheckBudget& budget, std::vector<ir::MotionSink*> more_sinks = {});

// Errors: as diagnose_text.
Result<ToolPath> follow_path(const DiagnoseOrder& order, const Documents& documents, const CheckBudget& budget);

}  // namespace dripfeed::app
