// Words of the cycle, positions, and the rest, which stands in a block of its own.
#include "dialects/sinumerik/writer/drill_block.h"

#include <cmath>

#include "dialects/passes/refusal.h"

namespace dripfeed::sinumerik {

namespace {

using ir::Address;
using ir::DrillCycle;
using ir::Function;
using ir::Operator;

bool is_cycle_word(Address a) {
  return a == Address::r || a == Address::q || a == Address::p || a == Address::k || a == Address::l;
}

double repeats_of(const Raising& raising, const ir::Word& w) {
  const ir::Expression& e = raising.program.at(w.value);
  if (e.op == Operator::constant && e.value >= 0.0) return std::floor(e.value);
  raising.cannot(passes::computed("a cycle with a computed number of repeats"), w.span);
  return 1.0;
}

}  // namespace

DrillBlock drill_block(const Raising& raising, const ir::Block& block, Address axis, DrillCycle cycle) {
  const ir::Program& program = raising.program;
  DrillBlock parts;
  const bool shifts = cycle == DrillCycle::fine_bore || cycle == DrillCycle::back_bore;
  for (const ir::Code& c : program.codes_of(block)) {
    parts.begins |= c.function == Function::drill;
    const bool of_cycle = c.function == Function::drill || c.function == Function::return_to_initial ||
                          c.function == Function::return_to_r || c.group == ir::ModalGroup::motion;
    if (!of_cycle) parts.rest_codes.push_back(c);
  }
  for (const ir::Word& w : program.words_of(block)) {
    const bool repeats = w.address == Address::k || w.address == Address::l;
    const bool shift = shifts && (w.address == Address::i || w.address == Address::j);
    if (w.address == axis || is_cycle_word(w.address) || shift) {
      parts.redefines |= !repeats;
      parts.drills |= w.address == axis || w.address == Address::r;
      if (repeats) parts.repeats = repeats_of(raising, w);
    } else if (ir::is_axis(w.address)) {
      parts.positions.push_back(w);
      parts.drills = true;
    } else {
      parts.rest_words.push_back(w);
    }
  }
  if (parts.repeats == 0.0) parts.drills = false;
  return parts;
}

}  // namespace dripfeed::sinumerik
