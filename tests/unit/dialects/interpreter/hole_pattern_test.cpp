// G34 to G37.1: where the holes lie, by sines and cosines of a table, and that each is a hole of the cycle in effect.
#include "dialects/ir/hole_pattern.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "dialects/ir/cycle.h"
#include "tests/unit/dialects/interpreter/run_trace.h"

namespace dripfeed::test {
namespace {

using ir::Address;
using ir::Function;
using Builder = ProgramBuilder;

Builder::CodeText figure(std::int16_t argument) {
  return {Function::hole_pattern, argument, ir::ModalGroup::non_modal};
}
const std::string kPositionsOnly = "a hole pattern without a drilling cycle";
const std::string kNotCertain = "a word of a hole pattern that may mean something else";
const std::string kIncrements = "increments from a position that is not known";

struct Place {
  double x;
  double y;
};
struct Drilled {
  Ran ran;
  std::vector<Place> holes;  // where a feed went down to Z-10
  std::vector<std::string> messages;
};
Drilled drilled(Builder& b, const ir::Control& control = mill_control()) {
  b.end();
  Drilled out{run_program(b.build(), control), {}, {}};
  for (const ir::Motion& m : out.ran.motions)
    if (m.kind == ir::MotionKind::linear && m.end[2] == -10.0) out.holes.push_back({m.end[0], m.end[1]});
  for (const auto& one : out.ran.result.not_interpreted) out.messages.push_back(one.name);
  return out;
}
void begin(Builder& b) {
  b.block({{Function::rapid}, {Function::absolute}}, {{Address::x, 0.0}, {Address::y, 0.0}, {Address::z, 50.0}});
  b.block({{Function::drill, ir::drill_argument(ir::DrillCycle::drill)}},
          {{Address::z, -10.0}, {Address::r, 5.0}, {Address::l, 0.0}, {Address::f, 200.0}});
}
void expect_holes(const Drilled& actual, const std::vector<Place>& expected, double tolerance = 1e-9) {
  ASSERT_EQ(actual.holes.size(), expected.size()) << actual.ran.trace;
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_NEAR(actual.holes[i].x, expected[i].x, tolerance) << i;
    EXPECT_NEAR(actual.holes[i].y, expected[i].y, tolerance) << i;
  }
}

// The example of the manual's G34: six holes on a radius of 100 about X200 Y100, the first at 20 degrees.
TEST(HolePattern, ACircleBeginsAtItsAngleAndGoesCounterclockwise) {
  const std::vector<Place> six = {{293.96926, 134.20201}, {217.36482, 198.48078}, {123.39556, 164.27876},
                                  {106.03074, 65.79799},  {182.63518, 1.51922},   {276.60444, 35.72124}};
  for (const double count : {6.0, -6.0}) {
    Builder b;
    begin(b);
    b.block({figure(ir::kHolesOnCircle)},
            {{Address::x, 200.0}, {Address::y, 100.0}, {Address::i, 100.0}, {Address::j, 20.0}, {Address::k, count}});
    b.block({}, {{Address::x, 7.0}});
    b.block({{Function::cycle_off}});
    const Drilled run = drilled(b);
    std::vector<Place> expected = six;
    if (count < 0.0) expected = {six[0], six[5], six[4], six[3], six[2], six[1]};
    expected.push_back({7.0, expected.back().y});  // over the last hole, and the cycle goes on
    expect_holes(run, expected, 1e-5);
    EXPECT_TRUE(run.messages.empty());
  }
}

TEST(HolePattern, EachHoleIsMadeAsItsOwnBlockWouldMakeIt) {
  Builder b;
  begin(b);
  b.block({figure(ir::kHolesOnLine), {Function::return_to_r}},
          {{Address::x, 10.0}, {Address::y, 5.0}, {Address::i, 4.0}, {Address::j, 90.0}, {Address::k, 2.0}});
  EXPECT_EQ(drilled(b).ran.trace,
            "1 rapid X0.0000 Y0.0000 Z50.0000\n3 rapid X10.0000 Y5.0000 Z50.0000\n3 rapid X10.0000 Y5.0000 Z5.0000\n"
            "3 linear X10.0000 Y5.0000 Z-10.0000 F200.0000/min\n3 rapid X10.0000 Y5.0000 Z5.0000\n"
            "3 rapid X10.0000 Y9.0000 Z5.0000\n3 linear X10.0000 Y9.0000 Z-10.0000 F200.0000/min\n"
            "3 rapid X10.0000 Y9.0000 Z5.0000\n4 end\n");
}

TEST(HolePattern, LineArcAndGrid) {
  Builder b;
  begin(b);
  b.block({figure(ir::kHolesOnLine)},
          {{Address::x, 10.0}, {Address::y, 20.0}, {Address::i, -10.0}, {Address::j, 30.0}, {Address::k, 3.0}});
  b.block({figure(ir::kHolesOnArc)}, {{Address::x, 0.0},
                                      {Address::y, 0.0},
                                      {Address::i, 20.0},
                                      {Address::j, 90.0},
                                      {Address::p, -30.0},
                                      {Address::k, 3.0}});
  b.block({figure(ir::kHolesOnGrid)}, {{Address::x, 1.0},
                                       {Address::y, 2.0},
                                       {Address::i, 10.0},
                                       {Address::p, 3.0},
                                       {Address::j, -8.0},
                                       {Address::k, 2.0}});
  const double root = std::sqrt(3.0);
  const Drilled run = drilled(b);
  expect_holes(run, {{10, 20},
                     {10 - 5 * root, 15},
                     {10 - 10 * root, 10},
                     {0, 20},
                     {10, 10 * root},
                     {10 * root, 10},
                     {1, 2},
                     {11, 2},
                     {21, 2},
                     {21, -6},
                     {11, -6},
                     {1, -6}});
  EXPECT_TRUE(run.messages.empty());
}

TEST(HolePattern, IncrementsInchAndFramesCountAsInABlock) {
  Builder b;
  begin(b);
  b.block({}, {{Address::x, 3.0}, {Address::y, 4.0}});
  b.block({figure(ir::kHolesOnLine), {Function::incremental}},
          {{Address::x, 10.0}, {Address::y, 0.0}, {Address::i, 5.0}, {Address::k, 2.0}});
  b.block({figure(ir::kHolesOnLine), {Function::absolute}, {Function::unit_inch}},
          {{Address::x, 1.0}, {Address::y, 2.0}, {Address::i, 0.5}, {Address::k, 2.0}});
  b.block({{Function::local_shift}, {Function::unit_mm}}, {{Address::x, 100.0}, {Address::y, 0.0}});
  b.block({figure(ir::kHolesOnLine)}, {{Address::x, 1.0}, {Address::y, 2.0}, {Address::i, 5.0}, {Address::k, 2.0}});
  expect_holes(drilled(b), {{3, 4}, {13, 4}, {18, 4}, {25.4, 50.8}, {38.1, 50.8}, {101, 2}, {106, 2}});
}

// In the ZX plane Z is the first axis, and the cycle drills along Y.
TEST(HolePattern, ThePlanesOwnAxesAreMeant) {
  Builder b;
  b.block({{Function::rapid}, {Function::plane_zx}}, {{Address::x, 0.0}, {Address::y, 9.0}, {Address::z, 0.0}});
  b.block({{Function::drill, ir::drill_argument(ir::DrillCycle::drill)}},
          {{Address::y, -1.0}, {Address::r, 2.0}, {Address::l, 0.0}, {Address::f, 200.0}});
  b.block({figure(ir::kHolesOnLine)},
          {{Address::z, 10.0}, {Address::x, 20.0}, {Address::i, 5.0}, {Address::j, 90.0}, {Address::k, 2.0}});
  const Drilled run = drilled(b);
  std::vector<Place> holes;
  for (const ir::Motion& m : run.ran.motions)
    if (m.kind == ir::MotionKind::linear) holes.push_back({m.end[0], m.end[2]});
  ASSERT_EQ(holes.size(), 2U) << run.ran.trace;
  EXPECT_NEAR(holes[1].x, 25.0, 1e-12);
  EXPECT_NEAR(holes[1].y, 10.0, 1e-12);
}

TEST(HolePattern, WhatIsNotCertainIsReported) {
  const auto messages = [](const std::vector<Builder::WordText>& words, std::int16_t argument, bool with_cycle = true,
                           bool from_known = true) {
    Builder b;
    if (from_known) b.block({{Function::rapid}, {Function::absolute}}, {{Address::x, 0.0}, {Address::y, 0.0}});
    b.block({{Function::rapid}, {Function::absolute}}, {{Address::z, 50.0}});
    if (with_cycle)
      b.block({{Function::drill, ir::drill_argument(ir::DrillCycle::drill)}},
              {{Address::z, -10.0}, {Address::r, 5.0}, {Address::l, 0.0}, {Address::f, 200.0}});
    b.block(std::vector{figure(argument)}, words);
    return drilled(b);
  };
  using Words = std::vector<Builder::WordText>;
  const Words line = {{Address::x, 1.0}, {Address::y, 2.0}, {Address::i, 5.0}, {Address::k, 2.0}};
  EXPECT_TRUE(messages(line, ir::kHolesOnLine).messages.empty());
  const Drilled positions = messages(line, ir::kHolesOnLine, false);
  EXPECT_EQ(positions.messages, std::vector{kPositionsOnly});
  EXPECT_NE(positions.ran.trace.find("rapid X6.0000 Y2.0000 Z50.0000"), std::string::npos) << positions.ran.trace;
  // From where the tool stands, as far as that is known.
  const Words no_place = {{Address::i, 5.0}, {Address::k, 2.0}};
  EXPECT_EQ(messages(no_place, ir::kHolesOnLine).messages, std::vector{kNotCertain});
  EXPECT_EQ(messages(no_place, ir::kHolesOnLine).holes.size(), 2U);
  const Drilled nowhere = messages(no_place, ir::kHolesOnLine, true, false);
  EXPECT_NE(std::ranges::find(nowhere.messages, kIncrements), nowhere.messages.end());
  EXPECT_TRUE(nowhere.holes.empty());
  // A radius or a number below 0, a part of a hole, no spacing.
  const Words radius = {{Address::x, 1.0}, {Address::y, 2.0}, {Address::i, -5.0}, {Address::k, 2.0}};
  EXPECT_EQ(messages(radius, ir::kHolesOnCircle).messages, std::vector{kNotCertain});
  EXPECT_TRUE(messages(radius, ir::kHolesOnLine).messages.empty());
  const Words below = {{Address::x, 1.0}, {Address::y, 2.0}, {Address::i, 5.0}, {Address::k, -2.0}};
  EXPECT_EQ(messages(below, ir::kHolesOnLine).messages, std::vector{kNotCertain});
  EXPECT_TRUE(messages(below, ir::kHolesOnCircle).messages.empty());
  const Words part = {{Address::x, 1.0}, {Address::y, 2.0}, {Address::i, 5.0}, {Address::k, 2.5}};
  EXPECT_EQ(messages(part, ir::kHolesOnLine).messages, std::vector{kNotCertain});
  const Words no_spacing = {{Address::x, 1.0}, {Address::y, 2.0}, {Address::k, 2.0}};
  EXPECT_EQ(messages(no_spacing, ir::kHolesOnLine).messages, std::vector{kNotCertain});
  EXPECT_TRUE(messages(no_spacing, ir::kHolesOnLine).holes.empty());
}

TEST(HolePattern, AGridOfTooManyHolesIsALimit) {
  Builder b;
  begin(b);
  b.block({figure(ir::kHolesOnGrid)}, {{Address::x, 1.0},
                                       {Address::y, 2.0},
                                       {Address::i, 1.0},
                                       {Address::p, 9999.0},
                                       {Address::j, 1.0},
                                       {Address::k, 9999.0}});
  EXPECT_EQ(drilled(b).ran.result.ended, interpreter::Ended::limit);
}

}  // namespace
}  // namespace dripfeed::test
