// Batches of motions.
#include "dialects/interpreter/motion_buffer.h"

#include <algorithm>
#include <limits>

namespace dripfeed::interpreter {

namespace {

std::uint32_t capped(std::uint64_t count) {
  return static_cast<std::uint32_t>(std::min<std::uint64_t>(count, std::numeric_limits<std::uint32_t>::max()));
}

}  // namespace

MotionBuffer::MotionBuffer(ir::MotionSink& sink) : sink_(sink), motions_(ir::kMotionBatch) {}

ir::Motion& MotionBuffer::add(ir::MotionKind kind) {
  if (used_ == motions_.size() && held_) motions_.resize(2 * motions_.size());
  if (used_ == motions_.size()) flush();
  ir::Motion& motion = motions_[used_++];
  motion = ir::Motion{};
  motion.kind = kind;
  motion.place = place;
  motion.compute = {capped(work.blocks), capped(work.number_reads), capped(work.named_reads), capped(work.operators),
                    capped(work.functions)};
  work = {};
  return motion;
}

void MotionBuffer::flush() {
  if (used_ == 0) return;
  for (std::size_t first = 0; first < used_; first += ir::kMotionBatch)
    sink_.consume({motions_.data() + first, std::min(ir::kMotionBatch, used_ - first)});
  flushed_ += used_;
  used_ = 0;
}

}  // namespace dripfeed::interpreter
