// While the blocks of a cycle's shape are run: which they are, what was before, and where the program goes on.
#pragma once

#include <cstdint>
#include <vector>

#include "dialects/interpreter/state/modal_state.h"
#include "dialects/interpreter/state/motion_buffer.h"

namespace dripfeed::interpreter {

class ShapeRun {
 public:
  // Instructions: of the cycle's block, of the shape's last block, and after the cycle.
  void begin(std::uint32_t cycle, std::uint32_t last, std::uint32_t resume, const ModalState& state, ir::Place place);
  // `last` is the block after the shape: a label that stands alone ends it.
  void end_in_front_of_last() { runs_last_ = false; }
  void end() { active_ = false; }

  [[nodiscard]] bool active() const { return active_; }
  // True for a block after the last one, once that has been run.
  bool ends_before(std::uint32_t instruction) {
    if (instruction == last_) reached_ = true;
    return reached_ && (instruction != last_ || !runs_last_);
  }
  // G70: the shape itself is cut.
  [[nodiscard]] bool finishes() const { return before_.repetitive.cycle == 0; }
  // The return after finishing, and the feed that was in effect.
  void finish(ModalState& state, MotionBuffer& out) const;

  [[nodiscard]] std::uint32_t cycle() const { return cycle_; }
  [[nodiscard]] std::uint32_t resume() const { return resume_; }
  [[nodiscard]] ir::Place place() const { return place_; }
  [[nodiscard]] const ModalState& before() const { return before_; }
  [[nodiscard]] std::vector<ir::Motion>& motions() { return motions_; }

 private:
  bool active_ = false;
  bool reached_ = false;
  bool runs_last_ = true;
  std::uint32_t cycle_ = 0;
  std::uint32_t last_ = 0;
  std::uint32_t resume_ = 0;
  ModalState before_;
  ir::Place place_;
  std::vector<ir::Motion> motions_;
};

}  // namespace dripfeed::interpreter
