// The axis of a cone's lead: along the one of X and Z that the thread moves farther along, X as a radius. Where the
// lead is a letter that names the axis (K or I of SINUMERIK), a macro needs it before the control computes where it
// goes: so it is run here. (SINUMERIK PG, "Thread cutting with constant lead": I above 45 degrees; Fanuc B-64604EN,
// G32: F counts along the longer axis.)
#pragma once

#include <cstdint>
#include <map>

#include "dialects/ir/control.h"
#include "dialects/ir/program.h"

namespace dripfeed::compile {

enum class ConeLead : std::uint8_t {
  along_z,
  along_x,
  either,  // now along the one, now along the other, or the run did not come to its end
};
// By line of `built`: its threads that move along both axes.
std::map<std::uint32_t, ConeLead> cone_leads(const ir::Program& built, const ir::Control& control);

// Names the axis in the blocks of `raised`, of a control whose leads are letters, that come from these lines.
void name_cone_leads(ir::Program& raised, const std::map<std::uint32_t, ConeLead>& leads);

}  // namespace dripfeed::compile
