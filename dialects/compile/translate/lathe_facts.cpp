// Positions and cycles are those of facts; G74 to G76 are run by the interpreter.
#include "dialects/compile/translate/lathe_facts.h"

#include <algorithm>
#include <cmath>

#include "dialects/interpreter/block/initial_state.h"
#include "dialects/interpreter/cycles/repetitive.h"
#include "dialects/ir/axis_letters.h"
#include "dialects/ir/cycle.h"

namespace dripfeed::compile {

namespace {

using facts::Kept;
using facts::Known;
using facts::Mode;
using facts::Number;
using ir::Address;
using ir::Function;
using ir::StatementKind;

constexpr double kCountedFeedsPerUnit = 100.0;  // F20 is 0.2 mm per turn

class NoSink final : public ir::MotionSink {
 public:
  void consume(std::span<const ir::Motion>) override {}
};

std::optional<double> number_of(const Known<double>& fact) {
  const double* value = fact.certain();
  return value == nullptr ? std::nullopt : std::optional(*value);
}
std::optional<double> number_of(const Known<facts::Written>& fact) {
  const facts::Written* word = fact.certain();
  return word == nullptr || !word->is_number ? std::nullopt : std::optional(word->number);
}
std::optional<bool> is_stated(const Known<facts::Written>& fact) {
  const facts::Written* word = fact.certain();
  return word == nullptr ? std::nullopt : std::optional(word->is_stated);
}

std::optional<Function> motion_of(const Known<facts::Setting>& fact) {
  const facts::Setting* motion = fact.certain();
  if (motion == nullptr) return std::nullopt;
  constexpr Function kMoves[] = {Function::rapid,   Function::linear, Function::arc_cw,
                                 Function::arc_ccw, Function::thread, Function::thread_changing};
  const bool moves = std::ranges::find(kMoves, motion->function) != std::end(kMoves);
  return moves ? std::optional(motion->function) : std::nullopt;
}
std::optional<std::int16_t> cycle_of(const Known<facts::Setting>& fact) {
  const facts::Setting* cycle = fact.certain();
  if (cycle == nullptr) return std::nullopt;
  return cycle->function == Function::turning_cycle ? static_cast<std::int16_t>(cycle->argument) : LatheState::kNone;
}

bool sets_all(const interpreter::PlainBlock& block, bool thread) {
  if (!thread) return block.has(Address::r);
  return block.has(Address::p) && block.has(Address::q) && block.has(Address::r);
}

}  // namespace

bool may_be_skipped(const ir::Program& program, const ir::Statement& s) {
  if (s.skip_level != 0 || s.kind != StatementKind::block) return s.skip_level != 0;
  // After "/M14" nothing moves.
  const ir::Block& block = program.blocks[s.payload];
  return std::ranges::any_of(program.words_of(block), [&](const ir::Word& w) { return ir::in_rest(block, w.span); }) ||
         std::ranges::any_of(program.codes_of(block),
                             [&](const ir::Code& c) { return c.letter != 'M' && ir::in_rest(block, c.span); });
}

std::optional<Address> turning_axis(Address address, const ir::Control& control) {
  if (address == Address::x || address == Address::z) return address;
  if (!control.semantics.incremental_letters_uvw) return std::nullopt;
  if (address == Address::u) return Address::x;
  if (address == Address::w) return Address::z;
  return std::nullopt;
}

LatheFacts::LatheFacts(const ir::Program& program, const ir::Control& control)
    : program_(program), control_(control), rules_(control), facts_(program, control) {}

std::optional<LatheState> LatheFacts::before(std::uint32_t statement) const {
  const facts::Facts* before = facts_.before(statement);
  if (before == nullptr) return std::nullopt;
  const facts::Facts& here = *before;
  LatheState state;
  state.x = number_of(here[Number::x]);
  state.z = number_of(here[Number::z]);
  state.c = number_of(here[Number::c]);
  state.motion = motion_of(here[Mode::motion]);
  state.cycle = cycle_of(here[Mode::cycle]);
  state.has_x = is_stated(here[Kept::turn_x]);
  state.has_z = is_stated(here[Kept::turn_z]);
  state.end_x = number_of(here[Kept::turn_x]);
  state.end_z = number_of(here[Kept::turn_z]);
  state.taper = number_of(here[Kept::turn_taper]);
  if (const facts::Written* feed = here[Kept::feed].certain())
    state.feed = scaled_feed(*feed, mode_before(Mode::feed, statement), mode_before(Mode::unit, statement));
  return state;
}

std::optional<Function> LatheFacts::mode(facts::Mode mode, std::uint32_t statement) const {
  const ir::Statement& s = program_.statements[statement];
  if (s.kind == StatementKind::block)
    for (const ir::Code& c : program_.codes_of(program_.blocks[s.payload]))
      if (facts::mode_of(c) == mode) return c.function;
  return mode_before(mode, statement);
}

std::optional<Function> LatheFacts::mode_before(facts::Mode mode, std::uint32_t statement) const {
  const facts::Facts* facts = facts_.before(statement);
  if (facts == nullptr) return std::nullopt;
  const facts::Known<facts::Setting>& fact = (*facts)[mode];
  return fact.agrees() ? std::optional(fact.value.function) : std::nullopt;
}

std::optional<double> LatheFacts::number(const ir::Word& word, std::uint32_t statement) const {
  if (word.value == ir::ExpressionId::none) return std::nullopt;
  const ir::Expression& e = program_.at(word.value);
  if (e.op != ir::Operator::constant) return std::nullopt;
  if (e.has_point || control_.semantics.decimal_mode != ir::DecimalMode::least_increment || e.value == 0.0)
    return e.value;
  const std::optional<Function> unit = mode(facts::Mode::unit, statement);
  if (!unit) return std::nullopt;
  const double per_mm = std::nearbyint(1.0 / control_.semantics.least_increment_mm);
  return e.value / (*unit == Function::unit_inch ? per_mm * 10.0 : per_mm);
}

std::optional<double> LatheFacts::feed_of(const ir::Word& word, std::uint32_t statement) const {
  if (word.value == ir::ExpressionId::none) return std::nullopt;
  const ir::Expression& e = program_.at(word.value);
  if (e.op != ir::Operator::constant) return std::nullopt;
  return scaled_feed({.number = e.value, .is_number = true, .has_point = e.has_point}, mode(Mode::feed, statement),
                     mode(Mode::unit, statement));
}

std::optional<double> LatheFacts::scaled_feed(const facts::Written& feed, std::optional<Function> mode,
                                              std::optional<Function> unit) const {
  if (!feed.is_number) return std::nullopt;
  const bool counts = !feed.has_point && control_.semantics.decimal_mode == ir::DecimalMode::least_increment;
  if (!counts || feed.number == 0.0) return feed.number;
  if (!mode || !unit) return std::nullopt;
  double value = feed.number;
  if (*mode == Function::feed_per_rev) value /= kCountedFeedsPerUnit;
  if (*unit == Function::unit_inch) value /= kCountedFeedsPerUnit;
  return value;
}

std::optional<bool> LatheFacts::is_increment(const ir::Word& word, std::uint32_t statement) const {
  if (word.mode != ir::WordMode::as_modal) return word.mode == ir::WordMode::incremental;
  if (control_.semantics.incremental_letters_uvw)
    return ir::incremented_axis(control_, ir::letter_of(word.address)).has_value();
  const std::optional<Function> distance = mode(facts::Mode::distance, statement);
  if (!distance) return std::nullopt;
  return *distance == Function::incremental;
}

// H of a lathe whose increments have letters.
bool LatheFacts::is_increment_of_c(const ir::Word& word) const {
  return word.address == Address::h && ir::incremented_axis(control_, 'H').has_value();
}

// --- G74 to G76

std::optional<interpreter::PlainBlock> LatheFacts::plain_block(std::uint32_t statement) const {
  interpreter::PlainBlock plain;
  for (const ir::Word& w : program_.words_of(program_.blocks[program_.statements[statement].payload])) {
    if (w.value == ir::ExpressionId::none || w.address == Address::n) continue;
    const ir::Expression& e = program_.at(w.value);
    if (e.op != ir::Operator::constant) return std::nullopt;
    plain.set(w.address, e.value);
    if (!e.has_point && (rules_.counting & interpreter::bit_of(w.address)) != 0)
      plain.in_increments |= interpreter::bit_of(w.address);
  }
  return plain;
}

std::optional<interpreter::ModalState> LatheFacts::modal_at(std::uint32_t statement) const {
  const std::optional<Function> unit = mode(Mode::unit, statement);
  const std::optional<Function> distance = mode(Mode::distance, statement);
  const bool by_letter = control_.semantics.incremental_letters_uvw;
  if (!unit || (!distance && !by_letter)) return std::nullopt;
  interpreter::ModalState modal = interpreter::initial_state(control_);
  modal.modes.inch = modal.modes.inch_feed = *unit == Function::unit_inch;
  modal.modes.absolute = by_letter || *distance == Function::absolute;
  return modal;
}

// A block that states only a part leaves the rest as the one before it did.
std::optional<interpreter::Repetitive> LatheFacts::data_before(std::uint32_t statement, Mode data) const {
  const std::optional<facts::Setting> stated = facts_.certain(data, statement);
  if (!stated) return std::nullopt;
  if (stated->function == Function::none) return interpreter::initial_state(control_).repetitive;
  const auto block = static_cast<std::uint32_t>(stated->argument);
  const std::optional<interpreter::PlainBlock> plain = plain_block(block);
  std::optional<interpreter::ModalState> modal = modal_at(block);
  if (!plain || !modal) return std::nullopt;
  const bool thread = data == Mode::thread_data;
  if (!sets_all(*plain, thread)) {
    const std::optional<interpreter::Repetitive> rest = data_before(block, data);
    if (!rest) return std::nullopt;
    modal->repetitive = *rest;
  }
  const auto codes = program_.codes_of(program_.blocks[program_.statements[block].payload]);
  const auto code = std::ranges::find(codes, Function::repetitive_cycle, &ir::Code::function);
  NoSink no_sink;
  const interpreter::RunOptions options;
  interpreter::RunBudget budget(options);
  interpreter::MotionBuffer buffer(no_sink, budget);
  interpreter::BlockResult result;
  interpreter::repetitive_block(*plain, rules_, code->argument, *modal, buffer, result);
  return modal->repetitive;
}

std::optional<LatheFacts::Repeated> LatheFacts::repeat(std::uint32_t statement, const LatheState& state) const {
  const ir::Block& block = program_.blocks[program_.statements[statement].payload];
  const auto codes = program_.codes_of(block);
  const auto code = std::ranges::find(codes, Function::repetitive_cycle, &ir::Code::function);
  std::optional<interpreter::ModalState> modal = modal_at(statement);
  const std::optional<interpreter::PlainBlock> plain = plain_block(statement);
  if (code == codes.end() || ir::follows_shape(*code) || !modal || !plain) return std::nullopt;
  Repeated out;
  out.inch = modal->modes.inch;
  const bool moves = std::ranges::any_of(
      program_.words_of(block), [&](const ir::Word& w) { return turning_axis(w.address, control_).has_value(); });
  if (!moves) return out;
  const auto data =
      data_before(statement, ir::is_cycle(*code, ir::RepetitiveCycle::thread) ? Mode::thread_data : Mode::peck_data);
  if (!data) return std::nullopt;
  modal->repetitive = *data;
  const double mm = out.inch ? 25.4 : 1.0;
  modal->feed_unknown = !state.feed;
  modal->feed = state.feed.value_or(0.0) * mm;
  if (state.x && state.z) {
    modal->unknown = 0;
    modal->position[0] = *state.x * mm;
    modal->position[2] = *state.z * mm;
  }
  NoSink no_sink;
  const interpreter::RunOptions options;  // one cycle, whose steps are limited
  interpreter::RunBudget budget(options);
  interpreter::MotionBuffer buffer(no_sink, budget);
  buffer.capture(&out.motions);
  interpreter::BlockResult result;
  interpreter::repetitive_block(*plain, rules_, code->argument, *modal, buffer, result);
  out.fails = result.fault != text::DiagnosticId::count_;
  if ((result.notes & interpreter::kNoteLevelUnknown) != 0) return std::nullopt;
  return out;
}

}  // namespace dripfeed::compile
