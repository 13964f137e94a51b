// Reports of checks as SARIF 2.1.0 (OASIS), which editors and code hosts show next to the lines of a file.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "server/app/base/report.h"

namespace dripfeed::json {

// One run with all reports. A verdict that is no pass without a result of its own, and what was not checked, stand in
// the run's notifications: a log without results does not look like a pass then.
std::string sarif(std::span<const app::CheckReport> reports, std::string_view version);

}  // namespace dripfeed::json
