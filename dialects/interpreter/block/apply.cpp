// Order within a block, as the controls do it: codes, then T S F and D, then what starts (offset, tool, spindle,
// coolant, compensation), then the one motion, dwell or shift, then what ends (coolant, spindle, stop).
#include "dialects/interpreter/block/apply.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "dialects/interpreter/block/code_effects.h"
#include "dialects/interpreter/block/feed_word.h"
#include "dialects/interpreter/block/frame_change.h"
#include "dialects/interpreter/block/idle_words.h"
#include "dialects/interpreter/cycles/drilling.h"
#include "dialects/interpreter/cycles/hole_pattern.h"
#include "dialects/interpreter/cycles/repetitive.h"
#include "dialects/interpreter/cycles/tool_measuring.h"
#include "dialects/interpreter/cycles/turning.h"
#include "dialects/interpreter/motion/events.h"
#include "dialects/interpreter/motion/move.h"
#include "dialects/interpreter/motion/nurbs_block.h"
#include "dialects/interpreter/motion/point_frame.h"
#include "dialects/interpreter/motion/polar.h"
#include "dialects/interpreter/motion/spline_block.h"
#include "dialects/interpreter/motion/transformed.h"
#include "dialects/interpreter/state/axis_words.h"
#include "dialects/ir/frame_use.h"

