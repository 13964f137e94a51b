// Threads of families: leads, and the feed behind them.
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/unit/dialects/compile/family_run.h"

namespace dripfeed::compile::test {
namespace {

text::Source lathe(const std::string& steps) {
  return {"test.family",
          "family test\nmachine lathe, x is diameter\nparam p length 1.5 mm in 0.5..4\nparam n count 3 in 1..9\n"
          "param slow feed 0.1 mm/rev in 0.01..1\nprogram test\n  spindle 600 rpm cw\n" +
              steps + "end\n"};
}

struct Cut {
  ir::MotionKind kind;
  double feed;
  bool operator==(const Cut&) const = default;
};
std::vector<Cut> cuts_of(const text::Source& family) {
  std::vector<Cut> out;
  for (const ir::Motion& m : one_trace(family))
    if (m.kind != ir::MotionKind::rapid) out.push_back({m.kind, m.feed});
  return out;
}

TEST(FamilyThreads, TheLeadIsThePitchAlongEitherAxis) {
  using enum ir::MotionKind;
  EXPECT_EQ(cuts_of(lathe("  rapid x 20 mm z 3 mm\n  thread z -10 mm pitch p\n  thread x 30 mm z -20 mm pitch 2*p\n"
                          "  rapid x 40 mm z 0 mm\n  thread x 20 mm pitch p + 0.5 mm\n")),
            (std::vector<Cut>{{thread, 1.5}, {thread, 3.0}, {thread, 2.0}}));
}

// Where F is the lead, the next cut must say its feed again, on every path.
TEST(FamilyThreads, TheFeedBehindAThreadIsTheOneBefore) {
  using enum ir::MotionKind;
  EXPECT_EQ(
      cuts_of(lathe("  feed slow\n  rapid x 20 mm z 3 mm\n  cut z 0 mm\n  thread z -10 mm pitch p\n  cut x 30 mm\n")),
      (std::vector<Cut>{{linear, 0.1}, {thread, 1.5}, {linear, 0.1}}));
  EXPECT_EQ(cuts_of(lathe(
                "  let f_now = slow\n  feed f_now\n  rapid x 20 mm z 3 mm\n  for q from 1 to n step 1\n    cut z 0 mm\n"
                "    set f_now = f_now*2\n    if q > 1\n      thread z -10 mm pitch p\n    end\n"
                "    if q > 2\n      feed f_now\n    end\n    cut x q*10 mm\n    rapid z 3 mm\n  end\n")),
            (std::vector<Cut>{{linear, 0.1},
                              {linear, 0.1},
                              {linear, 0.1},
                              {thread, 1.5},
                              {linear, 0.1},
                              {linear, 0.1},
                              {thread, 1.5},
                              {linear, 0.8}}));
}

}  // namespace
}  // namespace dripfeed::compile::test
