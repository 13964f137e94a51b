// Named variables to the free numbers of a control.
#include "dialects/passes/allocation.h"

#include <gtest/gtest.h>

#include "building.h"

namespace dripfeed::passes {
namespace {

using ir::Bank;
using ir::Operator;

std::uint32_t number_of(const ir::Program& p, std::size_t assign) { return p.at(p.assigns[assign].target).number; }

TEST(Allocation, GivesFreeCommonNumbersAndKeepsTaken) {
  Building b;
  const ir::SymbolId x = b.symbol("x");
  const ir::SymbolId y = b.symbol("y");
  b.assign(Building::numbered(Bank::hash, 100), b.value(1));
  b.assign(Building::named(x), b.value(2));
  b.assign(Building::named(y), b.op(Operator::add, b.value(Building::named(x)), b.value(3)));
  b.end();
  const ir::Control c = control_with(10);
  const AllocationReport report = allocate_variables(b.program, c, c, Bank::hash);
  EXPECT_TRUE(report.diagnostics.empty());
  ASSERT_EQ(report.variables.size(), 2U);
  EXPECT_EQ(number_of(b.program, 0), 100U);
  EXPECT_EQ(number_of(b.program, 1), 101U);
  EXPECT_EQ(number_of(b.program, 2), 102U);
  const auto values = run(b.program, c);
  EXPECT_EQ(values.at("#102"), 5.0);
}

TEST(Allocation, TakesLocalsLastAndThenReportsHowManyAreMissing) {
  Building b;
  const ir::SymbolId sum = b.symbol("sum");
  // All alive until the end, so that none can be shared.
  std::vector<ir::SymbolId> symbols;
  for (int i = 0; i < 5; ++i) symbols.push_back(b.symbol("v" + std::to_string(i)));
  for (const ir::SymbolId s : symbols) b.assign(Building::named(s), b.value(1));
  b.assign(Building::named(sum), b.value(0));
  for (const ir::SymbolId s : symbols) {
    b.assign(Building::named(sum), b.op(Operator::add, b.value(Building::named(sum)), b.value(Building::named(s))));
  }
  b.end();
  ir::Program enough = b.program;
  EXPECT_TRUE(allocate_variables(enough, control_with(3), control_with(3), Bank::hash).diagnostics.empty());
  EXPECT_EQ(number_of(enough, 2), 1U);  // #100..#102 are gone
  const AllocationReport report = allocate_variables(b.program, control_with(2), control_with(2), Bank::hash);
  ASSERT_EQ(report.diagnostics.size(), 1U);
  EXPECT_EQ(report.diagnostics[0].id, text::DiagnosticId::not_enough_variables);
  EXPECT_EQ(report.diagnostics[0].arguments, (std::vector<std::string>{"6", "5"}));
}

TEST(Allocation, RefusesAnArrayWhoseSizeTheProgramDoesNotSay) {
  // Declared in the control alone: A[5] and B[3] would share a number.
  Building b;
  for (const ir::SymbolId array : {b.symbol("a"), b.symbol("b")}) {
    for (const double at : {3.0, 5.0}) {
      ir::Variable element = Building::named(array);
      element.index = b.value(at);
      b.assign(element, b.value(1));
    }
  }
  b.end();
  const ir::Control c = control_with(50);
  const AllocationReport report = allocate_variables(b.program, c, c, Bank::hash);
  ASSERT_EQ(report.diagnostics.size(), 2U);  // one for each array
  EXPECT_EQ(report.diagnostics[0].id, text::DiagnosticId::translation_not_known);
  EXPECT_EQ(report.diagnostics[0].arguments[0], "the array a, whose size the program does not state,");
}

TEST(Allocation, SharesOnlyWhenItMustAndOnlyWhatIsNotAlive) {
  Building b;
  const ir::SymbolId kept = b.symbol("kept");
  b.assign(Building::named(kept), b.value(1000));
  for (int i = 0; i < 20; ++i) {
    const ir::SymbolId s = b.symbol("t" + std::to_string(i));
    b.assign(Building::named(s), b.value(i));
    b.assign(Building::named(kept), b.op(Operator::add, b.value(Building::named(kept)), b.value(Building::named(s))));
  }
  b.end();
  const ir::Control c = control_with(2);
  EXPECT_TRUE(allocate_variables(b.program, c, c, Bank::hash).diagnostics.empty());
  EXPECT_EQ(run(b.program, c).at("#100"), 1190.0);
}

TEST(Allocation, KeepsApartWhatALoopNeedsInItsNextPass) {
  Building b;
  const ir::SymbolId i = b.symbol("i");
  const ir::SymbolId a = b.symbol("a");
  const ir::SymbolId t = b.symbol("t");
  b.assign(Building::named(i), b.value(0));
  b.assign(Building::named(a), b.value(7));
  b.condition(ir::StatementKind::while_begin, b.op(Operator::less, b.value(Building::named(i)), b.value(3)));
  b.assign(Building::named(t), b.op(Operator::add, b.value(Building::named(a)), b.value(0)));
  b.assign(Building::named(t), b.op(Operator::multiply, b.value(Building::named(t)), b.value(100)));
  b.assign(Building::named(i), b.op(Operator::add, b.value(Building::named(i)), b.value(1)));
  b.structure(ir::StatementKind::while_end);
  b.end();
  ir::Control c = control_with(1);
  c.variables[0].last = 1;  // two numbers for three variables that all live through the loop
  EXPECT_FALSE(allocate_variables(b.program, c, c, Bank::hash).diagnostics.empty());
}

TEST(Allocation, PutsArraysInARow) {
  Building b;
  const ir::SymbolId a = b.symbol("a", ir::ValueType::real, 3);
  const ir::SymbolId i = b.symbol("i");
  b.assign(Building::numbered(Bank::hash, 101), b.value(1));
  b.assign(Building::named(i), b.value(2));
  b.assign(Building::named(a, b.value(1)), b.value(11));
  b.assign(Building::named(a, b.value(Building::named(i))), b.value(22));
  b.end();
  const ir::Control c = control_with(10);
  EXPECT_TRUE(allocate_variables(b.program, c, c, Bank::hash).diagnostics.empty());
  const auto values = run(b.program, c);
  EXPECT_EQ(values.at("#103"), 11.0);
  EXPECT_EQ(values.at("#104"), 22.0);
}

TEST(Allocation, NumbersOfAnotherBankKeepTheirDistance) {
  Building b;
  b.assign(Building::numbered(Bank::r, 5), b.value(50));
  b.end();
  const ir::Control c = control_with(10);
  EXPECT_TRUE(allocate_variables(b.program, c, c, Bank::hash).diagnostics.empty());
  EXPECT_EQ(number_of(b.program, 0), 105U);
}

TEST(Allocation, MovesAWholeBankForAComputedNumber) {
  Building b;
  ir::Variable computed = Building::numbered(Bank::r, 0);
  computed.index = b.op(Operator::add, b.value(Building::numbered(Bank::r, 1)), b.value(1));
  b.assign(Building::numbered(Bank::r, 1), b.value(3));
  b.assign(computed, b.value(42));  // R4
  b.end();
  const ir::Control c = control_with(20);
  EXPECT_TRUE(allocate_variables(b.program, c, c, Bank::hash).diagnostics.empty());
  const auto values = run(b.program, c);
  EXPECT_EQ(values.at("#101"), 3.0);
  EXPECT_EQ(values.at("#104"), 42.0);
  Building small = b;
  EXPECT_FALSE(allocate_variables(b.program, c, c, Bank::r).diagnostics.empty());  // # does not fit into R0-R9
}

TEST(Allocation, ComputedNumberOfTheTargetBankPinsItAll) {
  Building b;
  const ir::SymbolId x = b.symbol("x");
  ir::Variable computed = Building::numbered(Bank::hash, 0);
  computed.index = b.value(Building::numbered(Bank::hash, 1));
  b.assign(computed, b.value(1));
  b.assign(Building::named(x), b.value(2));
  b.end();
  const ir::Control c = control_with(20);
  EXPECT_EQ(allocate_variables(b.program, c, c, Bank::hash).diagnostics.size(), 1U);
}

TEST(Allocation, MakesAssignmentsOfDefinitions) {
  Building b;
  const ir::SymbolId x = b.symbol("x");
  const ir::SymbolId y = b.symbol("y");
  b.program.symbols[static_cast<std::uint32_t>(x)].initial = b.value(4);
  ir::Structure define;
  define.first_symbol = static_cast<std::uint32_t>(x);
  define.symbol_count = 2;
  b.structure(ir::StatementKind::define, define);
  b.assign(Building::named(y), b.op(Operator::add, b.value(Building::named(y)), b.value(Building::named(x))));
  b.end();
  const ir::Control c = control_with(10);
  EXPECT_TRUE(allocate_variables(b.program, c, c, Bank::hash).diagnostics.empty());
  EXPECT_EQ(run(b.program, c).at("#101"), 4.0);
}

TEST(Allocation, RefusesStrings) {
  Building b;
  const ir::SymbolId s = b.symbol("s", ir::ValueType::string);
  b.assign(Building::named(s), b.value(1));
  b.end();
  const ir::Control c = control_with(10);
  const AllocationReport report = allocate_variables(b.program, c, c, Bank::hash);
  ASSERT_EQ(report.diagnostics.size(), 1U);
  EXPECT_EQ(report.diagnostics[0].id, text::DiagnosticId::translation_value);
}

}  // namespace
}  // namespace dripfeed::passes
