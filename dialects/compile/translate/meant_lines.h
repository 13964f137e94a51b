// What the lines of a program say, whatever they look like: blanks, comments, the case of letters, leading zeros, the
// digits after a point and block numbers that nothing refers to are left out. Two programs of one control whose lines
// say the same do the same. It rests on the reader's tokens, statements and labels; where the reader did not understand
// something, it says so and no one may call the programs equal.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "dialects/ir/control.h"
#include "dialects/ir/program.h"
#include "dialects/ir/stage.h"

namespace dripfeed::compile {

struct MeantLine {
  std::uint32_t line = 0;               // 1-based
  std::uint32_t number = ir::kNoIndex;  // of the block, where it has one
  std::string words{};                  // "G 1 X 10. F 100"
};

struct Meaning {
  std::vector<MeantLine> lines;  // those that say something, in order
  std::string not_understood;    // "line 4: …"; empty: all of it was understood
  // Why a block number may matter although no jump names it: "line 7"; empty: none does.
  std::string numbers_matter;
};

// `read` is what the dialect's reader made of the text, for this control.
Meaning meaning_of(const ir::ReadResult& read, const ir::Control& control);

// What a line says; "" for one that says nothing.
std::string words_of_line(const Meaning& meaning, std::uint32_t line);

}  // namespace dripfeed::compile
