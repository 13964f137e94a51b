// The parameter space of a family on one machine: each trial renders the family with its values and examines the text
// as every other check does.
#pragma once

#include <vector>

#include "checks/sweep/sweep.h"
#include "dialects/compile/dialect/dialect.h"
#include "dialects/compile/render/render.h"
#include "server/machine/profile.h"

namespace dripfeed::app {

struct FamilySweep {
  text::Source family;
  std::vector<family::Override> fixed;  // parameters that are not swept
  ir::Control control;
  const machine::Profile* profile = nullptr;  // without one its limits are not checked
  compile::RenderMode mode = compile::RenderMode::automatic;
  ir::Delivery delivery = ir::Delivery::memory;
  sweep::Settings settings;
};

// What fails a trial is named by the diagnostic's id; only a verdict of `fail` does. Parameters without a unit whose
// default and bounds are whole are swept in whole steps. The family must be readable.
sweep::Report sweep_family(const FamilySweep& order);

}  // namespace dripfeed::app
