// Order within a block, as the controls do it: codes, then T S F and D, then what starts (offset, tool, spindle,
// coolant, compensation), then the one motion, dwell or shift, then what ends (coolant, spindle, stop).
#include "dialects/interpreter/apply.h"

#include <array>
#include <cmath>

#include "dialects/interpreter/move.h"
#include "dialects/interpreter/polar.h"

namespace dripfeed::interpreter {

namespace {

using ir::Address;
using ir::Function;
using ir::ModalGroup;
using ir::MotionKind;

// What the codes of this block ask for beyond the modes.
struct Effects {
  Function one_shot = Function::none;  // takes the block's axis words: dwell, local_shift(_add), set_coordinates,
                                       // reference_return, not_modelled
  std::int16_t argument = 0;           // of the one shot
  bool machine_coordinates = false;
  bool exact_stop = false;
  bool tool_change = false;
  bool coolant_off = false;
  bool spindle_stop = false;
  bool surface_code = false;            // this block switches the surface speed
  bool announces = false;               // something that events tell of may have changed
  std::int8_t stop = -1;                // 0 program, 1 optional
  Function move_once = Function::none;  // instead of the modal motion
  Flow flow = Flow::next;
};

struct CodeContext {
  const BlockRules& rules;
  ModalState& state;
  Effects& effects;
  PlainCode code;
};

void surface_speed(CodeContext& c, bool on) {
  c.state.modes.surface_speed = on;
  c.effects.surface_code = c.effects.announces = true;
}
void feed(CodeContext& c, ir::FeedMode mode) {
  c.state.modes.feed_mode = mode;
  // … but the feed code that a reader puts beside G96 belongs to it.
  if (c.rules.semantics.feed_code_ends_surface_speed && c.state.modes.surface_speed && !c.effects.surface_code) {
    c.state.modes.surface_speed = false;
    c.effects.announces = true;
  }
}
void unit(CodeContext& c, bool inch) {
  c.state.modes.inch = inch;
  if (c.code.argument == 0) c.state.modes.inch_feed = inch;
}
void comp(CodeContext& c, ir::CompSide side) {
  c.state.modes.comp = side;
  c.effects.announces = true;
}
void spindle(CodeContext& c, ir::SpindleState state) {
  c.state.spindle = state;
  c.effects.announces = true;
}
void coolant(CodeContext& c, ir::CoolantState state) {
  c.state.coolant = state;
  c.effects.announces = true;
}
void one_shot(CodeContext& c) {
  c.effects.one_shot = c.code.function;
  c.effects.argument = c.code.argument;
}
void not_modelled(CodeContext& c) {
  if (c.code.group == ModalGroup::motion || c.code.group == ModalGroup::cycle) c.state.modes.motion_modelled = false;
  if (c.code.group == ModalGroup::non_modal || c.code.group == ModalGroup::frame) one_shot(c);
}
void work_offset(CodeContext& c) {
  if (c.state.modes.work_offset == c.code.argument) return;
  c.state.modes.work_offset = c.code.argument;
  c.state.unknown = kAllAxes;  // offsets lie in the control: how far they are apart is not known
  c.effects.announces = true;
}

struct CodeRow {
  Function function;
  void (*apply)(CodeContext&);
};
// Functions without a row change nothing here: tool lengths are the control's, return levels belong to cycles.
constexpr CodeRow kCodeRows[] = {
    {Function::dwell, one_shot},
    {Function::exact_stop_once, [](CodeContext& c) { c.effects.exact_stop = true; }},
    {Function::exact_stop_mode, [](CodeContext& c) { c.state.modes.exact_stop = true; }},
    {Function::continuous_path, [](CodeContext& c) { c.state.modes.exact_stop = false; }},
    {Function::plane_xy, [](CodeContext& c) { c.state.modes.plane = ir::Plane::xy; }},
    {Function::plane_zx, [](CodeContext& c) { c.state.modes.plane = ir::Plane::zx; }},
    {Function::plane_yz, [](CodeContext& c) { c.state.modes.plane = ir::Plane::yz; }},
    {Function::unit_inch, [](CodeContext& c) { unit(c, true); }},
    {Function::unit_mm, [](CodeContext& c) { unit(c, false); }},
    {Function::absolute, [](CodeContext& c) { c.state.modes.absolute = true; }},
    {Function::incremental, [](CodeContext& c) { c.state.modes.absolute = false; }},
    {Function::feed_per_min, [](CodeContext& c) { feed(c, ir::FeedMode::per_min); }},
    {Function::feed_per_rev, [](CodeContext& c) { feed(c, ir::FeedMode::per_rev); }},
    {Function::feed_inverse_time, [](CodeContext& c) { feed(c, ir::FeedMode::inverse_time); }},
    {Function::diameter_on, [](CodeContext& c) { c.state.modes.diameter = ir::DiameterMode::diameter; }},
    {Function::diameter_off, [](CodeContext& c) { c.state.modes.diameter = ir::DiameterMode::radius; }},
    {Function::diameter_absolute_only,
     [](CodeContext& c) { c.state.modes.diameter = ir::DiameterMode::diameter_absolute_only; }},
    {Function::work_offset, work_offset},
    {Function::machine_coordinates, [](CodeContext& c) { c.effects.machine_coordinates = true; }},
    {Function::local_shift, one_shot},
    {Function::local_shift_add, one_shot},
    {Function::set_coordinates, one_shot},
    {Function::rotate, one_shot},
    {Function::scale, one_shot},
    {Function::mirror, one_shot},
    {Function::pole_from_last, one_shot},
    {Function::pole_from_zero, one_shot},
    {Function::pole_from_pole, one_shot},
    {Function::reference_return, one_shot},
    {Function::comp_off, [](CodeContext& c) { comp(c, ir::CompSide::off); }},
    {Function::comp_left, [](CodeContext& c) { comp(c, ir::CompSide::left); }},
    {Function::comp_right, [](CodeContext& c) { comp(c, ir::CompSide::right); }},
    {Function::tool_change, [](CodeContext& c) { c.effects.tool_change = true; }},
    {Function::surface_speed_on, [](CodeContext& c) { surface_speed(c, true); }},
    {Function::surface_speed_off, [](CodeContext& c) { surface_speed(c, false); }},
    {Function::spindle_cw, [](CodeContext& c) { spindle(c, ir::SpindleState::clockwise); }},
    {Function::spindle_ccw, [](CodeContext& c) { spindle(c, ir::SpindleState::counterclockwise); }},
    {Function::spindle_stop, [](CodeContext& c) { c.effects.spindle_stop = true; }},
    {Function::spindle_orient, [](CodeContext& c) { c.effects.spindle_stop = true; }},
    {Function::coolant_mist, [](CodeContext& c) { coolant(c, ir::CoolantState::mist); }},
    {Function::coolant_flood, [](CodeContext& c) { coolant(c, ir::CoolantState::flood); }},
    {Function::coolant_off, [](CodeContext& c) { c.effects.coolant_off = true; }},
    {Function::program_stop, [](CodeContext& c) { c.effects.stop = 0; }},
    {Function::optional_stop, [](CodeContext& c) { c.effects.stop = 1; }},
    {Function::program_end, [](CodeContext& c) { c.effects.flow = Flow::program_end; }},
    {Function::program_end_rewind, [](CodeContext& c) { c.effects.flow = Flow::program_end; }},
    {Function::subprogram_end, [](CodeContext& c) { c.effects.flow = Flow::subprogram_end; }},
    {Function::cycle_off, [](CodeContext& c) { c.state.modes.motion_modelled = true; }},
    {Function::not_modelled, not_modelled},
};
constexpr auto kCodeRules = [] {
  std::array<void (*)(CodeContext&), static_cast<std::size_t>(Function::count_)> rules{};
  for (const CodeRow& row : kCodeRows) rules[static_cast<std::size_t>(row.function)] = row.apply;
  return rules;
}();

constexpr bool is_motion(Function function) { return function >= Function::rapid && function <= Function::tap_retract; }

void apply_codes(const PlainBlock& block, const BlockRules& rules, ModalState& state, Effects& effects) {
  for (const PlainCode& code : block.codes) {
    if (is_motion(code.function) && code.group == ModalGroup::non_modal) {
      effects.move_once = code.function;  // G63
    } else if (is_motion(code.function)) {
      state.modes.motion = code.function;
      state.modes.motion_given = state.modes.motion_modelled = true;
    } else if (const auto rule = kCodeRules[static_cast<std::size_t>(code.function)]; rule != nullptr) {
      CodeContext context{rules, state, effects, code};
      rule(context);
    }
  }
}

// --- words that set a state
// -------------------------------------------------------------------------------------------

constexpr std::uint64_t kFeedWord = bit_of(Address::f);
constexpr std::uint64_t kToolWords = bit_of(Address::t) | bit_of(Address::d);
constexpr std::uint64_t kSpindleWords = bit_of(Address::s) | bit_of(Address::spindle_limit);
constexpr double kFootPerMinute = 0.3048;  // in m/min

// F without a point counts 0.01 mm/rev, 1 mm/min, and in inch a hundredth of these in inch (usual parameter settings).
void set_feed(const PlainBlock& block, ModalState& state) {
  state.feed_unknown = (block.unknown & kFeedWord) != 0;
  if (state.feed_unknown) {
    state.feed = 0.0;
    return;
  }
  double value = block.at(Address::f);
  const bool counted = (block.in_increments & kFeedWord) != 0;
  if (state.modes.feed_mode != ir::FeedMode::inverse_time) {
    if (counted && state.modes.feed_mode == ir::FeedMode::per_rev) value /= 100.0;
    if (counted && state.modes.inch_feed) value /= 100.0;
    if (state.modes.inch_feed) value *= 25.4;
  }
  state.feed = value;
}

void set_speed(const PlainBlock& block, ModalState& state, Effects& effects) {
  if (block.has(Address::spindle_limit)) state.spindle_limit_rpm = block.at(Address::spindle_limit);
  if (block.has(Address::s)) {
    const double value = block.at(Address::s);
    if (effects.one_shot == Function::set_coordinates)
      state.spindle_limit_rpm = value;
    else if (state.modes.surface_speed)
      state.surface_speed_m_min = state.modes.inch_feed ? value * kFootPerMinute : value;
    else
      state.rpm = value;
  }
  effects.announces = true;
}

// T0606: the last two digits are the offset; with more than four digits the last three.
Tool tool_of_number(double value) {
  const auto number = static_cast<std::int32_t>(std::min(std::abs(value), 99999999.0));
  const std::int32_t base = number > 9999 ? 1000 : 100;
  return {.number = number / base, .offset = number % base};
}

void set_tool(const PlainBlock& block, const BlockRules& rules, ModalState& state, Effects& effects) {
  effects.announces = true;
  if (block.has(Address::t) || block.tool_name != kNoText) {
    const double value = block.at(Address::t);
    if (block.tool_name != kNoText)
      state.selected = {.name = block.tool_name};
    else if (rules.semantics.tool_word == ir::ToolWord::number_and_offset)
      state.selected = tool_of_number(value);
    else
      state.selected = {.number = static_cast<std::int32_t>(std::min(std::abs(value), 99999999.0))};
    if (rules.tool_at_once) state.tool = state.selected;
  }
  if (effects.tool_change) state.tool = state.selected;
  if (rules.semantics.d_selects_edge && block.has(Address::d)) {
    const auto edge = static_cast<std::int32_t>(std::min(std::abs(block.at(Address::d)), 99999999.0));
    state.selected.offset = edge;
    if (state.tool != Tool{}) state.tool.offset = edge;
  }
}

// Seconds: P in milliseconds, X and U in seconds; or F in seconds, S in turns of the spindle.
double dwell_s(const PlainBlock& block, const BlockRules& rules, const ModalState& state) {
  if (!rules.semantics.dwell_p_is_ms) {
    if (block.has(Address::s)) return state.rpm > 0.0 ? block.at(Address::s) * 60.0 / state.rpm : 0.0;
    return block.has(Address::f) ? block.at(Address::f) : 0.0;
  }
  if (block.has(Address::p)) return block.at(Address::p) / 1000.0;
  for (const Address address : {Address::x, Address::u})
    if (block.has(address)) return rules.length_mm(block, address, false);
  return 0.0;
}

// --- the block's one action
// -------------------------------------------------------------------------------------------

void dwell(const PlainBlock& block, const BlockRules& rules, const ModalState& state, MotionBuffer& out) {
  emit_event(MotionKind::dwell, state, out).feed = dwell_s(block, rules, state);
}

void act_once(const PlainBlock& block, const BlockRules& rules, const Effects& effects, ModalState& state,
              MotionBuffer& out, BlockResult& result) {
  if (effects.one_shot == Function::dwell) {
    dwell(block, rules, state, out);
  } else if (effects.one_shot == Function::local_shift || effects.one_shot == Function::local_shift_add) {
    shift_locally(block, rules, effects.argument == 1, effects.one_shot == Function::local_shift_add, state);
  } else if (effects.one_shot >= Function::rotate && effects.one_shot <= Function::mirror) {
    change_frame(block, rules, effects.one_shot, effects.argument == 1, state);
  } else if (effects.one_shot >= Function::pole_from_last && effects.one_shot <= Function::pole_from_pole) {
    set_pole(block, rules, effects.one_shot, state);
  } else if (effects.one_shot == Function::set_coordinates) {
    set_coordinates(block, rules, state);
  } else if (effects.one_shot == Function::reference_return) {
    return_to_reference(block, rules, state, out, result);
  } else {
    forget_positions(block, rules, state);  // what the code does is not modelled
  }
}

// Moves when there is something to move by: axis words, or the centre of an arc alone, which is a full circle.
bool has_move(const PlainBlock& block, const BlockRules& rules, const ModalState& state) {
  constexpr std::uint64_t kArcWords = bit_of(Address::i) | bit_of(Address::j) | bit_of(Address::k);
  if (((block.present | block.unknown) & rules.axis_addresses) != 0 || has_polar_words(block)) return true;
  const bool arc = state.modes.motion == Function::arc_cw || state.modes.motion == Function::arc_ccw;
  if (block.has(Address::modal_rounding) && !arc) return false;
  return arc && state.modes.motion_modelled && ((block.present | block.unknown) & kArcWords) != 0;
}

Spindle spindle_of(const ModalState& state) {
  if (state.spindle == ir::SpindleState::stopped) return {};
  if (!state.modes.surface_speed) return {.state = state.spindle, .rpm = state.rpm};
  return {
      .state = state.spindle, .surface_speed_m_min = state.surface_speed_m_min, .limit_rpm = state.spindle_limit_rpm};
}

void finish(const Effects& effects, ModalState& state, MotionBuffer& out) {
  if (effects.coolant_off && state.coolant != ir::CoolantState::off) {
    state.coolant = ir::CoolantState::off;
    announce(state, out);
  }
  if (effects.spindle_stop && state.spindle != ir::SpindleState::stopped) {
    state.spindle = ir::SpindleState::stopped;
    announce(state, out);
  }
  if (effects.stop >= 0) emit_event(MotionKind::stop, state, out).number = effects.stop;
}

}  // namespace

ir::Motion& emit_event(MotionKind kind, const ModalState& state, MotionBuffer& out) {
  ir::Motion& motion = out.add(kind);
  fill_common(motion, state);
  motion.axes_unknown = state.unknown;
  return motion;
}

void announce(ModalState& state, MotionBuffer& out) {
  Announced& told = state.announced;
  if (told.work_offset != state.modes.work_offset) {
    told.work_offset = state.modes.work_offset;
    emit_event(MotionKind::offset, state, out).number = told.work_offset;
  }
  if (told.tool != state.tool) {
    told.tool = state.tool;
    ir::Motion& motion = emit_event(MotionKind::tool, state, out);
    motion.number = told.tool.number;
    motion.tool_offset = told.tool.offset;
    motion.text = told.tool.name;
  }
  if (const Spindle spindle = spindle_of(state); told.spindle != spindle) {
    told.spindle = spindle;
    emit_event(MotionKind::spindle, state, out);
  }
  if (told.coolant != state.coolant) {
    told.coolant = state.coolant;
    emit_event(MotionKind::coolant, state, out);
  }
  if (told.comp != state.modes.comp) {
    told.comp = state.modes.comp;
    emit_event(MotionKind::comp, state, out);
  }
}

BlockResult apply(const PlainBlock& block, const BlockRules& rules, ModalState& state, MotionBuffer& out) {
  BlockResult result;
  Effects effects;
  apply_codes(block, rules, state, effects);
  // A dwell's F and S are times; they do not change what is in effect.
  const bool times = effects.one_shot == Function::dwell && !rules.semantics.dwell_p_is_ms;
  if ((block.present & kToolWords) != 0 || block.tool_name != kNoText || effects.tool_change)
    set_tool(block, rules, state, effects);
  if ((block.present & kSpindleWords) != 0 && !times) set_speed(block, state, effects);
  if (((block.present | block.unknown) & kFeedWord) != 0 && !times) set_feed(block, state);
  if (block.has(Address::modal_rounding))
    state.modal_rounding_mm = rules.length_mm(block, Address::modal_rounding, state.modes.inch);
  if (effects.announces) announce(state, out);

  if (effects.one_shot != Function::none)
    act_once(block, rules, effects, state, out, result);
  else if (has_move(block, rules, state))
    move(block, rules, {effects.machine_coordinates, effects.exact_stop, effects.move_once}, state, out, result);
  if (result.fault != text::DiagnosticId::count_) return result;

  finish(effects, state, out);
  result.flow = effects.flow;
  return result;
}

}  // namespace dripfeed::interpreter
