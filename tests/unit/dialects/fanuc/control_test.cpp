// The tables, and what is inferred from a text.
#include <algorithm>
#include <string>

#include <gtest/gtest.h>

#include "dialects/fanuc/fanuc.h"

namespace dripfeed::fanuc {
namespace {

using ir::Function;
using ir::GSystem;
using ir::MachineKind;

Function function_of(const ir::Control& c, int number10) {
  const ir::CodeRow* row = ir::find_code(c.g_codes, number10);
  return row == nullptr ? Function::none : row->function;
}
ir::Control inferred(const std::string& text) { return Stages::infer_control(text::Source("x.nc", text)); }

TEST(Control, CodeSystemsOfLathesDiffer) {
  const ir::Control a = control(MachineKind::lathe, GSystem::a);
  const ir::Control b = control(MachineKind::lathe, GSystem::b);
  const ir::Control c = control(MachineKind::lathe, GSystem::c);
  EXPECT_EQ(function_of(a, 900), Function::turning_cycle);
  EXPECT_EQ(function_of(b, 900), Function::absolute);
  EXPECT_EQ(function_of(a, 990), Function::feed_per_rev);
  EXPECT_EQ(function_of(b, 950), Function::feed_per_rev);
  EXPECT_EQ(function_of(c, 710), Function::unit_mm);
  EXPECT_EQ(function_of(c, 210), Function::turning_cycle);
  EXPECT_EQ(function_of(a, 320), Function::thread);
  EXPECT_EQ(function_of(b, 330), Function::thread);
  EXPECT_EQ(function_of(a, 500), Function::set_coordinates);
  EXPECT_TRUE(a.semantics.incremental_letters_uvw);
  EXPECT_FALSE(b.semantics.incremental_letters_uvw);
}

TEST(Control, TablesAreSortedAndNamed) {
  for (const MachineKind kind : {MachineKind::mill, MachineKind::lathe, MachineKind::mill_turn}) {
    for (const GSystem system : {GSystem::a, GSystem::b, GSystem::c}) {
      const ir::Control c = control(kind, system);
      for (const auto table : {c.g_codes, c.m_codes}) {
        EXPECT_TRUE(std::ranges::is_sorted(table, {}, &ir::CodeRow::number10));
        EXPECT_EQ(std::ranges::adjacent_find(table, {}, &ir::CodeRow::number10), table.end());
        for (const ir::CodeRow& row : table) EXPECT_FALSE(row.reference.empty()) << row.name;
      }
      EXPECT_TRUE(std::ranges::none_of(c.variables, [](const ir::VariableRange& r) { return r.first > r.last; }));
    }
  }
}

TEST(Control, NamesAlarms) {
  const ir::Control c = control(MachineKind::mill, GSystem::a);
  EXPECT_EQ(ir::alarm_of(c, text::DiagnosticId::jump_target_missing), "PS0128");
  EXPECT_EQ(ir::alarm_of(c, text::DiagnosticId::bracket_nesting_too_deep), "PS0118");
  EXPECT_EQ(ir::alarm_of(c, text::DiagnosticId::loop_number_invalid), "PS0126");
}

TEST(Infer, DecidesLatheOrMillByTheFirstLineThatShows) {
  const ir::Control lathe = inferred("%\nO1\nG00 X50.\nT0606\nG01 Z-5. F0.2\nM30\n%\n");
  EXPECT_EQ(lathe.kind, MachineKind::lathe);
  EXPECT_EQ(lathe.because_line, 4U);
  const ir::Control mill = inferred("%\nO1\nG54\nG00 X50. Y2.\nM30\n%\n");
  EXPECT_EQ(mill.kind, MachineKind::mill);
  EXPECT_EQ(mill.because_line, 4U);
  EXPECT_EQ(inferred("T0606 M06\nG00 X1. Y1.\n").kind, MachineKind::mill);
  EXPECT_EQ(inferred("G00 X10. Z5.\nG01 Z-20. F0.2\n").kind, MachineKind::lathe);
  EXPECT_EQ(inferred("G00 Z5.\nG01 Z-20. F100\n").because_line, 0U);
  EXPECT_EQ(inferred("").kind, MachineKind::mill);
}

// A few lathes change their tools by M06; no mill has a G71 with P and Q.
TEST(Infer, AShapeThatIsTurnedOutweighsAToolChangeByCode) {
  const ir::Control lathe = inferred("G28 M06\nT0101\nG00 X60. Z2.\nG71 U2. R1.\nG71 P90 Q95 U.5 W.5 F.3\n");
  EXPECT_EQ(lathe.kind, MachineKind::lathe);
  EXPECT_EQ(lathe.because_line, 5U);
  EXPECT_EQ(inferred("T2 M06\nG00 X6. Y1.\nG71 P90 Q95 U.5 W.5 F.3\n").kind, MachineKind::mill);
  EXPECT_EQ(inferred("T2 M06\nG83 Z-5. R1. P90 Q1. F.3\n").kind, MachineKind::mill);
}

// Which of the two systems it is decides whether the control has G91.
TEST(Infer, WhereTheSystemIsNotCertainACodeOfAnotherIsNotAnError) {
  const text::Source source("x.nc", "%\nO1\nT0101\nG50 S2000\nG91 G28 Z0.\nM30\n%\n");
  const ir::Control control = Stages::infer_control(source);
  ASSERT_EQ(control.contradiction.size(), 2U);
  const auto found = Stages::read(source, control).diagnostics;
  const auto code = std::ranges::find(found, text::DiagnosticId::unknown_code, &text::Diagnostic::id);
  ASSERT_NE(code, found.end());
  EXPECT_EQ(code->severity, text::Severity::warning);
}

TEST(Infer, DecidesTheSystemOfALathe) {
  EXPECT_EQ(inferred("T0101\nG50 S2000\n").g_system, GSystem::a);
  EXPECT_EQ(inferred("T0101\nG99\nG90 X50. Z-5. F0.2\n").g_system, GSystem::a);
  EXPECT_EQ(inferred("T0101\nG90 G95\nG00 X50. Z5.\n").g_system, GSystem::b);
  EXPECT_EQ(inferred("T0101\nG71\nG00 X50. Z5.\n").g_system, GSystem::c);
  EXPECT_EQ(inferred("T0101\nG71 U2. R0.5\nG71 P10 Q20 U0.5 W0.1 F0.2\n").g_system, GSystem::a);
}

TEST(Infer, TakesTheAxesThatAreMoved) {
  EXPECT_EQ(inferred("G00 X1. Y1.\nG00 B90.\nG65 P9000 A1. C2.\n").axes, "XYZB");
  EXPECT_EQ(inferred("T0101\nG00 X1. Z1. C90.\n").axes, "XZC");
  EXPECT_EQ(inferred("T0101\nG00 X1. Z1.\nG00 H90.\n").axes, "XZC");
}

TEST(Read, TakesLongPlainPrograms) {
  std::string text = "%\nO1\nG21 G17 G90 G94\n";
  for (int i = 0; i < 100'000; ++i) text += "N" + std::to_string(i + 1) + " G01 X1.5 Y-2. F100.\n";
  text += "M30\n%\n";
  const text::Source source("long.nc", text);
  const ir::Control c = Stages::infer_control(source);
  const ir::ReadResult read = Stages::read(source, c);
  EXPECT_TRUE(read.diagnostics.empty());
  EXPECT_EQ(read.program.blocks.size(), 100'002U);
  EXPECT_TRUE(Stages::validate(read.program, c, ir::Delivery::drip).empty());
}

TEST(Validate, LooksAtEachProgramOfATextByItself) {
  const text::Source source("two.nc", "%\nO1\nGOTO10\nN10 M30\nO2\nGOTO10\nN20 M99\n%\n");
  const ir::Control c = Stages::infer_control(source);
  const auto found = Stages::validate(Stages::read(source, c).program, c, ir::Delivery::memory);
  ASSERT_EQ(std::ranges::count(found, text::DiagnosticId::jump_target_missing, &text::Diagnostic::id), 1);
  EXPECT_EQ(source.position(found.front().span.begin).line, 6U);
}

TEST(Control, CornersAndAnglesAreNoAxes) {
  const auto axes = [](std::string text) { return Stages::infer_control(text::Source("x.nc", std::move(text))).axes; };
  EXPECT_EQ(axes("%\nO1\nG01 X1. ,C1. F5.\nY2. , A45.\nM30\n%\n"), "XYZ");
  EXPECT_EQ(axes("%\nO1\nG01 X1. C1. F5.\nM30\n%\n"), "XYZC");
}

TEST(Validate, MeasuresBlocksWhereTheMachineHasALimit) {
  const text::Source source("long.nc", "%\nO1\nG21 G17 G90 G00 X1. Y1.\nM30\n%\n");
  ir::Control c = Stages::infer_control(source);
  const ir::Program program = Stages::read(source, c).program;
  c.limits.block_length_bytes = 23;
  EXPECT_TRUE(Stages::validate(program, c, ir::Delivery::memory).empty());
  c.limits.block_length_bytes = 22;
  const auto found = Stages::validate(program, c, ir::Delivery::memory);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].id, text::DiagnosticId::block_too_long);
}

TEST(Validate, SaysNothingOfWhatTheMachineConfirmed) {
  const text::Source source("x.nc", "%\nO1\nX100\nM30\n%\n");
  ir::Control c = control(MachineKind::mill, GSystem::a);
  c.from_profile = true;
  const ir::Program program = Stages::read(source, c).program;
  EXPECT_TRUE(text::has_error(Stages::validate(program, c, ir::Delivery::memory)));
  c.semantics.decimal_mode_confirmed = true;
  c.semantics.power_on_known = true;
  EXPECT_TRUE(Stages::validate(program, c, ir::Delivery::memory).empty());
}

}  // namespace
}  // namespace dripfeed::fanuc
