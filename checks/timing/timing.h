// checks/timing: how long a program takes and whether the control ever waits for it. Three times: what the control
// computes (cost model), what the machine moves (a look-ahead plan), what the line carries (bytes and baud); and a
// buffer between them that names the first line for which the machine stands still. What the cost model's figures are,
// and what the line does otherwise, is left to others.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "checks/finding.h"
#include "checks/machine.h"
#include "dialects/ir/cost_model.h"
#include "dialects/ir/motion.h"

namespace dripfeed::timing {

// The line a program is fed over.
struct Line {
  double baud = 0.0;            // bits/s
  double bits_per_char = 11.0;  // start, data, parity and stop bits: 7E2 has 11
  double latency_s = 0.0;       // once, before the first byte

  [[nodiscard]] double char_s() const { return bits_per_char / baud; }
};

struct Settings {
  checks::Machine machine = {};
  ir::CostModel cost = {};        // counts where the machine has none of its own
  bool x_is_diameter = false;     // the motions' x
  std::optional<Line> line = {};  // nothing: the program lies in the control's memory
  // Bytes on the wire of each line of the main program, its EOB included, line 1 first. Needed with a line.
  std::vector<std::uint32_t> line_bytes = {};
};

struct Report {
  std::uint64_t blocks = 0;  // executed
  double cycle_s = 0.0;      // from start to the end of the last move, all waiting included
  double motion_s = 0.0;     // moves, dwells and tool changes alone
  double compute_s = 0.0;
  double line_s = 0.0;       // of all bytes, without waiting for the control
  std::uint64_t stalls = 0;  // moves that began late because the control had no block
  double stall_s = 0.0;
  std::uint32_t first_stall_line = 0;  // 0: none
  double path_mm = 0.0;
  double rapid_s = 0.0;           // of motion_s
  bool cost_is_measured = false;  // otherwise compute_s is an assumption
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
