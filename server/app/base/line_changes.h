// Two lists of lines, and the shortest list of changes that makes one of the other (E. W. Myers, An O(ND) Difference
// Algorithm and Its Variations, 1986).
#pragma once

#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

namespace dripfeed::app {

// Lines [first, first_end) of the first list stand where the second one has [second, second_end); one of them may be
// empty. Indices from 0.
struct LineChange {
  std::size_t first = 0;
  std::size_t first_end = 0;
  std::size_t second = 0;
  std::size_t second_end = 0;
  friend bool operator==(const LineChange&, const LineChange&) = default;
};

// In their order; none where both are the same. Where more lines than `most` were changed, what lies between the first
// and the last change is one change: true, but not the shortest.
std::vector<LineChange> line_changes(std::span<const std::string_view> first, std::span<const std::string_view> second,
                                     std::size_t most = 1000);

}  // namespace dripfeed::app
