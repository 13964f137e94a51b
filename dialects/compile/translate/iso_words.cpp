// A part has no jumps and no variables: what is in effect within it follows from the order of the text.
#include "dialects/compile/translate/iso_words.h"

#include <algorithm>
#include <utility>

#include "dialects/ir/cycle.h"
#include "dialects/passes/refusal.h"

namespace dripfeed::compile {

namespace {

using ir::Address;
using ir::ExpressionId;
using ir::Function;
using ir::ModalGroup;

constexpr double kMsPerSecond = 1000.0;

struct IncrementRow {
  Address letter;
  Address axis;
};
constexpr IncrementRow kIncrements[] = {
    {Address::u, Address::x}, {Address::v, Address::y}, {Address::w, Address::z}, {Address::h, Address::c}};

// Codes whose R is no radius.
constexpr Function kWithOwnR[] = {Function::rotate,           Function::scale,        Function::data_input,
                                  Function::repetitive_cycle, Function::hole_pattern, Function::nurbs};

bool sets_motion(const ir::Code& c) { return c.group == ModalGroup::motion || c.group == ModalGroup::cycle; }
bool has_own_r(const ir::Code& c) { return std::ranges::find(kWithOwnR, c.function) != std::end(kWithOwnR); }
// G71 U1: a depth; G10 U0.1: an offset that is changed by it.
bool has_own_letters(const ir::Code& c) { return c.function == Function::data_input || ir::follows_shape(c); }
bool dwells(const ir::Code& c) { return c.function == Function::dwell; }

}  // namespace

void IsoWords::cannot(passes::Refusal what, text::Span span) {
  diagnostics_.push_back(passes::diagnose(std::move(what), span, to_.title));
}

void IsoWords::begin_program() { state_ = {}; }

void IsoWords::follow(std::span<const ir::Code> codes) {
  for (const ir::Code& c : codes) {
    if (c.function == Function::polar_words_on) state_.polar = true;
    if (c.function == Function::polar_words_off) state_.polar = false;
    if (!sets_motion(c)) continue;
    state_.drills = c.function == Function::drill;
    state_.turns = c.function == Function::turning_cycle;
    if (c.group != ModalGroup::motion) continue;
    state_.bends = c.function == Function::arc_cw || c.function == Function::arc_ccw;
    state_.unsure = false;
  }
}

std::string_view IsoWords::in_effect() const {
  if (state_.drills || state_.turns) return "a cycle of ISO mode that is in effect";
  return state_.polar ? "G16 of ISO mode, which is in effect," : "";
}

std::vector<ir::Word> IsoWords::translate(std::span<const ir::Code> codes, std::span<const ir::Word> words,
                                          bool skipped) {
  const State before = state_;
  follow(codes);
  std::vector<ir::Word> out;
  if (std::ranges::any_of(codes, dwells)) {
    translate_dwell(words, out);
  } else {
    const bool radius = state_.bends && !state_.drills && !state_.turns && std::ranges::none_of(codes, has_own_r);
    const bool letters = iso_.semantics.incremental_letters_uvw && std::ranges::none_of(codes, has_own_letters);
    for (ir::Word w : words) {
      if (w.address == Address::r && radius) w.address = Address::arc_radius;
      if (w.address == Address::r && state_.unsure)
        cannot(passes::at_switch("R after a motion code that a switch may leave out"), w.span);
      if (w.address == Address::q && state_.drills) w.value = with_point(w.value);
      if (letters) translate_increment(w);
      out.push_back(w);
    }
  }
  // What is left out is still in effect.
  if (skipped) {
    state_.drills |= before.drills;
    state_.turns |= before.turns;
    state_.polar |= before.polar;
    state_.unsure = before.unsure || state_.bends != before.bends;
  }
  return out;
}

ir::Argument IsoWords::translate(ir::Argument argument) {
  constexpr std::string_view kLengths = "ABCIJKQRUVWXYZ";
  if (argument.value != ExpressionId::none && kLengths.contains(argument.letter))
    argument.value = with_point(argument.value);
  return argument;
}

// What is a length here counts increments on another control; least increments of this one are settled elsewhere.
ExpressionId IsoWords::with_point(ExpressionId value) {
  if (!lacks_point(value) || iso_.semantics.decimal_mode != ir::DecimalMode::calculator) return value;
  return program_.add_constant(*number(value), program_.at(value).span);
}

void IsoWords::translate_increment(ir::Word& word) const {
  const auto* const row = std::ranges::find(kIncrements, word.address, &IncrementRow::letter);
  if (row == std::end(kIncrements)) return;
  word.address = row->axis;
  word.mode = ir::WordMode::incremental;
}

// P milliseconds, X and U seconds: G4 F in Siemens mode.
void IsoWords::translate_dwell(std::span<const ir::Word> words, std::vector<ir::Word>& out) {
  bool timed = false;
  for (const ir::Word& w : words) {
    const bool by_axis = w.address == Address::x || w.address == Address::u;
    const std::optional<double> value = number(w.value);
    if (!value || (w.address != Address::p && !by_axis)) {
      out.push_back(w);
      continue;
    }
    if (std::exchange(timed, true)) return cannot(passes::together("a dwell with two times"), w.span);
    const bool counts = iso_.semantics.decimal_mode == ir::DecimalMode::least_increment && lacks_point(w.value);
    const bool per_thousand = w.address == Address::p || counts;
    out.push_back(ir::word(Address::f, program_.add_constant(per_thousand ? *value / kMsPerSecond : *value, w.span)));
    out.back().span = w.span;
  }
}

// A number as it is written, with its sign.
std::optional<double> IsoWords::number(ExpressionId value) const {
  if (value == ExpressionId::none) return std::nullopt;
  const ir::Expression& e = program_.at(value);
  if (e.op == ir::Operator::constant) return e.value;
  if (e.op != ir::Operator::negate || program_.at(e.a).op != ir::Operator::constant) return std::nullopt;
  return -program_.at(e.a).value;
}
bool IsoWords::lacks_point(ExpressionId value) const {
  if (!number(value)) return false;
  const ir::Expression& e = program_.at(value);
  const ir::Expression& written = e.op == ir::Operator::negate ? program_.at(e.a) : e;
  return !written.has_point && written.value != 0.0;
}

}  // namespace dripfeed::compile
