// Rendering for a machine: which of the two renderings it gets where none of them was asked for. compile::render
// knows what the control can do; how long it takes for that only the machine's profile says. The same for the command,
// for the REST API and for sweeps.
#pragma once

#include "dialects/compile/render/render.h"
#include "server/machine/profile.h"

namespace dripfeed::app {

// As compile::render, but RenderMode::automatic takes, for memory, the rendering that the machine is through with first
// by the forecast of timing (computing, motion and waiting for each other together), and the macro where blocks save
// next to nothing. A native program is kept as it is written, however slow it is. `because` states both forecasts, or
// why there are none: no profile (nullptr), a rendering that is refused, a run that does not end.
compile::RenderResult render_for(const compile::RenderRequest& request, const machine::Profile* profile);

// Makes a rendered macro faster for the machine (compile::optimize_rendered), by the cost model of its profile;
// `because` says what that gained, or why nothing was gained.
void optimize_for(compile::RenderResult& rendered, const ir::Control& control, const machine::Profile& profile);

// The machine's own figures, or the usual ones of its control.
ir::CostModel cost_model_of(const ir::Control& control, const machine::Profile* profile);

}  // namespace dripfeed::app
