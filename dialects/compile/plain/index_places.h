// The place index of a printed explicit program: the printer says which block each line prints, the run says where that
// block came from and what the variables were.
#pragma once

#include <set>
#include <string>

#include "dialects/compile/plain/explicit_program.h"
#include "dialects/compile/plain/place_index.h"
#include "dialects/ir/stage.h"

namespace dripfeed::compile {

// `own_names`: variables that are reported. The text must be what printing `made.program`, raised, gave.
PlaceIndex index_places(const ir::PrintResult& printed, const ExplicitProgram& made,
                        const std::set<std::string>& own_names);

}  // namespace dripfeed::compile
