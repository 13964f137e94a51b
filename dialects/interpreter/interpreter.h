// dialects/interpreter: runs a program. IR is compiled to register bytecode, a virtual machine executes it, every block
// goes through the one `apply` that keeps the modal state, and motions come out in batches. Arithmetic is defined here
// once and follows ir::Semantics. What reading, checking, timing or printing means is left to others; nothing here
// knows which control it runs.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "dialects/ir/ir.h"
#include "dialects/ir/plain_batch.h"
#include "dialects/ir/plain_stretch.h"
#include "dialects/text/diagnostic.h"

namespace dripfeed::interpreter {

// Called programs by name, as the call writes it: "O9010", "TURNING_CYCLE", "L100". Asked once a call site.
class ProgramFinder {
 public:
  ProgramFinder() = default;
  ProgramFinder(const ProgramFinder&) = delete;
  ProgramFinder& operator=(const ProgramFinder&) = delete;
  virtual ~ProgramFinder() = default;
  // nullptr: there is none. What it returns must live until the run has ended.
  virtual const ir::Program* find(std::string_view name) = 0;
  // A program that is called in the control's other language (ISOCALL), and begins in it unless its text says
  // otherwise.
  virtual const ir::Program* find_foreign(std::string_view) { return nullptr; }
  // The foreign parts of a program, read in the other language: a text of the same length, with blanks for the rest,
  // and the control as it is in that language. nullptr when no reader can read them.
  struct ForeignText {
    const ir::Program* program = nullptr;
    const ir::Control* control = nullptr;
  };
  virtual ForeignText foreign_text(const ir::Program&) { return {}; }
  // A text that a program wants executed (EXECSTRING), read in its own language; nullptr when no reader can.
  virtual std::unique_ptr<ir::Program> read_text(std::string_view) { return nullptr; }
};
// A finder that finds nothing.
ProgramFinder& no_programs();

// Passing one ends the run with Ended::limit and a diagnostic. The control's own limits (nesting of calls) are alarms
// and stand in ir::ControlLimits.
struct Limits {
  std::uint64_t blocks = 100'000'000;       // executed
  std::uint64_t loop_passes = 100'000'000;  // jumps back, calls and repeats of calls
  std::uint32_t call_depth = 64;            // programs above the main one
  std::uint32_t variables = 1U << 20;       // slots of declared names in one program, arrays counted by element
  std::uint32_t strings = 1U << 20;         // distinct texts of messages and tool names
  std::uint64_t motions = 1'000'000'000;    // made, whether by a block, a cycle, a curve or a corner
  std::size_t kept_motions = 1'000'000;     // that wait for a later block (a shape, a spline, a corner): 256 bytes each
  std::size_t texts = 10'000;               // distinct ones that are executed (EXECSTRING)
};

// A variable's value before the start: of a state file, or an override. `name` for bank `named` (a DEF or parameter of
// the main program, otherwise global data; with its indices: "INI[53]") and `system` ("$A_IN[1]", axes by their
// letters), `number` otherwise. Declarations with a value still set theirs.
struct InitialValue {
  ir::Bank bank = ir::Bank::hash;
  std::uint32_t number = 0;
  std::string name = {};
  double value = 0.0;
};

// Names that the numbers of a run stand for. Given to `run`, it grows while running, so that a sink can look up what
// it is handed.
struct RunNames {
  std::vector<std::string> strings;    // Motion::text
  std::vector<std::string> programs;   // Place::program; 0 is the main one
  std::vector<std::string> variables;  // VariableChange::variable
};

struct VariableChange {
  std::uint32_t variable = 0;  // index into RunNames::variables
  double value = 0.0;          // NaN: vacant
};

// Hears of every executed block. Blocks come in order, but motions are handed over in batches: join them by
// Place::ordinal (a motion sees the changes of all ordinals up to its own).
class BlockObserver {
 public:
  BlockObserver() = default;
  BlockObserver(const BlockObserver&) = delete;
  BlockObserver& operator=(const BlockObserver&) = delete;
  virtual ~BlockObserver() = default;
  // `changes`: what the block assigned, in order; valid during the call only. Strings are not reported.
  virtual void block(const ir::Place& place, std::span<const VariableChange> changes) = 0;
};

struct ModalState;  // modal_state.h
class StateObserver;

// Of which assignments an observer learns: of none, but still of the blocks; of all but those to elements of arrays.
enum class Changes : std::uint8_t { none, scalars, all };

struct RunOptions {
  Limits limits;
  std::vector<InitialValue> initial_values;
  std::uint32_t skip_switches = 0;    // block skip: bit n is on for "/n", bit 1 for "/"
  bool want_variables = false;        // fill RunResult::variables
  BlockObserver* observer = nullptr;  // costs time when set
  Changes changes = Changes::all;     // for the observer
  StateObserver* states = nullptr;    // costs time when set; not of plain blocks that are run while they are read
  RunNames* names = nullptr;          // filled while running; nullptr: only RunResult has them
  bool every_order = false;           // events of what is ordered again, too: ir::kOrders…
  // Names a budget of the caller's that is used up ("60 s"), which ends the run as passing one of the limits does; ""
  // while there is some left. Asked every few thousand motions, blocks and passes of loops. May be empty.
  std::function<std::string()> used_up = {};
  const ir::PlainStretches* stretches = nullptr;  // that the program was read without; nullptr: none
};

// How a run ended: by the program's end, an alarm, one of Limits, or the end of the text without a program end.
enum class Ended : std::uint8_t { end, alarm, limit, text_end };
// "end", "alarm", "limit", "text_end"
std::string_view name_of(Ended ended);

// A variable after the run, named as the control writes it: "#100", "R5", "COUNTER", "A[3]".
struct VariableValue {
  std::string name;
  std::optional<double> value;      // none: vacant, or a string
  std::optional<std::string> text;  // of string variables
};

// What is known where a block begins, before anything of it is done. Valid during the call only.
struct BlockBegin {
  const ir::Place& place;
  const ModalState& state;
  bool in_main;     // not in a called program, a text that is executed or the shape of a cycle
  bool modal_call;  // G66, MCALL in effect
  bool guessed;     // the program took a branch that a value decides which is not known
};
class StateObserver {
 public:
  StateObserver() = default;
  StateObserver(const StateObserver&) = delete;
  StateObserver& operator=(const StateObserver&) = delete;
  virtual ~StateObserver() = default;
  // True: variables() is to follow, which only a block of the main program has.
  virtual bool begin(const BlockBegin& block) = 0;
  // As RunResult::variables, at this place.
  virtual void variables(std::vector<VariableValue> values) = 0;
};

struct RunDiagnostic {
  std::uint32_t program = 0;  // index into RunResult::programs
  std::uint32_t line = 0;     // 1-based; for programs without text, too
  text::Diagnostic diagnostic;
};

// A code, a word or native words that were met and not carried out, or a value that was needed and is not known, once a
// name.
struct NotInterpreted {
  std::string name;
  std::uint32_t program = 0;
  std::uint32_t first_line = 0;
  std::uint64_t count = 0;  // how often it was executed
  ir::Function function = ir::Function::not_modelled;
  bool effects_known = false;  // known to neither move nor change what is modelled
  bool is_input = false;       // a value that was not given: "INI[53]", "$A_IN[1]", "R5"
  bool is_model = false;       // moves were made for it in an order of our own: the control's is not documented
};

// A code whose number was computed (G#130, M[#1+1]) and what it came to, once a function.
struct ComputedCodeUse {
  std::string name;  // "M150"
  ir::Function function = ir::Function::none;
  std::uint32_t program = 0;
  std::uint32_t first_line = 0;
};

struct RunResult {
  std::uint64_t blocks = 0;   // executed; blank lines and comments do not count
  std::uint64_t motions = 0;  // moves, dwells and events handed to the sink
  Ended ended = Ended::end;
  std::vector<RunDiagnostic> diagnostics;  // an alarm or a passed limit is the last
  std::vector<std::string> strings;        // Motion::text
  std::vector<std::string> programs;       // Place::program
  std::vector<VariableValue> variables;    // those that the program names or that have a value, by bank and number
  std::vector<NotInterpreted> not_interpreted;
  std::vector<ComputedCodeUse> computed_codes;
  ir::Place last;  // the last block that was executed
};

// Runs `program` on `control` until it ends. Motions go to `sink` in batches, all of them before this returns. Reads no
// clock and no file; the only thing that fails is the program, and then the result says where and with which alarm of
// the control.
RunResult run(const ir::Program& program, const ir::Control& control, ProgramFinder& finder, ir::MotionSink& sink,
              const RunOptions& options);

// A program that is run while it is read: plain blocks in batches, and once a block is met that is not plain, the whole
// program, in which the run goes on there.
class PlainStream {
 public:
  PlainStream() = default;
  PlainStream(const PlainStream&) = delete;
  PlainStream& operator=(const PlainStream&) = delete;
  virtual ~PlainStream() = default;
  // nullptr: no plain block follows. The batch is valid until the next call.
  virtual const ir::PlainBatch* next() = 0;
  struct Rest {
    const ir::Program* program = nullptr;  // nullptr: nothing is left
    std::uint32_t offset = 0;              // of the block to go on with
    bool broken = false;                   // there is more, but it cannot be read: an alarm without a diagnostic
  };
  // Asked once, after next() gave nullptr.
  virtual Rest rest() = 0;
  [[nodiscard]] virtual std::string_view name() const = 0;
};

// As above, with the same result as for the program read whole. No observer: it would learn of blocks too late.
RunResult run(PlainStream& stream, const ir::Control& control, ProgramFinder& finder, ir::MotionSink& sink,
              const RunOptions& options);

}  // namespace dripfeed::interpreter
