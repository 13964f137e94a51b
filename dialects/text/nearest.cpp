// Two rows of the usual table, one kept.
#include "dialects/text/nearest.h"

#include <algorithm>
#include <numeric>
#include <vector>

namespace dripfeed::text {

std::size_t far_from(std::string_view word) { return word.size() / 3 + 2; }

std::string_view nearest_of(std::string_view word, std::span<const std::string_view> words) {
  std::string_view best;
  std::size_t best_distance = far_from(word);
  for (const std::string_view candidate : words) {
    const std::size_t distance = edit_distance(word, candidate);
    if (distance >= best_distance) continue;
    best_distance = distance;
    best = candidate;
  }
  return best;
}

std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i + 1;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({replaced, row[j] + 1, row[j + 1] + 1});
    }
  }
  return row[b.size()];
}

}  // namespace dripfeed::text
