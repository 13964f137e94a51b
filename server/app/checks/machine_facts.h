// What several checks ask of control and machine alike.
#pragma once

#include "checks/machine.h"
#include "dialects/ir/control.h"
#include "server/machine/profile.h"

namespace dripfeed::app {

// Whether x words are diameters: as the machine's profile states, otherwise as in the control's power-on state.
inline bool x_is_diameter(const ir::Control& control, const machine::Profile* profile) {
  if (profile != nullptr) {
    if (const checks::MachineAxis* x = checks::find_axis(profile->machine, ir::Axis::x)) return x->is_diameter;
  }
  return control.semantics.power_on_diameter != ir::DiameterMode::radius;
}

}  // namespace dripfeed::app
