// Block skip inside a block leaves out the rest of its words; here a slash stands in front of blocks only. A jump that
// the same switch leaves out chooses between the block with and without them:
//
//   Z3. /M14      / GOTOF N20
//                 Z3
//                 GOTOF N30
//                 N20 Z3 M14
//                 N30 …
#include <algorithm>
#include <iterator>
#include <span>
#include <vector>

#include "dialects/passes/labels.h"
#include "dialects/passes/rewrite.h"
#include "dialects/passes/structure_parts.h"
#include "dialects/sinumerik/writer/raise.h"

namespace dripfeed::sinumerik {

namespace {

using ir::StatementKind;

constexpr std::uint32_t kHighestBlockNumber = 99'999'999;

// Those that the switch never leaves out.
template <class Item>
std::vector<Item> first_of(std::span<const Item> all, const ir::Block& block) {
  std::vector<Item> first;
  std::ranges::copy_if(all, std::back_inserter(first), [&](const Item& one) { return !in_rest(block, one.span); });
  return first;
}

// Modes and tools are followed in the order of the text, and here are two paths.
bool changes_state(const ir::Program& program, const ir::Block& block) {
  const bool codes = std::ranges::any_of(program.codes_of(block),
                                         [&](const ir::Code& c) { return in_rest(block, c.span) && c.letter != 'M'; });
  return codes || std::ranges::any_of(program.words_of(block), [&](const ir::Word& w) {
           const bool tool = w.address == ir::Address::t || w.address == ir::Address::d || w.address == ir::Address::h;
           return tool && in_rest(block, w.span);
         });
}

void choose(const Raising& raising, passes::Rewrite& out, passes::FreeNumbers& numbers, const ir::Block block) {
  const ir::Program& program = raising.program;
  const auto codes = program.codes_of(block);
  const auto words = program.words_of(block);
  const std::vector<ir::Code> all_codes(codes.begin(), codes.end());
  const std::vector<ir::Word> all_words(words.begin(), words.end());
  const std::vector<ir::Code> first_codes = first_of(codes, block);
  const std::vector<ir::Word> first_words = first_of(words, block);
  const std::uint32_t whole = numbers.next();
  const std::uint32_t after = numbers.next();
  out.emit_jump(passes::jump_to(whole));
  out.last().skip_level = block.rest_level;
  if (!first_codes.empty() || !first_words.empty()) out.emit_block(first_codes, first_words);
  out.emit_jump(passes::jump_to(after));
  out.label_next(whole);
  out.emit_block(all_codes, all_words);
  out.label_next(after);
}

}  // namespace

void raise_skipped_words(const Raising& raising) {
  ir::Program& program = raising.program;
  const auto has_rest = [&](const ir::Statement& s) {
    return s.kind == StatementKind::block && program.blocks[s.payload].rest_level != 0 && s.skip_level == 0 &&
           !changes_state(program, program.blocks[s.payload]);
  };
  if (std::ranges::none_of(program.statements, has_rest)) return;
  passes::FreeNumbers numbers(program, kHighestBlockNumber);
  passes::Rewrite out(program);
  const auto count = static_cast<std::uint32_t>(program.statements.size());
  for (std::uint32_t i = 0; i < count; ++i) {
    out.at(i);
    const ir::Statement s = program.statements[i];
    if (has_rest(s))
      choose(raising, out, numbers, program.blocks[s.payload]);
    else
      out.keep();
  }
  out.finish();
}

}  // namespace dripfeed::sinumerik
