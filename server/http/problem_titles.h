// What a problem is called, by its status.
#pragma once

#include <algorithm>
#include <array>
#include <string_view>

namespace dripfeed::http {

struct ProblemTitle {
  unsigned status;
  std::string_view title;
};
inline constexpr std::array kProblemTitles = {
    ProblemTitle{400, "malformed"},
    ProblemTitle{401, "not signed in"},
    ProblemTitle{403, "not allowed"},
    ProblemTitle{404, "not found"},
    ProblemTitle{405, "method not allowed"},
    ProblemTitle{409, "refused"},
    ProblemTitle{412, "stale revision"},
    ProblemTitle{413, "too large"},
    ProblemTitle{415, "no JSON"},
    ProblemTitle{422, "invalid"},
    ProblemTitle{428, "revision missing"},
    ProblemTitle{429, "too many"},
    ProblemTitle{431, "too large"},
    ProblemTitle{500, "internal error"},
    ProblemTitle{503, "unavailable"},
    ProblemTitle{507, "no room on the disk"},
};

constexpr std::string_view title_of(unsigned status) {
  const auto* const row = std::ranges::find(kProblemTitles, status, &ProblemTitle::status);
  return row == kProblemTitles.end() ? "refused" : row->title;
}

}  // namespace dripfeed::http
