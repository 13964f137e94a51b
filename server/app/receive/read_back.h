// What came of punching a memory load back, by name, as it stands in a job, in the ledger and in the events.
#pragma once

#include <string>
#include <string_view>

namespace dripfeed::app {

inline constexpr std::string_view kReadBackWaits = "waiting for read-back";
inline constexpr std::string_view kReadBackEqual = "equal";
inline constexpr std::string_view kReadBackExpired = "expired: the control did not punch the program back";

// "equal", or "differs: line 3, column 5: …" with the place in what was sent.
std::string read_back_result(std::string_view sent, std::string_view punched);

}  // namespace dripfeed::app
