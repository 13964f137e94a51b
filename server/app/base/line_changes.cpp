// The search goes by the number of changes: after d of them, `reached[k]` is how far into the first list one gets on
// diagonal k = (place in the first) - (place in the second). Each round is kept, so that the path can be walked back.
#include "server/app/base/line_changes.h"

#include <algorithm>
#include <optional>
#include <string>
#include <unordered_map>

namespace dripfeed::app {

namespace {

using Ids = std::vector<std::size_t>;

// One number for each different line, so that lines are compared with each other once.
class Numbers {
 public:
  Ids of(std::span<const std::string_view> lines) {
    Ids ids;
    ids.reserve(lines.size());
    for (const std::string_view line : lines) ids.push_back(known_.try_emplace(line, known_.size()).first->second);
    return ids;
  }

 private:
  std::unordered_map<std::string_view, std::size_t> known_;
};

// reached[offset + k] of a round d, for k from -d to d.
using Round = std::vector<std::ptrdiff_t>;

class Search {
 public:
  Search(std::span<const std::size_t> first, std::span<const std::size_t> second) : first_(first), second_(second) {}

  // Nothing where more than `most` changes are needed.
  std::optional<std::vector<LineChange>> run(std::ptrdiff_t most) {
    for (std::ptrdiff_t d = 0; d <= most; ++d) {
      rounds_.emplace_back(static_cast<std::size_t>(2 * d + 1));
      for (std::ptrdiff_t k = -d; k <= d; k += 2) {
        const std::ptrdiff_t x = follow(step(d, k), k);
        at(d, k) = x;
        if (x >= size(first_) && x - k >= size(second_)) return walk_back(d, k);
      }
    }
    return std::nullopt;
  }

 private:
  static std::ptrdiff_t size(std::span<const std::size_t> list) { return static_cast<std::ptrdiff_t>(list.size()); }
  std::ptrdiff_t& at(std::ptrdiff_t d, std::ptrdiff_t k) {
    return rounds_[static_cast<std::size_t>(d)][static_cast<std::size_t>(k + d)];
  }
  // Whether round d comes to diagonal k by a line of the second list (down) or of the first one.
  bool comes_down(std::ptrdiff_t d, std::ptrdiff_t k) {
    return k == -d || (k != d && at(d - 1, k - 1) < at(d - 1, k + 1));
  }
  std::ptrdiff_t step(std::ptrdiff_t d, std::ptrdiff_t k) {
    if (d == 0) return 0;
    return comes_down(d, k) ? at(d - 1, k + 1) : at(d - 1, k - 1) + 1;
  }
  [[nodiscard]] std::ptrdiff_t follow(std::ptrdiff_t x, std::ptrdiff_t k) const {
    while (x < size(first_) && x - k < size(second_) &&
           first_[static_cast<std::size_t>(x)] == second_[static_cast<std::size_t>(x - k)])
      ++x;
    return x;
  }

  std::vector<LineChange> walk_back(std::ptrdiff_t d, std::ptrdiff_t k) {
    std::vector<LineChange> changes;
    for (; d > 0; --d) {
      const bool down = comes_down(d, k);
      const std::ptrdiff_t before = down ? k + 1 : k - 1;
      const auto x = static_cast<std::size_t>(at(d - 1, before));
      const auto y = static_cast<std::size_t>(at(d - 1, before) - before);
      const LineChange one{x, x + (down ? 0U : 1U), y, y + (down ? 1U : 0U)};
      const bool joins =
          !changes.empty() && one.first_end == changes.back().first && one.second_end == changes.back().second;
      if (joins) {
        changes.back().first = one.first;
        changes.back().second = one.second;
      } else {
        changes.push_back(one);
      }
      k = before;
    }
    std::ranges::reverse(changes);
    return changes;
  }

  std::span<const std::size_t> first_;
  std::span<const std::size_t> second_;
  std::vector<Round> rounds_;
};

}  // namespace

std::vector<LineChange> line_changes(std::span<const std::string_view> first, std::span<const std::string_view> second,
                                     std::size_t most) {
  Numbers numbers;
  const Ids left = numbers.of(first);
  const Ids right = numbers.of(second);
  const auto head = static_cast<std::size_t>(std::ranges::mismatch(left, right).in1 - left.begin());
  std::size_t tail = 0;
  while (tail < std::min(left.size(), right.size()) - head &&
         left[left.size() - 1 - tail] == right[right.size() - 1 - tail])
    ++tail;
  const auto middle = [&](const Ids& ids) { return std::span(ids).subspan(head, ids.size() - head - tail); };
  auto found = Search(middle(left), middle(right)).run(static_cast<std::ptrdiff_t>(most));
  if (!found) return {{head, left.size() - tail, head, right.size() - tail}};
  for (LineChange& one : *found) {
    one.first += head;
    one.first_end += head;
    one.second += head;
    one.second_end += head;
  }
  return std::move(*found);
}

}  // namespace dripfeed::app
