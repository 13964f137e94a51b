// The shipped families before their places are rounded: macros of all controls make the same moves to a millionth of a
// millimetre, and plain blocks those moves, rounded to the decimals that are written.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/unit/dialects/compile/family_run.h"

namespace dripfeed::compile::test {
namespace {

constexpr double kMacro = 1e-6;             // mm or degrees
constexpr double kWritten = 0.5e-3 + 1e-6;  // three decimals; a diameter is halved

std::vector<std::string> names() {
  std::vector<std::string> out;
  for (const auto& entry : std::filesystem::directory_iterator(std::string(DRIPFEED_SOURCE_DIR) + "/deploy/families"))
    if (entry.path().extension() == ".family") out.push_back(entry.path().stem().string());
  std::ranges::sort(out);
  return out;
}

// Empty where the family is not for that control.
std::vector<ir::Motion> moves(const text::Source& family, const std::string& dialect, RenderMode mode) {
  const RenderResult result = rendered(family, dialect, mode, {});
  if (text::has_error(result.diagnostics)) return {};
  return real_moves(run_text(result.text, control(dialect, kind_of(family))).motions);
}

void expect_near(const std::vector<ir::Motion>& a, const std::vector<ir::Motion>& b, double tolerance,
                 const std::string& what) {
  ASSERT_EQ(a.size(), b.size()) << what;
  double worst = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    ASSERT_EQ(a[i].kind, b[i].kind) << what << ", move " << i;
    for (std::size_t axis = 0; axis < 6; ++axis) worst = std::max(worst, std::abs(a[i].end[axis] - b[i].end[axis]));
    ASSERT_LE(worst, tolerance) << what << ", move " << i;
    ASSERT_NEAR(a[i].feed, b[i].feed, 1e-9) << what << ", move " << i;
  }
}

TEST(FamilyRounding, MacrosAreOneToAMillionthAndBlocksAreThemRounded) {
  std::set<std::string> elsewhere;  // a native program is one control's
  std::size_t compared = 0;
  for (const std::string& name : names()) {
    const text::Source family = shipped(name);
    std::vector<ir::Motion> first;
    for (const std::string& dialect : dialect_names()) {
      const std::vector<ir::Motion> macro = moves(family, dialect, RenderMode::macro);
      if (macro.empty()) {
        elsewhere.insert(name);
        continue;
      }
      if (first.empty()) first = macro;
      expect_near(first, macro, kMacro, name + " on " + dialect);
      expect_near(macro, moves(family, dialect, RenderMode::explicit_blocks), kWritten,
                  name + " on " + dialect + ", blocks");
      ++compared;
    }
  }
  EXPECT_EQ(elsewhere, (std::set<std::string>{"turning-cycle"}));
  EXPECT_EQ(compared, dialect_names().size() * (names().size() - 1));
}

}  // namespace
}  // namespace dripfeed::compile::test
