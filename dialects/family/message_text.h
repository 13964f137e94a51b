// Messages with values: Step::text has a mark where each stands, Step's words are the values, in stored units, or
// names of texts.
#pragma once

#include <string>

#include "dialects/family/bind.h"

namespace dripfeed::family {

inline constexpr char kValueMark = '\x01';  // no text that a person writes has it

// The text with the values as they are when the family is rendered.
std::string message_text(const BoundFamily& bound, const Step& message);

}  // namespace dripfeed::family
