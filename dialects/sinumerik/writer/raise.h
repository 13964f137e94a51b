// raise: a program of any control becomes one that the SINUMERIK reader could have read. One file a subject; each step
// changes the program in place and says what cannot be kept. Programs of SINUMERIK itself are only renamed.
#pragma once

#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "dialects/ir/control.h"
#include "dialects/ir/program.h"
#include "dialects/ir/stage.h"
#include "dialects/passes/refusal.h"
#include "dialects/text/diagnostic.h"

namespace dripfeed::sinumerik {

struct Raising {
  ir::Program& program;
  const ir::Control& from;
  const ir::Control& to;
  std::vector<text::Diagnostic>& diagnostics;

  text::Diagnostic& report(text::DiagnosticId id, text::Span span, std::vector<std::string> arguments) const;
  // `what` has no counterpart here; its kind is the diagnostic.
  void cannot(passes::Refusal what, text::Span span) const;
  [[nodiscard]] std::string_view text_of(text::Span span) const {
    return span.end <= program.source.text().size() ? span.in(program.source.text()) : std::string_view();
  }
  [[nodiscard]] bool is_own() const { return from.dialect == to.dialect; }
};

void raise_skipped_words(const Raising& raising);  // raise_skipped_words.cpp: block skip inside of blocks
// raise_arguments.cpp: local variables of macros. Returns the names that stay names.
std::set<ir::SymbolId> raise_arguments(const Raising& raising);
void raise_macro_calls(const Raising& raising);  // raise_macro_calls.cpp: letters to positions
void raise_vacant(const Raising& raising);       // raise_vacant.cpp: variables that are empty until they are set
void raise_expressions(const Raising& raising);  // raise_expressions.cpp: operators and system variables
void raise_flow(const Raising& raising);         // raise_flow.cpp: jumps, calls, alarms, natives
void raise_cycles(const Raising& raising);       // raise_cycles.cpp: modal drilling becomes MCALL
void raise_frames(const Raising& raising);       // raise_frames.cpp: G68, G51, G51.1 become chains of frames
void raise_reference(const Raising& raising);    // raise_reference.cpp: G28 becomes G75
// raise_machine_moves.cpp: machine positions are those of the spindle, not of the tool
void raise_machine_moves(const Raising& raising);
void raise_blocks(const Raising& raising);  // raise_blocks.cpp: codes and words
// raise_blocks.cpp: U V W H of a lathe are increments of X Y Z C.
void incremental_letter(ir::Word& w, const ir::Control& from);
void raise_modes(const Raising& raising);  // raise_modes.cpp: feed and surface speed in one group; the safe start
// raise.cpp: numbers and names become R parameters, except those in `kept`
std::vector<ir::PlacedName> raise_variables(const Raising& raising, std::set<ir::SymbolId> kept);

}  // namespace dripfeed::sinumerik
