// checks/timing: how long a program takes and whether the control ever waits for it. Three times: what the control
// computes (cost model), what the machine moves (a look-ahead plan), what the line carries (bytes and baud); and a
// buffer between them that names the first line for which the machine stands still. What the cost model's figures are,
// and what the line does otherwise, is left to others.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "checks/finding.h"
#include "checks/machine.h"
#include "checks/timing/course.h"
#include "checks/timing/limiters.h"
#include "dialects/ir/cost_model.h"
#include "dialects/ir/motion.h"

namespace dripfeed::timing {

// The line a program is fed over.
struct Line {
  double baud = 0.0;            // bits/s
  double bits_per_char = 11.0;  // start, data, parity and stop bits: 7E2 has 11
  double pace = 1.0;            // share of the line's rate that the sender uses
  double latency_s = 0.0;       // once, before the first byte
  double char_delay_s = 0.0;    // additional, for each character
  double line_delay_s = 0.0;    // additional, after each EOB

  [[nodiscard]] double char_s(double at_baud) const { return bits_per_char / (at_baud * pace) + char_delay_s; }
};

inline constexpr std::size_t kMostKept = 20'000'000;

struct Settings {
  checks::Machine machine = {};
  ir::CostModel cost = {};        // counts where the machine has none of its own
  bool x_is_diameter = false;     // the motions' x
  std::optional<Line> line = {};  // nothing: the program lies in the control's memory
  // Bytes on the wire of each line of the main program, its EOB included, line 1 first. Needed with a line.
  std::vector<std::uint32_t> line_bytes = {};
  bool limit_jerk = true;  // where the machine has one
  // The whole program is kept (about 100 bytes a block) instead of a window of it: for `advice`, and for `curve`.
  // Programs of more than `most_kept` motions are not, and say so. The same number ends the timing of a program whose
  // window grows beyond it: a block of a cycle may make any number of motions, and a control holds whole blocks.
  bool keep_whole = false;
  std::size_t most_kept = kMostKept;
  bool wants_curve = false;
  // Of so many motions, the first ones, the report has each one's own time.
  std::size_t most_motion_times = 0;
  unsigned threads = 1;  // for plans of whole programs
};
// What would keep the machine from waiting. Nothing where it does not wait, or where nothing within reach helps.
struct Advice {
  std::optional<double> feed_share = {};     // of the programmed feeds, all reduced alike
  std::optional<double> feed_mm_min = {};    // the highest programmed feed, reduced so
  std::optional<double> baud = {};           // lowest that does
  std::optional<double> standard_baud = {};  // the next usual one
};

// A place of the run: speed and what lay in the control's buffer.
struct CurvePoint {
  double time_s = 0.0;
  double speed_mm_s = 0.0;
  std::uint64_t buffered_bytes = 0;
  std::uint64_t buffered_blocks = 0;
};

// When a motion runs; what it waits for beforehand is left out.
struct MotionTime {
  double start_s = 0.0;
  double end_s = 0.0;
  std::uint64_t buffered_bytes = 0;  // in the control when it begins, of a program that is fed
};

struct Report {
  bool is_whole = true;      // otherwise the times are those of its beginning, and `not_checked` says why
  std::uint64_t blocks = 0;  // executed
  double cycle_s = 0.0;      // from start to the end of the last move, all waiting included
  double motion_s = 0.0;     // moves, dwells and tool changes alone
  double compute_s = 0.0;
  double line_s = 0.0;        // of all bytes, without waiting for the control
  std::uint64_t stalls = 0;   // blocks at which time was lost because the control did not have the next one in time
  double stall_s = 0.0;       // the time lost; cycle_s = first_move_s + motion_s + stall_s
  double standstill_s = 0.0;  // of it, without moving; the rest went into braking, creeping and starting again
  std::uint32_t first_stall_line = 0;  // 0: none
  double first_stall_at_s = 0.0;
  double longest_stall_s = 0.0;  // standing still
  std::uint32_t longest_stall_line = 0;
  double first_move_s = 0.0;              // until then the machine waits for its first block
  bool is_fed = false;                    // over a line; otherwise no buffer was watched
  std::uint64_t lowest_buffer_bytes = 0;  // whole blocks in the control, from the first move until all was sent
  std::uint64_t lowest_buffer_blocks = 0;
  std::array<double, kLimiters> limited_s{};  // by Limiter
  std::vector<Stretch> stretches;
  std::size_t stretch_count = 0;  // also those that the list has no room for
  Advice advice;
  std::vector<CurvePoint> curve;
  std::vector<MotionTime> motion_times;  // of the motions that have places (checks::has_places), in their order
  std::vector<CoursePoint> course;  // of the main program; empty where lines run more than once, or others are called
  double path_mm = 0.0;
  double rapid_s = 0.0;  // of motion_s
  // Where the cost model's figures are from, in words, too, and the factor that compute_s may be off by.
  ir::CostSource cost_source = ir::CostSource::assumed;
  std::string cost_origin;
  double cost_spread = 1.0;
  checks::FindingList findings;
  checks::NotCheckedList not_checked;
};

class Timing final : public ir::MotionSink {
 public:
  explicit Timing(Settings settings);
  ~Timing() override;
  void consume(std::span<const ir::Motion> motions) override;
  // After the last motion; once.
  [[nodiscard]] Report finish();

 private:
  class Work;
  std::unique_ptr<Work> work_;
};

}  // namespace dripfeed::timing
