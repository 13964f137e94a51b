// One row a function.
#include "dialects/interpreter/block/code_effects.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include "dialects/interpreter/cycles/drilling.h"
#include "dialects/interpreter/cycles/turning.h"
#include "dialects/ir/offset_words.h"
#include "dialects/ir/other_spindle.h"
#include "dialects/ir/transformation_use.h"

namespace dripfeed::interpreter {

namespace {

using ir::Address;
using ir::Function;
using ir::ModalGroup;

struct CodeContext {
  const BlockRules& rules;
  const PlainBlock& block;
  ModalState& state;
  Effects& effects;
  PlainCode code;
};

// What the surface speed comes to where the tool stands. Without a limit of the program's own the machine's counts,
// which is not known here.
std::optional<double> speed_at_diameter(const BlockRules& rules, const ModalState& state) {
  const bool stands =
      (state.unknown & 1U) == 0 && !state.modes.has_matrix && state.transformation.shape == Transformation::Shape::none;
  const bool known = state.surface_by_x && !state.speed_unknown && state.surface_speed_m_min > 0.0;
  if (!stands || !known || !(state.spindle_limit_rpm > 0.0)) return std::nullopt;
  const double x = state.position[0] - state.modes.shift[0] - state.coordinate_shift[0];
  const double around_mm = std::numbers::pi * std::fabs(x) * (rules.x_is_diameter ? 1.0 : 2.0);
  if (!(around_mm > 0.0)) return state.spindle_limit_rpm;
  return std::min(state.spindle_limit_rpm, 1000.0 * state.surface_speed_m_min / around_mm);
}

// The spindle goes on as fast as it turns, until another S is given: the S before G96 counts no longer. (PG, "Constant
// cutting rate"; 0i-F B-64604EN, "Constant surface speed control".)
void end_surface_speed(CodeContext& c) {
  if (!c.state.modes.surface_speed) return;
  const std::optional<double> rpm = speed_at_diameter(c.rules, c.state);
  c.state.rpm = rpm.value_or(0.0);
  c.state.speed_unknown = !rpm;
  c.state.modes.surface_speed = false;
}
void begin_surface_speed(CodeContext& c) {
  const bool names_axis = ((c.block.present | c.block.unknown) & bit_of(Address::p)) != 0;
  c.state.surface_by_x = c.rules.surface_by_x && !names_axis;
  if (!c.state.modes.surface_speed) c.state.speed_unknown = c.state.surface_speed_m_min == 0.0;
  c.state.modes.surface_speed = true;
}
void surface_speed(CodeContext& c, bool on) {
  on ? begin_surface_speed(c) : end_surface_speed(c);
  c.effects.surface_code = c.effects.announces = true;
}
// An F of the other kind is none of this one: 500 mm a minute are not 500 mm a turn. SINUMERIK wants another F then
// (PG, "Feedrate"); what the others go on with is not known.
void feed(CodeContext& c, ir::FeedMode mode) {
  if (mode != c.state.modes.feed_mode && c.state.feed != 0.0) {
    c.state.feed = 0.0;
    c.state.feed_unknown = !c.rules.semantics.feed_code_ends_surface_speed;
  }
  c.state.modes.feed_mode = mode;
  // … but the feed code that a reader puts with G96 belongs to it.
  if (c.rules.semantics.feed_code_ends_surface_speed && c.state.modes.surface_speed && !c.effects.surface_code) {
    end_surface_speed(c);
    c.effects.announces = true;
  }
}
void unit(CodeContext& c, bool inch) {
  c.state.modes.inch = inch;
  c.state.modes.unit_of_feed = c.code.argument == 0;
  if (c.code.argument == 0) c.state.modes.inch_feed = inch;
}
void comp(CodeContext& c, ir::CompSide side) {
  c.state.modes.comp = side;
  c.effects.announces = true;
}
void spindle(CodeContext& c, ir::SpindleState state) {
  c.state.spindle = state;
  c.effects.announces = true;
  c.effects.orders |= ir::kOrdersSpindle;
}
// S of the main spindle by its number.
void speed_by_number(CodeContext& c, bool is_known) {
  const double value = is_known ? c.block.at(Address::other_speed) : 0.0;
  constexpr double kFootPerMinute = 0.3048;  // in m/min
  c.state.speed_unknown = !is_known;
  if (c.state.modes.surface_speed)
    c.state.surface_speed_m_min = c.state.modes.inch_feed ? value * kFootPerMinute : value;
  else
    c.state.rpm = value;
  c.effects.announces = true;
  c.effects.orders |= ir::kOrdersSpeed;
}
void orient(CodeContext& c) {
  c.effects.spindle_stop = true;
  c.effects.orders |= ir::kOrdersOrientation;
}

void other_spindle(CodeContext& c) {
  const std::uint32_t number = ir::number_of_spindle(c.code.argument);
  const int order = ir::order_of_spindle(c.code.argument);
  const bool is_speed = order == ir::kSpindleSpeed || order == ir::kSpindleSpeedUnknown;
  const bool is_known = order == ir::kSpindleSpeed && c.block.has(Address::other_speed);
  if (number == c.state.spindles.main) {
    if (is_speed) speed_by_number(c, is_known);
    if (order == ir::kTurnsClockwise) spindle(c, ir::SpindleState::clockwise);
    if (order == ir::kTurnsCounterclockwise) spindle(c, ir::SpindleState::counterclockwise);
    if (order == ir::kStopsSpindle) c.effects.spindle_stop = true;
    if (order == ir::kOrientsSpindle) orient(c);
    return;
  }
  OtherSpindle& one = c.state.spindles.by_number[number];
  if (is_speed) {
    one.rpm = is_known ? c.block.at(Address::other_speed) : 0.0;
    one.speed_unknown = !is_known;
  }
  if (order == ir::kTurnsClockwise) one.state = ir::SpindleState::clockwise;
  if (order == ir::kTurnsCounterclockwise) one.state = ir::SpindleState::counterclockwise;
  if (order == ir::kStopsSpindle || order == ir::kOrientsSpindle) one.state = ir::SpindleState::stopped;
}

// Each goes on turning as it did. Machine data say which one is usual, and it is the first. (PG, "Setting the master
// spindle"; MD20090.)
void choose_main_spindle(CodeContext& c) {
  Spindles& spindles = c.state.spindles;
  const auto chosen = static_cast<std::uint8_t>(c.code.argument == 0 ? 1 : c.code.argument);
  if (chosen == spindles.main) return;
  spindles.by_number[spindles.main] = {c.state.spindle, c.state.rpm, c.state.speed_unknown};
  const OtherSpindle one = spindles.by_number[chosen];
  spindles.main = chosen;
  c.state.spindle = one.state;
  c.state.rpm = one.rpm;
  c.state.speed_unknown = one.speed_unknown || c.state.modes.surface_speed;
  c.state.surface_speed_m_min = 0.0;
  c.effects.announces = true;
}
void coolant(CodeContext& c, ir::CoolantState state) {
  c.state.coolant = state;
  c.effects.announces = true;
  c.effects.orders |= state == ir::CoolantState::mist ? ir::kOrdersMist : ir::kOrdersFlood;
}
void one_shot(CodeContext& c) {
  c.effects.one_shot = c.code.function;
  c.effects.argument = c.code.argument;
}
void not_modelled(CodeContext& c) {
  if (c.code.group == ModalGroup::motion || c.code.group == ModalGroup::cycle) {
    c.state.modes.motion_modelled = false;
    c.state.drilling = {};
    c.state.turning = {};
  }
  const ModalGroup group = c.code.group;
  if (group == ModalGroup::non_modal || group == ModalGroup::frame || group == ModalGroup::other) one_shot(c);
}
void drill(CodeContext& c) {
  c.state.modes.motion_modelled = true;
  c.state.turning = {};
  begin_drilling(c.code.argument, c.state);
}
void turn(CodeContext& c) {
  c.state.modes.motion_modelled = true;
  c.state.drilling = {};
  c.state.turning = {.active = true, .cycle = static_cast<TurningCycle>(c.code.argument)};
}
void select_offset(CodeContext& c) {
  c.effects.announces = true;
  if (c.state.modes.work_offset == c.code.argument) return;
  c.state.drilling.initial_known = false;
  c.state.modes.work_offset = c.code.argument;
  c.state.unknown = kAllAxes;  // offsets lie in the control: how far they are apart is not known
}

// G54.1 with a P that was computed; its number is reported as those of constant ones are.
void extended_offset(CodeContext& c) {
  const double p = c.block.has(Address::p) ? c.block.at(Address::p) : 1.0;
  const bool is_known = (c.block.unknown & bit_of(Address::p)) == 0;
  if (!is_known || !(p >= 1.0 && p <= ir::kLastExtendedOffset)) {
    c.state.unknown = kAllAxes;
    return;
  }
  c.code.argument = static_cast<std::int16_t>(kExtendedOffset + static_cast<int>(p));
  select_offset(c);
}

void work_offset(CodeContext& c) {
  const bool has_p = ((c.block.present | c.block.unknown) & bit_of(Address::p)) != 0;
  const bool takes_p = c.rules.semantics.g54_takes_p && c.code.argument == ir::kFirstWorkOffset && has_p &&
                       std::ranges::none_of(c.block.codes, ir::takes_p, &PlainCode::function);
  return takes_p ? extended_offset(c) : select_offset(c);
}

struct CodeRow {
  Function function;
  void (*apply)(CodeContext&);
};
// Functions without a row change nothing here.
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
    {Function::axial_shift, one_shot},
    {Function::rotate, one_shot},
    {Function::scale, one_shot},
    {Function::mirror, one_shot},
    {Function::pole_from_last, one_shot},
    {Function::pole_from_zero, one_shot},
    {Function::pole_from_pole, one_shot},
    {Function::spline_begin, [](CodeContext& c) { c.state.modes.spline_begin = c.code.argument; }},
    {Function::spline_end, [](CodeContext& c) { c.state.modes.spline_end = c.code.argument; }},
    {Function::polar_words_on,
     [](CodeContext& c) {
       c.state.modes.polar_words = true;
       c.state.polar = {};
     }},
    {Function::polar_words_off, [](CodeContext& c) { c.state.modes.polar_words = false; }},
    {Function::transformation,
     [](CodeContext& c) {
       if (c.code.argument != ir::kTransformationEnds) return one_shot(c);
       c.state.transformation = {};
     }},
    {Function::reference_return, one_shot},
    {Function::leave_reference, one_shot},
    {Function::approach, [](CodeContext& c) { c.effects.move_once = Function::rapid; }},
    {Function::stroke_check, one_shot},
    {Function::extended_offset, extended_offset},
    {Function::data_input, one_shot},
    {Function::skip_move, one_shot},
    {Function::measure_tool, one_shot},
    {Function::repetitive_cycle, one_shot},
    {Function::hole_pattern, one_shot},
    {Function::comp_off, [](CodeContext& c) { comp(c, ir::CompSide::off); }},
    {Function::comp_left, [](CodeContext& c) { comp(c, ir::CompSide::left); }},
    {Function::comp_right, [](CodeContext& c) { comp(c, ir::CompSide::right); }},
    // Positions stay the tip's: how long the tool is, the control knows.
    {Function::length_offset_plus, [](CodeContext& c) { c.state.length_offset = ir::LengthOffset::plus; }},
    {Function::length_offset_minus, [](CodeContext& c) { c.state.length_offset = ir::LengthOffset::minus; }},
    {Function::length_offset_off, [](CodeContext& c) { c.state.length_offset = ir::LengthOffset::off; }},
    {Function::tool_change, [](CodeContext& c) { c.effects.tool_change = true; }},
    {Function::surface_speed_on, [](CodeContext& c) { surface_speed(c, true); }},
    {Function::surface_speed_off, [](CodeContext& c) { surface_speed(c, false); }},
    {Function::spindle_cw, [](CodeContext& c) { spindle(c, ir::SpindleState::clockwise); }},
    {Function::spindle_ccw, [](CodeContext& c) { spindle(c, ir::SpindleState::counterclockwise); }},
    {Function::spindle_stop, [](CodeContext& c) { c.effects.spindle_stop = true; }},
    {Function::spindle_orient, orient},
    {Function::other_spindle, other_spindle},
    {Function::main_spindle, choose_main_spindle},
    {Function::coolant_mist, [](CodeContext& c) { coolant(c, ir::CoolantState::mist); }},
    {Function::coolant_flood, [](CodeContext& c) { coolant(c, ir::CoolantState::flood); }},
    {Function::coolant_off, [](CodeContext& c) { c.effects.coolant_off = true; }},
    {Function::program_stop, [](CodeContext& c) { c.effects.stop = 0; }},
    {Function::optional_stop, [](CodeContext& c) { c.effects.stop = 1; }},
    {Function::program_end, [](CodeContext& c) { c.effects.flow = Flow::program_end; }},
    {Function::program_end_rewind, [](CodeContext& c) { c.effects.flow = Flow::program_end; }},
    {Function::subprogram_end, [](CodeContext& c) { c.effects.flow = Flow::subprogram_end; }},
    {Function::drill, drill},
    {Function::turning_cycle, turn},
    {Function::cycle_off,
     [](CodeContext& c) {
       c.state.modes.motion_modelled = true;
       c.state.drilling = {};
     }},
    {Function::return_to_initial, [](CodeContext& c) { c.state.modes.return_to_r = false; }},
    {Function::return_to_r, [](CodeContext& c) { c.state.modes.return_to_r = true; }},
    {Function::not_modelled, not_modelled},
};
constexpr auto kCodeRules = [] {
  std::array<void (*)(CodeContext&), static_cast<std::size_t>(Function::count_)> rules{};
  for (const CodeRow& row : kCodeRows) rules[static_cast<std::size_t>(row.function)] = row.apply;
  return rules;
}();

constexpr bool is_motion(Function function) { return function >= Function::rapid && function <= Function::tap_retract; }

}  // namespace

void apply_codes(const PlainBlock& block, const BlockRules& rules, ModalState& state, Effects& effects) {
  for (const PlainCode& code : block.codes) {
    if (is_motion(code.function) && code.group == ModalGroup::non_modal) {
      effects.move_once = code.function;  // G63
    } else if (is_motion(code.function)) {
      state.modes.motion = code.function;
      if (code.function == Function::spline) [[unlikely]]
        state.modes.spline = code.argument;
      if (code.function == Function::thread_changing) [[unlikely]]
        state.modes.lead_shrinks = code.argument == 1;
      state.modes.motion_given = state.modes.motion_modelled = true;
      if (state.drilling.active) state.drilling = {};
      if (state.turning.active) state.turning = {};
    } else if (const auto rule = kCodeRules[static_cast<std::size_t>(code.function)]; rule != nullptr) {
      state.stated |= 1U << static_cast<unsigned>(code.group);
      CodeContext context{rules, block, state, effects, code};
      rule(context);
    }
  }
}

}  // namespace dripfeed::interpreter
