// How the controls write comments.
#pragma once

#include <cstdint>

namespace dripfeed::compile {

// How a control writes a comment: "(" and ")", or ";" to the end of the line.
enum class CommentStyle : std::uint8_t { brackets, semicolon };

}  // namespace dripfeed::compile
