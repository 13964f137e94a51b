// A program that is to go on in the middle: a preamble that states what the blocks before have set, an approach to the
// point where the tool was, and the rest of the text byte for byte. Nothing is guessed: what is not known is refused or
// named, and the text that comes out was run and compared with the whole program, move by move.
//
//   O1234 (BRACKET)          the head of the text
//   (RESTART AT LINE 40)     the preamble, in the control's own language
//   G21 G17 G90 G94 …
//   …
//   G1 Z-2. F300.            to the place where line 40 begins
//   N40 X55. Y12.            the rest
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "dialects/compile/dialect/library.h"
#include "dialects/compile/plain/explicit_program.h"
#include "dialects/ir/control.h"
#include "dialects/text/diagnostic.h"
#include "dialects/text/source.h"

namespace dripfeed::compile {

inline constexpr double kRestartClearance_mm = 2.0;

struct RestartRequest {
  text::Source source;
  ir::Control control;
  std::uint32_t line = 0;             // of the text, from 1
  ProgramLibrary* library = nullptr;  // of called programs; nullptr: none are found
  interpreter::Limits limits = kWrittenLimits;
  std::uint32_t skip_switches = 0;             // as interpreter::RunOptions
  double clearance_mm = kRestartClearance_mm;  // above the start, where the program has no higher level of its own
  std::function<std::string()> used_up = {};   // as interpreter::RunOptions, for all runs together
};

struct Restart {
  std::string text;                           // empty: refused, for the reasons in `diagnostics`
  std::string preamble;                       // the lines of it that the source has not
  std::uint32_t preamble_line = 0;            // of `text`: where the preamble begins
  std::uint32_t rest_line = 0;                // … and the rest
  std::vector<std::string> assumptions;       // what must hold at the machine: sentences for people
  std::size_t moves_before = 0;               // of the whole program, before the line
  std::size_t compared_moves = 0;             // of the rest, that are those of the whole program
  std::vector<text::Diagnostic> diagnostics;  // spans in `source`
  // Where it is refused: the nearest lines before and after at which a restart is possible; 0: none was found.
  std::uint32_t safe_before = 0;
  std::uint32_t safe_after = 0;
};

Restart restart_at(const RestartRequest& request);

}  // namespace dripfeed::compile
