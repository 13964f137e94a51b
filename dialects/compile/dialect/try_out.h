// A family's program run before it is rendered, for what only a run shows.
#pragma once

#include <cstdint>
#include <optional>
#include <set>
#include <span>

#include "dialects/family/model.h"
#include "dialects/interpreter/interpreter.h"
#include "dialects/ir/control.h"
#include "dialects/ir/motion.h"
#include "dialects/ir/program.h"

namespace dripfeed::compile {

// What a program does that calls no other; a long one is not tried to its end.
interpreter::RunResult try_out(const ir::Program& program, const ir::Control& control);
// The same, with its motions.
interpreter::RunResult try_out(const ir::Program& program, const ir::Control& control, ir::MotionSink& motions);

// Whether a list's numbers are set by steps, so that one may be taken before.
bool are_set_by_steps(std::span<const family::List> lists);
// The program, with no known number in the lists that it sets, for a control whose semantics are `unset_is_unknown`.
ir::Program with_unknown_lists(std::span<const family::List> lists, const ir::Program& built);
// Lines of the family that took a number that was not known, in a run of such a program.
std::set<std::uint32_t> lines_with_unset(const interpreter::RunResult& run);

// A run with lists whose numbers the program sets. Lines of the family that take one before a step has set it: here it
// is a zero, at the control whatever was left there.
struct TriedLists {
  std::set<std::uint32_t> lines;
  interpreter::RunResult run;
};
// Nothing where there are no such lists, and nothing was run.
std::optional<TriedLists> try_set_lists(std::span<const family::List> lists, const ir::Program& built,
                                        const ir::Control& control);

}  // namespace dripfeed::compile
