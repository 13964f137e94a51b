// The machine profile as JSON (deploy/machines/*.json): reading with every fault named.
#pragma once

#include <string_view>

#include "server/app/error.h"
#include "server/machine/profile.h"

namespace dripfeed::json {

// Errors: invalid, a place for each fault.
app::Result<machine::Profile> read_profile(std::string_view document);

}  // namespace dripfeed::json
