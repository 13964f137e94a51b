// A main program begins without a length, a subprogram with its caller's.
#include "dialects/passes/length_flow.h"

#include <algorithm>
#include <cmath>

#include "dialects/passes/main_return.h"
#include "dialects/passes/mode_flow.h"
#include "dialects/passes/state_flow.h"

namespace dripfeed::passes {

namespace {

using ir::Address;
using ir::Function;
using ir::StatementKind;

constexpr double kToolPlaces = 100.0;  // T0101: two digits for the offset

// Whether that is less than before.
bool meet(ToolLength& length, ToolLength with) {
  if (length == with || length == ToolLength::unknown) return false;
  length = ToolLength::unknown;
  return true;
}

}  // namespace

LengthFlow::LengthFlow(const ir::Program& program, const ir::Control& control)
    : program_(program), control_(control), before_(program.statements.size() + 1) {
  FlowGraph graph(program);
  for (const std::uint32_t entry : graph.entries_for_good())
    before_[entry] = is_subprogram(program, section_of(program, entry)) ? ToolLength::unknown : ToolLength::off;
  spread_states(
      program, graph, before_, [this](std::uint32_t i, ToolLength length) { return after(i, length); },
      [](ToolLength& length, ToolLength with) { return meet(length, with); });
}

ToolLength LengthFlow::at(std::uint32_t statement) const {
  if (!before_[statement].has_value()) return ToolLength::unknown;
  return after(statement, *before_[statement]);
}

ToolLength LengthFlow::after(std::uint32_t statement, ToolLength length) const {
  const ir::Statement& s = program_.statements[statement];
  if (is_call(s.kind)) return is_standard_cycle(program_, s) ? length : ToolLength::unknown;
  if (s.kind == StatementKind::native && !program_.natives[s.payload].effects_known) return ToolLength::unknown;
  return s.kind == StatementKind::block ? after_block(program_.blocks[s.payload], length) : length;
}

ToolLength LengthFlow::after_block(const ir::Block& block, ToolLength length) const {
  const ir::Semantics& semantics = control_.semantics;
  // Nothing where the word is computed.
  const auto number = [&](Address address) -> std::optional<ir::Expression> {
    const auto words = program_.words_of(block);
    const auto word = std::ranges::find(words, address, &ir::Word::address);
    return word == words.end() || word->value == ir::ExpressionId::none ? std::nullopt
                                                                        : std::optional(program_.at(word->value));
  };
  const auto by = [](const ir::Expression& e, double offset) {
    if (e.op != ir::Operator::constant) return ToolLength::unknown;
    return offset == 0.0 ? ToolLength::off : ToolLength::on;
  };
  const auto tool = number(Address::t);
  for (const ir::Code& c : program_.codes_of(block)) {
    const bool begins = c.function == Function::length_offset_plus || c.function == Function::length_offset_minus;
    if (begins) length = ToolLength::on;
    if (c.function == Function::length_offset_off) length = ToolLength::off;
    // A tool that comes in brings its first edge along (MD20270).
    if (semantics.d_selects_edge && c.function == Function::tool_change) length = ToolLength::on;
  }
  if (semantics.d_selects_edge) {
    if (tool) length = ToolLength::on;
    if (const auto edge = number(Address::d)) length = by(*edge, edge->value);
  } else if (semantics.tool_word == ir::ToolWord::number_and_offset) {
    if (tool) length = by(*tool, std::fmod(std::trunc(tool->value), kToolPlaces));
  } else if (const auto h = number(Address::h); h && length != ToolLength::off) {
    length = by(*h, h->value);
  }
  return length;
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

}  // namespace dripfeed::passes
