// The frame that a text needs on a wire, where the dialect's own text has none: SINUMERIK's punched-tape format.
#pragma once

#include <string_view>

#include "dialects/ir/stage.h"

namespace dripfeed::compile {

// Puts the frame around a printed program that goes over a line. Texts that have theirs ('%' first and last) stay as
// they are.
//   %_N_ROLL_1_MPF           first line: the name at the control
//   ;$PATH=/_N_MPF_DIR       second line: the folder it belongs to
//   …
//   %                        the tape's end, so that the sender knows that all is sent
void wrap_for_wire(ir::PrintResult& printed, std::string_view dialect, std::string_view program_name);

}  // namespace dripfeed::compile
