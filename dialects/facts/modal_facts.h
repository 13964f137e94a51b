// The facts that are followed: one row a modal group for what codes set, and the numbers that stay in effect. Values
// are as the program writes them.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "dialects/facts/known.h"
#include "dialects/ir/control.h"
#include "dialects/ir/program.h"

namespace dripfeed::facts {

// What a code sets until another one of its group replaces it.
enum class Mode : std::uint8_t {
  feed,
  surface_speed,
  unit,
  distance,
  plane,
  diameter,
  motion,
  cycle,  // cycle_off: none is in effect; a drilling or turning cycle otherwise
  compensation,
  work_offset,  // of G54.1 with its P: extended_offset
  return_level,
  path,  // exact stop or continuous
  spindle,
  coolant,
  length,    // length_offset_off: no tool length is in effect; see tool_length()
  frame,     // none, or one about a point (G68, G51, G51.1) in effect
  letters,   // polar_words_on: the letters of the plane are a radius and an angle (G16)
  hole_end,  // return_to_initial or return_to_r: where a drilling cycle has left the tool
  // Setting::argument of these is the number of the statement that set them.
  thread_data,     // none, or the block of G76 that only states data
  peck_data,       // … of G74 or G75
  modal_call,      // none, or a call that each move makes
  transformation,  // none, or what makes the face or the circumference of a part a plane
  pole,            // of polar positions; none: where the control has it before the first one
  count_,
};
inline constexpr std::size_t kModes = static_cast<std::size_t>(Mode::count_);
constexpr std::size_t index_of(Mode mode) { return static_cast<std::size_t>(mode); }

struct Setting {
  ir::Function function = ir::Function::none;
  std::int32_t argument = 0;
  friend bool operator==(const Setting&, const Setting&) = default;
};

// Numbers. Positions are those of the program's coordinates, in its unit, an X of a lathe as it is written (a diameter
// or a radius). `shift_x` to `shift_z` are what G52 has set, as written. `length_number` is H, D or the offset of
// T0101.
enum class Number : std::uint8_t { length_number, shift_x, shift_y, shift_z, x, y, z, a, b, c, u, v, w, count_ };
inline constexpr std::size_t kNumbers = static_cast<std::size_t>(Number::count_);
inline constexpr Number kFirstAxis = Number::x;

// A word as it was written, or what takes its place before the first one.
struct Written {
  double number = 0.0;                              // where it is one
  ir::ExpressionId value = ir::ExpressionId::none;  // none: not a word of the text
  bool is_number = false;
  bool has_point = false;
  bool is_stated = false;
  bool by_distance = false;  // of a drilling cycle: counts from the level above

  friend bool operator==(const Written& a, const Written& b) {
    if (a.is_number != b.is_number || a.is_stated != b.is_stated || a.by_distance != b.by_distance) return false;
    return a.is_number ? a.number == b.number && a.has_point == b.has_point : a.value == b.value;
  }
};

// Words that stay in effect. `next_tool` is T, `tool` the one in the spindle (of T0101 the tool's number). `edge` is D
// where it selects an edge of the tool, not stated since the tool came in otherwise; G43 and G44 state one, too.
// `next_edge` is the D in the block of T. `feed` and `speed` are F and S, 0 before the first one; `surface_speed` is
// the S that constant surface speed has, `spindle_limit` the highest speed that a program states for it. A turning
// cycle keeps the ends of its block, as numbers of the program's coordinates, and its taper; a drilling cycle Z, R, Q,
// P, I and J. `initial` is the level where that one began: a number, or the name by which the tool was sent there.
// `at_x` to `at_z` are such names, where an axis stands at what a variable alone says.
enum class Kept : std::uint8_t {
  next_tool,
  tool,
  next_edge,
  edge,
  feed,
  speed,
  surface_speed,
  spindle_limit,
  turn_x,
  turn_z,
  turn_taper,
  drill_depth,
  drill_level,
  drill_peck,
  drill_dwell,
  drill_i,
  drill_j,
  initial,
  at_x,
  at_y,
  at_z,
  count_
};
inline constexpr std::size_t kKept = static_cast<std::size_t>(Kept::count_);

struct Facts {
  std::array<Known<Setting>, kModes> modes;
  std::array<Known<double>, kNumbers> numbers;
  std::array<Known<Written>, kKept> kept;

  Known<Setting>& operator[](Mode mode) { return modes[index_of(mode)]; }
  const Known<Setting>& operator[](Mode mode) const { return modes[index_of(mode)]; }
  Known<double>& operator[](Number number) { return numbers[static_cast<std::size_t>(number)]; }
  const Known<double>& operator[](Number number) const { return numbers[static_cast<std::size_t>(number)]; }

  Known<Written>& operator[](Kept word) { return kept[static_cast<std::size_t>(word)]; }
  const Known<Written>& operator[](Kept word) const { return kept[static_cast<std::size_t>(word)]; }

  void forget_all(std::uint32_t changer);
  void forget_positions(std::uint32_t changer);
  // What is left where two paths join; true when that is less than before.
  bool join(const Facts& with);
};

// H0, D0 and T0100 take it out as G49 does.
enum class ToolLength : std::uint8_t { off, on, unknown };
ToolLength tool_length(const Facts& facts);

// The mode that a code sets; nothing for a code that sets none of these. A code of G96 sets two where the control has
// one group for feed and surface speed: this is the one that it names.
std::optional<Mode> mode_of(const ir::Code& code);
// As the control begins a program; function `none` where only the machine knows.
Setting power_on(Mode mode, const ir::Control& control);
// The axis that a letter names; nothing for other addresses.
std::optional<Number> axis_of(ir::Address address);
// "feed per revolution", for messages.
std::string_view description_of(const Setting& setting);

}  // namespace dripfeed::facts
