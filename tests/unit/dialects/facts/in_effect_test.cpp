// What checks ask: stated by the text on all paths, left to the machine on one, or not known.
#include "dialects/facts/in_effect.h"

#include <gtest/gtest.h>

#include "tests/support/program_builder.h"
#include "tests/unit/dialects/facts/mill.h"

namespace dripfeed::facts {
namespace {

using ir::Address;
using ir::Function;
using ir::ModalGroup;
using ir::StatementKind;
using Builder = dripfeed::test::ProgramBuilder;

// Statement 6 follows both branches; each may state the distance mode.
const ir::Program& branching(Builder& b, bool first, bool second) {
  const auto branch = [&b](bool states) {
    if (states)
      b.block({{Function::absolute, 0, ModalGroup::distance}});
    else
      b.block({}, {{Address::f, 100.0}});
  };
  b.block({{Function::linear, 0, ModalGroup::motion}});
  b.when(StatementKind::if_begin, b.read(Builder::hash(1)));
  branch(first);
  b.structure(StatementKind::else_begin);
  branch(second);
  b.structure(StatementKind::if_end);
  b.block({}, {{Address::x, 1.0}});
  b.end();
  return b.build();
}

TEST(InEffect, IsLeftToTheMachineWhereOnePathDoesNotStateIt) {
  const ir::Control control = mill();
  for (const auto& [first, second] : {std::pair(true, true), {true, false}, {false, true}, {false, false}}) {
    Builder b;
    const ir::Program& program = branching(b, first, second);
    const Resolved facts(program, control);
    InEffect here(program, facts);
    here.at(6);
    EXPECT_EQ(here.may_be_unstated(Mode::distance), !(first && second)) << first << second;
  }
}

TEST(InEffect, KnowsNothingOfPowerOnWhereACallerMayHaveStatedAnother) {
  Builder b;
  b.block({}, {{Address::x, 1.0}});
  b.end();
  const ir::Program& program = b.build();
  const ir::Control control = mill();
  const Resolved facts(program, control);
  InEffect begins(program, facts);
  InEffect called(program, facts, false);
  begins.at(0);
  called.at(0);
  EXPECT_EQ(begins.state_against(Mode::spindle, Function::spindle_stop), State::off);
  EXPECT_TRUE(begins.lacks(Kept::feed));
  EXPECT_TRUE(begins.lacks(Number::length_number));
  EXPECT_EQ(called.state_against(Mode::spindle, Function::spindle_stop), State::uncertain);
  EXPECT_FALSE(called.lacks(Kept::feed));
  EXPECT_FALSE(called.lacks(Number::length_number));
  EXPECT_FALSE(called.may_be_unstated(Mode::unit));
}

TEST(InEffect, TakesTheBlocksOwnCodesOneAfterAnother) {
  Builder b;
  b.block({{Function::plane_xy, 0, ModalGroup::plane}});
  b.block({{Function::plane_zx, 0, ModalGroup::plane}});
  b.end();
  const ir::Program& program = b.build();
  const ir::Control control = mill();
  const Resolved facts(program, control);
  InEffect here(program, facts);
  here.at(1);
  EXPECT_EQ(here.stated(Mode::plane)->function, Function::plane_xy);
  EXPECT_EQ(here.origin(Mode::plane), 0U);
  here.take(program.codes[1]);
  EXPECT_EQ(here.stated(Mode::plane)->function, Function::plane_zx);
  EXPECT_EQ(here.origin(Mode::plane), 1U);
  here.at(2);
  EXPECT_EQ(here.origin(Mode::plane), 1U);
}

TEST(InEffect, ACallOfAnotherProgramMayHaveStatedAnything) {
  Builder b;
  b.call(ir::CallKind::subprogram, "O9000");
  b.block({}, {{Address::x, 1.0}});
  b.end();
  const ir::Program& program = b.build();
  const ir::Control control = mill();
  const Resolved facts(program, control);
  InEffect here(program, facts);
  here.at(0);
  EXPECT_TRUE(here.may_be_unstated(Mode::motion));
  here.at(1);
  EXPECT_FALSE(here.may_be_unstated(Mode::motion));
  EXPECT_FALSE(here.lacks(Kept::feed));
}

}  // namespace
}  // namespace dripfeed::facts
