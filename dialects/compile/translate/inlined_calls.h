// Calls of subprograms, replaced in the text by the lines of what they call. Exact by its conditions alone: a call
// whose subprogram would do anything else in its caller's text stays, with the reason. The subprograms stay where they
// are, because other programs may call them.
//
//   N20 M98 P2 (HOLE)          N20 (START OF O0002) (HOLE)
//                              #101=#100*2.
//                              G1 X#101 F100. (CUT)
//                              (END OF O0002)
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "dialects/compile/dialect/dialect.h"
#include "dialects/compile/dialect/library.h"
#include "dialects/ir/control.h"
#include "dialects/ir/program.h"

namespace dripfeed::compile {

// A longer body gains little by it: by the assumed model a call takes as long as fifty blocks. One that runs once
// gains that once, and its blocks would stand in the text a second time.
inline constexpr std::uint32_t kMostBlocksInLoop = 1000;
inline constexpr std::uint32_t kMostBlocksOnce = 20;

struct InlinedCall {
  std::uint32_t line = 0;  // of the given text
  std::string program;     // "O0002"
  std::uint32_t blocks = 0;
};
struct KeptCall {
  std::uint32_t line = 0;  // of the given text: the call's, or that of the call around it
  std::string program;     // empty where a value names it
  std::string why;         // a clause: "it takes arguments"
};

// The program of a text that a run begins with, which other programs may follow.
struct MainPart {
  ir::Section range;
  std::uint32_t index = 0;
  std::uint32_t bytes = 0;  // of the text, from its beginning
};
MainPart main_part(const ir::Program& text);

struct InlinedText {
  std::string text;                         // of the main part; empty: no call was replaced
  std::vector<std::uint32_t> origin_lines;  // by line of it: the line of the given text; of a body's: its call's
  std::vector<InlinedCall> inlined;
  std::vector<KeptCall> kept;
};

// `library`: of programs that the text does not hold.
InlinedText inline_calls(const ir::Program& text, const Dialect& dialect, const ir::Control& control,
                         ProgramLibrary& library);

}  // namespace dripfeed::compile
