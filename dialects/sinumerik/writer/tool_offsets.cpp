// Every number is compared with the tool in the spindle; what cannot be compared is reported.
#include "dialects/sinumerik/writer/tool_offsets.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "dialects/facts/resolved.h"
#include "dialects/passes/refusal.h"

namespace dripfeed::sinumerik {

namespace {

using ir::Address;
using ir::Function;

constexpr double kToolPlaces = 100.0;  // T0606: two digits for the offset

const ir::Word* find(std::span<const ir::Word> words, Address address) {
  const auto found = std::ranges::find(words, address, &ir::Word::address);
  return found == words.end() ? nullptr : &*found;
}

// T6 and T9 alone: the tools stand side by side on the slide, and no turret is turned.
bool names_offsets_only(const ir::Program& program) {
  return std::ranges::all_of(program.words, [&](const ir::Word& w) {
    if (w.address != Address::t || w.value == ir::ExpressionId::none) return true;
    const ir::Expression& e = program.at(w.value);
    return e.op == ir::Operator::constant && e.value < kToolPlaces;
  });
}

}  // namespace

ToolOffsets::ToolOffsets(const Raising& raising)
    : raising_(raising), program_(raising.program), names_offsets_only_(names_offsets_only(raising.program)) {
  if (raising.is_own() || raising.from.semantics.tool_word != ir::ToolWord::number) return;
  const facts::Resolved known(program_, raising_.from, facts::ToolChange::as_the_text);
  for (std::uint32_t i = 0; i < program_.statements.size(); ++i) {
    const std::optional<facts::Facts> here = known.at(i);
    tools_.push_back(here ? facts::tool_in(program_, (*here)[facts::Kept::tool]) : facts::ToolIn());
  }
}

void ToolOffsets::begin_block(std::uint32_t statement, std::uint32_t first_word, std::span<const ir::Code> codes,
                              std::span<const ir::Word> words) {
  index_ = statement;
  first_word_ = first_word;
  codes_ = codes;
  words_ = words;
  if (has(Function::length_offset_plus)) length_ = Length::on;
  if (has(Function::length_offset_off)) length_ = Length::off;
  if (has(Function::comp_off)) compensates_ = false;
  if (starts_compensation()) compensates_ = true;
}

void ToolOffsets::end_block(text::Span span) {
  if (tools_.empty() || find(words_, Address::d) != nullptr || !starts_compensation() || !number_) return;
  if (*number_ == 0.0) return raising_.cannot(passes::of_tool("compensation without a radius (D0)"), span);
  (void)is_tool(*number_, "the compensation number of another tool, which is still in effect,", span);
}

// --- the length: H

// G43 H6 is edge 1 of tool 6: lengths belong to the tool here. Another number than the tool's is another tool's length.
void ToolOffsets::length_on(const ir::Code& code) {
  if (code.argument == kLengthAgain) return add_edge(code.span);
  const ir::Word* h = find(words_, Address::h);
  if (h == nullptr) return raising_.cannot(passes::not_known("G43 whose H was stated before"), code.span);
  const ir::Expression& number = program_.at(h->value);
  if (number.op != ir::Operator::constant)
    return raising_.cannot(passes::computed("a tool length with a computed number"), code.span);
  if (number.value == 0.0) {
    length_ = Length::off;
    return add(Address::d, 0.0, h->span);
  }
  if (is_tool(number.value, "the length offset of another tool", h->span)) add_edge(h->span);
}

void ToolOffsets::length_off(const ir::Code& code) { add(Address::d, 0.0, code.span); }

// After G43: another length, or none.
void ToolOffsets::length_number(const ir::Word& w) {
  const ir::Expression number = program_.at(w.value);
  if (length_ != Length::on || number.op != ir::Operator::constant)
    return raising_.cannot(passes::together("H without G43"), w.span);
  if (number.value != 0.0) {
    (void)is_tool(number.value, "the length offset of another tool", w.span);
    return;
  }
  length_ = Length::off;
  add(Address::d, 0.0, w.span);
}

// --- the radius: D

// The radius of the tool in the spindle needs no number here. D0 would take its length away, too, and another D bring
// it in.
void ToolOffsets::compensation_number(const ir::Word& w) {
  const ir::Expression number = program_.at(w.value);
  constexpr std::string_view kOther = "a compensation number that is not the tool's";
  if (number.op != ir::Operator::constant) return raising_.cannot(std::string(kOther), w.span);
  number_ = number.value;
  if (number.value == 0.0) {
    if (compensates_) raising_.cannot(passes::of_tool("compensation without a radius (D0)"), w.span);
    return;
  }
  if (!is_tool(number.value, kOther, w.span)) return;
  if (length_ == Length::off)
    return raising_.cannot(passes::of_tool("a radius where the length is off, which D would bring in again,"), w.span);
  add_edge(w.span);
}

// --- the tool: T

// T0606: tool 6 with its own offset is edge 1, T0600 is no offset; the offset of another tool has no counterpart.
void ToolOffsets::tool(const ir::Word& w) {
  const ir::Expression e = program_.at(w.value);
  const bool is_number = e.op == ir::Operator::constant;
  if (raising_.from.semantics.tool_word != ir::ToolWord::number_and_offset) {
    if (is_number) last_tool_ = e.value;
    return program_.words.push_back(w);
  }
  if (!is_number) return raising_.cannot(passes::computed("a computed tool word"), w.span);
  const double offset = std::fmod(std::trunc(e.value), kToolPlaces);
  const bool is_alone = names_offsets_only_ && offset != 0.0;
  const double tool = is_alone ? offset : std::trunc(e.value / kToolPlaces);
  if (is_alone) warn_taken_as_tool(w.span);
  if (tool != 0.0) last_tool_ = tool;  // otherwise T6 is another offset of the tool that is in
  if (tool != 0.0) add(Address::t, tool, w.span);
  length_ = offset == 0.0 ? Length::off : Length::on;
  if (offset == 0.0) return add(Address::d, 0.0, w.span);
  if (offset != last_tool_) return raising_.cannot(passes::of_tool("the offset of another tool"), w.span);
  add(Address::d, 1.0, w.span);
}

// Whether the number is that of the tool in the spindle; otherwise it is reported.
bool ToolOffsets::is_tool(double number, std::string_view otherwise, text::Span span) {
  if (tools_.empty()) {
    if (number != last_tool_) raising_.cannot(std::string(otherwise), span);
    return number == last_tool_;
  }
  const facts::ToolIn& in = tools_[index_];
  if (in.state == facts::ToolIn::State::differs) {
    raising_.cannot(
        passes::not_known("an offset of a tool that is not known here, or not the same on all control-flow paths,"),
        span);
    return false;
  }
  const bool same = in.number == number;
  if (!same) raising_.cannot(std::string(otherwise), span);
  if (same && in.changer != ir::kNoIndex) warn_of_caller(in.changer, span);
  return same;
}

void ToolOffsets::warn_taken_as_tool(text::Span span) {
  if (std::exchange(warned_of_tool_, true)) return;
  raising_.cannot(passes::of_tool("an offset without a tool, taken as that of the tool of its number,"), span);
  raising_.diagnostics.back().severity = text::Severity::warning;
}

void ToolOffsets::warn_of_caller(std::uint32_t caller, text::Span span) {
  const std::string line = std::to_string(program_.statements[caller].line);
  raising_.report(text::DiagnosticId::unknown_modal_state, span,
                  {"the tool in the spindle",
                   "it is taken as the one of T above, which what line " + line + " calls may have changed"});
  raising_.diagnostics.back().severity = text::Severity::warning;
}

// --- small parts

void ToolOffsets::add(Address address, double number, text::Span span) {
  ir::Word w = word(address, program_.add_constant(number, {}, false));
  w.span = span;
  program_.words.push_back(w);
}

// D1, which a block says once.
void ToolOffsets::add_edge(text::Span span) {
  const auto own = std::span(program_.words).subspan(first_word_);
  const bool is_stated = std::ranges::any_of(
      own, [&](const ir::Word& w) { return w.address == Address::d && program_.at(w.value).value == 1.0; });
  if (!is_stated) add(Address::d, 1.0, span);
}

bool ToolOffsets::has(Function function) const {
  return std::ranges::find(codes_, function, &ir::Code::function) != codes_.end();
}
bool ToolOffsets::starts_compensation() const { return has(Function::comp_left) || has(Function::comp_right); }

}  // namespace dripfeed::sinumerik
