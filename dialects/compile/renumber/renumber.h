// New block numbers for a program: N10, N20, …, with everything that names a block following it: GOTO, the P and Q of
// a turning cycle's contour, the P of M97, REPEAT. What names a block from elsewhere, or in a form that is only known
// while running, refuses it. The text that comes out is read again: apart from its block numbers it is the same
// program.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "dialects/ir/control.h"
#include "dialects/text/source.h"

namespace dripfeed::compile {

enum class Numbering : std::uint8_t {
  numbered,  // blocks that have a number get another one
  all,       // and the others get one
  none,      // no block has one but those that are named
};
// By Numbering.
inline constexpr std::string_view kNumberingNames[] = {"numbered", "all", "none"};

struct RenumberRequest {
  text::Source source;
  ir::Control control;
  Numbering numbering = Numbering::numbered;
  std::uint32_t first = 10;
  std::uint32_t step = 10;
};

struct RenumberRefusal {
  std::uint32_t line = 0;  // of the text, from 1; 0: of none
  std::string text;        // a sentence's end: why
};

struct Renumbered {
  std::string text;                      // empty: refused
  std::uint32_t numbers = 0;             // that the text has now
  std::uint32_t references = 0;          // that name one of them
  std::vector<std::string> assumptions;  // sentences for people
  std::vector<RenumberRefusal> refused;
};

// Each program of the text begins with `first`.
Renumbered renumber(const RenumberRequest& request);

}  // namespace dripfeed::compile
