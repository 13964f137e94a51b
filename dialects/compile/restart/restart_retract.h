// The tool axis goes clear before anything else moves: to the reference point where the control has a code for it that
// needs no value, otherwise as the program itself does it, otherwise a person does it by hand.
#pragma once

#include "dialects/compile/restart/restart_preamble.h"

namespace dripfeed::compile {

void write_retract(RestartDraft& draft);

// The words of a line of the main program without its number, block skip and comment.
std::string bare_line(const RestartDraft& draft, std::uint32_t line);

}  // namespace dripfeed::compile
