// A run of a program, kept: what each visit of a line did. Blocks that ran as a part of another statement (the shape of
// G71, the contour of CYCLE95, a called cycle) count for that one.
#pragma once

#include <cstdint>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "dialects/interpreter/interpreter.h"
#include "dialects/ir/control.h"
#include "dialects/ir/motion.h"
#include "dialects/ir/program.h"

namespace dripfeed::compile {

// Lines [first, last], 1-based, that only run as a part of other statements.
struct LineRange {
  std::uint32_t first = 0;
  std::uint32_t last = 0;
  [[nodiscard]] bool has(std::uint32_t line) const { return line >= first && line <= last; }
};

// The shapes that the program's G70 to G73 and CYCLE95 name by block numbers or labels.
std::vector<LineRange> shapes_of(const ir::Program& program);

// Levels of block skip that the program has.
std::set<std::uint8_t> skip_levels(const ir::Program& program);

struct Visit {
  std::uint32_t line = 0;  // of the main program: the owner's
  std::size_t first_motion = 0;
  std::size_t motion_count = 0;
};

struct RecordedRun {
  std::vector<Visit> visits;        // in order
  std::vector<ir::Motion> motions;  // all of them, in order
  bool is_whole = true;             // false: it made more motions than are kept
  std::vector<bool> plain_shapes;   // of shapes_of(): whether it was run by itself, too
  interpreter::RunResult result;

  [[nodiscard]] std::span<const ir::Motion> motions_of(const Visit& visit) const {
    return std::span(motions).subspan(visit.first_motion, visit.motion_count);
  }
};

// A run that goes on for ever ends by its limits, and what it is kept in does not grow for ever either.
inline constexpr std::size_t kKeptMotions = 2'000'000;  // half a gigabyte

// `owners`: lines that shapes belong to when they come next.
RecordedRun record(const ir::Program& program, const ir::Control& control, interpreter::ProgramFinder& finder,
                   const interpreter::RunOptions& options, const std::vector<LineRange>& shapes,
                   const std::vector<std::uint32_t>& owners);

}  // namespace dripfeed::compile
