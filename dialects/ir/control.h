// A control: what it can do, what it calls things, how it calculates and what a block costs it. Tables are static spans
// owned by the dialect; a machine's profile copies the struct and overrides single fields.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "dialects/ir/cost_model.h"
#include "dialects/ir/expression.h"
#include "dialects/ir/function.h"
#include "dialects/ir/semantics.h"
#include "dialects/ir/shared_definitions.h"
#include "dialects/text/diagnostic.h"

namespace dripfeed::ir {

enum class MachineKind : std::uint8_t { mill, lathe, mill_turn };
// By MachineKind.
inline constexpr std::array<std::string_view, 3> kMachineKindNames = {"mill", "lathe", "mill-turn"};
constexpr std::string_view name_of(MachineKind kind) { return kMachineKindNames[static_cast<std::size_t>(kind)]; }
// Whether a machine makes what was written for a kind: a mill-turn center turns like a lathe. It does not mill like a
// mill: its X is a diameter and its plane is that of turning.
constexpr bool serves(MachineKind machine, MachineKind wanted) {
  return machine == wanted || (machine == MachineKind::mill_turn && wanted == MachineKind::lathe);
}
enum class GSystem : std::uint8_t { a, b, c };  // of lathes

// A consecutive range of variables that the control has.
enum class VariableUse : std::uint8_t { local, common, permanent, system };
struct VariableRange {
  Bank bank = Bank::hash;
  std::uint32_t first = 0;
  std::uint32_t last = 0;
  VariableUse use = VariableUse::common;
  bool writable = true;
};

// A system variable by name (bank `system`) or number range; `kind` says what the interpreter answers.
enum class SystemValue : std::uint8_t {
  not_modelled,
  end_position,
  machine_position,
  work_offset_value,
  skip_position,  // where G31 ended
  feed,
  spindle_speed,
  tool_number,
  comp_number,
  length_number,  // D, H
  block_number,
  program_number,
  active_code,
  clock_ms,
  clock_hours,
  selected_tool,
  tool_edge,
  spindle_direction,
  constant,  // SystemVariableRow::first
  programmable_frame,
  base_frame,           // in effect
  base_frame_in_data,   // in memory: the next selection of a work offset takes it
  settable_frame,       // in memory, by number
  active_frame,         // the settable one in effect
  total_frame,          // the settable one and the programmable one in it
  call_argument,        // of the last macro call; SystemVariableRow::first is the number of its local variable
  call_argument_given,  // … 1 when it was given
  parameter_given,      // whether the program's parameter of that number was given
  changing,             // the control, the PLC or time changes it: what a program wrote is not what it reads
  tool_type,            // of a cutting edge, by the numbers of tool and edge; 0 deletes it
  tool_length,          // … of a mill along the spindle
  tool_radius,
};
// What programs write one for.
enum class SystemUse : std::uint8_t {
  other,
  memory,  // the program's own numbers, as in a common variable
  output,  // to the PLC, the machine or its outputs
};
struct SystemVariableRow {
  std::string_view name;    // "$P_EP"; empty for numbered ones
  std::uint32_t first = 0;  // #5001
  std::uint32_t last = 0;
  SystemValue kind = SystemValue::not_modelled;
  bool writable = false;
  std::string_view reference;
  bool inert = false;                 // writing it neither moves nor changes what is modelled
  std::uint32_t extended_offset = 0;  // of work_offset_value: `first` is of this P of G54.1; 0: of no such
  SystemUse use = SystemUse::other;
};

// Which of several alarms that a control has for one diagnostic.
enum class AlarmDetail : std::uint8_t {
  none,
  if_statement,
  while_statement,
  jump_number,  // GOTO to a number that no block can have
  two_signs,
  opening_bracket,
  closing_bracket,
  code_as_argument,
  subprogram_in_drip,  // M198 or M99 P while the program is fed
  macro_call,          // nesting of macros, not of subprograms
  macro_program,       // a macro call without its program
  if_nesting,
  inverse_time,      // no feed in a block of G93
  second_call,       // M98 twice in a block
  reference_check,   // G27
  axis_moves,        // between a rigid tap's M29 and its cycle
  plane_changes,     // … or in it
  ends,              // compensation, not its start
  by_name,           // a call by a file's name
  block_of_call,     // the block number that M98 Q, M98 H or M99 P names
  second_type,       // arguments I J K of more than ten sets
  name_statement,    // SETVN
  output_statement,  // DPRNT, BPRNT
  unknown_word,      // a name that no function has
  axis_letter,       // the letter of an axis that the machine lacks
  tap,               // a tapping cycle's feed
  thread,            // the lead of a thread; a corner in one
  no_shape,          // G70 to G73 without P or Q
  depth_of_pass,     // … with none
  call_in_shape,     // … a code that may not stand in the shape
  two_corners,       // ,C and ,R in one block
  value_of_data,     // G10 with a value that no offset takes
  small_radius,      // of an arc: less than half its chord
  order_of_curve,
  in_face,          // a code in polar interpolation, not in cylindrical
  first_point,      // of a curve: not where the tool is
  whole_numbers,    // too large for an integer
  write_only,       // a variable that only takes values
  program_number,   // 0 of a program, not of a block
  block_number,     // … too large for a block
  with_return,      // words in the block of M99
  second_macro,     // G65 twice in a block
  second_device,    // M198 in what M198 called
  name_characters,  // of a name that SETVN gives
  name_in_use,      // … that stands in an expression
  condition_end,    // ENDIF without IF
  missing_comma,
  code_in_drip,      // a code that is refused while the program is fed
  kind_of_data,      // L of G10
  number_of_preset,  // of machining conditions
  surface_axis,      // P of G96
  parallel_axes,     // of one direction, in the choice of a plane
  speed_in_tap,      // S while a synchronous tap is in effect
  not_a_line,        // after a corner of a lathe
  tapered,           // … in both axes
  last_of_shape,     // a corner in the last block of a turning cycle's shape
  next_move,         // the one after a corner
  no_end_point,      // two angles, and no end after them
  not_an_end,        // an end that the angle does not lead to
  skip,              // a move that a signal ends
  with_tool,         // a tool or its offset in the block that measures it
  without_offset,    // … and none before it
  below,             // the travel
  above,
  position,  // a coordinate too large to count
};
struct AlarmRow {
  text::DiagnosticId id;
  std::string_view alarm;  // "PS0124", "14080"
  AlarmDetail detail = AlarmDetail::none;
};

// A fault that is one only for want of what may exist next to the program: definition files, programs, cycles, options.
// It is a warning, and says what would settle it.
struct OutsideRow {
  text::DiagnosticId id;
  std::string_view settled_by;
  bool profile_settles = false;  // a named machine knows: then it is a fault
};

// 0 means: no limit.
struct ControlLimits {
  std::uint32_t block_length_bytes = 0;
  std::uint32_t digits = 8;  // of one number
  std::uint32_t expression_nesting = 5;
  std::uint32_t loop_nesting = 3;
  std::uint32_t condition_nesting = 0;
  std::uint32_t call_nesting = 4;
  std::uint32_t macro_nesting = 4;
  std::uint32_t name_length = 31;
  std::uint32_t shape_blocks = 0;  // of a turning cycle
  std::uint32_t axes_at_once = 0;  // that one block moves
  int linear_decimals = 3;         // digits after the point that an axis word resolves
};

// A code that the machine's parameters turn into a call of a program.
struct CodeCall {
  char letter = 'G';
  std::int32_t number10 = 0;  // as CodeRow
  std::uint32_t program = 0;
  bool macro = true;  // the block's words are arguments; otherwise as by M98
};

// A line that says which G-code system a lathe's program is written in.
struct SystemEvidence {
  GSystem system = GSystem::a;
  std::uint32_t line = 0;  // 0: none
  std::string code;        // "G50 S"
};

// A cutter of the machine, for cycles whose path depends on it.
struct ToolRadius {
  std::int32_t tool = 0;
  std::int32_t offset = 0;  // D; 0: of any
  double radius_mm = 0.0;
};
// … and how far its tip stands before the spindle.
struct ToolLength {
  std::int32_t tool = 0;
  std::int32_t offset = 0;
  double length_mm = 0.0;
};
// Of T="MILL_D10".
struct ToolName {
  std::string name;
  std::int32_t tool = 0;
};

struct Control {
  std::string dialect;  // "fanuc", "sinumerik-840d"
  std::string title;    // as people say it: "Fanuc 0i-TF"
  MachineKind kind = MachineKind::mill;
  GSystem g_system = GSystem::a;
  std::string axes = "XYZ";  // letters in the order of the trace: X Y Z A B C U V W
  Semantics semantics;
  ControlLimits limits;
  CostModel cost;
  std::span<const CodeRow> g_codes;  // sorted by number10
  std::span<const CodeRow> m_codes;
  std::span<const SystemVariableRow> system_variables;
  std::span<const AlarmRow> alarms;
  std::span<const OutsideRow> outside;
  std::vector<VariableRange> variables;
  bool variables_stated = false;     // a profile gives them all
  std::vector<CodeCall> code_calls;  // machine
  // M functions of the machine, by number, besides those of the table; empty: any may be.
  std::vector<std::uint16_t> machine_functions;
  // Codes that are in effect where a program starts: for subprograms that are taken without their caller. They stand
  // before power-on; rows of `g_codes`.
  std::vector<CodeRow> caller_modes;
  std::vector<std::string> definition_files;        // programs that declare global data, by name; read before a run
  std::shared_ptr<const SharedDefinitions> shared;  // what those declare, as far as they were found
  // Of the machine's tools, as far as its profile states them. Names are sorted.
  std::vector<ToolRadius> tool_radii;
  std::vector<ToolLength> tool_lengths;
  std::vector<ToolName> tool_names;
  bool from_profile = false;  // a named machine: what it leaves unconfirmed is an error, not a warning
  // Two lines of the text that name different G-code systems, when no machine was named: then neither is certain.
  std::vector<SystemEvidence> contradiction;
  // Why the control was taken for this one, when no machine was named: the line that decided, 0 for the default.
  std::uint32_t because_line = 0;
};

// nullptr when the table has no such number. `number10` is ten times the written number.
const CodeRow* find_code(std::span<const CodeRow> table, std::int32_t number10);
// The control's own alarm for a diagnostic, "" when it has none.
// … with that detail, or without one where the control makes no difference.
std::string_view alarm_of(const Control& control, text::DiagnosticId id, AlarmDetail detail = AlarmDetail::none);
// "M29" of that number.
std::string name_of_machine_function(int number);
// Whether an M function of the machine is known to move no axis and to change nothing that is modelled: M29 of rigid
// tapping, and those that the profile lists.
bool is_known_machine_function(const Control& control, int number);
// How the control spells the system variable with that value; empty when it has none, or only a number.
std::string_view name_of_system(const Control& control, SystemValue value);
// The number of the tool that programs call by this name; 0: the profile has none such. The control distinguishes
// capital letters in names of tools alone (SINUMERIK NC programming, "Structure and contents of an NC program").
std::int32_t tool_of_name(const Control& control, std::string_view name);
// What the system variable with that row is written for.
SystemUse use_of_system(const Control& control, std::uint32_t row);
// The range that holds the variable; nullptr when the control has no such variable.
const VariableRange* find_variable(const Control& control, Bank bank, std::uint32_t number);
// Whether a machine may have that variable although the control's usual ranges have not: by an option, or made by the
// machine's builder. Numbers from 34 to 99 are left free by every control.
bool may_have_variable(const Control& control, Bank bank, std::uint32_t number);
// Whether its variables are numbers after a # (Fanuc, Mazak, Mitsubishi). Such a control jumps to the value of one,
// too, and knows no names and no parts to repeat.
bool has_numbered_variables(const Control& control);

// A diagnostic with the control's alarm next to it, a warning where what exists next to the program decides.
text::Diagnostic diagnose(const Control& control, text::DiagnosticId id, text::Span span,
                          std::vector<std::string> arguments = {}, AlarmDetail detail = AlarmDetail::none);

}  // namespace dripfeed::ir
