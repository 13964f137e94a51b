// Likely faults that only a run sees, and that the control takes without an alarm: a tool without its length, a cut
// with a spindle that stands, feeds of the other mode, holes whose levels do not fit. Watched in checks only
// (Semantics::unset_is_unknown).
#pragma once

#include "dialects/interpreter/machine/run_report.h"
#include "dialects/interpreter/state/modal_state.h"
#include "dialects/interpreter/state/plain_block.h"
#include "dialects/ir/control.h"

namespace dripfeed::interpreter {

class BlockWatch {
 public:
  BlockWatch(const ir::Control& control, const ModalState& state, RunReport& report)
      : control_(control),
        state_(state),
        report_(report),
        is_on_(control.semantics.unset_is_unknown && control.semantics.has_vacant) {}

  // After the block was applied. `moved`: it named an axis and moved.
  void look(const Instruction& i, const PlainBlock& block, bool moved) {
    if (is_on_) [[unlikely]]
      look_at(i, block, moved);
  }
  // A program that is not known was called: it may have changed the tool and its length.
  void forget() { length_known_ = spindle_known_ = false; }

 private:
  void look_at(const Instruction& i, const PlainBlock& block, bool moved);
  void take_tool(const PlainBlock& block);
  void length(const Instruction& i, const PlainBlock& block);
  void cut(const Instruction& i, const PlainBlock& block);
  void selected(const Instruction& i);
  void feed(const Instruction& i, const PlainBlock& block);
  void hole(const Instruction& i, const PlainBlock& block);

  const ir::Control& control_;
  const ModalState& state_;
  RunReport& report_;
  bool is_on_;
  std::int32_t tool_ = 0;
  bool length_known_ = false;      // a tool was changed in, and nothing since that is not known may have set its length
  bool reported_length_ = false;   // of this tool
  std::int32_t selected_ = 0;      // a tool that was called, and not changed in as yet
  bool spindle_known_ = true;      // nothing since the tool was changed in may have started the spindle unseen
  bool reported_spindle_ = false;  // of this tool
  bool spindle_ran_ = false;       // at some time of the run
  bool reported_speed_ = false;
  bool reported_selected_ = false;
  bool feed_mode_stated_ = false;
  double reported_feed_ = 0.0;
};

}  // namespace dripfeed::interpreter
