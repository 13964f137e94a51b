// From the line into the control: blocks arrive when there is room in the buffer, and are computed one after the other.
// Says when each row was ready to move; who moves them says when each started and left the buffer.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "checks/machine.h"
#include "checks/timing/limiters.h"
#include "checks/timing/ring.h"
#include "checks/timing/rows.h"

namespace dripfeed::timing {

struct SupplySettings {
  checks::BufferSize buffer = {};  // without figures it has no limit
  double char_s = 0.0;             // 0: the program lies in the memory
  double latency_s = 0.0;          // before the first byte
  double line_delay_s = 0.0;       // after each EOB, with char_s alone
};

class Supply {
 public:
  explicit Supply(const SupplySettings& settings) { restart(settings); }
  // From the first row again; its memory is used again.
  void restart(const SupplySettings& settings);

  // Lets in what there is room for. Rows once let in must not change.
  void let_in(const Rows& rows);
  // The block of the oldest row that is still buffered begins to move. Only for rows that are new blocks, in order.
  void start_block(double now_s);

  // Rows that were let in, from the first that is kept.
  [[nodiscard]] std::size_t count() const { return ready_s_.size(); }
  [[nodiscard]] double ready_s(std::size_t row) const { return ready_s_[row]; }
  [[nodiscard]] double arrived_s(std::size_t row) const { return arrived_s_[row]; }
  // Why it was not ready earlier: never motion. `buffer`: it waited for room.
  [[nodiscard]] Limiter reason(std::size_t row) const { return reasons_[row]; }
  [[nodiscard]] bool has_limit() const { return buffer_.blocks > 0 || buffer_.bytes > 0; }
  // The caller drops its first rows, too.
  void drop_front(std::size_t rows);

 private:
  [[nodiscard]] bool is_full(std::uint64_t bytes) const;

  checks::BufferSize buffer_;
  double char_s_ = 0.0;
  double line_delay_s_ = 0.0;
  Ring<std::uint32_t> buffered_;  // bytes of each; bounded by the buffer's size
  std::uint64_t buffered_bytes_ = 0;
  bool blocked_ = false;  // the next block waits for room
  double room_s_ = 0.0;   // when there was room for the newest block
  double line_s_ = 0.0;   // when the line is free again
  double block_s_ = 0.0;  // when the newest block was there, before the rest after its EOB
  double computed_s_ = 0.0;
  std::vector<double> ready_s_;
  std::vector<double> arrived_s_;
  std::vector<Limiter> reasons_;
};

}  // namespace dripfeed::timing
