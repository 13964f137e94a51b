// The tool first: its length and edge are those of the one that is in after the block.
#include "dialects/facts/tool_effects.h"

#include <algorithm>

#include "dialects/facts/kept_words.h"
#include "dialects/ir/axis_letters.h"

namespace dripfeed::facts {

namespace {

using ir::Address;
using ir::Function;

constexpr double kFirstEdge = 1.0;

}  // namespace

void ToolEffects::run() {
  if (const ir::Word* tool = values.word(Address::t)) name_tool(*tool);
  if (comes_in()) bring_in();
  take_edge();
  take_length();
}

bool ToolEffects::comes_in() const {
  return values.has_code(Function::tool_change) || (tool_at_once && values.word(Address::t) != nullptr);
}

bool ToolEffects::turns_length_on() const {
  return values.has_code(Function::length_offset_plus) || values.has_code(Function::length_offset_minus);
}

void ToolEffects::name_tool(const ir::Word& word) {
  Written tool = written(word, values);
  if (tool.is_number && control.semantics.tool_word == ir::ToolWord::number_and_offset)
    tool.number = tool_of_pair(tool.number).tool;
  tool.has_point = false;
  facts[Kept::next_tool].set(tool, statement);
  const ir::Word* edge = values.word(Address::d);
  facts[Kept::next_edge].set(edge == nullptr ? Written() : written(*edge, values), statement);
}

void ToolEffects::bring_in() {
  facts[Kept::tool] = facts[Kept::next_tool];
  facts[Kept::edge] = facts[Kept::next_edge];
  facts.forget_positions(statement);
}

// D in the block of a T that only prepares acts on the tool that is in, too.
void ToolEffects::take_edge() {
  if (turns_length_on()) facts[Kept::edge].set({.is_stated = true}, statement);
  const ir::Word* edge = values.word(Address::d);
  if (edge == nullptr) return;
  const bool has_tool = facts[Kept::tool].is_always([](const Written& tool) { return tool.is_stated; });
  const bool prepares = values.word(Address::t) != nullptr && !comes_in();
  if (!prepares || has_tool) facts[Kept::edge].set(written(*edge, values), statement);
}

// By G43, G44 and G49 with H, by the offset of T0101, or by D where that is a cutting edge of the tool.
void ToolEffects::take_length() {
  for (const ir::Code& code : values.codes)
    if (mode_of(code) == Mode::length) facts[Mode::length].set({.function = code.function}, statement);
  const ir::Semantics& semantics = control.semantics;
  if (semantics.d_selects_edge) return take_length_of_edge();
  const ir::Word* tool = values.word(Address::t);
  if (semantics.tool_word == ir::ToolWord::number_and_offset && tool != nullptr) {
    const std::optional<double> pair = values.constant(*tool);
    set_length_number(pair ? std::optional(tool_of_pair(*pair).offset) : std::nullopt);
  }
  // On lathes of G-code system A H is an increment of C.
  const bool h_is_length = !ir::incremented_axis(control, 'H').has_value();
  const ir::Word* number = h_is_length ? values.word(Address::h) : nullptr;
  if (number == nullptr) return;
  const std::optional<double> value = values.constant(*number);
  value ? facts[Number::length_number].set(*value, statement) : facts[Number::length_number].forget(statement);
}

// Of a control whose T or D brings the length along.
void ToolEffects::set_length_number(std::optional<double> number) {
  number ? facts[Number::length_number].set(*number, statement) : facts[Number::length_number].forget(statement);
  facts[Mode::length].set({.function = Function::length_offset_plus}, statement);
}

// A tool that comes in brings its first edge along (MD20270).
void ToolEffects::take_length_of_edge() {
  if (comes_in()) {
    const Written* tool = facts[Kept::tool].certain();
    const bool is_named = tool != nullptr && !tool->is_number && tool->value != ir::ExpressionId::none &&
                          values.program.at(tool->value).op == ir::Operator::string;
    const bool is_known = is_named || (tool != nullptr && tool->is_number);
    const bool is_none = is_known && !is_named && tool->number == 0.0;
    set_length_number(is_known ? std::optional(is_none ? 0.0 : kFirstEdge) : std::nullopt);
  }
  const ir::Word* edge = values.word(Address::d);
  if (edge == nullptr) return;
  facts.forget_positions(statement);
  set_length_number(values.constant(*edge));
}

}  // namespace dripfeed::facts
