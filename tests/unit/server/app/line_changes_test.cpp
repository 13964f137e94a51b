// Changes make one list of the other, and no shorter list of changes does: compared with the longest common list.
#include "server/app/base/line_changes.h"

#include <algorithm>
#include <random>
#include <string>

#include <gtest/gtest.h>

namespace dripfeed::app {
namespace {

using Lines = std::vector<std::string_view>;

// By the table of all beginnings.
std::size_t common_of(const Lines& a, const Lines& b) {
  std::vector<std::vector<std::size_t>> table(a.size() + 1, std::vector<std::size_t>(b.size() + 1, 0));
  for (std::size_t i = 1; i <= a.size(); ++i)
    for (std::size_t j = 1; j <= b.size(); ++j)
      table[i][j] = a[i - 1] == b[j - 1] ? table[i - 1][j - 1] + 1 : std::max(table[i - 1][j], table[i][j - 1]);
  return table[a.size()][b.size()];
}

Lines applied(const Lines& a, const Lines& b, const std::vector<LineChange>& changes) {
  Lines out;
  std::size_t at = 0;
  for (const LineChange& one : changes) {
    for (; at < one.first; ++at) out.push_back(a[at]);
    for (std::size_t i = one.second; i < one.second_end; ++i) out.push_back(b[i]);
    at = one.first_end;
  }
  for (; at < a.size(); ++at) out.push_back(a[at]);
  return out;
}

std::size_t lines_in(const std::vector<LineChange>& changes) {
  std::size_t count = 0;
  for (const LineChange& one : changes) count += one.first_end - one.first + one.second_end - one.second;
  return count;
}

TEST(LineChanges, NoneAndAll) {
  EXPECT_TRUE(line_changes(Lines{}, Lines{}).empty());
  EXPECT_TRUE(line_changes(Lines{"a", "b"}, Lines{"a", "b"}).empty());
  EXPECT_EQ(line_changes(Lines{"a"}, Lines{}), (std::vector<LineChange>{{0, 1, 0, 0}}));
  EXPECT_EQ(line_changes(Lines{}, Lines{"a"}), (std::vector<LineChange>{{0, 0, 0, 1}}));
  EXPECT_EQ(line_changes(Lines{"a", "b", "c"}, Lines{"a", "x", "c"}), (std::vector<LineChange>{{1, 2, 1, 2}}));
}

TEST(LineChanges, AreTrueAndShortest) {
  std::mt19937 random(7);
  constexpr std::string_view kLetters[] = {"a", "b", "c", "d"};
  for (int round = 0; round < 3000; ++round) {
    Lines a(random() % 12);
    Lines b(random() % 12);
    for (Lines* list : {&a, &b})
      for (std::string_view& line : *list) line = kLetters[random() % 4];
    const auto changes = line_changes(a, b);
    ASSERT_EQ(applied(a, b, changes), b);
    ASSERT_EQ(lines_in(changes), a.size() + b.size() - 2 * common_of(a, b));
    ASSERT_EQ(applied(a, b, line_changes(a, b, 2)), b);  // too many to be looked for: still true
  }
}

}  // namespace
}  // namespace dripfeed::app
