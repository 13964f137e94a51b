// Characters become blocks at their EOB; a block's time begins when the one before is over, or when it came.
#include "server/simulator/tape_reader.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace dripfeed::simulator {

void TapeReader::start(Time_ns now) {
  reset();
  run_until_ = now;
}

void TapeReader::reset() {
  blocks_.clear();
  block_.clear();
  block_bytes_ = buffered_ = 0;
  label_skip_ = true;
  seen_percent_ = at_end_ = running_ = false;
  run_until_ = 0;
  dry_since_.reset();
  clock_ = BlockClock(settings_);
}

void TapeReader::take(char c, Time_ns at) {
  if (at_end_ || c == '\0' || c == '\r' || c == 0x7F) return;
  if (label_skip_) {
    // All up to the first EOB after the first '%' is leader.
    if (c == '%') seen_percent_ = true;
    if (c == '\n' && seen_percent_) label_skip_ = false;
    return;
  }
  if (c == '%' && block_.empty()) {
    at_end_ = true;
    return;
  }
  ++buffered_;
  ++block_bytes_;
  if (c != '\n') {
    block_ += c;
    return;
  }
  finish_block(at);
}

void TapeReader::finish_block(Time_ns at) {
  blocks_.push_back({std::exchange(block_, {}), std::exchange(block_bytes_, 0)});
  if (const auto dry = std::exchange(dry_since_, {})) {
    ++stalls_;
    stall_s_ += static_cast<double>(at - *dry) * 1e-9;
  }
  if (!running_) run_until_ = std::max(run_until_, at);
  run(at);
}

void TapeReader::run(Time_ns now) {
  while (clock_.fault().empty()) {
    if (running_) {
      if (run_until_ > now) return;
      running_ = false;
    }
    if (blocks_.empty()) {
      if (!dry_since_ && blocks_run_ > 0 && !at_end_ && !clock_.ended()) dry_since_ = run_until_;
      return;
    }
    const Block block = std::move(blocks_.front());
    blocks_.pop_front();
    buffered_ -= block.bytes;
    const double seconds = clock_.run(block.text);
    if (!clock_.fault().empty()) return;
    ++blocks_run_;
    bytes_run_ += block.bytes;
    running_ = true;
    run_until_ += static_cast<Time_ns>(std::llround(seconds / speed_ * 1e9));
  }
}

void TapeReader::report(ControlReport& report) const {
  report.blocks_run = blocks_run_;
  report.bytes_run = bytes_run_;
  report.stalls = stalls_;
  report.stall_s = stall_s_;
  report.unfinished_block = !block_.empty();
}

}  // namespace dripfeed::simulator
