// The revision of the code that judges programs: of the dialects, the checks, the profiles and the verdict's own rules.
// cmake/rules_revision.cmake makes it of their sources, so no change of them can be forgotten.
#pragma once

#include <string_view>

namespace dripfeed::cli {

// 16 hexadecimal digits, the same in every build of the same sources.
std::string_view rules_revision();

}  // namespace dripfeed::cli
