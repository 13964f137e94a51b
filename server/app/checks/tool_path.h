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
  std::uint32_t first_line = 0;
};

// What one tool does of it.
struct ToolMoves {
  std::string name;              // "T5", or as the program names it; "": before any is taken
  std::uint32_t first_line = 0;  // that takes it; 0: none of the text
  double cut_mm = 0.0;
  double rapid_mm = 0.0;
};

struct ToolPath {
  static constexpr std::size_t kMostPoints = 1'000'000;
  static constexpr double kArcError_mm = 5e-3;

  // One row a point.
  std::vector<float> points_mm;  // x y z; x as radius
  std::vector<PathKind> kinds;
  std::vector<std::uint32_t> lines;  // of the text; 0: in a called program
  std::vector<float> feeds;          // mm/min, mm/rev or 1/min as the kind says; of a thread its lead

  std::uint64_t segments = 0;
  std::array<double, 3> low_mm{};  // of all points; without one: 0
  std::array<double, 3> high_mm{};
  double cut_mm = 0.0;
  double rapid_mm = 0.0;
  std::vector<ToolMoves> tools;  // in the order in which they are taken first
  std::array<NotDrawnMoves, kNotDrawnNames.size()> not_drawn{};
  std::uint16_t other_axes = 0;         // bit per ir::Axis: moves other than x, y and z
  std::set<std::int32_t> work_offsets;  // as ir::Motion::number, of the moves
  bool compensated = false;             // a move has tool radius compensation
  bool is_cut_off = false;              // it has more points than are kept
  bool x_is_diameter = false;
  CheckReport report;  // of reading, validating and running
};

class PathRecorder final : public ir::MotionSink {
 public:
  explicit PathRecorder(bool x_is_diameter, std::size_t most_points = ToolPath::kMostPoints);
  void consume(std::span<const ir::Motion> motions) override;
  [[nodiscard]] bool is_full() const { return path_.is_cut_off; }
  ToolPath finish(const Followed::Run& run);

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
    float feed = 0.0F;
    std::uint32_t tool = 0;  // of tools_
    bool ends_move = true;   // it is no chord within an arc
  };
  void add(const ir::Motion& given);
  void leave_out(NotDrawn why, const ir::Motion& motion);
  void push(const Row& row);
  void keep(const Row& row, std::uint32_t line);

  ToolPath path_;
  std::size_t most_points_;
  std::vector<Row> rows_;
  std::optional<Spot> here_;  // where the last point is
  ToolList tools_;
  std::int32_t work_offset_ = 0;
  std::uint8_t commanded_ = 0;  // bit per axis
};

// Of an opened text; `beside` gets the same motions.
ToolPath record_path(Examination& examination, const CheckBudget& budget, ir::MotionSink* beside = nullptr);

// Errors: as diagnose_text.
Result<ToolPath> follow_path(const DiagnoseOrder& order, const Documents& documents, const CheckBudget& budget);

}  // namespace dripfeed::app
