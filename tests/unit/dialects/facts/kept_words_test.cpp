// Words that stay in effect: the tool by T and M6, what was computed, and what a turning cycle keeps.
#include <gtest/gtest.h>

#include "dialects/facts/facts.h"
#include "tests/support/program_builder.h"

namespace dripfeed::facts {
namespace {

using ir::Address;
using ir::Function;
using ir::ModalGroup;
using Builder = dripfeed::test::ProgramBuilder;

ir::Control control_of(ir::MachineKind kind) {
  ir::Control control;
  control.kind = kind;
  control.axes = kind == ir::MachineKind::mill ? "XYZ" : "XZ";
  control.semantics.power_on_known = true;
  return control;
}
constexpr Builder::CodeText kChange = {.function = Function::tool_change, .letter = 'M'};

TEST(KeptWords, TOnlyPreparesWhereM6Changes) {
  Builder b;
  b.block({}, {{Address::t, 2.0}});
  b.block({kChange});
  b.end();
  const ir::Program& program = b.build();
  const ir::Control control = control_of(ir::MachineKind::mill);
  const Resolved resolved(program, control);
  EXPECT_EQ(tool_in(program, (*resolved.before(1))[Kept::tool]).state, ToolIn::State::none);
  EXPECT_EQ(tool_in(program, (*resolved.before(1))[Kept::next_tool]).number, 2.0);
  EXPECT_EQ(tool_in(program, (*resolved.before(2))[Kept::tool]).number, 2.0);
}

TEST(KeptWords, ATextWithoutM6ChangesByTForWhoeverAsks) {
  Builder b;
  b.block({}, {{Address::t, 2.0}});
  b.end();
  const ir::Program& program = b.build();
  const ir::Control control = control_of(ir::MachineKind::mill);
  EXPECT_EQ(tool_in(program, (*Resolved(program, control).before(1))[Kept::tool]).state, ToolIn::State::none);
  const Resolved as_the_text(program, control, ToolChange::as_the_text);
  EXPECT_EQ(tool_in(program, (*as_the_text.before(1))[Kept::tool]).number, 2.0);
}

TEST(KeptWords, ACalledProgramMayHaveChangedTheTool) {
  Builder b;
  b.block({kChange}, {{Address::t, 2.0}});
  b.call(ir::CallKind::subprogram, "O9000");
  b.end();
  const ir::Program& program = b.build();
  const ir::Control control = control_of(ir::MachineKind::mill);
  const Resolved resolved(program, control);
  const ToolIn tool = tool_in(program, (*resolved.before(2))[Kept::tool]);
  EXPECT_EQ(tool.state, ToolIn::State::tool);
  EXPECT_EQ(tool.changer, 1U);
}

TEST(KeptWords, WhatWasComputedIsNotKnownOnceItsVariableChanges) {
  Builder b;
  b.block({kChange}, {{Address::t, b.read(Builder::hash(100))}});
  b.assign(Builder::hash(101), b.number(1.0));
  b.assign(Builder::hash(100), b.number(1.0));
  b.end();
  const ir::Program& program = b.build();
  const ir::Control control = control_of(ir::MachineKind::mill);
  const Resolved resolved(program, control);
  EXPECT_EQ(tool_in(program, (*resolved.before(2))[Kept::tool]).state, ToolIn::State::tool) << "another variable";
  EXPECT_EQ(tool_in(program, (*resolved.before(3))[Kept::tool]).state, ToolIn::State::differs);
}

TEST(KeptWords, ATurningCycleKeepsItsEndsAndLeavesTheToolWhereItBegan) {
  Builder b;
  b.block({{Function::rapid, 0, ModalGroup::motion}}, {{Address::x, 50.0}, {Address::z, 2.0}});
  b.block({{Function::turning_cycle, 0, ModalGroup::motion}}, {{Address::x, 40.0}, {Address::z, -20.0}});
  b.block({}, {{Address::x, 38.0}});
  b.block({{Function::rapid, 0, ModalGroup::motion}}, {{Address::x, 60.0}});
  b.end();
  const ir::Program& program = b.build();
  const ir::Control control = control_of(ir::MachineKind::lathe);
  const Resolved resolved(program, control);
  const Facts in_cycle = *resolved.before(3);
  EXPECT_EQ(in_cycle[Kept::turn_x].certain()->number, 38.0);
  EXPECT_EQ(in_cycle[Kept::turn_z].certain()->number, -20.0);
  EXPECT_TRUE(in_cycle[Number::x].is(50.0));
  EXPECT_TRUE(in_cycle[Number::z].is(2.0));
  EXPECT_TRUE((*resolved.before(4))[Number::x].is(60.0));
}

TEST(KeptWords, ADrillingCycleLeavesTheToolAtItsLevel) {
  Builder b;
  b.block({{Function::rapid, 0, ModalGroup::motion}}, {{Address::z, 50.0}});
  b.block({{Function::return_to_r, 0, ModalGroup::return_level}, {Function::drill, 0, ModalGroup::cycle}},
          {{Address::x, 1.0}, {Address::z, -5.0}, {Address::r, 2.0}});
  b.block({{Function::return_to_initial, 0, ModalGroup::return_level}}, {{Address::x, 9.0}});
  b.block({{Function::cycle_off, 0, ModalGroup::cycle}});
  b.end();
  const ir::Program& program = b.build();
  const ir::Control control = control_of(ir::MachineKind::mill);
  const Resolved resolved(program, control);
  EXPECT_TRUE((*resolved.before(2))[Number::z].is(2.0));
  EXPECT_EQ((*resolved.before(2))[Kept::initial].certain()->number, 50.0);
  EXPECT_EQ((*resolved.before(2))[Kept::drill_depth].certain()->number, -5.0);
  EXPECT_TRUE((*resolved.before(3))[Number::z].is(50.0));
  EXPECT_TRUE((*resolved.before(4))[Number::x].is(9.0));
}

// Right after its roughing cycle nothing else runs a shape.
TEST(KeptWords, BlocksOfAShapeAreLeftOutAfterTheirCycle) {
  Builder b;
  b.block({{Function::linear, 0, ModalGroup::motion}}, {{Address::x, 50.0}});
  b.block({{Function::repetitive_cycle, 1, ModalGroup::non_modal}}, {{Address::p, 10.0}, {Address::q, 20.0}});
  b.label(10);
  b.block({{Function::rapid, 0, ModalGroup::motion}}, {{Address::x, 30.0}});
  b.label(20);
  b.block({}, {{Address::x, 48.0}});
  b.end();
  const ir::Program& program = b.build();
  const ir::Control control = control_of(ir::MachineKind::lathe);
  const Resolved resolved(program, control);
  EXPECT_TRUE((*resolved.before(3))[Number::x].is(30.0)) << "the cycle runs it";
  EXPECT_EQ(resolved.certain(Mode::motion, 3)->function, Function::rapid);
  const auto end = static_cast<std::uint32_t>(program.statements.size()) - 1;
  EXPECT_TRUE((*resolved.before(end))[Number::x].is(50.0));
  EXPECT_EQ(resolved.certain(Mode::motion, end)->function, Function::linear);
}

}  // namespace
}  // namespace dripfeed::facts
