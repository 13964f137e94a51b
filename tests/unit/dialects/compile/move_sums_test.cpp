// What the moves of a program's stretches add up to: whatever one of them differs by shows, also two that change
// places. Lines outside of a stretch are compared by where they lead.
#include "dialects/compile/translate/move_sums.h"

#include <functional>
#include <vector>

#include <gtest/gtest.h>

namespace dripfeed::compile {
namespace {

using ir::Motion;
using ir::MotionKind;

// Lines 11 to 20 and 31 to 1030.
const std::vector<ir::PlainStretch> kStretches = {{.line = 11, .line_count = 10}, {.line = 31, .line_count = 1000}};

Motion move(std::uint32_t line, double x, MotionKind kind = MotionKind::linear) {
  Motion m;
  m.place.line = line;
  m.kind = kind;
  m.axes_commanded = 1;
  m.end[0] = x;
  m.feed = 100.0;
  return m;
}
Motion called(Motion m) {
  m.place.program = 1;
  return m;
}
std::vector<Motion> program() {
  return {move(10, 1.0), move(11, 2.0),  move(12, 3.0, MotionKind::arc_cw),   move(13, 4.0, MotionKind::rapid),
          move(21, 5.0), move(31, -6.0), move(300, 7.0, MotionKind::arc_ccw), move(1031, 8.0)};
}

bool same(const std::vector<Motion>& a, const std::vector<Motion>& b) {
  MoveSums first(kStretches, nullptr);
  MoveSums second(kStretches, nullptr);
  first.consume(a);
  second.consume(b);
  return first.same(second);
}

TEST(MoveSums, EachDifferenceShows) {
  const struct {
    const char* what;
    std::function<void(std::vector<Motion>&)> change;
  } rows[] = {
      {"end", [](auto& m) { m[1].end[0] += 1e-4; }},
      {"axis",
       [](auto& m) {
         m[1].axes_commanded = 3;
         m[1].end[1] = 1.0;
       }},
      {"center of an arc, clockwise", [](auto& m) { m[2].center[1] += 1e-4; }},
      {"center of an arc, counterclockwise", [](auto& m) { m[6].center[0] += 1e-4; }},
      {"kind",
       [](auto& m) {
         m[1].kind = MotionKind::rapid;
         m[1].feed = 0.0;
         m[3].feed = 100.0;
       }},
      {"compensation", [](auto& m) { m[1].comp = ir::CompSide::left; }},
      {"feed", [](auto& m) { m[1].feed = 101.0; }},
      {"feed mode", [](auto& m) { m[1].feed_mode = ir::FeedMode::per_rev; }},
      {"speed", [](auto& m) { m[3].spindle_rpm = 1.0; }},
      {"ends change places", [](auto& m) { std::swap(m[1].end, m[2].end); }},
      {"kinds change places", [](auto& m) { std::swap(m[1].kind, m[2].kind); }},
      {"feeds change places",
       [](auto& m) {
         m[1].feed = 90.0;
         m[2].feed = 110.0;
       }},
      {"a move less", [](auto& m) { m.erase(m.begin() + 1); }},
      {"a move of no length more",
       [](auto& m) {
         m.insert(m.begin() + 1, m[1]);
         m[1].end[0] = 0.0;
         m[1].feed = 0.0;
       }},
      {"another piece", [](auto& m) { m[6].place.line = 31 + MoveSums::kLinesOfAPiece - 1; }},
      {"another stretch", [](auto& m) { m[5].place.line = 20; }},
      {"the end of a line outside", [](auto& m) { m[0].end[2] = 1.0; }},
      {"what lies on the path of a line outside", [](auto& m) { m.insert(m.begin(), move(10, 9.0)); }},
      {"what lies before it", [](auto& m) { m.insert(m.begin(), move(10, -9.0)); }},
      {"a line outside less", [](auto& m) { m.pop_back(); }},
      {"a line outside more", [](auto& m) { m.push_back(move(22, 5.0)); }},
  };
  EXPECT_TRUE(same(program(), program()));
  for (const auto& [what, change] : rows) {
    std::vector<Motion> other = program();
    change(other);
    EXPECT_FALSE(same(program(), other)) << what;
    EXPECT_FALSE(same(other, program())) << what;
  }
}

TEST(MoveSums, WhatMovesNothingCountsNot) {
  std::vector<Motion> other = program();
  other[1].end[1] = 50.0;                                // an axis that the block does not name
  other[1].center[0] = 3.0;                              // a line has no centre
  other[3].feed = 7.0;                                   // a rapid has no feed
  other[2].end[0] += 1e-9;                               // less than a rounding
  other.push_back(move(12, 99.0, MotionKind::spindle));  // an event
  other.push_back(called(move(12, 99.0)));               // a called program
  EXPECT_TRUE(same(program(), other));
}

TEST(MoveSums, LinesOfATranslationAreThoseOfTheSource) {
  const std::vector<ir::PlainStretch> none = {{.line = 100, .line_count = 1}};
  const std::vector<std::uint32_t> origins = {7, 8, 8};
  MoveSums source(none, nullptr);
  source.consume(std::vector{move(7, 1.0), move(8, 2.0)});
  MoveSums made(none, &origins);
  made.consume(std::vector{move(1, 1.0), move(2, 1.5), move(3, 2.0)});
  EXPECT_FALSE(source.same(made));  // line 8 leads elsewhere in between
  MoveSums again(none, &origins);
  again.consume(std::vector{move(1, 1.0), move(3, 2.0)});
  EXPECT_TRUE(source.same(again));
}

}  // namespace
}  // namespace dripfeed::compile
