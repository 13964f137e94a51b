// The machine profile as JSON (deploy/machines/*.json): reading with every fault named.
#pragma once

#include <string>
#include <string_view>

#include "server/app/base/error.h"
#include "server/json/schema.h"
#include "server/machine/profile.h"

namespace dripfeed::json {

// Errors: invalid, a place for each fault.
app::Result<machine::Profile> read_profile(std::string_view document);
// The same, described.
Schema profile_schema();

// The same document with another cost model, with its `origin` in words, and with every axis' acceleration times a
// factor; nothing else changes. Errors: no JSON object.
app::Result<std::string> calibrated_profile(std::string_view document, const ir::CostModel& cost,
                                            std::string_view origin, double acceleration_factor);

}  // namespace dripfeed::json
