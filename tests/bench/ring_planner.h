// The textbook look-ahead of small controls, as a peer for measurements: a ring of a few blocks, each new block sweeps
// back over those that may still become faster and forward again; single precision; speeds only, no times.
#pragma once

#include <cstddef>

#include "checks/timing/line_path.h"

namespace dripfeed::bench {

// Returns the sum of the entry speeds that went out, mm/s, so that nothing is left out by the compiler.
double plan_in_ring(const timing::LinePath& path, double acceleration, std::size_t ring_size);

}  // namespace dripfeed::bench
