// `engrave` as the moves that it stands for, once the text is known.
#pragma once

#include <string>

#include "dialects/family/bind.h"

namespace dripfeed::family {

// The family with rapids and cuts in place of its engravings, bound as before; the same where it engraves nothing.
BoundFamily with_strokes(const BoundFamily& bound);

// The first character of the text that cannot be engraved, and its place from 1: "character 3, '_',"; "" where all can.
std::string fault_of_engraving(const std::string& text);

}  // namespace dripfeed::family
