// Forward dataflow over the edges of the program; where two ways meet, what they agree on is kept.
#include "dialects/sinumerik/writer/drill_state.h"

#include <algorithm>
#include <array>

#include "dialects/facts/axis_words.h"
#include "dialects/facts/calls.h"
#include "dialects/facts/flow_graph.h"
#include "dialects/facts/spread.h"

namespace dripfeed::sinumerik {

namespace {

using ir::Address;
using ir::Function;
using ir::ModalGroup;
using ir::StatementKind;

// Names that are set once, before paths part, and that nothing else can set.
std::set<ir::SymbolId> settled_names(const ir::Program& program) {
  std::set<ir::SymbolId> once;
  std::set<ir::SymbolId> others;
  bool straight = true;
  for (const ir::Statement& s : program.statements) {
    const bool plain = s.kind == StatementKind::block || s.kind == StatementKind::assign ||
                       s.kind == StatementKind::message || s.kind == StatementKind::empty ||
                       s.kind == StatementKind::program_end || s.kind == StatementKind::alarm;
    if (!plain && !ir::is_structure(s.kind) && s.kind != StatementKind::go_to) return {};
    straight = straight && plain && !s.is_label && s.skip_level == 0;
    if (s.kind != StatementKind::assign) continue;
    const ir::Variable& target = program.at(program.assigns[s.payload].target);
    if (target.bank != ir::Bank::named) continue;
    if (!straight || !once.insert(target.symbol).second) others.insert(target.symbol);
  }
  std::erase_if(once, [&](ir::SymbolId one) { return others.contains(one); });
  return once;
}

// And with it the level where a cycle may begin.
void forget_height(DrillState& state) {
  state.height.forget();
  if (!state.cycle.known) state.initial.forget();
}

bool is_motion(Function f) {
  return f == Function::rapid || f == Function::linear || f == Function::arc_cw || f == Function::arc_ccw ||
         f == Function::thread || f == Function::thread_changing;
}

}  // namespace

ir::Address drilling_axis(Function plane) {
  if (plane == Function::plane_zx) return Address::y;
  return plane == Function::plane_yz ? Address::x : Address::z;
}

void DrillState::Level::forget() {
  number.forget();
  name.forget();
}
bool DrillState::Level::meet(const Level& other) {
  const std::array less = {number.meet(other.number), name.meet(other.name)};
  return less[0] || less[1];
}

// Every field must meet its other, whatever the ones before came to.
bool DrillState::meet(const DrillState& o) {
  const std::array less = {
      cycle.meet(o.cycle),
      depth.meet(o.depth),
      level.meet(o.level),
      peck.meet(o.peck),
      dwell.meet(o.dwell),
      shift_i.meet(o.shift_i),
      shift_j.meet(o.shift_j),
      depth_by_distance.meet(o.depth_by_distance),
      level_by_distance.meet(o.level_by_distance),
      feed.meet(o.feed),
      speed.meet(o.speed),
      to_level.meet(o.to_level),
      incremental.meet(o.incremental),
      inch.meet(o.inch),
      at_initial.meet(o.at_initial),
      height.meet(o.height),
      initial.meet(o.initial),
      motion.meet(o.motion),
      plane.meet(o.plane),
      spindle.meet(o.spindle),
      feed_mode.meet(o.feed_mode),
  };
  return std::ranges::find(less, true) != less.end();
}

void DrillState::forget() {
  cycle.forget();
  for (auto* words : {&depth, &level, &peck, &dwell, &shift_i, &shift_j, &feed, &speed}) words->forget();
  for (auto* flags : {&depth_by_distance, &level_by_distance, &to_level, &incremental, &inch, &at_initial})
    flags->forget();
  for (Level* levels : {&height, &initial}) levels->forget();
  for (auto* functions : {&motion, &plane, &spindle, &feed_mode}) functions->forget();
}

DrillFlow::DrillFlow(const ir::Program& program, const ir::Control& from)
    : program_(program), from_(from), settled_(settled_names(program)), before_(program.statements.size() + 1) {
  facts::FlowGraph graph(program);
  DrillState start;
  start.motion.set(from.semantics.power_on_motion);
  start.plane.set(from.semantics.power_on_plane);
  start.incremental.set(from.semantics.power_on_distance == Function::incremental);
  start.inch.set(from.semantics.power_on_unit == Function::unit_inch);
  start.feed_mode.set(from.semantics.power_on_feed);
  start.spindle.set(Function::spindle_stop);
  for (const std::uint32_t entry : graph.entries()) {
    before_[entry] = start;
    if (entry != 0) before_[entry]->forget();
  }
  facts::spread_states(
      program, graph, before_,
      [this](std::uint32_t i, const DrillState& state) { return step(state, program_.statements[i]); },
      [](DrillState& state, const DrillState& with) { return state.meet(with); });
}

const DrillState* DrillFlow::before(std::uint32_t statement) const {
  return before_[statement].has_value() ? &*before_[statement] : nullptr;
}

DrillState DrillFlow::step(const DrillState& state, const ir::Statement& statement) const {
  if (statement.kind == StatementKind::block) return after(state, program_.blocks[statement.payload]);
  if (facts::keeps_modes(statement.kind)) return state;
  DrillState out = state;
  out.forget();
  if (statement.kind != StatementKind::call) return out;
  // passes::settle_modes() has looked through the call for these, and has said them where the text would mislead.
  out.plane = state.plane;
  out.incremental = state.incremental;
  out.inch = state.inch;
  return out;
}

DrillState DrillFlow::after(const DrillState& state, const ir::Block& block) const {
  DrillState out = state;
  const auto codes = program_.codes_of(block);
  for (const ir::Code& code : codes) take_code(code, out);
  const bool own_words = facts::has_own_words(program_, block);
  const bool dwell = std::ranges::find(codes, Function::dwell, &ir::Code::function) != codes.end();
  if (own_words && !dwell) forget_height(out);
  if (!own_words) take_words(program_.words_of(block), !out.cycle.is(DrillState::kNone), out);
  if (out.cycle.is(DrillState::kNone)) out.initial = out.height;
  return out;
}

void DrillFlow::take_code(const ir::Code& code, DrillState& out) const {
  const Function f = code.function;
  if (code.number != ir::ExpressionId::none && code.letter == 'G') return out.forget();
  if (f == Function::drill) {
    const bool enters = out.cycle.is(DrillState::kNone);
    if (enters || !out.cycle.known) {
      for (auto* words : {&out.depth, &out.level, &out.peck, &out.dwell, &out.shift_i, &out.shift_j})
        words->set(ir::ExpressionId::none);
      out.at_initial.set(enters);
      if (!enters) out.at_initial.forget();
    }
    out.cycle.set(code.argument);
  }
  if (f == Function::cycle_off || (code.group == ModalGroup::motion && is_motion(f))) {
    // The tool is left at the level where the last hole ended.
    if (!out.cycle.is(DrillState::kNone))
      out.at_initial.is(true) ? void(out.height = out.initial) : out.height.forget();
    out.cycle.set(DrillState::kNone);
  }
  if (code.group == ModalGroup::motion) is_motion(f) ? out.motion.set(f) : out.motion.forget();
  if (code.group == ModalGroup::plane) out.plane.set(f);
  if (f == Function::absolute || f == Function::incremental) out.incremental.set(f == Function::incremental);
  if (f == Function::unit_inch || f == Function::unit_mm) out.inch.set(f == Function::unit_inch);
  if (f == Function::return_to_initial || f == Function::return_to_r) out.to_level.set(f == Function::return_to_r);
  if (f == Function::spindle_cw || f == Function::spindle_ccw || f == Function::spindle_stop) out.spindle.set(f);
  if (code.group == ModalGroup::feed) out.feed_mode.set(f);
  // Other zeros, lengths and units: the same height has another number.
  const bool moves_zero = code.group == ModalGroup::work_offset || code.group == ModalGroup::length_offset ||
                          code.group == ModalGroup::unit || code.group == ModalGroup::frame ||
                          code.group == ModalGroup::plane;
  if (moves_zero) forget_height(out);
}

DrillState::Level DrillFlow::level_of(const ir::Word& word, const DrillState& state) const {
  DrillState::Level out;
  if (!state.incremental.is(false) || word.mode != ir::WordMode::as_modal) return out;
  const ir::Expression& e = program_.at(word.value);
  const bool constant =
      e.op == ir::Operator::constant && (e.has_point || from_.semantics.decimal_mode == ir::DecimalMode::calculator);
  if (constant) out.number.set(e.value);
  if (e.op != ir::Operator::variable) return out;
  const ir::Variable& v = program_.at(e.variable);
  const bool settled = v.bank == ir::Bank::named && v.index == ir::ExpressionId::none && settled_.contains(v.symbol);
  if (settled) out.name.set(v.symbol);
  return out;
}

void DrillFlow::take_words(std::span<const ir::Word> words, bool drills, DrillState& out) const {
  const Address axis = drilling_axis(out.plane.known ? out.plane.value : Function::plane_xy);
  bool makes_hole = false;
  // I and J say the shift of a boring cycle together, Q says it without them.
  const auto says = [&](Address a) { return std::ranges::find(words, a, &ir::Word::address) != words.end(); };
  if (drills && (says(Address::i) || says(Address::j) || says(Address::q)))
    for (auto* shift : {&out.shift_i, &out.shift_j}) shift->set(ir::ExpressionId::none);
  for (const ir::Word& w : words) {
    makes_hole |=
        w.address == Address::x || w.address == Address::y || w.address == Address::z || w.address == Address::r;
    if (w.address == Address::f) out.feed.set(w.value);
    if (w.address == Address::s) out.speed.set(w.value);
    if (!drills) {
      if (w.address == axis) out.height = level_of(w, out);
      continue;
    }
    // Where it is not known whether a cycle is in effect, this may be a move to another level.
    if (!out.cycle.known && ir::is_axis(w.address)) out.initial.forget();
    if (w.address == axis) {
      out.depth.set(w.value);
      out.depth_by_distance = out.incremental;
    }
    if (w.address == Address::r) {
      out.level.set(w.value);
      out.level_by_distance = out.incremental;
      if (from_.semantics.drill_r_from_initial) out.level_by_distance.set(true);
    }
    if (w.address == Address::q) out.peck.set(w.value);
    if (w.address == Address::p) out.dwell.set(w.value);
    if (w.address == Address::i) out.shift_i.set(w.value);
    if (w.address == Address::j) out.shift_j.set(w.value);
  }
  // After a hole the tool is at the R level, or back where the cycle began.
  if (!drills || !makes_hole) return;
  if (out.to_level.is(false) && out.at_initial.is(true)) return;
  if (out.to_level.is(true))
    out.at_initial.set(false);
  else if (out.to_level.is(false))
    out.at_initial.set(true);
  else
    out.at_initial.forget();
}

}  // namespace dripfeed::sinumerik
