// How the spindle turns, as far as the text states it.
#pragma once

#include <optional>

#include "dialects/facts/modal_facts.h"
#include "dialects/ir/program.h"

namespace dripfeed::facts {

// As all paths have stated it. The machine builder's M functions are taken not to turn it, nor blocks that are not
// read: translations keep what stands in the text, and a cut without a spindle is reported by who checks.
std::optional<ir::Function> stated_spindle(const ir::Program& program, const Facts& facts);

}  // namespace dripfeed::facts
