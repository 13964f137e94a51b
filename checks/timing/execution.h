// The machine as it runs: each row begins when it is ready and the one before has ended, and each move ends as fast as
// what is known by then allows: a control must be able to stop at the end of the blocks that it has.
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "checks/timing/limiters.h"
#include "checks/timing/piece_arrays.h"
#include "checks/timing/rows.h"
#include "checks/timing/supply.h"

namespace dripfeed::timing {

inline constexpr double kStall_s = 1e-6;

// How a row ran.
struct Ran {
  std::size_t row = 0;
  double start_s = 0.0;
  double waited_s = 0.0;  // before it, standing still
  double duration_s = 0.0;
  std::size_t piece = 0;  // where the row is one
  double start2 = 0.0;    // (mm/s)²
  double end2 = 0.0;
  Limiter limiter = Limiter::motion;
  double lost_s = 0.0;               // of duration_s, by braking for what was not known yet
  std::size_t late_row = 0;          // the one that was missing, where limiter is not motion
  std::uint64_t buffered_bytes = 0;  // when it began, of whole blocks, itself not counted
  std::uint64_t buffered_blocks = 0;
  bool all_arrived = false;  // nothing more comes: the buffer runs empty as it should
};

class RanSink {
 public:
  RanSink() = default;
  RanSink(const RanSink&) = delete;
  RanSink& operator=(const RanSink&) = delete;
  virtual ~RanSink() = default;
  // False: that is enough, run no further.
  virtual bool ran(const Row& row, const Ran& how) = 0;
};

class Execution {
 public:
  explicit Execution(const SupplySettings& settings) : supply_(settings) {}
  // From the first row again; its memory is used again.
  void restart(const SupplySettings& settings);

  // `speed2`: squares at the starts of the pieces (and after the last) by the plan of the whole path, certain up to
  // index `certain`; `duration_s`: of the pieces before that, by the plan; `sums`: change_sums of the pieces. Runs rows
  // as far as that goes; all when `is_last`. Returns how many rows ran.
  struct Window {
    const Rows& rows;
    const PieceArrays& pieces;
    const std::vector<double>& speed2;
    const std::vector<double>& duration_s;
    const std::vector<double>& sums;
    std::size_t certain = 0;
    bool is_last = true;
  };
  std::size_t run(const Window& window, RanSink& sink);
  // The caller drops the rows that ran, and their pieces.
  void drop_front(std::size_t rows, std::size_t pieces);

  [[nodiscard]] double end_s() const { return end_s_; }
  [[nodiscard]] std::size_t pieces_run() const { return piece_; }

 private:
  explicit Execution(Supply supply) : supply_(std::move(supply)) {}
  bool learn(const Rows& rows, double now_s);
  void run_piece(const Window& window, Ran& how);
  void count_buffered(const Rows& rows, Ran& how);
  [[nodiscard]] Limiter limiter_of(std::size_t row) const;

  Supply supply_;
  std::size_t row_ = 0;
  std::size_t piece_ = 0;         // of row_, or the next one
  std::size_t known_rows_ = 0;    // ready by now
  std::size_t known_pieces_ = 0;  // among them
  std::size_t arrived_rows_ = 0;
  std::uint64_t arrived_bytes_ = 0;  // of blocks that arrived and have not started
  std::uint64_t arrived_blocks_ = 0;
  double end_s_ = 0.0;
  double speed2_ = 0.0;
  bool moved_ = false;
};

}  // namespace dripfeed::timing
