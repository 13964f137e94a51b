// Holes of families: each cycle as the control's own, and its moves against those that the words mean.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "dialects/text/number.h"
#include "tests/unit/dialects/compile/render/family_run.h"

namespace dripfeed::compile::test {
namespace {

text::Source holes(const std::string& cycle, const std::string& at = "    at x 10 mm y 5 mm\n    at x 20 mm\n") {
  return with(
      "param depth length 12 mm in 1..50\nparam top length 2 mm in 1..9\n",
      "  spindle 500 rpm cw\n  rapid x 0 mm y 0 mm z 30 mm\n  " + cycle + "\n" + at + "  end\n  rapid x 0 mm y 0 mm\n");
}

// "r" or "c" and X Y Z of each move with a length.
std::vector<std::string> path_of(const std::vector<ir::Motion>& motions) {
  std::vector<std::string> out;
  for (const ir::Motion& m : real_moves(motions)) {
    std::string one = m.kind == ir::MotionKind::rapid ? "r" : "c";
    for (std::size_t axis = 0; axis < 3; ++axis) one += " " + text::format_shortest(m.end[axis]);
    out.push_back(one);
  }
  return out;
}

std::string macro_of(const text::Source& family, const std::string& dialect, const Values& values = {}) {
  const RenderResult result = rendered(family, dialect, RenderMode::macro, values);
  EXPECT_TRUE(result.diagnostics.empty()) << dialect << messages_of(result.diagnostics, family);
  return result.text;
}

using Path = std::vector<std::string>;

TEST(FamilyHoles, DrillGoesInByFeedAndOutByRapid) {
  const text::Source family = holes("drill from top to -depth");
  EXPECT_EQ(path_of(one_trace(family)), (Path{"r 0 0 30", "r 10 5 30", "r 10 5 2", "c 10 5 -12", "r 10 5 2", "r 20 5 2",
                                              "c 20 5 -12", "r 20 5 2", "r 0 0 2"}));
  EXPECT_TRUE(macro_of(family, "fanuc").contains("G99 G81 X10. Y5. Z#102 R#101 F100.")) << macro_of(family, "fanuc");
  EXPECT_TRUE(macro_of(family, "sinumerik-840d").contains("MCALL CYCLE81(")) << macro_of(family, "sinumerik-840d");
}

TEST(FamilyHoles, PecksLeaveTheHole) {
  const text::Source family = holes("drill from top to -depth peck 6 mm", "    at x 10 mm y 5 mm\n");
  EXPECT_EQ(path_of(one_trace(family)),
            (Path{"r 0 0 30", "r 10 5 30", "r 10 5 2", "c 10 5 -4", "r 10 5 2", "r 10 5 -3", "c 10 5 -10", "r 10 5 2",
                  "r 10 5 -9", "c 10 5 -12", "r 10 5 2", "r 0 0 2"}));
  EXPECT_TRUE(macro_of(family, "haas").contains("G83")) << macro_of(family, "haas");
}

TEST(FamilyHoles, ReturnIsTheLevelBetweenHoles) {
  const text::Source family =
      with("param over length 25 mm in 10..50\nparam n count 2 in 1..9\n",
           "  spindle 500 rpm cw\n  rapid x 0 mm y 0 mm z 30 mm\n  drill from 2 mm to -5 mm return over\n"
           "    for q from 1 to n step 1\n      at x q*10 mm y 0 mm\n    end\n    at x 50 mm\n  end\n  rapid x 0 mm\n");
  EXPECT_EQ(path_of(one_trace(family)),
            (Path{"r 0 0 30", "r 0 0 25", "r 10 0 25", "r 10 0 2", "c 10 0 -5", "r 10 0 25", "r 20 0 25", "r 20 0 2",
                  "c 20 0 -5", "r 20 0 25", "r 50 0 25", "r 50 0 2", "c 50 0 -5", "r 50 0 25", "r 0 0 25"}));
}

// Every cycle with its code on every control.
TEST(FamilyHoles, CyclesAreTheControls) {
  struct Row {
    const char* cycle;
    const char* code;
    const char* call;
  };
  const Row rows[] = {{"drill from top to -depth", "G81", "CYCLE81("},
                      {"drill from top to -depth dwell 0.5 s", "G82", "CYCLE82("},
                      {"drill from top to -depth peck 5 mm", "G83", "CYCLE83("},
                      {"drill from top to -depth break 5 mm dwell 1 s", "G73", "CYCLE83("},
                      {"ream from top to -depth", "G85", "CYCLE85("},
                      {"ream from top to -depth dwell 250 ms", "G89", "CYCLE85("},
                      {"bore from top to -depth", "G86", "CYCLE86("},
                      {"tap from top to -depth pitch 1.5 mm", "G84", "CYCLE84("},
                      {"tap from top to -depth pitch 1.5 mm left", "", "CYCLE84("}};
  for (const Row& row : rows) {
    for (const std::string& dialect : dialect_names()) {
      const std::string text = macro_of(holes(row.cycle), dialect);
      const bool calls = dialect == "sinumerik-840d";
      EXPECT_TRUE(text.contains(calls ? row.call : row.code)) << row.cycle << " " << dialect << "\n" << text;
      EXPECT_TRUE(text.contains(calls ? "MCALL\n" : "G80")) << row.cycle << " " << dialect << "\n" << text;
    }
  }
}

TEST(FamilyHoles, ADwellIsSecondsOnEveryControl) {
  for (const char* cycle : {"drill from top to -depth dwell 0.5 s", "ream from top to -depth dwell 500 ms"}) {
    for (const std::string& dialect : dialect_names()) {
      for (const RenderMode mode : {RenderMode::macro, RenderMode::explicit_blocks}) {
        const std::string text = rendered(holes(cycle), dialect, mode, {}).text;
        std::vector<double> dwells;
        for (const ir::Motion& m : run_text(text, control(dialect, ir::MachineKind::mill)).motions)
          if (m.kind == ir::MotionKind::dwell) dwells.push_back(m.feed);
        EXPECT_EQ(dwells, (std::vector<double>{0.5, 0.5})) << dialect << "\n" << text;
      }
    }
  }
}

// The lead of every cut of a tap is its pitch, in by one turn of the spindle and out by the other, and the feed after
// it is the one before.
TEST(FamilyHoles, ATapTurnsTheSpindleByItsPitch) {
  for (const bool left : {false, true}) {
    const text::Source family =
        with("param n count 2 in 1..5\nparam speed_rpm speed 400 rpm in 100..900\nparam slow feed 70 mm/min in 1..99\n",
             std::string("  spindle speed_rpm cw\n  rapid x 0 mm y 0 mm z 30 mm\n  feed slow\n") +
                 "  tap from 4 mm to -9 mm pitch 1.25 mm" + (left ? " left" : "") +
                 "\n    at x 1 mm y 1 mm\n    for q from 1 to n step 1\n      at x q*10 mm y 5 mm\n    end\n  end\n"
                 "  cut x 90 mm\n");
    for (const std::string& dialect : dialect_names()) {
      for (const RenderMode mode : {RenderMode::macro, RenderMode::explicit_blocks}) {
        const RenderResult result = rendered(family, dialect, mode, {});
        const std::string what = dialect + " " + std::string(name_of(mode)) + "\n" + result.text;
        ASSERT_TRUE(result.diagnostics.empty()) << what << messages_of(result.diagnostics, family);
        std::vector<ir::Motion> cuts =
            real_moves(run_text(result.text, control(dialect, ir::MachineKind::mill)).motions);
        std::erase_if(cuts, [](const ir::Motion& m) { return m.kind == ir::MotionKind::rapid; });
        ASSERT_EQ(cuts.size(), 7U) << what;
        for (std::size_t i = 0; i < 6; ++i) {
          const bool by_turn = cuts[i].kind == ir::MotionKind::thread || cuts[i].feed_mode == ir::FeedMode::per_rev;
          EXPECT_TRUE(by_turn) << what;
          EXPECT_DOUBLE_EQ(std::abs(cuts[i].feed), 1.25) << what;
          EXPECT_DOUBLE_EQ(cuts[i].spindle_rpm, 400.0) << what;
          EXPECT_DOUBLE_EQ(cuts[i].end[2], i % 2 == 0 ? -9.0 : 4.0) << what;
          // G331 turns in the other direction where its lead is below zero.
          const bool clockwise = cuts[i].spindle == ir::SpindleState::clockwise;
          if (dialect.starts_with("sinumerik"))
            EXPECT_EQ(cuts[i].feed < 0.0, left) << what;
          else
            EXPECT_EQ(clockwise, (i % 2 == 0) != left) << what;
        }
        EXPECT_DOUBLE_EQ(cuts[6].feed, 70.0) << what;
        EXPECT_EQ(cuts[6].feed_mode, ir::FeedMode::per_min) << what;
      }
    }
  }
}

// The word that makes a tap rigid stands once before each cycle, never in one.
TEST(FamilyHoles, ATapIsMadeRigidOnceACycle) {
  const text::Source family =
      holes("tap from top to -depth pitch 1 mm",
            "    at x 1 mm y 1 mm\n    at x 2 mm\n    for q from 3 to 4 step 1\n      at x q*1 mm\n"
            "    end\n    at x 5 mm\n");
  const std::string text = macro_of(family, "fanuc");
  bool in_cycle = false;
  std::size_t begins = 0;
  for (std::size_t at = 0; at < text.size(); at = std::min(text.find('\n', at), text.size() - 1) + 1) {
    const std::string line = text.substr(at, text.find('\n', at) - at);
    if (line.contains("M29")) {
      EXPECT_FALSE(in_cycle) << text;
      ++begins;
    }
    if (line.contains("G84")) in_cycle = true;
    if (line.contains("G80")) in_cycle = false;
  }
  EXPECT_EQ(begins, 3U) << text;
}

// What is set among holes does not change the cycle that is in effect.
TEST(FamilyHoles, ACycleKeepsItsValues) {
  const std::string steps =
      "  let low = -5 mm\n  rapid x 0 mm y 0 mm z 30 mm\n  drill from 2 mm to low\n    at x 1 mm\n    set low = -9 mm\n"
      "    at x 2 mm\n    if low < -6 mm\n      at x 3 mm\n    end\n  end\n  drill from 2 mm to low\n    at x 4 mm\n  "
      "end\n";
  std::vector<double> depths;
  for (const ir::Motion& m : one_trace(with("", steps)))
    if (m.kind == ir::MotionKind::linear) depths.push_back(m.end[2]);
  EXPECT_EQ(depths, (std::vector<double>{-5, -5, -5, -9}));
}

// A feed that waits goes into the first hole; one of several is kept while a tap is cut.
TEST(FamilyHoles, TheFeedIsTheLastOne) {
  const text::Source family =
      with("param n count 3 in 1..9\n",
           "  spindle 500 rpm cw\n  rapid x 0 mm y 0 mm z 30 mm\n  for q from 1 to n step 1\n    if q > 1\n      feed "
           "q*10 mm/min\n"
           "    end\n    drill from 2 mm to -5 mm\n      at x q*1 mm\n    end\n  tap from 2 mm to -5 mm pitch 1 mm\n"
           "      at x q*1 mm\n    end\n    cut x 50 mm\n  end\n");
  for (const std::string& dialect : dialect_names()) {
    const std::string text = macro_of(family, dialect);
    std::vector<double> feeds;
    for (const ir::Motion& m : real_moves(run_text(text, control(dialect, ir::MachineKind::mill)).motions))
      if (m.kind == ir::MotionKind::linear && m.feed_mode == ir::FeedMode::per_min) feeds.push_back(m.feed);
    EXPECT_EQ(feeds, (std::vector<double>{100, 100, 20, 20, 30, 30})) << dialect << "\n" << text;
  }
}

}  // namespace
}  // namespace dripfeed::compile::test
