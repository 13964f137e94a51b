// Data of the control that outlives a program and that a definition file declares (GUD): here each name gets permanent
// common variables, in the order of the definitions, so that all programs of one set of files find it at one place.
//
//   DEF NCK REAL WHEEL[3]=REP(1.5)            #500, #501, #502
//   DEF NCK INT PASSES=4                      #503
//   G0 X=WHEEL[1]                             IF[#501EQ#0]THEN #501=1.5
//                                             G00 X#501
//
// What no one has set yet is vacant here, and its initial value there: a program begins with the values of what it
// reads before it sets it. A program of definitions alone becomes one that does so for all of them.
#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <vector>

#include "dialects/ir/control.h"
#include "dialects/ir/program.h"
#include "dialects/text/diagnostic.h"

namespace dripfeed::macro_b {

struct PlacedGlobals {
  std::map<ir::SymbolId, std::uint32_t> numbers;  // the first of each
  std::set<ir::SymbolId> defined;                 // all names of the definitions, also those without a place
  std::set<ir::SymbolId> unplaced;                // of those, numbers for which nothing is left
  std::set<std::uint32_t> reserved;               // all of them, also of names that this program does not use
  std::vector<text::Diagnostic> diagnostics;      // names that the program uses and that have no place
};

// To be run first. Takes the definitions out of the program, and points all uses of a name to one symbol.
PlacedGlobals place_globals(ir::Program& program, const ir::Control& to);

}  // namespace dripfeed::macro_b
