// What the stages hand to one another: reading gives a program with diagnostics and never fails; raising gives a legal
// program or says why not; printing gives text and, for every line of it, where it came from.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "dialects/ir/program.h"
#include "dialects/text/diagnostic.h"

namespace dripfeed::ir {

// How a text reaches the control: stored in its memory and run there, or fed block by block while it runs (tape, DNC,
// remote mode), which excludes jumps and loops.
enum class Delivery : std::uint8_t { memory, drip };

struct ReadResult {
  Program program;
  std::vector<text::Diagnostic> diagnostics;
};

// A name of the program that became variables with numbers.
struct PlacedName {
  SymbolId symbol = SymbolId::none;
  Bank bank = Bank::hash;
  std::uint32_t first = 0;
  std::uint32_t count = 1;  // in a row
};

// `program` is to be used only when no diagnostic is an error. Spans of the diagnostics are in the text of the program
// that was raised; a built program has none, then Statement::line reports the place.
struct RaiseResult {
  Program program;
  std::vector<text::Diagnostic> diagnostics;
  std::vector<PlacedName> placed = {};
};

struct PrintResult {
  std::string text;                         // LF as EOB
  std::vector<std::uint32_t> origin_lines;  // per printed line: Statement::line of what it prints, 0 for frame lines
  std::uint32_t variables = 0;              // distinct user variables that the text touches
};

}  // namespace dripfeed::ir
