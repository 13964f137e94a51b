// The shipped families before their places are rounded: macros of all controls make the same moves to a millionth of a
// millimetre, and plain blocks those moves, rounded to the decimals that are written.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/unit/dialects/compile/render/family_run.h"

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

// Verbs that stand for many moves.
TEST(FamilyRounding, VerbsAreOneToAMillionthAndBlocksAreThemRounded) {
  const std::string lathe =
      "family test\nmachine lathe, x is diameter\nparam foot length 30.7 mm in 1..99\nprogram test\n  spindle 600 rpm "
      "cw\n"
      "  feed 0.2 mm/rev\n  rapid x 110 mm z 5 mm\n  rough x 100 mm z 2 mm depth 2.3 mm retract 1 mm allowance x 0.31 "
      "mm "
      "z 0.17 mm\n    cut x foot z 0 mm\n    cut z -20 mm\n    arc cw x foot + 10 mm z -25 mm center i 5 mm k 0 mm\n"
      "    cut x 60 mm z -40 mm\n    arc ccw x 80 mm z -50 mm radius 10 mm\n    cut x 104 mm\n  end\nend\n";
  const std::string mill =
      "family test\nmachine mill\nparam wide length 12.3 mm in 1..99\nprogram test\n  tool 1 diameter wide\n"
      "  spindle 600 rpm cw\n  feed 200 mm/min\n  rapid z 9 mm\n"
      "  face y 0 mm to 61 mm x 0 mm to 33 mm z 2 mm to 0 mm depth 0.9 mm stepover 7.7 mm beyond 1 mm return 5 mm\n"
      "  pocket x 17 mm y 30 mm length 31 mm width 47 mm corner 7.1 mm z 0 mm to -5 mm depth 1.7 mm stepover 8.1 mm "
      "finish 0.23 mm ramp 3.3 deg feed 90 mm/min return 5 mm\n"
      "  pocket x 17 mm y 30 mm length 31 mm width 47 mm corner 7.1 mm z 0 mm to -5 mm depth 1.7 mm stepover 8.1 mm "
      "finish 0.23 mm helix 3.3 deg return 5 mm\n"
      "  pocket x 17 mm y 30 mm diameter 47 mm z 0 mm to -5 mm depth 1.7 mm stepover 8.1 mm finish 0.23 mm helix 3.3 "
      "deg "
      "return 5 mm\nend\n";
  for (const std::string& text : {lathe, mill}) {
    const text::Source family = {"test.family", text};
    std::vector<ir::Motion> first;
    for (const std::string& dialect : dialect_names()) {
      const std::vector<ir::Motion> macro = moves(family, dialect, RenderMode::macro);
      ASSERT_GT(macro.size(), 50U) << dialect;
      if (first.empty()) first = macro;
      expect_near(first, macro, kMacro, dialect);
      expect_near(macro, moves(family, dialect, RenderMode::explicit_blocks), kWritten, dialect + ", blocks");
    }
  }
}

}  // namespace
}  // namespace dripfeed::compile::test
