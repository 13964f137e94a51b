// What a program is compiled to: instructions on registers, and the tables that they point into. Data only; compile.cpp
// makes it, the machine runs it.
//
// An operand is a register: its space in the two low bits, its index above. Numbers live in four spaces: variables of
// the run (#100, R5), the frame of the running program (declared names, then temporaries), the local set (#1-#33), and
// the program's constants. Strings live in frames and constants of their own.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <unordered_map>
#include <vector>

#include "dialects/interpreter/state/motion_buffer.h"
#include "dialects/interpreter/state/plain_block.h"
#include "dialects/ir/called_cycle.h"
#include "dialects/ir/control.h"
#include "dialects/ir/program.h"
#include "dialects/text/diagnostic_id.h"
#include "dialects/text/span.h"

namespace dripfeed::interpreter {

enum class Space : std::uint32_t { global, frame, local, constant };
enum class Operand : std::uint32_t { none = 0xFFFFFFFFU };
constexpr Operand make_operand(Space space, std::uint32_t index) {
  return static_cast<Operand>((index << 2) | static_cast<std::uint32_t>(space));
}
constexpr Space space_of(Operand operand) { return static_cast<Space>(static_cast<std::uint32_t>(operand) & 3U); }
constexpr std::uint32_t index_of(Operand operand) { return static_cast<std::uint32_t>(operand) >> 2; }
constexpr std::uint32_t raw_of(Operand operand) { return static_cast<std::uint32_t>(operand); }
// The register after another one of the same space.
constexpr std::uint32_t next_register(std::uint32_t operand) { return operand + 4; }

// `a` is what is written unless said otherwise; `extra` a small enum; targets are instruction indices.
enum class Opcode : std::uint8_t {
  copy,  // a = b
  // Double precision only; a result out of range or not a number takes the slow path.
  add,
  subtract,
  multiply,
  divide,
  sin,
  cos,
  sqrt,
  // Exact comparisons.
  equal,
  not_equal,
  less,
  less_equal,
  greater,
  greater_equal,
  // Any operator by the rules of Arithmetic; extra: ir::Operator.
  unary,
  binary,
  integer_quotient,
  bound,        // a = BOUND(b, b + 1, b + 2) of three registers in a row
  negate_word,  // a = -b, vacant stays vacant
  count,        // a = b counted in least increments: an argument that was written without a point
  convert,      // a = b as extra: ir::ValueType
  // Variables by computed number or index. Indices of arrays stand in three registers in a row.
  load_number,     // a = variable number b of bank extra
  store_number,    // variable number a of bank extra = b
  load_element,    // a = array b [c …]
  store_element,   // array a [b …] = c
  load_of_row,     // a = array b [c], which has one dimension
  store_in_row,    // array a [b] = c
  fill_array,      // every element of array a = b
  load_reference,  // a = what frame register b refers to
  store_reference,
  refer,          // a = a reference to register b
  refer_number,   // a = … to variable number b of bank extra
  refer_element,  // a = … to array b [c …]
  load_system,    // a = row b of the system table, number or index c
  store_system,   // row a, number or index b = c
  // Data of the control by name; extra: how many indices stand in registers in a row; detail: 0, or one more than the
  // row of the system table.
  load_shared,       // a = name b [c …]
  store_shared,      // name a [b …] = c
  load_shared_text,  // … as a text
  store_shared_text,
  refer_shared,  // a = a reference to name b [c …]
  // Strings: string registers, but for results that are numbers.
  string_copy,         // a = b
  string_join,         // a = b << c
  string_from_number,  // a = number b as extra: ir::ValueType
  string_to_number,    // number a
  string_is_number,    // number a
  string_to_axis,      // number a: the axis of a name
  string_to_value,     // number a as extra: ir::ValueType, of CHAR or BOOL
  string_length,       // number a
  string_upper,
  string_lower,
  string_find,   // number a = place of c in b; extra: ir::Operator
  string_part,   // a = of text b from number c, number c + 1 characters
  axis_name,     // text a = name of axis b
  string_equal,  // number a = (b == c)
  string_load_element,
  string_store_element,
  string_fit,  // a = b when it has at most c characters, otherwise an alarm
  // Frames: registers that hold the number of one
  frame_make,      // a = the frame of axis b and value c; extra: ir::Operator
  frame_chain,     // a = b : c
  frame_part,      // a = part of frame b; axis and part in registers c, c + 1
  frame_set_part,  // frame a with part c, of axis and part in registers b, b + 1
  load_frame,      // a = frame b of the control; extra: ir::SystemValue
  store_frame,     // frame b of the control = a
  // Flow
  block,           // a block begins: line a, work b
  jump,            // to a; c: 1 when it is one of the program's, not a part of a structure
  jump_back,       // to a, counts as a pass; c as above
  branch_false,    // to b unless a holds; extra 1: also when it is not known whether it does
  jump_number,     // to the block whose number is a; extra: JumpSearch; c: 1 when a missing target is passed over
  jump_text,       // to the label in string a; as above
  repeat_section,  // back to a, number b times; section c
  section_end,     // of section c: to a when it is being repeated
  execute_text,    // string a as a block
  foreign_part,    // part a in the control's other language; after it, to b
  plain_stretch,   // number a of the program
  apply,           // block template a
  call,            // call site a
  modal_call,      // from here on call site a after each block that moves, number b times
  modal_end,
  passes,      // an alarm unless number a is one that a program can run
  skip_given,  // to b when parameter a was given
  load_given,  // a: whether parameter b was given; not known where the program runs by itself
  back,        // of a subprogram, and of a further ones; b 1: from a foreign part, to the program that it stands in
  back_to,     // … to the block with number a in the caller, and of b further ones
  program_end,
  text_end,
  message,  // string a, or none: clear
  output,   // outputs a of the program; b: the first of the parts' registers
  alarm,    // number a (or none), string b (or none)
  fail,     // failure a: an alarm that was seen while compiling
  report,   // report a: something that is not interpreted; b 1: axes may be anywhere after it
  // For an observer
  report_variable,  // register a has a new value; b: name
  report_number,    // variable number a of bank extra is now b
  report_element,   // array a [b …] is now c
};

struct Instruction {
  Opcode op = Opcode::text_end;
  std::uint8_t extra = 0;
  std::uint16_t detail = 0;
  std::uint32_t a = 0;
  std::uint32_t b = 0;
  std::uint32_t c = 0;
};
static_assert(sizeof(Instruction) == 16);

// `b` of Opcode::text_end: the program needs no code that ends it.
inline constexpr std::uint32_t kNothingMissing = 1;

// --- blocks
// -----------------------------------------------------------------------------------------------------------

inline constexpr std::uint8_t kWordInIncrements = 1;
inline constexpr std::uint8_t kWordAbsolute = 2;
inline constexpr std::uint8_t kWordIncremental = 4;
inline constexpr std::uint8_t kWordNumbered = 8;

struct TemplateWord {
  double value = 0.0;
  ir::Address address = ir::Address::other;
  std::uint8_t flags = 0;
};
struct ComputedWord {
  Operand operand = Operand::none;
  Operand axis = Operand::none;  // Address::named_axis
  ir::Address address = ir::Address::other;
  std::uint8_t flags = 0;
  bool is_string = false;
};
struct ComputedCode {
  Operand operand = Operand::none;  // the code's number
  char letter = 'G';
};
// The parts of a block that not every block has: ranges of the tables of the same name.
struct BlockExtra {
  std::uint32_t first_word = 0;
  std::uint32_t word_count = 0;
  std::uint32_t first_code = 0;
  std::uint32_t code_count = 0;
  std::uint32_t first_report = 0;
  std::uint32_t report_count = 0;
};
struct BlockTemplate {
  std::uint32_t first_word = 0;
  std::uint32_t first_code = 0;
  std::uint32_t extra = 0xFFFFFFFFU;  // none
  std::uint16_t word_count = 0;
  std::uint16_t code_count = 0;
};

// --- calls
// ------------------------------------------------------------------------------------------------------------

struct CompiledProgram;

struct CallArgument {
  Operand value = Operand::none;      // none: left out
  Operand reference = Operand::none;  // to the variable that it is, for a parameter by reference
  Operand text = Operand::none;       // data of the control as a text, for a parameter that is one
  bool is_string = false;
  std::uint32_t local = 0;  // macro: number of the local variable
};
struct CallSite {
  ir::CallKind kind = ir::CallKind::subprogram;
  std::string name;
  Operand number = Operand::none;            // computed; the name is then "O" and four digits
  Operand start = Operand::none;             // block number where it begins
  bool itself = false;                       // the calling program, from its block `start`
  bool in_other_language = false;            // … of the control
  bool cuts_contour = false;                 // a cycle that runs the blocks of its contour
  const ir::CalledCycle* milling = nullptr;  // a milling cycle
  Operand text = Operand::none;              // the name is a text that is computed
  Operand first_label = Operand::none;       // of the part that is called, as texts
  Operand last_label = Operand::none;
  std::uint32_t first_argument = 0;
  std::uint32_t argument_count = 0;
  CompiledProgram* target = nullptr;  // once it was looked up
};

struct Parameter {
  std::uint32_t slot = 0;  // of the frame, or of the string frame
  ir::ValueType type = ir::ValueType::real;
  bool by_reference = false;
};

// --- variables, reports
// -----------------------------------------------------------------------------------------------

struct Array {
  std::uint32_t first_slot = 0;
  std::uint32_t dimension1 = 0;
  std::uint32_t dimension2 = 1;
  std::uint32_t dimension3 = 1;
  ir::ValueType type = ir::ValueType::real;
  ir::SymbolId symbol = ir::SymbolId::none;
};

inline constexpr std::uint32_t kNoArray = 0xFFFFFFFFU;
struct SymbolSlot {
  std::uint32_t slot = 0;  // strings: of the string frame
  std::uint32_t array = kNoArray;
};

struct Failure {
  text::DiagnosticId id = text::DiagnosticId::count_;
  std::vector<std::string> arguments;
  ir::AlarmDetail detail = ir::AlarmDetail::none;
};
// Bits of a report's second operand, of what the control then does.
inline constexpr std::uint32_t kReportMoves = 1;   // axes may be anywhere
inline constexpr std::uint32_t kReportShifts = 2;  // coordinates may lie elsewhere
struct Report {
  std::string name;
  ir::Function function = ir::Function::not_modelled;
  bool effects_known = false;
  bool is_input = false;  // a value that the control or its surroundings hold
  bool is_model = false;  // moves that stand for a strategy of the control's own
};

class BlockRules;
struct CompiledProgram {
  const ir::Program* source = nullptr;
  std::uint32_t section = 0;  // of the source
  std::uint32_t index = 0;    // RunNames::programs
  std::vector<Instruction> code;
  std::vector<text::Span> spans;  // of the instruction of the same index
  std::vector<double> constants;
  std::vector<std::string> texts;
  std::vector<Work> works;

