// Which line of a family each line of its rendered text comes from, for who reads what was found in the text.
#pragma once

#include <cstdint>
#include <vector>

#include "dialects/compile/render/render.h"

namespace dripfeed::compile {

// By line of made.text, which is what render gave for `request`, in whatever mode it chose: the family's line, 1-based;
// 0 where it comes from none (the frame around the program, a heading).
std::vector<std::uint32_t> family_lines(const RenderRequest& request, const RenderResult& made);

}  // namespace dripfeed::compile
