// A program with parameters, and the calls that give them, as a macro with arguments:
//
//   PROC GROOVE(REAL DEPTH, INT PASSES=3)     IF[#1EQ#0]THEN #1=0.
//                                             IF[#2EQ#0]THEN #2=3.
//                                             #2=ROUND[#2]
//   GROOVE(R1,4)                              G65 <GROOVE> A#101 B4.
//
// Parameters become the local variables of their letters (passes/macro_arguments.h). What is handed over by reference,
// and what is not a number, has no such variable.
#pragma once

#include <map>
#include <vector>

#include "dialects/ir/control.h"
#include "dialects/ir/program.h"
#include "dialects/text/diagnostic.h"

namespace dripfeed::macro_b {

struct RaisedParameters {
  std::map<ir::SymbolId, std::uint32_t> numbers;  // of the local variables
  std::vector<text::Diagnostic> diagnostics;
};

// Replaces the head of the program by the assignments of its defaults.
RaisedParameters raise_parameters(ir::Program& program, const ir::Control& to);

// Arguments by position get letters; a call becomes a macro call where it has some, or where the calling program has
// variables of its own, which a subprogram of the same level would overwrite.
std::vector<text::Diagnostic> raise_calls(ir::Program& program, const ir::Control& to);

// Calls other programs or is called: variables of its own must be local ones.
bool has_company(const ir::Program& program);

}  // namespace dripfeed::macro_b
