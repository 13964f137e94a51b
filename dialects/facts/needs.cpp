// In the order of the text: what leads elsewhere may need anything.
#include "dialects/facts/needs.h"

#include <algorithm>

#include "dialects/facts/calls.h"

namespace dripfeed::facts {

namespace {

using ir::Address;
using ir::Function;
using ir::StatementKind;

bool says_motion(const ir::Code& c) { return c.group == ir::ModalGroup::motion; }

// Nothing that moves, and nothing that leads elsewhere.
bool goes_on(const ir::Program& program, const ir::Statement& s) {
  return s.kind == StatementKind::empty || s.kind == StatementKind::assign || s.kind == StatementKind::message ||
         s.kind == StatementKind::modal_call_end || (s.kind == StatementKind::call && is_standard_cycle(program, s));
}

}  // namespace

bool needs_motion(const ir::Program& program, std::uint32_t statement) {
  for (std::uint32_t i = statement + 1; i < program.statements.size(); ++i) {
    const ir::Statement& s = program.statements[i];
    if (s.kind == StatementKind::program_end) return false;
    if (goes_on(program, s)) continue;
    if (s.kind != StatementKind::block || s.skip_level != 0) return true;
    const ir::Block& block = program.blocks[s.payload];
    if (std::ranges::any_of(program.codes_of(block), says_motion)) return false;
    if (std::ranges::any_of(program.words_of(block), ir::is_axis, &ir::Word::address)) return true;
  }
  return false;
}

bool moves_length_to_machine(const ir::Program& program, const ir::Block& block, const ir::Control& control) {
  const auto to_machine = [](const ir::Code& c) { return c.function == Function::machine_coordinates; };
  const auto other_plane = [](const ir::Code& c) {
    return c.function == Function::plane_zx || c.function == Function::plane_yz;
  };
  if (std::ranges::none_of(program.codes_of(block), to_machine)) return false;
  const bool only_z = control.kind == ir::MachineKind::mill && std::ranges::none_of(program.codes, other_plane);
  return std::ranges::any_of(program.words_of(block), [&](const ir::Word& w) {
    return only_z ? w.address == Address::z : ir::is_linear_axis(w.address);
  });
}

}  // namespace dripfeed::facts
