// Batches of motions.
#include "dialects/interpreter/state/motion_buffer.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace dripfeed::interpreter {

namespace {

std::uint32_t capped(std::uint64_t count) {
  return static_cast<std::uint32_t>(std::min<std::uint64_t>(count, std::numeric_limits<std::uint32_t>::max()));
}

// motion = Motion{}, field by field: in one piece the compiler clears it by a string instruction, which takes longer
// than all else that a straight move needs.
void make_blank(ir::Motion& motion) {
  static_assert(sizeof(ir::Motion) == 280, "a new field? It belongs into this list.");
  constexpr ir::Motion kBlank;
  motion.plane = kBlank.plane;
  motion.feed_mode = kBlank.feed_mode;
  motion.length_offset = kBlank.length_offset;
  motion.axes_commanded = kBlank.axes_commanded;
  motion.machine_coordinates = kBlank.machine_coordinates;
  motion.exact_stop = kBlank.exact_stop;
  motion.start.fill(0.0);
  motion.end.fill(0.0);
  motion.center.fill(0.0);
  motion.feed = kBlank.feed;
  motion.spindle_rpm = kBlank.spindle_rpm;
  motion.surface_speed_m_min = kBlank.surface_speed_m_min;
  motion.spindle = kBlank.spindle;
  motion.comp = kBlank.comp;
  motion.coolant = kBlank.coolant;
  motion.gaps = kBlank.gaps;
  motion.number = kBlank.number;
  motion.tool_offset = kBlank.tool_offset;
  motion.text = kBlank.text;
  motion.axes_unknown = kBlank.axes_unknown;
  motion.length_offset_number = kBlank.length_offset_number;
}

// Of a plain block there is none but the block itself.
void take_work(Work& work, ir::ComputeCounts& counts) {
  const std::uint64_t others = work.number_reads | work.number_writes | work.named_reads | work.named_writes |
                               work.operators | work.functions | work.jumps | work.rounds | work.calls | work.indexed;
  if (others == 0) {
    counts = {};
    counts.blocks = capped(std::exchange(work.blocks, 0));
    return;
  }
  counts = {capped(work.blocks),       capped(work.number_reads), capped(work.number_writes), capped(work.named_reads),
            capped(work.named_writes), capped(work.operators),    capped(work.functions),     capped(work.jumps),
            capped(work.rounds),       capped(work.calls),        capped(work.indexed)};
  work = {};
}

}  // namespace

MotionBuffer::MotionBuffer(ir::MotionSink& sink, RunBudget& budget)
    : sink_(sink), budget_(budget), motions_(ir::kMotionBatch) {}

ir::Motion& MotionBuffer::add(ir::MotionKind kind) {
  budget_.take_motion();
  if (captured_ != nullptr) [[unlikely]] {
    budget_.keep(captured_->size());
    ir::Motion& kept = captured_->emplace_back();
    kept.kind = kind;
    kept.place = place;
    return kept;
  }
  if (used_ == motions_.size() && (held_ || held_for_spline_ || held_for_plane_)) {
    budget_.keep(2 * used_);
    motions_.resize(2 * used_);
  }
  if (used_ == motions_.size()) flush();
  ir::Motion& motion = motions_[used_++];
  make_blank(motion);
  motion.kind = kind;
  motion.place.program = place.program;
  motion.place.line = place.line;
  motion.place.ordinal = place.ordinal;
  take_work(work, motion.compute);
  return motion;
}

void MotionBuffer::flush() {
  if (used_ == 0) return;
  for (std::size_t first = 0; first < used_; first += ir::kMotionBatch)
    sink_.consume({motions_.data() + first, std::min(ir::kMotionBatch, used_ - first)});
  flushed_ += used_;
  remembered_ = used_;
  used_ = 0;
}

void MotionBuffer::replace(std::size_t taken, const std::vector<ir::Motion>& made) {
  for (std::size_t first = 0; first < made.size(); first += ir::kMotionBatch)
    sink_.consume({made.data() + first, std::min(ir::kMotionBatch, made.size() - first)});
  flushed_ += made.size();
  std::copy(motions_.begin() + static_cast<std::ptrdiff_t>(taken),
            motions_.begin() + static_cast<std::ptrdiff_t>(used_), motions_.begin());
  used_ -= taken;
  remembered_ = 0;
}

std::vector<ir::Motion> MotionBuffer::take_back(std::size_t first) {
  const auto begin = motions_.begin() + static_cast<std::ptrdiff_t>(first);
  std::vector<ir::Motion> taken(begin, motions_.begin() + static_cast<std::ptrdiff_t>(used_));
  used_ = first;
  return taken;
}

const ir::Motion* MotionBuffer::last_move() const {
  for (std::size_t i = used_; i-- > 0;)
    if (ir::is_move(motions_[i].kind)) return &motions_[i];
  for (std::size_t i = remembered_; i-- > used_;)
    if (ir::is_move(motions_[i].kind)) return &motions_[i];
  return nullptr;
}

}  // namespace dripfeed::interpreter
