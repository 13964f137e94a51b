// Rendering for those who want the text alone, however long it is: most of it goes to a sink while the program runs.
#pragma once

#include <vector>

#include "dialects/compile/plain/position_runs.h"
#include "dialects/compile/render/render.h"

namespace dripfeed::compile {

// The text is that of `result` with the splices put in, in their order; blocks and bytes are of the whole. A result
// with splices has no profile lines and no place index.
struct StreamedRendering {
  RenderResult result;
  std::vector<Splice> splices;
};

// As render. What `sink` was given counts only as far as there are splices.
StreamedRendering render_streamed(const RenderRequest& request, TextSink& sink);

}  // namespace dripfeed::compile
