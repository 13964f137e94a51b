// What is known where control-flow paths join, at calls, and at returns. In addition to random programs and the
// interpreter: tests/unit/dialects/compile/facts_oracle_test.cpp.
#include <gtest/gtest.h>

#include "dialects/facts/facts.h"
#include "dialects/ir/sections.h"
#include "tests/support/program_builder.h"
#include "tests/unit/dialects/facts/mill.h"

namespace dripfeed::facts {
namespace {

using ir::Address;
using ir::Function;
using ir::ModalGroup;
using Builder = dripfeed::test::ProgramBuilder;

// Names the program that the statements from `first` on are.
void section(Builder& b, std::string_view name, std::uint32_t first) {
  ir::Program& p = b.program();
  const auto last = static_cast<std::uint32_t>(p.statements.size());
  p.sections.push_back({.name = p.strings.add(name), .first = first, .last = last});
}
std::uint32_t next(Builder& b) { return static_cast<std::uint32_t>(b.program().statements.size()); }

TEST(Known, KeepsWhatPathsDisagreeOn) {
  Known<int> fact;
  fact.set(1, 10);
  EXPECT_TRUE(fact.is(1));
  Known<int> second;
  second.set(2, 20);
  EXPECT_TRUE(fact.join(second));
  EXPECT_FALSE(fact.join(second)) << "nothing new";
  EXPECT_FALSE(fact.is_certain());
  EXPECT_TRUE(fact.may_be(1));
  EXPECT_TRUE(fact.may_be(2));
  EXPECT_FALSE(fact.may_be(3));
  Known<int> third;
  third.set(3, 30);
  EXPECT_TRUE(fact.join(third));
  EXPECT_TRUE(fact.may_be(3)) << "two values are kept, a third is not forgotten";
  EXPECT_TRUE(fact.may_be(4));
}

TEST(Known, ASettingEndsWhatWasNotKnown) {
  Known<int> fact;
  fact.set(1, 10);
  fact.forget(11);
  EXPECT_TRUE(fact.agrees());
  EXPECT_EQ(fact.certain(), nullptr);
  fact.set(1, 12);
  EXPECT_TRUE(fact.is(1));
}

TEST(Resolved, ABranchLeavesWhatBothSidesHave) {
  Builder b;
  b.block({{Function::absolute, 0, ModalGroup::distance}});
  b.go_to(10, b.read(Builder::hash(1)));
  b.block({{Function::incremental, 0, ModalGroup::distance}});
  b.label(10);
  b.block({}, {{Address::x, 1.0}});
  b.end();
  const ir::Program& program = b.build();
  const ir::Control control = mill();
  const Resolved resolved(program, control);
  const Known<Setting> distance = (*resolved.before(3))[Mode::distance];
  EXPECT_FALSE(distance.is_certain());
  EXPECT_EQ(resolved.paths(distance).size(), 2U);
  EXPECT_EQ(resolved.certain(Mode::plane, 3)->function, Function::plane_xy) << "neither side touches it";
}

TEST(Resolved, ASubprogramBeginsInWhatItsCallersHave) {
  Builder b;
  const std::uint32_t main = next(b);
  b.block({{Function::incremental, 0, ModalGroup::distance}});
  b.call(ir::CallKind::subprogram, "O2");
  b.block({{Function::plane_zx, 0, ModalGroup::plane}});
  b.call(ir::CallKind::subprogram, "O2");
  b.end();
  section(b, "O1", main);
  const std::uint32_t sub = next(b);
  b.block({{Function::spindle_cw, 0, ModalGroup::spindle}});
  b.back();
  section(b, "O2", sub);
  const ir::Program& program = b.build();
  const ir::Control control = mill();
  const Resolved resolved(program, control);
  EXPECT_EQ(resolved.certain(Mode::distance, sub)->function, Function::incremental);
  EXPECT_FALSE(resolved.certain(Mode::plane, sub).has_value()) << "the second call is in another plane";
  EXPECT_EQ(resolved.certain(Mode::spindle, 2)->function, Function::spindle_cw) << "by the subprogram";
  EXPECT_EQ(resolved.certain(Mode::plane, 4)->function, Function::plane_zx) << "what it does not touch passes by";
}

TEST(Resolved, ASubprogramAloneInheritsFromACallerThatIsNotSeen) {
  Builder b;
  b.block({}, {{Address::x, 1.0}});
  b.back();
  const ir::Program& program = b.build();
  const ir::Control control = mill();
  const Resolved resolved(program, control);
  EXPECT_TRUE(ir::is_subprogram(program));
  EXPECT_TRUE((*resolved.before(0))[Mode::unit].inherited);
  EXPECT_FALSE(resolved.certain(Mode::unit, 0).has_value());
}

TEST(Resolved, AProgramThatIsNotInTheTextMayChangeEverything) {
  Builder b;
  b.block({{Function::linear, 0, ModalGroup::motion}}, {{Address::x, 1.0}});
  b.call(ir::CallKind::subprogram, "O9000");
  b.block({{Function::absolute, 0, ModalGroup::distance}});
  b.end();
  const ir::Program& program = b.build();
  const ir::Control control = mill();
  const Resolved resolved(program, control);
  EXPECT_TRUE((*resolved.before(1))[Number::x].is(1.0));
  const Facts after = *resolved.before(2);
  EXPECT_TRUE(after[Mode::motion].agrees()) << "the text itself sets one";
  EXPECT_EQ(after[Mode::motion].changer, 1U);
  EXPECT_FALSE(after[Number::x].is_certain());
  EXPECT_TRUE((*resolved.before(3))[Mode::distance].is({.function = Function::absolute}));
}

TEST(Resolved, AfterAModalMacroThatLeavesPolarWordsOnALetterIsNoPosition) {
  Builder b;
  const std::uint32_t main = next(b);
  b.block({{Function::linear, 0, ModalGroup::motion}, {Function::absolute, 0, ModalGroup::distance}});
  b.call(ir::CallKind::subprogram, "O2");
  b.program().statements.back().kind = ir::StatementKind::modal_call;
  b.block({}, {{Address::x, 1.0}});
  b.add(ir::StatementKind::modal_call_end);
  b.block({}, {{Address::x, 2.0}});
  b.end();
  section(b, "O1", main);
  const std::uint32_t sub = next(b);
  b.block({{Function::polar_words_on, 0, ModalGroup::other}});
  b.back();
  section(b, "O2", sub);
  const ir::Program& program = b.build();
  const ir::Control control = mill();
  const Resolved resolved(program, control);
  EXPECT_FALSE((*resolved.before(5))[Number::x].is_certain());
}

TEST(Resolved, PositionsAreFollowedBeforeAndAfterATransformation) {
  constexpr std::int16_t kFace = 1;
  Builder b;
  b.block({{Function::linear, 0, ModalGroup::motion}}, {{Address::x, 1.0}});
  b.block({{Function::transformation, kFace, ModalGroup::other}});
  b.block({}, {{Address::x, 2.0}});
  b.block({{Function::transformation, 0, ModalGroup::other}});
  b.block({}, {{Address::x, 3.0}});
  b.end();
  const ir::Program& program = b.build();
  const ir::Control control = mill();
  const Resolved resolved(program, control);
  EXPECT_TRUE((*resolved.before(1))[Number::x].is(1.0));
  EXPECT_TRUE((*resolved.before(2))[Mode::transformation].is({.function = Function::transformation, .argument = 1}));
  EXPECT_FALSE((*resolved.before(3))[Number::x].is_certain()) << "X across the face is not X";
  EXPECT_TRUE((*resolved.before(4))[Mode::transformation].is({}));
  EXPECT_TRUE((*resolved.before(5))[Number::x].is(3.0));
}

TEST(Resolved, APoleIsTheOneOfAllPaths) {
  Builder b;
  b.block({{Function::pole_from_zero, 0, ModalGroup::non_modal}}, {{Address::x, 1.0}});
  b.block({{Function::pole_from_zero, 0, ModalGroup::non_modal}}, {{Address::x, 2.0}});
  b.program().statements.back().skip_level = 1;
  b.block({{Function::pole_from_zero, 0, ModalGroup::non_modal}}, {{Address::x, 3.0}});
  b.end();
  const ir::Program& program = b.build();
  const ir::Control control = mill();
  const Resolved resolved(program, control);
  EXPECT_FALSE(resolved.certain(Mode::pole, 0).has_value());
  EXPECT_EQ(resolved.certain(Mode::pole, 1)->argument, 0);
  EXPECT_FALSE(resolved.certain(Mode::pole, 2).has_value());
  EXPECT_EQ(resolved.certain(Mode::pole, 3)->argument, 2);
}

TEST(Resolved, SaveGivesTheModesBackAndNotThePosition) {
  Builder b;
  const std::uint32_t main = next(b);
  b.block({{Function::linear, 0, ModalGroup::motion}}, {{Address::x, 1.0}});
  b.call(ir::CallKind::subprogram, "SUB");
  b.end();
  section(b, "MAIN", main);
  const std::uint32_t sub = next(b);
  b.procedure(true);
  b.block({{Function::rapid, 0, ModalGroup::motion}, {Function::incremental, 0, ModalGroup::distance}},
          {{Address::x, 2.0}});
  b.back();
  section(b, "SUB", sub);
  const ir::Program& program = b.build();
  const ir::Control control = mill();
  const Resolved resolved(program, control);
  EXPECT_EQ(resolved.certain(Mode::motion, 2)->function, Function::linear);
  EXPECT_EQ(resolved.certain(Mode::distance, 2)->function, Function::absolute);
  EXPECT_TRUE((*resolved.before(2))[Number::x].is(3.0));
}

TEST(Resolved, AReturnToABlockOfTheCallerGoesOnThere) {
  Builder b;
  const std::uint32_t main = next(b);
  b.call(ir::CallKind::subprogram, "O2");
  b.end();
  b.label(100);
  b.block({}, {{Address::x, 1.0}});
  b.end();
  section(b, "O1", main);
  const std::uint32_t sub = next(b);
  b.block({{Function::incremental, 0, ModalGroup::distance}});
  b.back_to(100);
  section(b, "O2", sub);
  const ir::Program& program = b.build();
  const ir::Control control = mill();
  const Resolved resolved(program, control);
  ASSERT_NE(resolved.before(2), nullptr);
  EXPECT_EQ(resolved.certain(Mode::distance, 2)->function, Function::incremental);
}

TEST(Resolved, AModalCallIsMadeByEachMove) {
  Builder b;
  b.block({{Function::absolute, 0, ModalGroup::distance}});
  ir::Program& program = b.program();
  b.call(ir::CallKind::macro, "O9000");
  program.statements.back().kind = ir::StatementKind::modal_call;
  b.block({{Function::linear, 0, ModalGroup::motion}, {Function::absolute, 0, ModalGroup::distance}},
          {{Address::x, 1.0}});
  b.add(ir::StatementKind::modal_call_end);
  b.block({{Function::absolute, 0, ModalGroup::distance}}, {{Address::x, 2.0}});
  b.end();
  b.build();
  const ir::Control control = mill();
  const Resolved resolved(program, control);
  EXPECT_TRUE((*resolved.before(2))[Mode::distance].is_certain()) << "not called yet";
  EXPECT_FALSE((*resolved.before(3))[Mode::distance].is_certain()) << "the macro ran after the block";
  EXPECT_TRUE((*resolved.before(5))[Mode::distance].is_certain());
}

TEST(Resolved, AnswersInAnyOrder) {
  Builder b;
  for (int i = 0; i < 20; ++i)
    b.block({{i % 2 == 0 ? Function::absolute : Function::incremental, 0, ModalGroup::distance}});
  b.end();
  const ir::Program& program = b.build();
  const ir::Control control = mill();
  const Resolved resolved(program, control);
  for (const std::uint32_t i : {19U, 2U, 2U, 3U, 11U, 10U, 1U}) {
    const Function expected = i % 2 == 1 ? Function::absolute : Function::incremental;
    EXPECT_EQ(resolved.certain(Mode::distance, i)->function, expected) << i;
  }
}

}  // namespace
}  // namespace dripfeed::facts
