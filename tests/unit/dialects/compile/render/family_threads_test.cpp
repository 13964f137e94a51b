// Threads of families: leads, and the feed after them.
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/unit/dialects/compile/render/family_run.h"

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
TEST(FamilyThreads, TheFeedAfterAThreadIsTheOneBefore) {
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

// The letter of the lead names the axis that the cone is longer along, also where the control computes its end.
TEST(FamilyThreads, TheLeadOfASteepConeCountsAlongX) {
  const text::Source steep = lathe(
      "  rapid x 20 mm z 3 mm\n  let far = 50 mm + n*10 mm\n  thread x far z 0 mm pitch p\n  thread x far + 10 mm z "
      "-20 mm pitch p\n"
      "  rapid x 20 mm z 3 mm\n  thread x 40 mm z -8 mm pitch 2*p\n");
  EXPECT_EQ(cuts_of(steep).size(), 3U);
  for (const RenderMode mode : {RenderMode::macro, RenderMode::explicit_blocks}) {
    const std::string text = rendered(steep, "sinumerik-840d", mode, {}).text;
    std::string letters;
    for (std::size_t at = text.find("G33"); at != std::string::npos && at < text.size(); at = text.find('\n', at) + 1) {
      const std::string line = text.substr(at, text.find('\n', at) - at);
      if (line.contains(" I")) letters += 'I';
      if (line.contains(" K")) letters += 'K';
    }
    EXPECT_EQ(letters, "IKK") << text;
  }
}

// Which letter it is, no macro can choose.
TEST(FamilyThreads, AConeThatIsNowSteepAndNowNotIsPlainBlocks) {
  const text::Source both = lathe(
      "  for q from 1 to 3 step 1\n    rapid x 20 mm z 3 mm\n    thread x 20 mm + q*20 mm z -22 mm pitch p\n  end\n");
  const RenderResult made = rendered(both, "sinumerik-840d", RenderMode::automatic, {});
  EXPECT_EQ(made.mode, RenderMode::explicit_blocks);
  EXPECT_TRUE(made.because.contains("now longer along X")) << made.because;
  EXPECT_TRUE(made.text.contains(" K1.5") && made.text.contains(" I1.5")) << made.text;
  EXPECT_TRUE(text::has_error(rendered(both, "sinumerik-840d", RenderMode::macro, {}).diagnostics));
  EXPECT_FALSE(text::has_error(rendered(both, "fanuc", RenderMode::macro, {}).diagnostics));
}

}  // namespace
}  // namespace dripfeed::compile::test
