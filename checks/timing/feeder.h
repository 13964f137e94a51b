// The buffer between line, computing and motion. Blocks arrive over the line when there is room, are computed one after
// the other, and move one after the other; a block that is not ready when the one before has ended is a stall.
#pragma once

#include <cstddef>
#include <cstdint>

#include "checks/machine.h"
#include "checks/timing/ring.h"

namespace dripfeed::timing {

struct FedBlock {
  std::uint32_t line = 0;
  bool is_new = true;       // begins another block; otherwise goes on with the one before (its second motion)
  std::uint64_t bytes = 0;  // on the wire
  double compute_s = 0.0;
  double motion_s = 0.0;
};

class Feeder {
 public:
  // `char_s` 0: the program lies in the memory. A buffer without figures has no limit.
  Feeder(checks::BufferSize buffer, double char_s, double latency_s);

  // Returns how long the machine waited for it, s.
  double feed(const FedBlock& block);
  // End of the last block, s after the start.
  [[nodiscard]] double end_s() const { return end_s_; }

 private:
  struct Buffered {
    double start_s = 0.0;
    std::uint64_t bytes = 0;
  };
  void make_room(std::uint64_t bytes);

  checks::BufferSize buffer_;
  double char_s_;
  Ring<Buffered> buffered_;  // bounded by the buffer's size
  std::uint64_t buffered_bytes_ = 0;
  double room_s_ = 0.0;   // when there was room for the newest block
  double line_s_ = 0.0;   // when the line is free again
  double ready_s_ = 0.0;  // when the newest block was computed
  double end_s_ = 0.0;    // when it has moved
  bool moved_ = false;
};

}  // namespace dripfeed::timing
