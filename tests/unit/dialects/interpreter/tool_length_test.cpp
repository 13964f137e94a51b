// Which tool length a motion goes by, and what the program changed in the control's memory.
#include <gtest/gtest.h>

#include "tests/unit/dialects/interpreter/run_trace.h"

namespace dripfeed::test {
namespace {

using ir::Address;
using ir::Function;
using ir::LengthOffset;
using Builder = ProgramBuilder;

// The moves of a program, in order.
std::vector<ir::Motion> moves_of(Builder& b, const ir::Control& control) {
  b.end();
  std::vector<ir::Motion> moves;
  for (const ir::Motion& motion : run_program(b.build(), control).motions)
    if (ir::is_move(motion.kind)) moves.push_back(motion);
  return moves;
}

TEST(ToolLength, GCodesNameAnOffset) {
  Builder b;
  b.block({{Function::rapid}}, {{Address::z, 50.0}});
  b.block({{Function::length_offset_plus}}, {{Address::h, 3.0}, {Address::z, 40.0}});
  b.block({}, {{Address::x, 1.0}});
  b.block({}, {{Address::h, 4.0}, {Address::z, 30.0}});
  b.block({{Function::length_offset_minus}}, {{Address::z, 20.0}});
  b.block({{Function::length_offset_off}}, {{Address::z, 10.0}});
  const auto moves = moves_of(b, mill_control());
  ASSERT_EQ(moves.size(), 6U);
  const LengthOffset offsets[] = {LengthOffset::off,  LengthOffset::plus,  LengthOffset::plus,
                                  LengthOffset::plus, LengthOffset::minus, LengthOffset::off};
  const int numbers[] = {0, 3, 3, 4, 4, 4};
  for (std::size_t i = 0; i < moves.size(); ++i) {
    EXPECT_EQ(moves[i].length_offset, offsets[i]) << i;
    EXPECT_EQ(moves[i].length_offset_number, numbers[i]) << i;
    EXPECT_EQ(moves[i].gaps, 0) << i;
  }
}

TEST(ToolLength, OfALatheItComesWithTheTool) {
  Builder b;
  b.block({}, {{Address::t, b.number(606, false)}});
  b.block({{Function::rapid}}, {{Address::x, 50.0}});
  b.block({}, {{Address::t, b.number(600, false)}});
  b.block({}, {{Address::x, 60.0}});
  const auto moves = moves_of(b, lathe_control());
  ASSERT_EQ(moves.size(), 2U);
  EXPECT_EQ(moves[0].length_offset, LengthOffset::plus);
  EXPECT_EQ(moves[0].length_offset_number, 6);
  EXPECT_EQ(moves[1].length_offset, LengthOffset::off);
}

TEST(ToolLength, DSelectsTheEdge) {
  Builder b;
  b.block({{Function::tool_change}}, {{Address::t, 5.0}});
  b.block({{Function::rapid}}, {{Address::z, 50.0}});
  b.block({}, {{Address::d, 2.0}, {Address::z, 40.0}});
  b.block({}, {{Address::d, 0.0}, {Address::z, 30.0}});
  const auto moves = moves_of(b, sinumerik_control());
  ASSERT_EQ(moves.size(), 3U);
  EXPECT_EQ(moves[0].length_offset, LengthOffset::plus) << "an edge is active, the program does not say which";
  EXPECT_EQ(moves[0].length_offset_number, 0);
  EXPECT_EQ(moves[1].length_offset, LengthOffset::plus);
  EXPECT_EQ(moves[1].length_offset_number, 2);
  EXPECT_EQ(moves[2].length_offset, LengthOffset::off);
}

TEST(ToolLength, AnIncrementFromAnUnknownPlaceEndsAtOne) {
  Builder b;
  b.block({{Function::rapid}, {Function::incremental}}, {{Address::x, 5.0}});
  b.block({{Function::absolute}}, {{Address::x, 5.0}});
  b.block({{Function::incremental}}, {{Address::x, 5.0}});
  const auto moves = moves_of(b, mill_control());
  ASSERT_EQ(moves.size(), 3U);
  EXPECT_EQ(moves[0].gaps, ir::kEndUnknown);
  EXPECT_EQ(moves[1].gaps, 0);
  EXPECT_EQ(moves[2].gaps, 0);
}

TEST(ToolLength, CoordinatesAtAnUnknownPlaceHaveNoZeroThatIsKnown) {
  Builder known;
  known.block({{Function::rapid}}, {{Address::x, 5.0}});
  known.block({{Function::set_coordinates}}, {{Address::x, 0.0}});
  known.block({}, {{Address::x, 5.0}});
  EXPECT_EQ(moves_of(known, mill_control()).back().gaps, 0) << "so far from the work offset as before";
  Builder unknown;
  unknown.block({{Function::set_coordinates}}, {{Address::x, 0.0}});
  unknown.block({{Function::rapid}}, {{Address::x, 5.0}});
  EXPECT_EQ(moves_of(unknown, mill_control()).back().gaps, ir::kZerosChanged);
}

}  // namespace
}  // namespace dripfeed::test
