// Forward dataflow over the edges of the program; where two ways meet, what they agree on is kept. Whatever is not
// plainly a move to a number makes the place unknown.
#include "dialects/compile/translate/lathe_flow.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "dialects/facts/axis_words.h"
#include "dialects/facts/calls.h"
#include "dialects/facts/flow_graph.h"
#include "dialects/facts/shape_blocks.h"
#include "dialects/facts/spread.h"
#include "dialects/interpreter/block/initial_state.h"
#include "dialects/interpreter/cycles/repetitive.h"
#include "dialects/ir/called_cycle.h"
#include "dialects/ir/sections.h"

namespace dripfeed::compile {

namespace {

using ir::Address;
using ir::Function;
using ir::ModalGroup;
using ir::StatementKind;

constexpr std::int16_t kThreadCycle = 6;        // G76
constexpr double kCountedFeedsPerUnit = 100.0;  // F20 is 0.2 mm per turn

bool is_move(Function f) {
  return f == Function::rapid || f == Function::linear || f == Function::arc_cw || f == Function::arc_ccw ||
         f == Function::thread || f == Function::thread_changing;
}

// A turning cycle leaves the modes as they were. HOLES1 may call a program of the shop's.
bool is_cycle(const ir::Program& program, const ir::Statement& s) {
  if (s.kind != StatementKind::call) return false;
  const ir::CalledCycle* cycle = program.calls[s.payload].cycle;
  return cycle != nullptr && cycle->sort != ir::CalledSort::holes_in_row &&
         cycle->sort != ir::CalledSort::holes_on_circle && cycle->sort != ir::CalledSort::holes_anywhere;
}
// … and these do not cut with the feed that is in effect.
bool brings_its_feed(const ir::Program& program, const ir::Statement& s) {
  const ir::Call& call = program.calls[s.payload];
  return ir::is_called(call, ir::CalledSort::removal) || ir::is_called(call, ir::CalledSort::thread);
}

// The place has other numbers behind these, or is only known to the machine.
bool loses_place(const ir::Code& c) {
  return c.group == ModalGroup::frame || c.group == ModalGroup::work_offset || c.group == ModalGroup::unit ||
         c.group == ModalGroup::diameter || c.group == ModalGroup::cycle || c.function == Function::not_modelled ||
         c.function == Function::machine_coordinates || c.function == Function::transformation ||
         c.function == Function::tool_change || c.function == Function::data_input ||
         (c.group == ModalGroup::non_modal && c.function != Function::dwell &&
          c.function != Function::exact_stop_once && c.function != Function::repetitive_cycle);
}

ThreadData data_of(const interpreter::Repetitive& r) {
  return {r.finishes, r.angle_deg, r.run_out_leads, r.least_cut_mm, r.allowance_mm, r.first_cut_mm};
}
void set_data(const ThreadData& data, interpreter::Repetitive& r) {
  r.finishes = data.finishes;
  r.angle_deg = data.angle_deg;
  r.run_out_leads = data.run_out_leads;
  r.least_cut_mm = data.least_cut_mm;
  r.allowance_mm = data.allowance_mm;
  r.first_cut_mm = data.first_cut_mm;
}

class NoSink final : public ir::MotionSink {
 public:
  void consume(std::span<const ir::Motion>) override {}
};

}  // namespace

bool may_be_skipped(const ir::Program& program, const ir::Statement& s) {
  if (s.skip_level != 0 || s.kind != StatementKind::block) return s.skip_level != 0;
  // Behind "/M14" nothing moves.
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

bool LatheState::meet(const LatheState& o) {
  const std::array less = {x.meet(o.x),
                           z.meet(o.z),
                           c.meet(o.c),
                           feed.meet(o.feed),
                           motion.meet(o.motion),
                           cycle.meet(o.cycle),
                           has_x.meet(o.has_x),
                           has_z.meet(o.has_z),
                           end_x.meet(o.end_x),
                           end_z.meet(o.end_z),
                           taper.meet(o.taper),
                           thread.meet(o.thread),
                           retract_mm.meet(o.retract_mm)};
  return std::ranges::find(less, true) != less.end();
}

LatheFlow::LatheFlow(const ir::Program& program, const ir::Control& control)
    : program_(program),
      control_(control),
      rules_(control),
      modes_(program, control),
      in_shape_(facts::blocks_of_shapes(program)),
      before_(program.statements.size() + 1) {
  facts::FlowGraph graph(program);
  const std::uint32_t first = program.sections.empty() ? 0 : program.sections.front().first;
  const facts::StatementRange main = facts::section_of(program, first);
  const bool is_main = !ir::is_subprogram(program, main.first, main.last);
  for (const std::uint32_t entry : graph.entries()) before_[entry] = entry <= first && is_main ? start() : LatheState();
  const auto after_or_skipped = [this](std::uint32_t i, const LatheState& state) {
    LatheState out = after(i, state);
    if (may_be_skipped(program_, program_.statements[i])) out.meet(state);
    return out;
  };
  facts::spread_states(program, graph, before_, after_or_skipped,
                       [](LatheState& state, const LatheState& with) { return state.meet(with); });
}

LatheState LatheFlow::start() const {
  LatheState state;
  state.motion.value = control_.semantics.power_on_motion;
  state.cycle.value = LatheState::kNone;
  state.feed.value = 0.0;
  const interpreter::ModalState woken = interpreter::initial_state(control_);
  state.thread.value = data_of(woken.repetitive);
  state.retract_mm.value = woken.repetitive.peck_retract_mm;
  return state;
}

const LatheState* LatheFlow::before(std::uint32_t statement) const {
  return before_[statement].has_value() ? &*before_[statement] : nullptr;
}

std::optional<Function> LatheFlow::mode(facts::Mode mode, std::uint32_t statement) const {
  const ir::Statement& s = program_.statements[statement];
  if (s.kind == StatementKind::block)
    for (const ir::Code& c : program_.codes_of(program_.blocks[s.payload]))
      if (facts::mode_of(c) == mode) return c.function;
  return mode_before(mode, statement);
}

std::optional<Function> LatheFlow::mode_before(facts::Mode mode, std::uint32_t statement) const {
  const facts::Facts* facts = modes_.before(statement);
  if (facts == nullptr) return std::nullopt;
  const facts::Known<facts::Setting>& fact = (*facts)[mode];
  return fact.agrees() ? std::optional(fact.value.function) : std::nullopt;
}

std::optional<double> LatheFlow::number(const ir::Word& word, std::uint32_t statement) const {
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

std::optional<double> LatheFlow::feed_of(const ir::Word& word, std::uint32_t statement) const {
  if (word.value == ir::ExpressionId::none) return std::nullopt;
  const ir::Expression& e = program_.at(word.value);
  if (e.op != ir::Operator::constant) return std::nullopt;
  if (e.has_point || control_.semantics.decimal_mode != ir::DecimalMode::least_increment) return e.value;
  const std::optional<Function> feed = mode(facts::Mode::feed, statement);
  const std::optional<Function> unit = mode(facts::Mode::unit, statement);
  if (!feed || !unit) return std::nullopt;
  double value = e.value;
  if (*feed == Function::feed_per_rev) value /= kCountedFeedsPerUnit;
  if (*unit == Function::unit_inch) value /= kCountedFeedsPerUnit;
  return value;
}

std::optional<bool> LatheFlow::is_increment(const ir::Word& word, std::uint32_t statement) const {
  if (word.mode != ir::WordMode::as_modal) return word.mode == ir::WordMode::incremental;
  if (control_.semantics.incremental_letters_uvw)
    return word.address == Address::u || word.address == Address::w || is_increment_of_c(word);
  const std::optional<Function> distance = mode(facts::Mode::distance, statement);
  if (!distance) return std::nullopt;
  return *distance == Function::incremental;
}

// H of a lathe whose increments have letters.
bool LatheFlow::is_increment_of_c(const ir::Word& word) const {
  return word.address == Address::h && control_.semantics.incremental_letters_uvw && control_.axes.contains('C');
}

LatheState LatheFlow::after(std::uint32_t statement, LatheState state) const {
  const ir::Statement& s = program_.statements[statement];
  if (in_shape_[statement]) return state;
  if (s.kind == StatementKind::block) {
    const ir::Block& block = program_.blocks[s.payload];
    take_codes(block, statement, state);
    return state;
  }
  if (facts::keeps_modes(s.kind)) return state;
  LatheState out;
  if (is_cycle(program_, s)) out = state;
  for (Known<double>* place : {&out.x, &out.z, &out.c}) place->value.reset();
  return out;
}

void LatheFlow::take_codes(const ir::Block& block, std::uint32_t statement, LatheState& state) const {
  const auto codes = program_.codes_of(block);
  const auto words = program_.words_of(block);
  const auto forget_place = [&state] {
    for (Known<double>* place : {&state.x, &state.z, &state.c}) place->value.reset();
  };
  for (const ir::Code& c : codes) {
    if (c.number != ir::ExpressionId::none && c.letter == 'G') {
      state = {};
      return;
    }
    if (loses_place(c)) forget_place();
    if (c.group == ModalGroup::unit)
      for (Known<double>* length : {&state.feed, &state.end_x, &state.end_z, &state.taper})
        if (!length->is(0.0)) length->value.reset();
    // G97 of SINUMERIK is of that group, too, and leaves a feed per turn one.
    if (c.group == ModalGroup::feed && mode_before(facts::Mode::feed, statement) != c.function)
      state.feed.value.reset();
    if (c.group != ModalGroup::motion) continue;
    const bool turns = c.function == Function::turning_cycle;
    state.cycle.value = turns ? c.argument : LatheState::kNone;
    if (turns) {
      state.has_x.value = state.has_z.value = false;
      state.end_x.value = state.end_z.value = state.taper.value = 0.0;
      continue;
    }
    is_move(c.function) ? void(state.motion.value = c.function) : state.motion.value.reset();
    if (!is_move(c.function)) forget_place();
  }
  const bool own_words = facts::has_own_words(program_, block);
  for (const ir::Word& w : words) {
    // Another offset: the place has another number.
    if (w.address == Address::t || (w.address == Address::d && !own_words)) forget_place();
    if (w.address != Address::f || own_words) continue;
    // With G34 and G35 of SINUMERIK it is no feed.
    const bool is_change = !control_.semantics.arc_radius_is_r && state.motion.is(Function::thread_changing);
    state.feed.value = is_change ? std::nullopt : feed_of(w, statement);
  }
  const auto repeats = std::ranges::find(codes, Function::repetitive_cycle, &ir::Code::function);
  if (repeats != codes.end()) {
    for (const ir::Word& w : words)
      if (w.address == Address::f) state.feed.value = feed_of(w, statement);
    // Back where they began.
    const std::optional<Repeated> done = repeat(statement, state);
    state.thread = done ? done->thread : Known<ThreadData>();
    state.retract_mm = done ? done->retract_mm : Known<double>();
    return;
  }
  if (own_words) return;
  if (!state.cycle.value) {
    if (std::ranges::any_of(words, [&](const ir::Word& w) { return turning_axis(w.address, control_).has_value(); }))
      forget_place();
    return;
  }
  *state.cycle.value == LatheState::kNone ? take_moves(block, statement, state)
                                          : take_cycle_words(block, statement, state);
}

void LatheFlow::take_moves(const ir::Block& block, std::uint32_t statement, LatheState& state) const {
  for (const ir::Word& w : program_.words_of(block)) {
    if (w.address == Address::direct_angle || w.address == Address::polar_radius || w.address == Address::polar_angle ||
        w.address == Address::named_axis) {
      for (Known<double>* place : {&state.x, &state.z, &state.c}) place->value.reset();
      return;
    }
    const bool turns = w.address == Address::c || is_increment_of_c(w);
    const std::optional<Address> axis = turning_axis(w.address, control_);
    if (!axis && !turns) continue;
    Known<double>& place = turns ? state.c : *axis == Address::x ? state.x : state.z;
    std::optional<double> value = number(w, statement);
    if (turns && value && *value != 0.0 && !program_.at(w.value).has_point) value.reset();  // another increment counts
    const std::optional<bool> increment = is_increment(w, statement);
    if (!value || !increment || (*increment && !place.value))
      place.value.reset();
    else
      place.value = *increment ? *place.value + *value : *value;
  }
}

std::optional<LatheFlow::Repeated> LatheFlow::repeat(std::uint32_t statement, const LatheState& state) const {
  const ir::Block& block = program_.blocks[program_.statements[statement].payload];
  const auto codes = program_.codes_of(block);
  const auto code = std::ranges::find(codes, Function::repetitive_cycle, &ir::Code::function);
  const std::optional<Function> unit = mode(facts::Mode::unit, statement);
  const std::optional<Function> distance = mode(facts::Mode::distance, statement);
  const bool by_letter = control_.semantics.incremental_letters_uvw;
  if (code == codes.end() || ir::follows_shape(*code) || !unit || (!distance && !by_letter)) return std::nullopt;
  interpreter::PlainBlock plain;
  for (const ir::Word& w : program_.words_of(block)) {
    if (w.value == ir::ExpressionId::none || w.address == Address::n) continue;
    const ir::Expression& e = program_.at(w.value);
    if (e.op != ir::Operator::constant) return std::nullopt;
    plain.set(w.address, e.value);
    if (!e.has_point && (rules_.counting & interpreter::bit_of(w.address)) != 0)
      plain.in_increments |= interpreter::bit_of(w.address);
  }
  // A first block sets all of it, or only a part.
  const bool thread = code->argument == kThreadCycle;
  const bool moves = std::ranges::any_of(
      program_.words_of(block), [&](const ir::Word& w) { return turning_axis(w.address, control_).has_value(); });
  const bool sets_all =
      thread ? plain.has(Address::p) && plain.has(Address::q) && plain.has(Address::r) : plain.has(Address::r);
  const bool known = thread ? state.thread.value.has_value() : state.retract_mm.value.has_value();
  if (!known && (moves || !sets_all)) return std::nullopt;
  interpreter::ModalState modal = interpreter::initial_state(control_);
  const bool inch = *unit == Function::unit_inch;
  const double mm = inch ? 25.4 : 1.0;
  modal.modes.inch = modal.modes.inch_feed = inch;
  modal.modes.absolute = by_letter || *distance == Function::absolute;
  if (state.thread.value) set_data(*state.thread.value, modal.repetitive);
  if (state.retract_mm.value) modal.repetitive.peck_retract_mm = *state.retract_mm.value;
  modal.feed_unknown = !state.feed.value;
  modal.feed = state.feed.value.value_or(0.0) * mm;
  if (state.x.value && state.z.value) {
    modal.unknown = 0;
    modal.position[0] = *state.x.value * mm;
    modal.position[2] = *state.z.value * mm;
  }
  NoSink nobody;
  const interpreter::RunOptions options;  // one cycle, whose steps are limited
  interpreter::RunBudget budget(options);
  interpreter::MotionBuffer buffer(nobody, budget);
  Repeated out;
  out.inch = inch;
  buffer.capture(&out.motions);
  interpreter::BlockResult result;
  interpreter::repetitive_block(plain, rules_, code->argument, modal, buffer, result);
  out.thread = state.thread;
  out.retract_mm = state.retract_mm;
  if (thread) out.thread.value = data_of(modal.repetitive);
  if (!thread) out.retract_mm.value = modal.repetitive.peck_retract_mm;
  out.fails = result.fault != text::DiagnosticId::count_;
  if ((result.notes & interpreter::kNoteLevelUnknown) != 0) return std::nullopt;
  return out;
}

// They end where they began.
void LatheFlow::take_cycle_words(const ir::Block& block, std::uint32_t statement, LatheState& state) const {
  const Address old_taper = state.cycle.is(2) ? Address::k : Address::i;
  for (const ir::Word& w : program_.words_of(block)) {
    if (w.address == Address::r || w.address == old_taper) state.taper.value = number(w, statement);
    const std::optional<Address> axis = turning_axis(w.address, control_);
    if (!axis) continue;
    const bool is_x = *axis == Address::x;
    const std::optional<double> value = number(w, statement);
    const std::optional<bool> increment = is_increment(w, statement);
    const Known<double>& place = is_x ? state.x : state.z;
    Known<double>& end = is_x ? state.end_x : state.end_z;
    (is_x ? state.has_x : state.has_z).value = true;
    if (!value || !increment || (*increment && !place.value))
      end.value.reset();
    else
      end.value = *increment ? *place.value + *value : *value;
  }
}

namespace {

// What a statement does to something that stays in effect.
enum class Use : std::uint8_t { none, sets, needs };

// Where the program goes on elsewhere, or nobody knows how: what is in effect may be needed there.
bool leaves(const ir::Program& program, const ir::Statement& s) {
  constexpr std::array kElsewhere = {StatementKind::subprogram_return, StatementKind::return_to,
                                     StatementKind::modal_call,        StatementKind::modal_call_end,
                                     StatementKind::repeat_section,    StatementKind::execute_text};
  if (s.kind == StatementKind::native) return !program.natives[s.payload].effects_known;
  return std::ranges::find(kElsewhere, s.kind) != kElsewhere.end();
}

// On some way behind the statement. `use_of`: of a block or a call.
template <class UseOf>
bool is_needed_behind(const ir::Program& program, std::uint32_t statement, UseOf use_of) {
  facts::FlowGraph graph(program);
  std::set<std::uint32_t> seen;  // a few as a rule
  std::vector<std::uint32_t> open = graph.after(statement);
  while (!open.empty()) {
    const std::uint32_t i = open.back();
    open.pop_back();
    if (i >= program.statements.size() || !seen.insert(i).second) continue;
    const ir::Statement& s = program.statements[i];
    if (leaves(program, s)) return true;
    const bool uses = s.kind == StatementKind::block || s.kind == StatementKind::call;
    const Use use = uses ? use_of(s) : Use::none;
    if (use == Use::needs) return true;
    if (use == Use::sets && s.skip_level == 0) continue;
    const std::vector<std::uint32_t> next = graph.after(i);
    open.insert(open.end(), next.begin(), next.end());
  }
  return false;
}

}  // namespace

bool LatheFlow::needs_feed(std::uint32_t statement) const {
  return is_needed_behind(program_, statement, [&](const ir::Statement& s) {
    if (s.kind == StatementKind::call) return brings_its_feed(program_, s) ? Use::none : Use::needs;
    const ir::Block& block = program_.blocks[s.payload];
    const auto words = program_.words_of(block);
    if (std::ranges::find(words, Address::f, &ir::Word::address) != words.end()) return Use::sets;
    const bool cuts = std::ranges::any_of(program_.codes_of(block), [](const ir::Code& c) {
      return c.group == ir::ModalGroup::motion && c.function != Function::rapid && c.function != Function::thread &&
             c.function != Function::thread_changing;
    });
    return cuts ? Use::needs : Use::none;
  });
}

bool LatheFlow::needs_motion(std::uint32_t statement) const {
  return is_needed_behind(program_, statement, [&](const ir::Statement& s) {
    if (s.kind == StatementKind::call) return is_cycle(program_, s) ? Use::none : Use::needs;
    const ir::Block& block = program_.blocks[s.payload];
    const auto codes = program_.codes_of(block);
    if (std::ranges::find(codes, ir::ModalGroup::motion, &ir::Code::group) != codes.end()) return Use::sets;
    return program_.words_of(block).empty() ? Use::none : Use::needs;
  });
}

}  // namespace dripfeed::compile
