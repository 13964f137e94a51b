// T, D and M6 of a control whose D is an edge of the tool, as T0606, or as G43 H and the D of compensation. ISO mode
// says them as these controls do. A tool's length is in effect before its block moves.
#include <algorithm>
#include <string>

#include <fmt/format.h>

#include "dialects/facts/calls.h"
#include "dialects/facts/tool_in.h"
#include "dialects/macro_b/writer/raise_block.h"
#include "dialects/passes/refusal.h"

namespace dripfeed::macro_b {

namespace {

using facts::Kept;
using ir::Address;
using ir::ExpressionId;
using ir::Function;
using ir::Operator;
using ir::StatementKind;

constexpr double kToolPlaces = 100.0;  // T0606: two digits for the offset

// D, or a length, is stated for the tool that is in.
bool has_edge(const facts::Facts& facts) {
  return facts[Kept::edge].is_always([](const facts::Written& edge) { return edge.is_stated; });
}

bool changes_tool(const ir::Code& c) { return c.function == Function::tool_change; }

}  // namespace

void BlockRaiser::tool_words(const Traits& traits) {
  if (!tools_) {
    const bool as_it_is = same_ || from_.semantics.tool_word == to_.semantics.tool_word;
    if (!as_it_is) return cannot(*statement_, passes::of_tool("a tool word with an offset number"));
    return draft_.words.push_back(*traits.tool);
  }
  if (traits.tool != nullptr && program_.at(traits.tool->value).op == Operator::string) {
    const std::string_view name = program_.strings.at(program_.at(traits.tool->value).string);
    return cannot(*statement_,
                  passes::of_tool(fmt::format("T=\"{}\", a name that no tool in the machine's profile has,", name)));
  }
  const bool on_lathe = to_.semantics.tool_word == ir::ToolWord::number_and_offset;
  if (!on_lathe && traits.tool != nullptr) draft_.words.push_back(*traits.tool);
  if (traits.tool != nullptr && !traits.tool_change && !tools_->tool_comes_by_t()) return prepare(traits);
  const ExpressionId edge = edge_of(traits);
  if (!on_lathe) return length_offset(traits, edge);
  if (const std::optional<ExpressionId> tool = tool_of(traits)) lathe_tool(*tool, edge);
}

// T that only prepares. D in its block comes with M6, and acts on the tool that is in the spindle until then.
void BlockRaiser::prepare(const Traits& traits) {
  const facts::Facts* before = tools_->before(index_);
  if (traits.edge == nullptr || before == nullptr) return;
  if (facts::tool_in(program_, (*before)[Kept::tool]).state == facts::ToolIn::State::none) return;
  const ExpressionId edge = traits.edge->value;
  if (has_edge(*before) && is_constant(edge, 1.0)) return;
  const std::optional<ExpressionId> tool = tool_in(*before);
  if (!tool) return;
  if (to_.semantics.tool_word == ir::ToolWord::number_and_offset) return lathe_tool(*tool, edge);
  if (is_constant(edge, 0.0)) return change_first(traits, {{code_of(Function::length_offset_off)}, {}});
  if (!is_constant(edge, 1.0))
    return cannot(*statement_, passes::of_tool("an edge that is not the first of a known tool"));
  change_first(traits, length_of(*tool));
}

// After the block's own T, M6 and D.
facts::Facts BlockRaiser::facts_here() const { return tools_->at(index_).value_or(facts::Facts()); }

// The block's own D, or the one that stood in the block of the T which M6 brings in.
ExpressionId BlockRaiser::edge_of(const Traits& traits) const {
  if (traits.edge != nullptr) return traits.edge->value;
  if (!traits.tool_change || traits.tool != nullptr) return ExpressionId::none;
  const facts::Known<facts::Written> edge = facts_here()[Kept::next_edge];
  return edge.agrees() ? edge.value.value : ExpressionId::none;
}

std::optional<ExpressionId> BlockRaiser::tool_of(const Traits& traits) {
  return traits.tool != nullptr ? std::optional(traits.tool->value) : tool_in(facts_here());
}

std::optional<ExpressionId> BlockRaiser::tool_in(const facts::Facts& facts) {
  using State = facts::ToolIn::State;
  const facts::ToolIn in = facts::tool_in(program_, facts[Kept::tool]);
  if (in.state == State::none) return ExpressionId::none;
  // A program that is called between T and D may have been what changes it.
  const facts::ToolIn next = facts::tool_in(program_, facts[Kept::next_tool]);
  const bool between = in.changer != ir::kNoIndex && next.state != State::none &&
                       !(facts[Kept::next_tool].value == facts[Kept::tool].value);
  const bool is_name = in.state == State::tool && program_.at(in.value).op == Operator::string;
  if (in.state == State::differs || between || is_name) {
    cannot(*statement_, passes::not_known("a tool that is not known here, or not the same on all control-flow paths,"));
    return std::nullopt;
  }
  if (in.changer != ir::kNoIndex)
    warn("the tool in the spindle", fmt::format("it is taken as the one of T above, which what line {} calls may have "
                                                "changed",
                                                program_.statements[in.changer].line));
  return in.value;
}

void BlockRaiser::warn(std::string what, std::string why) {
  diagnostics_.push_back(text::make_diagnostic(text::DiagnosticId::unknown_modal_state, statement_->span,
                                               {std::move(what), std::move(why)}));
  diagnostics_.back().severity = text::Severity::warning;
}

// Where D names an edge, compensation takes its radius from there; here it needs the number of an offset.
void BlockRaiser::compensation_number() {
  if (to_.semantics.tool_word != ir::ToolWord::number) return;
  const std::optional<ExpressionId> tool = tool_in(facts_here());
  if (tool && *tool != ExpressionId::none) return draft_.words.push_back(word_of(Address::d, *tool));
  if (tool) warn("the number of the compensation (D)", "the tool is a caller's, which must have stated it");
}

// T0606: each tool has the offset of its own number; edge 0 takes the offset away.
void BlockRaiser::lathe_tool(ExpressionId tool, ExpressionId edge) {
  if (tool == ExpressionId::none) return cannot(*statement_, passes::of_tool("an edge before a tool"));
  const bool off = is_constant(edge, 0.0);
  if (edge != ExpressionId::none && !off && !is_constant(edge, 1.0))
    return cannot(*statement_, passes::of_tool("a second edge of a tool"));
  draft_.words.push_back(word_of(Address::t, scaled(tool, off ? kToolPlaces : kToolPlaces + 1.0)));
}

// D1 turns the tool's length on: G43 H with the tool's number.
void BlockRaiser::length_offset(const Traits& traits, ExpressionId edge) {
  const bool changes = traits.tool_change || (traits.tool != nullptr && tools_->tool_comes_by_t());
  Draft length;
  if (edge == ExpressionId::none) {
    if (!changes || !lacks_edge()) return change_first(traits, {});
    const std::optional<ExpressionId> tool = tool_of(traits);
    if (!tool) return change_first(traits, {});
    if (is_constant(*tool, 0.0)) return change_first(traits, {{code_of(Function::length_offset_off)}, {}});
    if (*tool == ExpressionId::none) {
      warn("the tool length", "neither the tool nor a cutting edge of it is stated here");
      return change_first(traits, {});
    }
    if (tools_->tool_comes_by_t() && calls_next())
      return cannot(*statement_, passes::of_tool("a tool that a called program brings in, without D after the call,"));
    warn("the cutting edge after a tool change without D", "MD20270 decides, and it is taken as D1");
    length = length_of(*tool);
  } else if (is_constant(edge, 0.0)) {
    length = {{code_of(Function::length_offset_off)}, {}};
  } else {
    const std::optional<ExpressionId> tool = tool_of(traits);
    if (!tool) return;
    if (*tool == ExpressionId::none || !is_constant(edge, 1.0))
      return cannot(*statement_, passes::of_tool("an edge that is not the first of a known tool"));
    length = length_of(*tool);
  }
  change_first(traits, std::move(length));
}

// Programs that are called compensate with the tool of their caller: its number stays in effect for them.
BlockRaiser::Draft BlockRaiser::length_of(ExpressionId tool) const {
  Draft length{{code_of(Function::length_offset_plus)}, {word_of(Address::h, tool)}};
  if (calls_others_) length.words.push_back(word_of(Address::d, tool));
  return length;
}

// The tool change, then its length, then what the block does; all in one order where nothing moves.
void BlockRaiser::change_first(const Traits& traits, Draft length) {
  const bool moves = std::ranges::any_of(draft_.words, ir::is_axis, &ir::Word::address);
  if (!moves) {
    if (!length.empty()) after_.push_back(std::move(length));
    return;
  }
  std::vector<Draft> first;
  if (traits.tool_change) {
    Draft change;
    for (const ir::Code& c : draft_.codes)
      if (changes_tool(c)) change.codes.push_back(c);
    for (const ir::Word& w : draft_.words)
      if (w.address == Address::t) change.words.push_back(w);
    std::erase_if(draft_.codes, changes_tool);
    std::erase_if(draft_.words, [](const ir::Word& w) { return w.address == Address::t; });
    first.push_back(std::move(change));
  }
  if (!length.empty()) first.push_back(std::move(length));
  before_.insert(before_.begin(), first.begin(), first.end());
}

// Whether the tool that the block brings in may move along its axis before D is stated: on the path straight on; where
// that leads elsewhere, it may. Looked at from the end of the text, once for all changes.
bool BlockRaiser::lacks_edge() {
  const std::size_t count = program_.statements.size();
  if (lacks_edge_.empty()) {
    lacks_edge_.resize(count + 1, true);
    stands_on_xy_ = plane_is_always_xy();
    for (std::size_t i = count; i-- > 0;)
      lacks_edge_[i] = moves_without_edge(program_.statements[i]).value_or(lacks_edge_[i + 1]);
  }
  return lacks_edge_[index_ + 1] && !has_edge(facts_here());
}

bool BlockRaiser::plane_is_always_xy() const {
  return from_.semantics.power_on_plane == Function::plane_xy &&
         std::ranges::none_of(program_.codes, [](const ir::Code& c) {
           return c.function == Function::plane_zx || c.function == Function::plane_yz;
         });
}

// Before anything moves.
bool BlockRaiser::calls_next() const {
  for (std::uint32_t i = index_ + 1; i < program_.statements.size(); ++i) {
    const ir::Statement& s = program_.statements[i];
    if (s.kind == StatementKind::call) return !facts::is_standard_cycle(program_, s);
    if (s.kind != StatementKind::empty && moves_without_edge(s)) return false;
  }
  return false;
}

// Nothing for a statement that says neither.
std::optional<bool> BlockRaiser::moves_without_edge(const ir::Statement& s) const {
  if (s.kind == StatementKind::program_end) return false;
  if (s.kind == StatementKind::empty || s.kind == StatementKind::assign || s.kind == StatementKind::message ||
      s.kind == StatementKind::define)
    return std::nullopt;
  // A called program may be what brings the tool in.
  if (s.kind == StatementKind::call && tools_->tool_comes_by_t()) return std::nullopt;
  if (s.kind != StatementKind::block || s.skip_level != 0) return true;
  const ir::Block& block = program_.blocks[s.payload];
  const auto codes = program_.codes_of(block);
  const auto words = program_.words_of(block);
  if (std::ranges::find(words, Address::d, &ir::Word::address) != words.end()) return false;
  if (std::ranges::find(codes, ir::ModalGroup::length_offset, &ir::Code::group) != codes.end()) return false;
  const bool stays = std::ranges::any_of(codes, [](const ir::Code& c) {
    return c.group == ir::ModalGroup::frame || c.function == Function::dwell ||
           c.function == Function::machine_coordinates || c.function == Function::reference_return;
  });
  const bool moves = !stays && std::ranges::any_of(words, [this](const ir::Word& w) {
    const bool across = stands_on_xy_ && (w.address == Address::x || w.address == Address::y);
    return ir::is_axis(w.address) && !across;
  });
  return moves ? std::optional(true) : std::nullopt;
}

}  // namespace dripfeed::macro_b
