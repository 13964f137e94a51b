// What a test of a bridged line measured, for the command and the API.
#pragma once

#include <expected>
#include <string>

#include "server/app/lines/link_test.h"

namespace dripfeed::json {

std::string link_test(const app::LinkTestResult& result, const machine::LineSettings& line);
// {"fault","fault_id","result"}: either the first two are null, or the last.
std::string line_test(const std::expected<app::LinkTestResult, app::LinkTestFault>& done,
                      const machine::LineSettings& line);

}  // namespace dripfeed::json
