// The explicit form of any program: it is run, and what it did is written down as plain blocks with constants, in the
// terms of a neutral control. Loops, jumps, calls, cycles, shifts, inches and increments are gone; what remains is one
// block a motion or event. Raising it to a control and printing it is left to the callers.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "dialects/compile/dialect/run_texts.h"
#include "dialects/compile/plain/position_runs.h"
#include "dialects/interpreter/interpreter.h"
#include "dialects/ir/control.h"
#include "dialects/ir/program.h"

namespace dripfeed::compile {

// Where a block of the explicit program came from.
struct BlockOrigin {
  std::uint32_t line = 0;     // of the main program
  std::uint64_t ordinal = 0;  // of the executed block
};

// A variable got a value. In the order of execution.
struct LoggedChange {
  std::uint64_t ordinal = 0;
  interpreter::VariableChange change;
};

struct ExplicitProgram {
  // Statement::line of it is 1 + the index into `origins`; 0 for what stands at its head.
  ir::Program program;
  ir::Control control;  // that `program` is written for
  std::vector<BlockOrigin> origins;
  text::Source source;                      // of what was run; empty for a program that was built
  std::vector<LoggedChange> changes;        // filled when wanted
  std::vector<std::string> variable_names;  // VariableChange::variable
  interpreter::RunResult run;               // with the diagnostics of running
  std::vector<text::Diagnostic> lost;       // errors: words of executed blocks that plain blocks would not have
};

// What is written down is held whole, so a run that would go on for ever (M99 at the end of a main program) ends with
// limit_reached while there is memory: two million blocks take about 3 GB. A block may hold a million pecks.
inline constexpr interpreter::Limits kWrittenLimits{
    .blocks = 2'000'000, .loop_passes = 2'000'000, .motions = 4'000'000};

// Where runs go to a sink: fifty million blocks are about 1 GB of text.
inline constexpr interpreter::Limits kStreamedLimits{
    .blocks = 50'000'000, .loop_passes = 50'000'000, .motions = 100'000'000};

struct ExplicitOptions {
  interpreter::Limits limits = kWrittenLimits;
  std::vector<interpreter::InitialValue> initial_values;
  bool want_changes = false;
  // Of a program whose taps are rigid whatever they are called (Semantics::taps_are_rigid): each stays a cycle, because
  // the control turns the spindle with it.
  bool keep_taps = false;
  // Block skip of the main program's lines stays: each line is of blocks that are all skipped or none. Otherwise it is
  // decided as off.
  bool keep_skips = false;
  bool own_unit = false;  // in inches where the program is written in them throughout; otherwise in mm
  // Takes blocks that state positions alone, which the program then lacks; of a program that taps or has lines with
  // block skip it takes none.
  PositionRuns* runs = nullptr;
};

// Runs `program` as `control` would. The result is whole when run.ended is `end` or `text_end` and no diagnostic is an
// error; words that motions do not carry are taken over, see carried_words.h.
ExplicitProgram explicit_program(const ir::Program& program, const ir::Control& control,
                                 interpreter::ProgramFinder& finder, const ExplicitOptions& options);

// The diagnostics of the run, and an error for whatever was met and would be lost in plain blocks; the one that ended
// the run is an error, whatever its row says.
std::vector<text::Diagnostic> run_faults(const ExplicitProgram& made, const RunTexts& texts);

}  // namespace dripfeed::compile
