// Answers to operators, as programs that their control can read and show: the only screen that they have.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "protocol/feed/program_check.h"
#include "server/machine/profile.h"

namespace dripfeed::app {

// The O number of an answer at a control that has numbers: the profile's, or the request's own, which the shop keeps
// free for that.
std::uint32_t answer_number_of(const machine::ReceiveSettings& receive);

// A program of comments and an end, with LF as EOB: "%", "O9999(NOT FOUND 1234)", "M30", "%", or in the form of a
// SINUMERIK archive. Characters that the control does not take in a comment become '.', lines fit its block length.
std::string answer_program(const machine::Profile& profile, const std::vector<std::string>& lines);

// What such a program is checked by before it goes out.
feed::ProgramSyntax answer_syntax(const machine::Profile& profile);

}  // namespace dripfeed::app
