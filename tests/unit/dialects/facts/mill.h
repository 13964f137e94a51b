// A control whose state at power-on is known.
#pragma once

#include "dialects/ir/control.h"

namespace dripfeed::facts {

inline ir::Control mill() {
  ir::Control control;
  control.axes = "XYZ";
  control.semantics.power_on_known = true;
  return control;
}

}  // namespace dripfeed::facts
