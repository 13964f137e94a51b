// What a code does, whatever the control calls it. A dialect's table maps G02, M3 or DIAMON to a function with an
// argument; the interpreter and the writers know functions only.
#pragma once

#include <cstdint>
#include <string_view>

namespace dripfeed::ir {

enum class Function : std::uint8_t {
  none,
  // motion
  rapid,
  linear,
  arc_cw,
  arc_ccw,
  thread,
  thread_changing,  // G34: its lead grows by a word's value in each turn; argument 1: it shrinks by it (G35)
  arc_via,          // CIP
  arc_tangent,      // CT
  spline,           // ASPLINE, BSPLINE, CSPLINE: argument as ir/spline_use.h
  nurbs,            // G06.2: a control point or a knot a block
  polynomial,       // POLY: each axis a polynomial of its own
  tap,
  tap_retract,  // G331, G332
  dwell,
  exact_stop_once,
  exact_stop_mode,
  continuous_path,
  // plane, unit, distance, feed
  plane_xy,
  plane_zx,
  plane_yz,
  unit_inch,
  unit_mm,  // argument: 0 lengths and feeds, 1 lengths only (G70, G71 of SINUMERIK)
  absolute,
  incremental,
  pole_from_last,
  pole_from_zero,
  pole_from_pole,  // G110, G111, G112
  polar_words_on,
  polar_words_off,  // G16, G15: the plane's two letters are a radius and an angle
  spline_begin,
  spline_end,      // BNAT, ETAN …: argument as ir/spline_use.h
  transformation,  // G12.1, G07.1, TRANSMIT, TRACYL: argument as ir/transformation_use.h
  feed_per_min,
  feed_per_rev,
  feed_inverse_time,
  diameter_on,
  diameter_off,
  diameter_absolute_only,  // DIAMON, DIAMOF, DIAM90
  // coordinates
  work_offset,          // argument: 0 none (G500), 1 G54, 2 G55 …
  machine_coordinates,  // G53, SUPA: this block only
  local_shift,          // G52, TRANS; argument 1: axes that are not named lose their shift (TRANS)
  local_shift_add,      // ATRANS
  axial_shift,          // G58; argument 1: the fine part (G59)
  rotate,
  scale,
  mirror,            // ROT, SCALE, MIRROR, G68, G51, G51.1: argument as ir/frame_use.h
  set_coordinates,   // G92; G50 of G-code system A; argument 1: takes such shifts back (G92.1)
  reference_return,  // G28, G74; argument: reference point 1, 2 …
  leave_reference,   // G29: through the point where G28 went through
  approach,          // a rapid move whose further meaning is not interpreted: G27, G60
  stroke_check,      // G22: its axis words are limits
  extended_offset,   // G54.1: P is its number
  data_input,        // G10: L says what is set
  skip_move,         // G31: a straight move that a signal may end
  measure_tool,      // G37: a straight move that a touch ends, and the tool's length becomes another
  // tool
  comp_off,
  comp_left,
  comp_right,
  length_offset_plus,
  length_offset_minus,
  length_offset_off,
  tool_change,  // M6
  // spindle and coolant
  surface_speed_on,
  surface_speed_off,  // G96, G97
  spindle_cw,
  spindle_ccw,
  spindle_stop,
  spindle_orient,
  other_spindle,  // M2=3, S2=: argument as ir/other_spindle.h
  main_spindle,   // SETMS: the spindle that S, M3 and feeds per revolution mean; argument: its number, 0: the usual one
  coolant_mist,
  coolant_flood,
  coolant_off,
  // program flow
  program_stop,
  optional_stop,
  program_end,
  program_end_rewind,
  subprogram_end,
  local_call,  // P is the block of the same program where it begins (Haas M97)
  // cycles
  drill,  // argument: drill_argument() of ir/cycle.h
  cycle_off,
  turning_cycle,     // argument: 0 along Z (G90), 1 thread (G92), 2 along X (G94)
  repetitive_cycle,  // argument: 0 to 6 as G70 to G76
  hole_pattern,      // G34 to G37.1 of a mill: the cycle in effect at each hole; argument as ir/hole_pattern.h
  return_to_initial,
  return_to_r,  // G98, G99 of mills
  // without effect on motion, time or geometry that is modelled: said once by name in the report
  no_effect,
  // known to the control, not interpreted here: the report names it
  not_modelled,
  // an M function of the machine tool builder; argument: its number
  machine_function,
  count_,
};

std::string_view name_of(Function function);

// Codes of one group exclude each other within a block (SINUMERIK alarm 12060) and replace each other in the modal
// state.
enum class ModalGroup : std::uint8_t {
  none,
  motion,
  non_modal,
  plane,
  distance,
  feed,
  unit,
  comp,
  length_offset,
  cycle,
  return_level,
  work_offset,
  surface_speed,
  exact_stop,
  diameter,
  spindle,
  coolant,
  flow,
  frame,
  other,
};

// One row of a control's code table. `number10` is ten times the written number (G54.1 is 541), -1 for a code with a
// name only.
struct CodeRow {
  std::string_view name;  // as the control's manual writes it: "G00", "M30", "DIAMON"
  std::int16_t number10 = -1;
  Function function = Function::none;
  std::int16_t argument = 0;
  ModalGroup group = ModalGroup::none;
  std::string_view reference;  // manual and section, or where else the fact is from
};

}  // namespace dripfeed::ir
