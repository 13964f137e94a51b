// G34 and G35: threads whose lead grows or shrinks. After a travel s the square of the lead is L² + 2 c s.
#include <gtest/gtest.h>

#include "dialects/ir/thread_lead.h"
#include "tests/unit/dialects/interpreter/run_trace.h"

namespace dripfeed::test {
namespace {

using ir::Address;
using ir::Function;
using Builder = ProgramBuilder;

Ran ran(Builder& b, const ir::Control& control) {
  b.end();
  return run_program(b.build(), control);
}
std::vector<std::string> names_of(const Ran& run) {
  std::vector<std::string> names;
  for (const auto& one : run.result.not_interpreted) names.push_back(one.name);
  return names;
}
const std::string kNotReported = "the change of a thread's lead that its block does not state for certain";

// From 1 with 0.5 more in each turn: 1, 1.5, 2, 2.5 begin the first four turns, which take 1.25 + 1.75 + 2.25 + 2.75.
TEST(ChangingThread, TheLeadFollowsFromTheTravel) {
  EXPECT_DOUBLE_EQ(ir::lead_after(1.0, 0.5, 8.0), 3.0);
  EXPECT_DOUBLE_EQ(ir::mean_lead(1.0, 0.5, 8.0), 2.0);  // 4 turns
  EXPECT_DOUBLE_EQ(ir::lead_after(3.0, -0.5, 8.0), 1.0);
  EXPECT_EQ(ir::lead_after(2.0, -0.1, 20.0), 0.0);
  EXPECT_EQ(ir::lead_after(0.3, 0.0, 7.0), 0.3);
}

TEST(ChangingThread, FIsTheLeadAndKItsChange) {
  Builder b;
  b.block({{Function::rapid}}, {{Address::x, 20.0}, {Address::z, 5.0}});
  b.block({{Function::thread_changing}}, {{Address::z, -30.0}, {Address::f, 2.0}, {Address::k, 0.1}});
  b.block({}, {{Address::w, -10.0}, {Address::f, 3.0}, {Address::k, -0.2}});
  b.block({{Function::linear}}, {{Address::x, 30.0}});
  const Ran run = ran(b, lathe_control());
  EXPECT_EQ(run.trace,
            "1 rapid X20.0000 Z5.0000\n2 thread X20.0000 Z-30.0000 F2.0000/rev +0.1000/rev2\n"
            "3 thread X20.0000 Z-40.0000 F3.0000/rev -0.2000/rev2\n4 linear X30.0000 Z-40.0000 F3.0000/min\n5 end\n");
  EXPECT_TRUE(run.result.not_interpreted.empty());
}

TEST(ChangingThread, KIsTheLeadAndFItsChangeWhichIsNoFeed) {
  Builder b;
  b.block({{Function::rapid}}, {{Address::x, 20.0}, {Address::z, 5.0}});
  b.block({{Function::thread_changing}}, {{Address::z, -30.0}, {Address::k, 2.0}, {Address::f, 0.1}});
  b.block({{Function::thread_changing, 1}}, {{Address::x, 24.0}, {Address::i, 3.0}, {Address::f, 0.25}});
  b.block({{Function::linear}}, {{Address::x, 30.0}});
  const Ran run = ran(b, sinumerik_control());
  EXPECT_EQ(run.trace,
            "1 rapid X20.0000 Y0.0000 Z5.0000\n2 thread X20.0000 Y0.0000 Z-30.0000 F2.0000/rev +0.1000/rev2\n"
            "3 thread X24.0000 Y0.0000 Z-30.0000 F3.0000/rev -0.2500/rev2\n"
            "4 linear X30.0000 Y0.0000 Z-30.0000 F0.0000/min\n5 end\n");
  ASSERT_NE(run.last_diagnostic(), nullptr);
  EXPECT_EQ(run.last_diagnostic()->diagnostic.id, text::DiagnosticId::no_feed);
  EXPECT_EQ(run.last_diagnostic()->line, 4U);
}

TEST(ChangingThread, LeadAndChangeAreLengthsInInch) {
  Builder b;
  b.block({{Function::rapid}, {Function::unit_inch}}, {{Address::x, 1.0}, {Address::z, 0.2}});
  b.block({{Function::thread_changing}}, {{Address::z, -1.0}, {Address::f, 0.1}, {Address::k, 0.01}});
  const Ran run = ran(b, lathe_control());
  EXPECT_NE(run.trace.find("F2.5400/rev +0.2540/rev2"), std::string::npos) << run.trace;
  EXPECT_TRUE(run.result.not_interpreted.empty());
  // Lengths in inch and feeds in mm (G70): in which of the two the change is, is not known.
  Builder s;
  s.block({{Function::rapid}, {Function::unit_inch, 1}}, {{Address::x, 1.0}, {Address::z, 0.2}});
  s.block({{Function::thread_changing}}, {{Address::z, -1.0}, {Address::k, 0.1}, {Address::f, 0.01}});
  EXPECT_EQ(names_of(ran(s, sinumerik_control())), std::vector{kNotReported});
}

// 2² - 2 · 0.1 · 19 is above 0, with 20 instead of 19 it is 0. The longer travel counts, of X its half.
TEST(ChangingThread, ALeadThatFallsToNothingIsAnAlarm) {
  for (const double z : {-14.0, -15.0}) {
    Builder b;
    b.block({{Function::rapid}}, {{Address::x, 20.0}, {Address::z, 5.0}});
    b.block({{Function::thread_changing}},
            {{Address::x, 50.0}, {Address::z, z}, {Address::f, 2.0}, {Address::k, -0.1}});
    const Ran run = ran(b, lathe_control());
    EXPECT_EQ(run.result.ended, z == -14.0 ? interpreter::Ended::end : interpreter::Ended::alarm) << z;
    if (z == -14.0) continue;
    EXPECT_EQ(run.last_diagnostic()->diagnostic.id, text::DiagnosticId::thread_invalid);
    EXPECT_EQ(run.motions.size(), 1U);
  }
  Builder b;
  b.block({{Function::thread_changing}}, {{Address::z, 5.0}, {Address::f, -2.0}, {Address::k, 0.1}});
  EXPECT_EQ(ran(b, lathe_control()).last_diagnostic()->diagnostic.id, text::DiagnosticId::thread_invalid);
}

TEST(ChangingThread, WhatABlockDoesNotSayOfTheChangeIsReported) {
  for (const bool point : {true, false}) {
    Builder b;
    ir::Control lathe = lathe_control();
    lathe.semantics.decimal_mode = ir::DecimalMode::least_increment;
    b.block({{Function::rapid}}, {{Address::x, b.number(20)}, {Address::z, b.number(5)}});
    b.block({{Function::thread_changing}},
            {{Address::z, b.number(-30)}, {Address::f, b.number(2)}, {Address::k, b.number(1, point)}});
    EXPECT_EQ(names_of(ran(b, lathe)).size(), point ? 0U : 1U);
  }
  Builder b;
  b.block({{Function::rapid}}, {{Address::x, 20.0}, {Address::z, 5.0}});
  b.block({{Function::thread_changing}}, {{Address::z, -30.0}, {Address::f, 2.0}});
  const Ran run = ran(b, lathe_control());
  EXPECT_EQ(names_of(run), std::vector{kNotReported});
  EXPECT_NE(run.trace.find("F2.0000/rev\n"), std::string::npos) << run.trace;
  Builder s;
  s.block({{Function::thread_changing}}, {{Address::z, -30.0}, {Address::k, 2.0}, {Address::f, -0.01}});
  EXPECT_EQ(names_of(ran(s, sinumerik_control())), std::vector{kNotReported});
}

}  // namespace
}  // namespace dripfeed::test
