// Blocks that end a program or return from one.
#include <algorithm>

#include "dialects/macro_b/reader/lower.h"

namespace dripfeed::macro_b {

namespace {

using ir::ExpressionId;
using ir::Function;
using ir::Operator;
using ir::StatementKind;

}  // namespace

// The end of a program or subprogram is the last effect of its block, wherever its code stands. Its statement's
// payload, for the end of a program, is a block that holds the code alone.
void BlockLowering::emit_ending_block(std::uint32_t first_code, std::uint32_t first_word, const BlockPlace& place) {
  each_block_.reset();
  const auto is_end = [](const ir::Code& c) {
    return c.function == Function::program_end || c.function == Function::program_end_rewind ||
           c.function == Function::subprogram_end;
  };
  const auto begin = program_.codes.begin() + static_cast<std::ptrdiff_t>(first_code);
  const auto end_code = std::find_if(begin, program_.codes.end(), is_end);
  const ir::Code end = *end_code;
  program_.codes.erase(end_code);
  const bool is_return = end.function == Function::subprogram_end;
  const auto first = program_.words.begin() + static_cast<std::ptrdiff_t>(first_word);
  const auto target =
      std::find_if(first, program_.words.end(), [](const ir::Word& w) { return w.address == ir::Address::p; });
  const bool returns_to_block = is_return && target != program_.words.end();
  const ExpressionId block = returns_to_block ? target->value : ExpressionId::none;
  if (returns_to_block) program_.words.erase(target);
  // M99 L: how often the subprogram is still to be run, on Mazak.
  const auto from = program_.words.begin() + static_cast<std::ptrdiff_t>(first_word);
  const auto count =
      std::find_if(from, program_.words.end(), [](const ir::Word& w) { return w.address == ir::Address::l; });
  const bool counts = is_return && count != program_.words.end();
  if (counts) program_.words.erase(count);
  emit_block(first_code, first_word, place);
  if (counts) emit_native("L of M99", false, place);
  if (returns_to_block) return emit_return_jump(block, place);
  if (is_return) {
    BlockPlace own = place;
    own.span = end.span;
    emit(StatementKind::subprogram_return, ir::kNoIndex, own);
    return;
  }
  program_.codes.push_back(end);
  program_.blocks.push_back(
      {static_cast<std::uint32_t>(program_.codes.size() - 1), 1, static_cast<std::uint32_t>(program_.words.size()), 0});
  emit(StatementKind::program_end, static_cast<std::uint32_t>(program_.blocks.size() - 1), place);
}

// M99 P100: the block in the caller that is next.
void BlockLowering::emit_return_jump(ExpressionId target, const BlockPlace& place) {
  ir::Jump jump;
  const ir::Expression& e = program_.at(target);
  if (e.op == Operator::constant && e.value >= 1.0 && e.value <= grammar_.highest_block_number) {
    jump.number = static_cast<std::uint32_t>(e.value);
  } else {
    jump.computed = target;
  }
  program_.jumps.push_back(jump);
  emit(StatementKind::return_to, static_cast<std::uint32_t>(program_.jumps.size() - 1), place);
}

}  // namespace dripfeed::macro_b
