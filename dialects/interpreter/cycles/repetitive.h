// Multiple repetitive cycles of lathes as motions. G71 to G73 cut away what lies over a shape that stands in blocks of
// the program; the machine runs those blocks first and hands their motions over. G74 to G76 need no shape. (0i-F
// B-64604EN-1, multiple repetitive canned cycle.)
#pragma once

#include <string>
#include <vector>

#include "dialects/interpreter/state/block_result.h"
#include "dialects/interpreter/state/block_rules.h"
#include "dialects/interpreter/state/modal_state.h"
#include "dialects/interpreter/state/motion_buffer.h"
#include "dialects/interpreter/state/plain_block.h"

namespace dripfeed::interpreter {

using ir::RepetitiveCycle;

// Takes the words of a block with such a code; cuts where the cycle needs no shape. BlockResult::needs_shape says that
// the cycle in ModalState::repetitive is to follow.
void repetitive_block(const PlainBlock& block, const BlockRules& rules, std::int16_t cycle, ModalState& state,
                      MotionBuffer& out, BlockResult& result);

// What is wrong with a shape: count_ for nothing; `text` and `line` are arguments of the diagnostic.
struct ShapeFault {
  text::DiagnosticId id = text::DiagnosticId::count_;
  std::string text;
  std::uint32_t line = 0;
  bool is_doubtful = false;  // a parameter of the machine decides: the shape was cut
};

// Cuts the shape, given as the motions of its blocks from the start point on; the state is at the start point before
// and after.
ShapeFault cut_shape(const std::vector<ir::Motion>& shape, const BlockRules& rules, ModalState& state,
                     MotionBuffer& out, BlockResult& result);

}  // namespace dripfeed::interpreter