  std::vector<BlockTemplate> blocks;
  std::vector<TemplateWord> words;
  std::vector<PlainCode> codes;
  std::vector<BlockExtra> extras;
  std::vector<ComputedWord> computed_words;
  std::vector<ComputedCode> computed_codes;
  std::vector<std::uint32_t> block_reports;  // indices of reports

  std::vector<CallSite> calls;
  std::vector<CallArgument> arguments;
  std::vector<Array> arrays;
  std::vector<SymbolSlot> symbols;  // as ir::Program::symbols
  std::vector<Failure> failures;
  std::vector<Report> reports;

  bool keeps_place = false;           // what it does is done by the block that calls it
  bool is_text = false;               // runs in the frame of the program that has it executed
  bool is_foreign = false;            // in the control's other language
  const BlockRules* rules = nullptr;  // by which its blocks are understood
  bool has_procedure = false;
  bool saves_modal = false;
  std::vector<Parameter> parameters;
  std::uint32_t declared_slots = 0;  // of the frame, cleared at a call; temporaries follow
  std::uint32_t declared_strings = 0;
  std::uint32_t frame_slots = 0;
  std::uint32_t string_slots = 0;

  // Instruction indices of the blocks with that number or label, in order.
  std::unordered_map<std::uint32_t, std::vector<std::uint32_t>> numbers;
  std::unordered_map<std::string, std::vector<std::uint32_t>> labels;
  // References used by the program: numbers of variables that it names, for the listing.
  std::vector<std::pair<ir::Bank, std::uint32_t>> named_variables;
};

}  // namespace dripfeed::interpreter
