// Blocks of codes and words while running: the template's constants and the computed registers become a plain block,
// which is applied. What came of it (alarm, notes) goes to the report.
#pragma once

#include <span>
#include <vector>

#include "dialects/interpreter/apply.h"
#include "dialects/interpreter/arithmetic.h"
#include "dialects/interpreter/run_report.h"
#include "dialects/interpreter/storage.h"

namespace dripfeed::interpreter {

class BlockRunner {
 public:
  BlockRunner(const ir::Control& control, const BlockRules& rules, const Arithmetic& arithmetic, Storage& storage,
              SharedData& shared, ModalState& state, MotionBuffer& out, RunReport& report)
      : control_(control),
        rules_(rules),
        arithmetic_(arithmetic),
        storage_(storage),
        shared_(shared),
        state_(state),
        out_(out),
        report_(report) {}

  // What the block asks of the flow; nothing when the run has ended.
  std::optional<Flow> run(const Instruction& i, const CompiledProgram& program);
  // The same for a block that was scanned; its reports are the caller's. `i` tells the report the place.
  std::optional<Flow> run_plain(const Instruction& i, const ir::PlainBatch& batch, const ir::PlainBlockRow& row);

 private:
  std::optional<Flow> apply_block(const Instruction& i);
  void drop_foreign_axes(std::span<const ir::PlainWord> words);
  void fill(const BlockTemplate& made, const CompiledProgram& program);
  bool fill_computed(const Instruction& i, const BlockTemplate& made, const CompiledProgram& program);
  bool add_computed_code(const Instruction& i, const ComputedCode& code);
  void set_word(ir::Address address, double value, std::uint8_t flags);
  ir::Address find_axis(const ComputedWord& word);
  void skip_vacant(const Instruction& i, const CompiledProgram& program, std::uint32_t word);
  void take_notes(const Instruction& i, std::uint32_t notes);
  bool fail(const Instruction& i, const BlockResult& result);

  const ir::Control& control_;
  const BlockRules& rules_;
  const Arithmetic& arithmetic_;
  Storage& storage_;
  SharedData& shared_;
  ModalState& state_;
  MotionBuffer& out_;
  RunReport& report_;
  PlainBlock block_;
  std::vector<PlainCode> codes_;  // of a block with computed codes
  std::vector<std::pair<const CompiledProgram*, std::uint32_t>> said_vacant_;
  bool said_no_feed_ = false;
};

}  // namespace dripfeed::interpreter
