// How a control calculates and what it assumes, as data: the interpreter and the translators read these fields and
// never ask which control it is. Values marked "machine" come from the profile; a control's table gives what is usual.
#pragma once

#include <cstdint>

#include "dialects/ir/function.h"

namespace dripfeed::ir {

// One constant without a decimal point: 10 is 10 mm (calculator), or ten least increments (machine).
enum class DecimalMode : std::uint8_t { calculator, least_increment };
// exact: stored values compared bit for bit; relative: equal within Semantics::relative_tolerance of the larger.
enum class ComparisonMode : std::uint8_t { exact, relative };
// double_precision: IEEE; eight_digit: results rounded to 8 decimal digits (16i and older).
enum class NumberFormat : std::uint8_t { double_precision, eight_digit };
enum class RoundHalf : std::uint8_t { away_from_zero, up };
enum class RoundUpMode : std::uint8_t { away_from_zero, next_larger };  // FUP, ROUNDUP
enum class DiameterMode : std::uint8_t { radius, diameter, diameter_absolute_only };
enum class ToolWord : std::uint8_t { number, number_and_offset };  // T6; T0606
enum class FeedMode : std::uint8_t { per_min, per_rev, inverse_time };
// G53, SUPA. rapid: at rapid whatever is in effect, and left out where it would be an increment (Fanuc, "Selecting a
// machine coordinate system"). programmed: by the motion in effect, increments as increments (Mitsubishi M700V
// programming manual, 14.4). without_frames: by the motion in effect; whether increments take the shifts along, setting
// data decides (SINUMERIK).
enum class MachineMove : std::uint8_t { rapid, programmed, without_frames };
// How a tap that turns the spindle by its position is written. usual: as every tap, or apart by the words of the cycle
// (SINUMERIK); m29: M29 in the block before it (Fanuc); comma_r: ,R1 in its block (Mitsubishi); own_code: a code next
// to the usual one (Mazak, G84.2).
enum class RigidTap : std::uint8_t { usual, m29, comma_r, own_code };
enum class Plane : std::uint8_t { xy, zx, yz };

struct Semantics {
  bool has_vacant = true;  // #0 exists; without it unset variables read 0
  // What only the control's memory or its surroundings hold (R parameters, global data, inputs) is not known until it
  // is set, and neither is what is computed from it; otherwise it reads 0.
  bool unset_is_unknown = false;
  NumberFormat number_format = NumberFormat::double_precision;
  ComparisonMode comparison = ComparisonMode::exact;
  double relative_tolerance = 0.0;
  RoundHalf round_half = RoundHalf::away_from_zero;
  RoundUpMode round_up = RoundUpMode::away_from_zero;
  bool atan_full_circle = true;          // ATAN[a]/[b] in 0…360, otherwise -180…180
  bool asin_from_90_to_270 = true;       // ASIN in 270…90 (parameter 6004#0 = 0), otherwise -90…90
  bool integer_division_is_real = true;  // 7/4 = 1.75 on INT operands

  DecimalMode decimal_mode = DecimalMode::calculator;  // machine
  bool decimal_mode_confirmed = false;                 // machine: a person looked at the parameter
  double least_increment_mm = 0.001;
  double least_increment_deg = 0.001;

  bool incremental_letters_uvw = false;     // U V W H as incremental X Y Z C (lathe, G-code system A)
  ToolWord tool_word = ToolWord::number;    // T0606 on Fanuc lathes
  bool arc_radius_is_r = true;              // R; otherwise CR=
  bool dwell_p_is_ms = true;                // G04 P in ms, X/U in s; otherwise G4 F in s
  bool arc_without_center_is_line = false;  // G02 without I J K R goes straight (Fanuc 3403#5 = 0); otherwise an alarm
  MachineMove machine_move = MachineMove::rapid;
  double scale_unit = 0.001;          // what a factor of G51 without a point counts (5400#7)
  bool scale_unit_known = false;      // … on every such control, or looked at
  double arc_tolerance_mm = 0.02;     // start and end radius may differ by this (3410; MD21000)
  double arc_tolerance_factor = 0.0;  // … or by this part of the radius, where that is more (MD21010)
  int reference_fixed_point = 0;      // machine: the fixed point (G75 FP=) at the reference point; 0: none said
  bool spline_form_known = false;     // machine: how a spline bends between its points was looked at

  // Cycles: what parameters decide. Neither changes the hole, only the approach to it.
  double chip_break_retract_mm = 1.0;  // machine: G73 goes back by this between pecks (5114)
  double peck_clearance_mm = 1.0;      // machine: G83 goes back in to this far above the last depth (5115)
  bool drill_r_from_initial = false;   // R of drilling is a distance from the initial level in G90, too (lathes)
  bool pecks_need_depth = false;       // G73 and G83 without Q are an alarm (Fanuc mills)

  // Turning cycles, where the program does not say: machine (5132 … 5145). All mm, radius.
  double cycle_depth_mm = 1.0;       // of a pass of G71, G72
  double cycle_retract_mm = 0.5;     // away from the work after each pass
  std::int32_t cycle_passes = 3;     // of G73
  double thread_first_cut_mm = 0.3;  // G76 without Q
  double thread_least_cut_mm = 0.05;

  // The other language of a SINUMERIK, ISO mode: machine (Function Manual ISO Dialects).
  bool starts_in_iso_mode = false;                         // G291 is in effect where a program begins (MD20150)
  DecimalMode iso_decimal_mode = DecimalMode::calculator;  // MD10884 EXTERN_FLOATINGPOINT_PROG; from memory
  bool iso_decimal_mode_confirmed = false;

  // State at power-on or reset; `known` is false where the machine decides and no one confirmed.
  bool power_on_known = false;
  Function power_on_motion = Function::rapid;
  Function power_on_plane = Function::plane_xy;
  Function power_on_unit = Function::unit_mm;
  Function power_on_distance = Function::absolute;
  Function power_on_feed = Function::feed_per_min;
  DiameterMode power_on_diameter = DiameterMode::radius;

  // Ends, alarms and edges, where controls differ.
  bool end_in_subprogram_returns = false;     // M30 or M2 of a called program only returns (SINUMERIK)
  bool return_in_main_restarts = false;       // M99 of the main program starts it again, without end
  std::uint32_t user_alarm_base = 0;          // #3000 = 1 is shown as alarm 3001: 3000
  std::uint32_t highest_user_alarm = 0;       // above it all are shown as the base alone; 0: no limit
  bool feed_code_ends_surface_speed = false;  // G94, G95, G96 replace each other (SINUMERIK)
  bool taps_are_rigid = false;                // G84 and G74 always turn the spindle by position (Haas)
  RigidTap rigid_tap = RigidTap::usual;
  bool tool_number_has_suffix = false;  // T01.01: the fraction distinguishes tools of one number
  bool g54_takes_p = false;             // G54 P3 is G54.1 P3
  bool length_needs_code = false;       // a tool's length acts by G43 alone, not by its change (mills)
  bool change_needs_code = false;       // a tool is changed in by M06 alone; elsewhere T may do it, by the builder
  bool d_selects_edge = false;          // D is the tool's edge and takes effect at once; otherwise a comp number
};

}  // namespace dripfeed::ir
