// The arenas of a program, matching of structures, and the look-ups in a control's tables.
#include "dialects/ir/program.h"

#include <gtest/gtest.h>

#include "dialects/ir/control.h"
#include "tests/support/program_builder.h"

namespace dripfeed::ir {
namespace {

TEST(StringTable, KeepsEachTextOnce) {
  StringTable table;
  const StringId a = table.add("A");
  EXPECT_EQ(table.add("B"), static_cast<StringId>(1));
  EXPECT_EQ(table.add("A"), a);
  EXPECT_EQ(table.find("B"), static_cast<StringId>(1));
  EXPECT_EQ(table.find("C"), StringId::none);
  EXPECT_EQ(table.at(a), "A");
  EXPECT_EQ(table.at(StringId::none), "");
}

TEST(Operators, HaveTheirOperandCounts) {
  EXPECT_EQ(operand_count(Operator::constant), 0);
  EXPECT_EQ(operand_count(Operator::string), 0);
  EXPECT_EQ(operand_count(Operator::negate), 1);
  EXPECT_EQ(operand_count(Operator::to_lower), 1);
  EXPECT_EQ(operand_count(Operator::add), 2);
  EXPECT_EQ(operand_count(Operator::maximum), 2);
  EXPECT_EQ(operand_count(Operator::bound), 3);
}

TEST(Structures, KnowTheirPartners) {
  test::ProgramBuilder b;
  b.structure(StatementKind::while_begin);  // 0
  b.structure(StatementKind::if_begin);     // 1
  b.structure(StatementKind::else_begin);   // 2
  b.structure(StatementKind::if_end);       // 3
  b.structure(StatementKind::while_end);    // 4
  const std::vector<std::uint32_t> unmatched = match_structures(b.program());
  EXPECT_TRUE(unmatched.empty());
  const auto partner = [&](std::uint32_t statement) {
    return b.program().structures[b.program().statements[statement].payload].partner;
  };
  EXPECT_EQ(partner(0), 4U);
  EXPECT_EQ(partner(1), 2U);
  EXPECT_EQ(partner(2), 3U);
  EXPECT_EQ(partner(3), 1U);
  EXPECT_EQ(partner(4), 0U);
}

TEST(Structures, NameWhatDoesNotMatch) {
  test::ProgramBuilder b;
  b.structure(StatementKind::while_begin, {.loop_number = 1});
  b.structure(StatementKind::while_end, {.loop_number = 2});
  b.structure(StatementKind::else_begin);
  EXPECT_EQ(match_structures(b.program()), (std::vector<std::uint32_t>{1, 2, 0}));
}

TEST(Control, FindsCodesVariablesAndAlarms) {
  constexpr CodeRow kCodes[] = {{"G00", 0, Function::rapid, 0, ModalGroup::motion, ""},
                                {"G54.1", 541, Function::not_modelled, 0, ModalGroup::work_offset, ""}};
  constexpr AlarmRow kAlarms[] = {{text::DiagnosticId::division_by_zero, "PS0112"}};
  Control control;
  control.g_codes = kCodes;
  control.alarms = kAlarms;
  control.variables = {{Bank::hash, 100, 149, VariableUse::common, true}};
  EXPECT_EQ(find_code(control.g_codes, 541)->name, "G54.1");
  EXPECT_EQ(find_code(control.g_codes, 540), nullptr);
  EXPECT_NE(find_variable(control, Bank::hash, 149), nullptr);
  EXPECT_EQ(find_variable(control, Bank::hash, 150), nullptr);
  EXPECT_EQ(find_variable(control, Bank::r, 100), nullptr);
  EXPECT_EQ(diagnose(control, text::DiagnosticId::division_by_zero, {}).alarm, "PS0112");
  EXPECT_EQ(alarm_of(control, text::DiagnosticId::syntax_error), "");
}

}  // namespace
}  // namespace dripfeed::ir
