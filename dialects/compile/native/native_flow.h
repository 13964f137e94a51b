// Where a run of a native text can go, through calls of programs of the same text, and which of its programs share
// their variables.
#pragma once

#include <cstdint>
#include <vector>

#include "dialects/ir/program.h"

namespace dripfeed::compile {

// The first program of the text that no other one calls; all statements where the text is one program.
ir::Section main_section(const ir::Program& program);

// By statement: whether a run can be there without having executed `setting`. Calls of programs of the same text are
// followed; what a called program sets counts for itself alone.
std::vector<bool> reached_without(const ir::Program& program, std::uint32_t setting);
// The same for a run that begins at `start` and ends at the first of `stops`, by statement.
std::vector<bool> reached_from(const ir::Program& program, std::uint32_t start, const std::vector<bool>& stops);
// By statement: whether a run can be there after it has executed one of `from`, and none of `stops` since. A return
// goes on after every call of its program.
std::vector<bool> reached_after(const ir::Program& program, const std::vector<std::uint32_t>& from,
                                const std::vector<bool>& stops);

// By statement: whether it has the same local variables (#1) as `statement`: M98 keeps them, G65 begins new ones.
std::vector<bool> shares_locals(const ir::Program& program, std::uint32_t statement);

}  // namespace dripfeed::compile
