// Whether two programs of one control move the axes the same. Both are run, and their moves, tools, stops and what they
// do that no run shows (M functions, reference returns, data that outlives the program) are compared with each other in
// order. What a run took from outside, or did not understand, is unknown for both: then nothing is compared, and `why`
// says so.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "dialects/compile/dialect/library.h"
#include "dialects/compile/translate/meant_lines.h"
#include "dialects/interpreter/interpreter.h"
#include "dialects/ir/control.h"
#include "dialects/ir/program.h"

namespace dripfeed::compile {

// Coordinates are compared with each other to a millionth of a millimetre or degree: what two spellings of one number
// differ by is less, what a control rounds to is more.
inline constexpr double kSameCoordinate = 1e-6;

struct ComparedProgram {
  const ir::Program& program;
  const ir::Control& control;
  const Meaning& meaning;   // of the same text
  ProgramLibrary& library;  // of called programs
};

struct MovesAnswer {
  std::string why{};      // nothing was compared; empty: it was
  bool equal = false;     // where it was compared
  std::size_t moves = 0;  // of both up to the first difference, or all of them
  // The first that differs: lines of the main programs, 0 where one has ended.
  std::uint32_t first_line = 0;
  std::uint32_t second_line = 0;
  std::string first{};  // "line X10. F100"
  std::string second{};
  // Largest difference of end points and centres, of diameters half of it; nothing where the two do not consist of the
  // same moves.
  std::optional<double> deviation_mm{};
  std::optional<double> deviation_deg{};
};

// `used_up` as in interpreter::RunOptions, for both runs together.
MovesAnswer compare_moves(const ComparedProgram& first, const ComparedProgram& second,
                          const std::function<std::string()>& used_up);

}  // namespace dripfeed::compile
