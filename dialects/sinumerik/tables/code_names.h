// What SINUMERIK calls a code of any control, by what it does.
#pragma once

#include <string>

#include "dialects/ir/statement.h"

namespace dripfeed::sinumerik {

// "" where it has no name of one code: a call, a frame's words, or nothing at all says it then.
std::string name_of_code(const ir::Code& code);

}  // namespace dripfeed::sinumerik
