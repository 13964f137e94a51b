// Statements: one entry per thing that a block says, in the order of the text. A line with an assignment and a move
// gives two statements of the same line. Each kind has its own arena in Program; `payload` is the index there.
#pragma once

#include <cstdint>
#include <limits>

#include "dialects/ir/expression.h"
#include "dialects/ir/function.h"
#include "dialects/ir/token.h"
#include "dialects/text/span.h"

namespace dripfeed::ir {

struct CalledCycle;

inline constexpr std::uint32_t kNoIndex = std::numeric_limits<std::uint32_t>::max();

// Addresses: single letters, and those with a name. `axis_*` numbering of the letters is by Control::axes.
enum class Address : std::uint8_t {
  a,
  b,
  c,
  d,
  e,
  f,
  g,
  h,
  i,
  j,
  k,
  l,
  m,
  n,
  o,
  p,
  q,
  r,
  s,
  t,
  u,
  v,
  w,
  x,
  y,
  z,
  arc_radius,     // CR=
  opening_angle,  // AR=
  spindle_limit,  // LIMS=
  polar_angle,
  polar_radius,    // AP=, RP=
  turns,           // TURN=
  chamfer,         // CHR=: along both sides of the corner
  chamfer_length,  // CHF=: of the edge that it makes
  rounding,        // RND=
  named_axis,      // AX[…]=: the axis that Word::axis gives
  via_i,
  via_j,
  via_k,           // I1=, J1=, K1=: the point in between of an arc
  modal_rounding,  // RNDM=
  frame_angle,     // RPL=
  measuring,       // MEAS=: a probe may end the move
  direct_angle,    // ,A: of the line that the block cuts, from the plane's first axis
  contour_offset,  // OFFN=: how far the compensated path lies from the programmed one
  block_feed,      // FB=: the feed of this block alone
  other_speed,     // S2= while a block runs: which spindle's, its code states (ir/other_spindle.h)
  point_weight,
  knot_distance,
  spline_degree,  // PW=, PL=, SD= of a spline
  poly_x2,
  poly_x3,
  poly_x4,
  poly_x5,
  poly_y2,
  poly_y3,
  poly_y4,
  poly_y5,
  poly_z2,
  poly_z3,
  poly_z4,
  poly_z5,  // POLY, PO[X]=(end, a2, a3 …): what stands before each power of the parameter; the end is X itself
  other,    // a named address that is kept as text: Word::name
  count_,
};

// A, B and C turn, U to Z go along; which of them a machine has is its control's to say.
constexpr bool is_rotary_axis(Address a) { return a <= Address::c; }
constexpr bool is_linear_axis(Address a) { return a >= Address::u && a <= Address::z; }
constexpr bool is_axis(Address a) { return is_rotary_axis(a) || is_linear_axis(a); }

enum class WordMode : std::uint8_t { as_modal, absolute, incremental };  // AC(), IC()

// Of a named word that moves nothing itself: a code of its line carries it out, it turns a spindle to an angle, or it
// is the feed of an axis that moves by itself.
inline constexpr std::uint8_t kCarriedOut = 1;
inline constexpr std::uint8_t kTurnsSpindle = 2;
inline constexpr std::uint8_t kPacesAxis = 3;

struct Word {
  Address address = Address::other;
  std::uint8_t extension = 0;  // S2=, M2=: 2; Address::other: see above
  WordMode mode = WordMode::as_modal;
  ExpressionId value = ExpressionId::none;  // a number or a string expression (T="NAME")
  StringId name = StringId::none;           // Address::other: as written
  ExpressionId axis = ExpressionId::none;   // Address::named_axis
  text::Span span;
};

constexpr Word word(Address address, ExpressionId value) {
  Word made;
  made.address = address;
  made.value = value;
  return made;
}

// A code of a block. A computed one (G#130, G[1]=…) has `number` and gets its function from the control's table while
// running.
struct Code {
  Function function = Function::none;
  std::int16_t argument = 0;
  ModalGroup group = ModalGroup::none;
  char letter = 'G';  // 'G' or 'M' for a computed one
  ExpressionId number = ExpressionId::none;
  StringId name = StringId::none;  // not_modelled, no_effect: as written, for the report
  text::Span span;
};

enum class StatementKind : std::uint8_t {
  empty,   // blank, comment only, tape mark, program number
  block,   // codes and words                       -> blocks
  assign,  // variable = expression                 -> assigns
  go_to,   // GOTO, GOTOF, GOTOB, IF … GOTO          -> jumps
  if_begin,
  else_begin,
  if_end,  // IF/ELSE/ENDIF, and IF … THEN statement (then `if_end` follows the statement)
  while_begin,
  while_end,
  repeat_begin,
  repeat_end,  // REPEAT … UNTIL condition
  for_begin,
  for_end,
  loop_begin,
  loop_end,           // DO n … END n without WHILE; LOOP … ENDLOOP      -> openers and closers share `structures`
  define,             // DEF: initialises its symbols          -> its range of symbols, in structures
  call,               // subprogram or macro                   -> calls
  procedure,          // PROC … (the head of a subprogram)     -> structures
  declaration,        // EXTERN: no effect while running
  subprogram_return,  // M99, M17, RET
  return_to,          // M99 P100: the jump in the caller that follows                     -> jumps
  modal_call,         // G66: the call is made after every block that moves               -> calls
  modal_call_end,     // G67
  output,             // DPRNT and what else writes to a device                            -> outputs
  program_end,        // M30, M02 as the block's last effect; with a payload: the code alone -> blocks
  message,            // MSG(…), (MSG …)                       -> messages
  alarm,              // #3000 = n(…), SETAL                   -> messages
  native,             // kept as text, effects declared or unknown -> natives
  repeat_section,     // REPEAT label …: the part is run again  -> repeats
  execute_text,       // EXECSTRING: a text as a block          -> messages
};

// Begins, splits or ends a control structure.
constexpr bool is_structure(StatementKind kind) {
  return kind >= StatementKind::if_begin && kind <= StatementKind::loop_end;
}

struct Statement {
  StatementKind kind = StatementKind::empty;
  std::uint8_t skip_level = 0;  // 0: no block skip; 1 is '/'
  bool is_label = false;        // it starts at a label: see Program::labels
  bool moves_follow = false;    // plain moves after it were not read: where the axes are then, no statement states
  std::uint32_t payload = kNoIndex;
  std::uint32_t line = 0;  // 1-based
  TokenRange tokens;       // the whole block's for its first statement, empty for those that follow it
  text::Span span;         // of this statement alone
};

// Ranges [first, first + count) of the arena of the same name.
struct Block {
  std::uint32_t first_code = 0;
  std::uint32_t code_count = 0;
  std::uint32_t first_word = 0;
  std::uint32_t word_count = 0;
  // "/n" inside the block: codes and words from here on are left out while switch n is on. 0: there is none.
  std::uint8_t rest_level = 0;
  std::uint32_t rest_begin = 0;  // offset in the text
};
inline bool in_rest(const Block& block, text::Span span) {
  return block.rest_level != 0 && span.begin >= block.rest_begin;
}

struct Assign {
  VariableId target = VariableId::none;
  ExpressionId value = ExpressionId::none;
};

// In which direction a jump looks for its label. `both` is GOTO: from here to the end, then from the top.
enum class JumpSearch : std::uint8_t { forward, backward, both };

struct Jump {
  ExpressionId condition = ExpressionId::none;  // none: always
  JumpSearch search = JumpSearch::both;
  bool tolerant = false;                       // GOTOC: a missing label goes on with the next block
  bool restart = false;                        // GOTOS: to the start of the program
  StringId label = StringId::none;             // a name
  std::uint32_t number = kNoIndex;             // a block number (N10), when `label` is none
  ExpressionId computed = ExpressionId::none;  // GOTO#1, when neither
  std::uint8_t levels = 1;                     // of a return: how many programs it leaves
};

// Openers and closers of structures: each knows its partner, so that nothing is searched while running.
struct Structure {
  ExpressionId condition = ExpressionId::none;  // if, while, until
  VariableId counter = VariableId::none;        // for
  ExpressionId first = ExpressionId::none;      // for
  ExpressionId last = ExpressionId::none;       // for
  std::uint8_t loop_number = 0;                 // DO m
  std::uint32_t partner = kNoIndex;             // statement index: begin -> else or end; else -> end; end -> begin
  std::uint32_t first_symbol = 0;               // define, procedure
  std::uint32_t symbol_count = 0;
  bool saves_modal = false;  // PROC … SAVE
};

enum class CallKind : std::uint8_t {
  subprogram,  // M98, L, name
  macro,       // G65: a new set of local variables
  external,    // M198: a subprogram of another device
};

struct Argument {
  char letter = 0;                          // G65 letters; 0: by position
  ExpressionId value = ExpressionId::none;  // none: left out
};

struct Call {
  CallKind kind = CallKind::subprogram;
  StringId name = StringId::none;              // as called: "O9010", "TURNING_CYCLE", "L100"; none: the program itself
  ExpressionId number = ExpressionId::none;    // P of M98/G65 when it is computed
  ExpressionId computed = ExpressionId::none;  // the name when it is a text that is computed
  ExpressionId repeats = ExpressionId::none;   // none: once
  ExpressionId start = ExpressionId::none;     // block number in the called program; none: its beginning
  ExpressionId first_label = ExpressionId::none;  // of a part of it, as texts; none: all of it
  ExpressionId last_label = ExpressionId::none;
  bool in_other_language = false;      // ISOCALL: the program begins in the control's other language
  const CalledCycle* cycle = nullptr;  // of the control (called_cycle.h); nullptr: a program of the user's own
  std::uint32_t first_argument = 0;
  std::uint32_t argument_count = 0;
};

struct Message {
  ExpressionId text = ExpressionId::none;    // none: MSG() clears
  ExpressionId number = ExpressionId::none;  // alarms
};

// POPEN, PCLOS and DPRNT. A part is a text, then a value in a field of digits.
enum class OutputKind : std::uint8_t { open, close, line };
struct OutputPart {
  StringId text = StringId::none;
  ExpressionId value = ExpressionId::none;
  std::uint8_t whole_digits = 0;
  std::uint8_t decimals = 0;
};
struct Output {
  OutputKind kind = OutputKind::line;
  std::uint32_t first_part = 0;
  std::uint32_t part_count = 0;
};

// Words that only one control understands. `reason` says what they are; unknown effects make every verdict unknown.
struct Native {
  StringId name = StringId::none;
  bool effects_known = false;  // declared to neither move nor change state
  bool moves = false;          // axes may be anywhere after it
  bool shifts = false;         // coordinates may lie elsewhere after it
  bool writes = false;         // to a file or a device, for others to read
  bool smooths = false;        // tolerance and smoothing: how the machine follows the path, not which path
  bool paces = false;          // along which axes feeds count: how fast it follows the path
};

// A part of the program that is run again: from the first label to where this stands, to the block of the last label
// or of the next ENDLABEL, or the first label's block alone.
struct Repeat {
  StringId first = StringId::none;
  std::uint32_t first_number = kNoIndex;  // N10, when `first` is none
  StringId last = StringId::none;
  std::uint32_t last_number = kNoIndex;
  bool one_block = false;                   // REPEATB
  ExpressionId times = ExpressionId::none;  // none: once
};

// One of several programs of a text: statements [first, last).
struct Section {
  StringId name = StringId::none;  // as calls name it: "O0012"
  std::uint32_t first = 0;
  std::uint32_t last = 0;
};

// Blocks in the other language of a control (SINUMERIK's ISO mode). The statements [first, last) keep them as written;
// `text` is what stands between the blocks that switch.
struct ForeignPart {
  std::uint32_t first = 0;
  std::uint32_t last = 0;
  text::Span text;
  bool ends_by_switch = false;  // the block after it switches back
};

struct Label {
  StringId name = StringId::none;   // a label, or none for a block number
  std::uint32_t number = kNoIndex;  // N10
  std::uint32_t statement = 0;      // index of the first statement of its block
  text::Span span;
};

}  // namespace dripfeed::ir
