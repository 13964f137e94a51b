// Blocks of codes and words while running: the template's constants and the computed registers become a plain block,
// which is applied. What came of it (alarm, notes) goes to the report.
#pragma once

#include <span>
#include <vector>

#include "dialects/interpreter/arithmetic/arithmetic.h"
#include "dialects/interpreter/machine/block_watch.h"
#include "dialects/interpreter/machine/frame_access.h"
#include "dialects/interpreter/machine/run_report.h"
#include "dialects/interpreter/machine/storage.h"
#include "dialects/interpreter/machine/variable_access.h"
#include "dialects/interpreter/state/block_result.h"
#include "dialects/interpreter/state/block_rules.h"
#include "dialects/interpreter/state/modal_state.h"
#include "dialects/interpreter/state/motion_buffer.h"
#include "dialects/interpreter/state/plain_block.h"

namespace dripfeed::interpreter {

class BlockRunner {
 public:
  BlockRunner(const ir::Control& control, const BlockRules& rules, const Arithmetic& arithmetic, Storage& storage,
              VariableAccess& access, SharedData& shared, FrameAccess& frames, ModalState& state, MotionBuffer& out,
              RunReport& report)
      : control_(control),
        rules_(rules),
        arithmetic_(arithmetic),
        storage_(storage),
        access_(access),
        shared_(shared),
        frames_(frames),
        state_(state),
        out_(out),
        report_(report),
        watch_(control, state, report) {}

  // What the block asks of the flow; nothing when the run has ended.
  std::optional<Flow> run(const Instruction& i, const CompiledProgram& program);
  // The same for a block that was scanned; its reports are the caller's. `i` gives the report the place.
  std::optional<Flow> run_plain(const Instruction& i, const ir::PlainBatch& batch, const ir::PlainBlockRow& row);
  // The last block named an axis and moved (a cycle or dwell without positions did not).
  [[nodiscard]] bool moved() const { return moved_; }
  // How many motions and events it made; a cycle makes as many as it is asked for.
  [[nodiscard]] std::uint64_t made() const { return made_; }
  // A program that no one has was called.
  void forget_tool() { watch_.forget(); }
  // … called a cycle whose shape is to be run.
  [[nodiscard]] bool needs_shape() const { return needs_shape_; }

 private:
  std::optional<Flow> apply_block(const Instruction& i);
  Flow cut(const Instruction& i);  // a block that is_straight_cut
  void drop_foreign_axes(std::span<const ir::PlainWord> words);
  void set_data();
  void fill(const BlockTemplate& made, const CompiledProgram& program);
  // T="NAME": its number where the machine's profile has the name; otherwise a report.
  bool name_tool(const Instruction& i, const std::string& name);
  bool fill_computed(const Instruction& i, const BlockTemplate& made, const CompiledProgram& program);
  bool add_computed_code(const Instruction& i, const ComputedCode& code);
  void set_word(ir::Address address, double value, std::uint8_t flags);
  ir::Address find_axis(const ComputedWord& word);
  void skip_vacant(const Instruction& i, const CompiledProgram& program, std::uint32_t word);
  void take_notes(const Instruction& i, std::uint64_t notes);
  void report_radii(const Instruction& i, const BlockResult& result);
  [[nodiscard]] bool x_may_be_radius() const;
  bool fail(const Instruction& i, const BlockResult& result);

  const ir::Control& control_;
  const BlockRules& rules_;
  const Arithmetic& arithmetic_;
  Storage& storage_;
  VariableAccess& access_;
  SharedData& shared_;
  FrameAccess& frames_;
  ModalState& state_;
  MotionBuffer& out_;
  RunReport& report_;
  BlockWatch watch_;
  PlainBlock block_;
  std::vector<PlainCode> codes_;  // of a block with computed codes
  std::vector<std::pair<const CompiledProgram*, std::uint32_t>> reported_vacant_;
  bool reported_no_feed_ = false;
  bool forgets_ = false;  // a word or code of this block leaves it open where the axes are
  std::uint64_t made_ = 0;
  bool moved_ = false;
  bool needs_shape_ = false;
};

}  // namespace dripfeed::interpreter