namespace dripfeed::interpreter {

namespace {

using ir::Address;
using ir::Function;
using ir::MotionKind;

// --- words that set a state

constexpr std::uint64_t kContourOffsetWord = bit_of(Address::contour_offset);
constexpr std::uint64_t kBlockFeedWord = bit_of(Address::block_feed);
constexpr std::uint64_t kToolWords = bit_of(Address::t) | bit_of(Address::d);
constexpr std::uint64_t kSpindleWords = bit_of(Address::s) | bit_of(Address::spindle_limit);
constexpr std::uint64_t kNumberWords = bit_of(Address::d) | bit_of(Address::h);
constexpr double kFootPerMinute = 0.3048;  // in m/min

void set_feed(const PlainBlock& block, const BlockRules& rules, ModalState& state) {
  // With G34 and G35 of SINUMERIK it is the change of the lead, and no feed is left. (PG, "Thread cutting with
  // increasing or decreasing lead".)
  if (state.modes.motion == Function::thread_changing && !rules.semantics.arc_radius_is_r) [[unlikely]] {
    state.feed_unknown = false;
    state.feed = 0.0;
    return;
  }
  state.feed_unknown = (block.unknown & kFeedWord) != 0;
  if (state.feed_unknown) {
    state.feed = 0.0;
    return;
  }
  state.feed = feed_of_word(block, state.modes);
}

// FB: the block's own feed, of the kind that is in effect; F stays for the blocks to come. (PG, "Non-modal feedrate".)
void set_block_feed(const PlainBlock& block, ModalState& state) {
  state.feed_unknown = (block.unknown & kBlockFeedWord) != 0;
  state.feed = state.feed_unknown ? 0.0 : block.at(Address::block_feed);
  if (state.modes.inch_feed && state.modes.feed_mode != ir::FeedMode::inverse_time) state.feed *= 25.4;
}

// One that is not known is 0: neither the one before counts any more, nor a limit.
void set_speed(const PlainBlock& block, ModalState& state, Effects& effects) {
  const auto given = [&](Address address) { return ((block.present | block.unknown) & bit_of(address)) != 0; };
  const auto value_of = [&](Address address) { return block.has(address) ? block.at(address) : 0.0; };
  const bool limits = effects.one_shot == Function::set_coordinates;
  if (given(Address::spindle_limit)) state.spindle_limit_rpm = value_of(Address::spindle_limit);
  if (given(Address::spindle_limit) || (limits && given(Address::s))) effects.orders |= ir::kOrdersLimit;
  if (given(Address::s)) {
    const double value = value_of(Address::s);
    if (!limits) effects.orders |= ir::kOrdersSpeed;
    if (!limits) state.speed_unknown = !block.has(Address::s);
    if (limits)
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

std::uint16_t offset_number(double value) {
  return static_cast<std::uint16_t>(std::clamp(std::abs(value), 0.0, 65535.0));
}

// The tool in the spindle has changed: where T or D name the lengths, theirs count from here on.
void take_length(const BlockRules& rules, ModalState& state) {
  const bool pairs = rules.semantics.tool_word == ir::ToolWord::number_and_offset;
  if (!pairs && !rules.semantics.d_selects_edge) return;
  const bool none = pairs ? state.tool.offset == 0 : state.tool.number == 0 && state.tool.name == kNoText;
  state.length_offset = none ? ir::LengthOffset::off : ir::LengthOffset::plus;
  state.length_offset_number = offset_number(state.tool.offset);
}

void set_tool(const PlainBlock& block, const BlockRules& rules, ModalState& state, Effects& effects) {
  effects.announces = true;
  if (block.has(Address::t) || block.tool_name != kNoText) {
    state.tool_stated = true;
    const double value = block.at(Address::t);
    if (block.tool_name != kNoText)
      state.selected = {.number = block.named_tool, .name = block.tool_name};
    else if (rules.semantics.tool_word == ir::ToolWord::number_and_offset)
      state.selected = tool_of_number(value);
    else
      state.selected = {.number = static_cast<std::int32_t>(std::min(std::abs(value), 99999999.0))};
    if (rules.tool_at_once) {
      effects.orders |= ir::kOrdersTool;
      state.tool = state.selected;
      take_length(rules, state);
    }
  }
  if (effects.tool_change) {
    effects.orders |= ir::kOrdersChange;
    state.tool = state.selected;
    take_length(rules, state);
  }
  if (rules.semantics.d_selects_edge && block.has(Address::d)) {
    const auto edge = static_cast<std::int32_t>(std::min(std::abs(block.at(Address::d)), 99999999.0));
    state.selected.offset = edge;
    if (state.tool != Tool{}) {
      state.tool.offset = edge;
      effects.orders |= ir::kOrdersEdge;
    }
    state.length_offset = edge == 0 ? ir::LengthOffset::off : ir::LengthOffset::plus;
    state.length_offset_number = offset_number(edge);
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

// On lathes of G-code system A H is an increment of C.
void set_numbers(const PlainBlock& block, const BlockRules& rules, ModalState& state) {
  if (block.has(Address::d)) state.comp_number = block.at(Address::d);
  if (!block.has(Address::h)) return;
  state.length_number = block.at(Address::h);
  if ((rules.axis_addresses & bit_of(Address::h)) == 0 && !rules.semantics.d_selects_edge)
    state.length_offset_number = offset_number(block.at(Address::h));
}

// --- the block's one action

void dwell(const PlainBlock& block, const BlockRules& rules, ModalState& state, MotionBuffer& out) {
  const double seconds = dwell_s(block, rules, state);
  emit_event(MotionKind::dwell, state, out).feed = seconds;
  state.clock_ms += seconds * 1000.0;
}

// How the frames of a control's two languages lie in each other is not followed. One that is taken back leaves none.
void note_language_of_frame(const BlockRules& rules, ModalState& state, BlockResult& result) {
  Modes& modes = state.modes;
  const bool is_none =
      !modes.has_matrix && modes.shift == AxisValues{} && std::ranges::none_of(modes.point_frames, &PointFrame::active);
  modes.frame_languages |= static_cast<std::uint8_t>(rules.other_language ? 2 : 1);
  if (modes.frame_languages == 3) {
    result.notes |= kNoteFramesOfBoth;
    state.unknown = kAllAxes;
  }
  if (is_none) modes.frame_languages = 0;
}

void frame(const PlainBlock& block, const BlockRules& rules, const Effects& effects, ModalState& state,
           BlockResult& result) {
  if (effects.argument == ir::kFrameEnds) {
    if (end_point_frame(block, rules, effects.one_shot, state)) note_language_of_frame(rules, state, result);
    // The axes of G50.1 are those whose mirror ends.
    if (effects.one_shot == Function::mirror || axis_letters(block, rules) == 0) return;
    result.notes |= kNoteMoveAtFrameEnd;
    return forget_positions(block, rules, state);
  }
  if (effects.argument != ir::kFrameAboutPoint) {
    change_frame(block, rules, effects.one_shot, effects.argument == ir::kFrameReplaces, state);
    return note_language_of_frame(rules, state, result);
  }
  const PointFrameGap gap = set_point_frame(block, rules, effects.one_shot, state);
  note_language_of_frame(rules, state, result);
  if (gap == PointFrameGap::factor_unit) result.notes |= kNoteScaleUnit;
  if (gap == PointFrameGap::factor || gap == PointFrameGap::angle) result.notes |= kNoteFrameValue;
}

bool changes_frame(Function function) {
  return function == Function::local_shift || function == Function::local_shift_add ||
         function == Function::axial_shift || (function >= Function::rotate && function <= Function::mirror);
}

void frame_block(const PlainBlock& block, const BlockRules& rules, const Effects& effects, ModalState& state,
                 BlockResult& result) {
  if (effects.one_shot == Function::axial_shift)
    shift_axes(block, rules, effects.argument == 1, state);
  else if (effects.one_shot == Function::local_shift || effects.one_shot == Function::local_shift_add)
    shift_locally(block, rules, effects.argument == 1, effects.one_shot == Function::local_shift_add, state);
  else
    return frame(block, rules, effects, state, result);
  note_language_of_frame(rules, state, result);
}

void act_once(const PlainBlock& block, const BlockRules& rules, const Effects& effects, ModalState& state,
              MotionBuffer& out, BlockResult& result) {
  if (effects.one_shot == Function::dwell) {
    dwell(block, rules, state, out);
  } else if (changes_frame(effects.one_shot)) {
    const Modes before = state.modes;
    frame_block(block, rules, effects, state, result);
    mark_shifted(before, rules, state);
  } else if (effects.one_shot >= Function::pole_from_last && effects.one_shot <= Function::pole_from_pole) {
    set_pole(block, rules, effects.one_shot, state);
  } else if (effects.one_shot == Function::set_coordinates) {
    set_coordinates(block, rules, effects.argument == 1, state);
  } else if (effects.one_shot == Function::reference_return) {
    return_to_reference(block, rules, state, out, result);
  } else if (effects.one_shot == Function::leave_reference) {
    leave_reference(block, rules, state, out, result);
  } else if (effects.one_shot == Function::stroke_check) {
    return;  // its words are limits
  } else if (effects.one_shot == Function::skip_move) {
    result.moved = true;
    move_until_touch(block, rules, state, out, result);
  } else if (effects.one_shot == Function::measure_tool) {
    result.moved = true;
    measure_tool(block, rules, state, out, result);
  } else if (effects.one_shot == Function::repetitive_cycle) {
    repetitive_block(block, rules, effects.argument, state, out, result);
  } else if (effects.one_shot == Function::hole_pattern) {
    result.moved = true;
    drill_pattern(block, rules, effects.argument, state, out, result);
  } else if (effects.one_shot == Function::data_input) {
    result.sets_data = true;
  } else if (effects.one_shot == Function::transformation) {
    begin_transformation(block, rules, effects.argument, state);
  } else {
    forget_positions(block, rules, state);  // what the code does is not modelled
  }
}

// Moves when there is something to move by: axis words, or the centre of an arc alone, which is a full circle.
bool has_move(const PlainBlock& block, const BlockRules& rules, const ModalState& state) {
  constexpr std::uint64_t kArcWords = bit_of(Address::i) | bit_of(Address::j) | bit_of(Address::k);
  if (axis_letters(block, rules) != 0 || has_polar_words(block)) return true;
  if (((block.present | block.unknown) & bit_of(Address::direct_angle)) != 0) return true;
  const bool arc = state.modes.motion == Function::arc_cw || state.modes.motion == Function::arc_ccw;
  if (block.has(Address::modal_rounding) && !arc) return false;
  return arc && state.modes.motion_modelled && ((block.present | block.unknown) & kArcWords) != 0;
}

void finish(const Effects& effects, ModalState& state, MotionBuffer& out) {
  const bool every_order = state.announced.every_order;
  if (effects.coolant_off && (every_order || state.coolant != ir::CoolantState::off)) {
    state.coolant = ir::CoolantState::off;
    announce(state, out, ir::kOrdersFlood);
  }
  if (effects.spindle_stop && (every_order || state.spindle != ir::SpindleState::stopped)) {
    state.spindle = ir::SpindleState::stopped;
    const bool orients = (effects.orders & ir::kOrdersOrientation) != 0;
    announce(state, out, orients ? ir::kOrdersOrientation : ir::kOrdersSpindle);
  }
  if (effects.stop >= 0) emit_event(MotionKind::stop, state, out).number = effects.stop;
}

void act(const PlainBlock& block, const BlockRules& rules, const Effects& effects, ModalState& state, MotionBuffer& out,
         BlockResult& result, const PlainBlock* letters = nullptr) {
  if (state.drilling.active) {
    drill_holes(block, rules, state, out, result, letters);
  } else if (state.turning.active) {
    turn_once(block, rules, state, out, result);
  } else if (state.modes.motion == Function::nurbs && state.modes.motion_modelled) {
    add_to_curve(block, rules, state, out, result);
  } else if (has_move(block, rules, state)) {
    const bool at_rapid = effects.machine_coordinates && rules.semantics.machine_move == ir::MachineMove::rapid;
    const Function motion = at_rapid ? Function::rapid : effects.move_once;
    move(block, rules, {effects.machine_coordinates, effects.exact_stop, motion}, state, out, result);
  } else {
    return;
  }
  result.moved = true;
}

// On a face or cylinder: the block moves in that plane, and what comes out is brought to the axes. Apart, so that plain
// blocks do not pay for its copies.
[[gnu::noinline]] void act_transformed(const PlainBlock& block, const BlockRules& rules, const Effects& effects,
                                       ModalState& state, MotionBuffer& out, BlockResult& result) {
  TransformedBlock plane(block, rules, state, out, result);
  act(plane.block(), plane.rules(), effects, state, out, result);
  plane.finish();
}

// Whether the plane's letters of this block are a radius and an angle.
bool names_polar(const PlainBlock& block, const Effects& effects, const ModalState& state) {
  if (!state.modes.polar_words || effects.machine_coordinates) return false;
  constexpr std::array kLetters = {Address::x, Address::y, Address::z};
  const PlaneAxes axes = axes_of(state.modes.plane);
  return ((block.present | block.unknown) & (bit_of(kLetters[axes.p]) | bit_of(kLetters[axes.q]))) != 0;
}

// OFFN acts with the compensation of the radius, and as the half of a groove's width under TRACYL. The motions say the
// programmed contour. (PG, "Tool radius compensation"; PGA, "TRACYL".)
bool uses_contour_offset(const ModalState& state) {
  return state.modes.comp != ir::CompSide::off || state.transformation.shape == Transformation::Shape::cylinder;
}

// X and U of a lathe in one block: which of them is effective, their order may decide, and a block does not know it.
void note_axis_named_twice(std::uint64_t letters, const BlockRules& rules, ModalState& state, BlockResult& result) {
  const std::uint16_t twice =
      axes_of(letters & rules.coordinates, rules) & axes_of(letters & ~rules.coordinates, rules);
  if (twice == 0) return;
  result.notes |= kNoteAxisTwice;
  state.unknown |= twice;
}

}  // namespace

BlockResult apply(const PlainBlock& block, const BlockRules& rules, ModalState& state, MotionBuffer& out) {
  BlockResult result;
  Effects effects;
  apply_codes(block, rules, state, effects);
  // A dwell's F and S are times; they do not change what is in effect.
  const bool times = effects.one_shot == Function::dwell && !rules.semantics.dwell_p_is_ms;
  if ((block.present & kToolWords) != 0 || block.tool_name != kNoText || effects.tool_change)
    set_tool(block, rules, state, effects);
  if (((block.present | block.unknown) & kSpindleWords) != 0 && !times) set_speed(block, state, effects);
  if (((block.present | block.unknown) & kFeedWord) != 0 && !times) set_feed(block, rules, state);
  // D of G37 is how far from its place the touch may be.
  if ((block.present & kNumberWords) != 0 && effects.one_shot != Function::measure_tool)
    set_numbers(block, rules, state);
  if (block.has(Address::modal_rounding))
    state.modal_rounding_mm = rules.length_mm(block, Address::modal_rounding, state.modes.inch);
  if (effects.announces) announce(state, out, effects.orders);
  const std::pair modal_feed(state.feed, state.feed_unknown);
  const bool own_feed = ((block.present | block.unknown) & kBlockFeedWord) != 0;
  if (own_feed) [[unlikely]]
    set_block_feed(block, state);

  // M functions in the block of a hole act when its first positioning begins (Fanuc, "Canned cycle for drilling").
  const bool ends_first = state.drilling.active && effects.one_shot == Function::none;
  if (ends_first) [[unlikely]]
    finish(effects, state, out);
  if (effects.one_shot != Function::none) {
    act_once(block, rules, effects, state, out, result);
  } else if (names_polar(block, effects, state)) {
    act(with_coordinates_of_letters(block, rules, state), rules, effects, state, out, result, &block);
  } else if (state.transformation.shape != Transformation::Shape::none && !effects.machine_coordinates) [[unlikely]] {
    act_transformed(block, rules, effects, state, out, result);
  } else {
    act(block, rules, effects, state, out, result);
  }
  if (((block.present | block.unknown) & kIdleLetters) != 0 || effects.one_shot == Function::dwell) [[unlikely]]
    result.notes |= idle_notes(block, rules, effects, state);
  if (const std::uint64_t letters = axis_letters(block, rules); (letters & ~rules.coordinates) != 0) [[unlikely]]
    note_axis_named_twice(letters, rules, state, result);
  if (((block.present | block.unknown) & kContourOffsetWord) != 0) [[unlikely]]
    state.offsets_contour = !block.has(Address::contour_offset) || block.at(Address::contour_offset) != 0.0;
  if (state.offsets_contour && result.moved && uses_contour_offset(state)) [[unlikely]]
    result.notes |= kNoteContourOffset;
  if (own_feed) std::tie(state.feed, state.feed_unknown) = modal_feed;
  if (state.curve.open) [[unlikely]]
    if (state.modes.motion != Function::nurbs || effects.flow != Flow::next) break_curve(state, result);
  if (state.plane_corner.kind != 0) [[unlikely]] {
    constexpr std::size_t kWaitsAtMost = 4 * ir::kMotionBatch;
    const bool ends = state.transformation.shape == Transformation::Shape::none || effects.flow == Flow::program_end;
    if (ends || out.used() > state.plane_corner.motion + state.plane_corner.pieces + kWaitsAtMost)
      drop_plane_corner(state, out, result);
  }
  if (state.spline.active) [[unlikely]]
    follow_spline(rules, state, out);
  if (result.fault != text::DiagnosticId::count_) return result;

  if (!ends_first) finish(effects, state, out);
  result.flow = effects.flow;
  return result;
}

}  // namespace dripfeed::interpreter
