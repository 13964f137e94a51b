// Words of a block that its codes do not take, or whose effect its positions do not show: counted, never dropped.
#include <gtest/gtest.h>

#include "dialects/ir/frame_use.h"
#include "tests/unit/dialects/interpreter/run_trace.h"

namespace dripfeed::test {
namespace {

using ir::Address;
using ir::Function;
using Builder = ProgramBuilder;

// M03 P11 chooses a spindle where a machine has several; R of a block without arc or cycle, no one knows what for.
TEST(IdleWords, AWordThatNoCodeTakesIsCounted) {
  const auto counted = [](std::initializer_list<Builder::CodeText> codes,
                          std::initializer_list<Builder::WordText> words, ir::Control control = mill_control()) {
    Builder b;
    b.block({{Function::rapid}}, {{Address::x, 1.0}, {Address::z, 3.0}});
    b.block(codes, words);
    b.end();
    return run_program(b.build(), control).result.not_interpreted.size();
  };
  EXPECT_EQ(counted({{Function::spindle_cw}}, {{Address::p, 11.0}}), 1U);
  EXPECT_EQ(counted({}, {{Address::s, 500.0}, {Address::p, 2.0}}), 1U);
  EXPECT_EQ(counted({{Function::tool_change}}, {{Address::t, 2.0}, {Address::r, 5.0}}), 1U);
  EXPECT_EQ(counted({{Function::linear}}, {{Address::x, 5.0}, {Address::f, 100.0}, {Address::e, 3.0}}), 1U);
  EXPECT_EQ(counted({{Function::spindle_cw}}, {{Address::s, 500.0}}), 0U);
  EXPECT_EQ(counted({{Function::surface_speed_on}}, {{Address::s, 90.0}, {Address::p, 11.0}}), 1U);
  EXPECT_EQ(counted({{Function::surface_speed_on}}, {{Address::s, 90.0}, {Address::p, 1.0}}), 0U);
  EXPECT_EQ(counted({{Function::dwell}}, {{Address::p, 500.0}}), 0U);
  EXPECT_EQ(counted({{Function::dwell}}, {{Address::x, 1.0}}), 0U);
  EXPECT_EQ(counted({{Function::dwell}}, {{Address::x, 1.0}, {Address::y, 2.0}}), 1U);
  EXPECT_EQ(counted({{Function::dwell}}, {{Address::p, 500.0}, {Address::x, 2.0}}), 1U);
  EXPECT_EQ(counted({{Function::linear}, {Function::dwell}}, {{Address::p, 500.0}, {Address::z, 2.0}}), 1U);
  EXPECT_EQ(counted({{Function::dwell}}, {{Address::u, 0.5}}, lathe_control()), 0U);
  EXPECT_EQ(counted({{Function::dwell}}, {{Address::u, 0.5}, {Address::w, 1.0}}, lathe_control()), 1U);
  EXPECT_EQ(counted({{Function::spindle_orient}}, {{Address::r, 90.0}}), 0U);
  EXPECT_EQ(counted({{Function::arc_cw}}, {{Address::x, 5.0}, {Address::r, 8.0}, {Address::f, 100.0}}), 0U);
  EXPECT_EQ(counted({{Function::spindle_cw}}, {{Address::p, 11.0}}, sinumerik_control()), 0U);
  EXPECT_EQ(counted({{Function::work_offset, 1}}, {{Address::q, 3.0}}), 1U);
  const ir::Control lathe = lathe_control();
  EXPECT_EQ(counted({{Function::linear}}, {{Address::r, 3.0}}, lathe), 1U);
  EXPECT_EQ(counted({{Function::linear}, {Function::comp_off}},
                    {{Address::x, 5.0}, {Address::i, 2.0}, {Address::f, 1.0}}, lathe),
            1U);
}

// Fanuc takes other commands next to G69 (16i-LA B-63194EN/02, 12.6); of other controls and of G50 no source was found.
TEST(IdleWords, AnAxisInTheBlockThatEndsARotationIsNotKnown) {
  const auto end_of_run = [](std::initializer_list<Builder::WordText> words) {
    Builder b;
    b.block({{Function::linear}}, {{Address::x, 1.0}, {Address::y, 2.0}, {Address::z, 3.0}, {Address::f, 100.0}});
    b.block({{Function::rotate, ir::kFrameEnds}}, words);
    b.block({}, {{Address::y, 5.0}});
    b.end();
    return run_program(b.build(), mill_control());
  };
  EXPECT_TRUE(end_of_run({}).result.not_interpreted.empty());
  const auto moved = end_of_run({{Address::x, 40.0}});
  ASSERT_EQ(moved.result.not_interpreted.size(), 1U);
  EXPECT_EQ(moved.result.not_interpreted[0].function, Function::rotate);
  EXPECT_EQ(moved.result.not_interpreted[0].first_line, 2U);
}

TEST(IdleWords, AnAxisThatIsNamedTwiceIsNotKnown) {
  const auto counted = [](std::initializer_list<Builder::WordText> words, const ir::Control& control) {
    Builder b;
    b.block({{Function::rapid}}, {{Address::x, 50.0}, {Address::z, 3.0}});
    b.block({{Function::linear}}, words);
    b.end();
    return run_program(b.build(), control).result.not_interpreted.size();
  };
  const ir::Control lathe = lathe_control();
  EXPECT_EQ(counted({{Address::x, 40.0}, {Address::w, -1.0}, {Address::f, 1.0}}, lathe), 0U);
  EXPECT_EQ(counted({{Address::x, 40.0}, {Address::u, -1.0}, {Address::f, 1.0}}, lathe), 1U);
  EXPECT_EQ(counted({{Address::z, 40.0}, {Address::x, 3.0}, {Address::w, -1.0}, {Address::f, 1.0}}, lathe), 1U);
}

TEST(IdleWords, TheStartOfAThreadIsNotInItsPositions) {
  const auto counted = [](Function function, std::int16_t argument, double angle) {
    Builder b;
    b.block({{Function::rapid}}, {{Address::x, 50.0}, {Address::z, 3.0}});
    b.block({{function, argument}}, {{Address::x, 40.0}, {Address::z, -9.0}, {Address::f, 1.0}, {Address::q, angle}});
    b.end();
    return run_program(b.build(), lathe_control()).result.not_interpreted.size();
  };
  constexpr auto kCycle = static_cast<std::int16_t>(ir::TurningCycle::thread);
  EXPECT_EQ(counted(Function::thread, 0, 180'000.0), 1U);
  EXPECT_EQ(counted(Function::thread, 0, 0.0), 0U);
  EXPECT_EQ(counted(Function::turning_cycle, kCycle, 180'000.0), 1U);
  EXPECT_EQ(counted(Function::turning_cycle, kCycle, 0.0), 0U);
}

}  // namespace
}  // namespace dripfeed::test
