// What a sweep found, as JSON.
#pragma once

#include <string>

#include "checks/sweep/sweep.h"

namespace dripfeed::json {

// {"parameters":[{"name","unit","low","high","standard","passes":[a,b],"low_bound","high_bound"}],"standard",
//  "corners":{"tried","passed"},"samples":{…},"smallest_failure":{"values","changed","check","text"}|null,"trials"}
std::string sweep_report(const sweep::Report& report);

}  // namespace dripfeed::json
