// Looked at statement by statement; nothing is kept.
#include "dialects/macro_b/writer/drill_region.h"

#include <algorithm>

#include "dialects/facts/calls.h"
#include "dialects/facts/flow_graph.h"

namespace dripfeed::macro_b {

namespace {

using ir::Address;
using ir::Function;
using ir::ModalGroup;
using ir::StatementKind;

bool ends_region(const ir::Statement& s) {
  return s.kind == StatementKind::modal_call || s.kind == StatementKind::modal_call_end;
}

std::uint32_t end_of_region(const ir::Program& program, std::uint32_t call) {
  const auto begin = program.statements.begin() + call + 1;
  return static_cast<std::uint32_t>(std::find_if(begin, program.statements.end(), ends_region) -
                                    program.statements.begin());
}

constexpr ModalGroup kOtherPlaces[] = {ModalGroup::plane, ModalGroup::frame, ModalGroup::work_offset, ModalGroup::unit,
                                       ModalGroup::length_offset};
constexpr Function kOtherMoves[] = {Function::tool_change, Function::machine_coordinates, Function::reference_return};
// Of the hole, or of a tool.
constexpr Address kOwnWords[] = {Address::z, Address::r, Address::q, Address::l, Address::d, Address::t};

bool holds(const auto& list, auto what) { return std::ranges::find(list, what) != std::end(list); }

bool positions(const ir::Program& program, const ir::Block& block, bool taps) {
  const auto other_code = [taps](const ir::Code& c) {
    if (c.group == ModalGroup::motion && c.function != Function::rapid) return true;
    if (taps && (c.group == ModalGroup::feed || c.group == ModalGroup::spindle)) return true;
    return holds(kOtherPlaces, c.group) || holds(kOtherMoves, c.function);
  };
  const auto other_word = [taps](const ir::Word& w) {
    return holds(kOwnWords, w.address) || (taps && (w.address == Address::f || w.address == Address::s));
  };
  return std::ranges::none_of(program.codes_of(block), other_code) &&
         std::ranges::none_of(program.words_of(block), other_word);
}

}  // namespace

bool region_positions(const ir::Program& program, std::uint32_t call, bool taps) {
  const std::uint32_t end = end_of_region(program, call);
  for (std::uint32_t i = call + 1; i < end; ++i) {
    const ir::Statement& s = program.statements[i];
    if (s.kind == StatementKind::block && !positions(program, program.blocks[s.payload], taps)) return false;
  }
  return true;
}

bool calls_in_region(const ir::Program& program, std::uint32_t call) {
  const std::uint32_t end = end_of_region(program, call);
  for (std::uint32_t i = call + 1; i < end; ++i) {
    const ir::Statement& s = program.statements[i];
    if (s.kind == StatementKind::call && !facts::is_standard_cycle(program, s)) return true;
  }
  return false;
}

bool jumps_across_region(const ir::Program& program, std::uint32_t call, std::span<const std::uint32_t> jumps) {
  const std::uint32_t end = end_of_region(program, call);
  const auto is_inside = [&](std::uint32_t i) { return i > call && i <= end; };
  return std::ranges::any_of(jumps, [&](std::uint32_t jump) {
    const std::uint32_t target = facts::target_of(program, jump);
    return target == ir::kNoIndex ? is_inside(jump) : is_inside(jump) != is_inside(target);
  });
}

}  // namespace dripfeed::macro_b
