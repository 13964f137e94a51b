// Which dialect a text is taken for, and the control that it gets.
#include <string>

#include <gtest/gtest.h>

#include "tests/unit/dialects/compile/harness.h"

namespace dripfeed::compile::test {
namespace {

std::string inferred(const std::string& text) { return std::string(infer_dialect(text::Source("x", text)).name); }

TEST(Infer, StatesTheFamilyFirst) {
  EXPECT_EQ(inferred("%\nO1(PART)\nG00 X1.\nM30\n%\n"), "fanuc");
  EXPECT_EQ(inferred("%_N_PART_MPF\nG0 X1\nM30\n"), "sinumerik-840d");
  EXPECT_EQ(inferred("G1 X10\n"), "fanuc");
}

TEST(Infer, ReadsTheEndingOfTheNameAndSmallLetters) {
  const auto named = [](const char* name) { return infer_dialect(text::Source(name, "G1 X10\n")).name; };
  EXPECT_EQ(named("shop/SHAFT.MPF"), "sinumerik-840d");
  EXPECT_EQ(named("_N_SHAFT_SPF"), "sinumerik-840d");
  EXPECT_EQ(named("part.eia"), "mazak");
  EXPECT_EQ(named("part.nc"), "fanuc");
  EXPECT_EQ(inferred("(DIAMETER 20)\nG1 X10.\n"), "fanuc");
  EXPECT_EQ(inferred("Proc Wheel(Real Edge)\nG1 X10\nM17\n"), "sinumerik-840d");
}

TEST(Infer, SeparatesTheHashControlsByWhatOneAloneHas) {
  EXPECT_EQ(inferred("%\nO1\nG53.5\nG00 X1.\nM30\n%\n"), "mazak");
  EXPECT_EQ(inferred("%\nO1(FOR THE MAZAK)\nG00 X1.\nM30\n%\n"), "mazak");
  EXPECT_EQ(inferred("%\nO1\nG31.1 Z-5. F50.\nM30\n%\n"), "mitsubishi-m80");
  EXPECT_EQ(inferred("%\nO1\n#100=#70001\nM30\n%\n"), "mazak");
}

TEST(Infer, AnIntegrexHasCodesOfItsOwn) {
  const Dialect& mazak = *find_dialect("mazak");
  EXPECT_EQ(mazak.infer_control(text::Source("x", "%\nO1\nT0101\nG122.1\nG00 X5. Z1.\nM30\n%\n")).kind,
            ir::MachineKind::mill_turn);
  EXPECT_EQ(mazak.infer_control(text::Source("x", "%\nO1\nT0101\nG00 X5. Z1.\nM30\n%\n")).kind, ir::MachineKind::lathe);
}

// Lathes of schools change the tool by T0707 M06: the lines after it decide.
TEST(Infer, AToolWithItsOwnOffsetWithM06IsEithers) {
  const Dialect& fanuc = *find_dialect("fanuc");
  const auto kind = [&](const std::string& text) { return fanuc.infer_control(text::Source("x", text)).kind; };
  EXPECT_EQ(kind("O1\nG28 G21\nT0707 M06\nG99 G96 S255 M03\nG00 X55. Z1.5\nG71 U1. R0.5\nM30\n"),
            ir::MachineKind::lathe);
  EXPECT_EQ(kind("O1\nT0606 M06\nG00 X1. Y1.\nM30\n"), ir::MachineKind::mill);
  EXPECT_EQ(kind("O1\nT0108 M06\nG00 X55. Z1.5\nM30\n"), ir::MachineKind::mill);
  EXPECT_EQ(kind("O1\nT7 M06\nG00 X55. Z1.5\nM30\n"), ir::MachineKind::mill);
}

// G49 and G17 stand in the first line of lathes' programs, too.
TEST(Infer, AFirstLineWithG49IsEithers) {
  const Dialect& fanuc = *find_dialect("fanuc");
  const auto kind = [&](const std::string& text) { return fanuc.infer_control(text::Source("x", text)).kind; };
  EXPECT_EQ(kind("O1\nG21 G40 G49 G54 G80 G90\nT0000\nG97 S1200 M03\nG00 X-25. Z.5\nG71 U.5 R.2\nM30\n"),
            ir::MachineKind::lathe);
  EXPECT_EQ(kind("O1\nG17 G40 G49\nT0101\nG28 U0 W0\nG00 X55. Z1.5\nM30\n"), ir::MachineKind::lathe);
  EXPECT_EQ(kind("O1\nG17 G40 G49\nG00 X55. Z1.5\nM30\n"), ir::MachineKind::mill);
}

TEST(Infer, AG90AmongTheFirstCodesIsNoSystemB) {
  const Dialect& fanuc = *find_dialect("fanuc");
  const auto control = [&](const std::string& text) { return fanuc.infer_control(text::Source("x", text)); };
  const ir::Control a = control("%\nO1\nG18 G20 G40 G80 G90 G99\nT0101\nG50 S2500\nG00 X1. Z.1\nM30\n%\n");
  EXPECT_EQ(a.g_system, ir::GSystem::a);
  EXPECT_TRUE(a.contradiction.empty());
  EXPECT_EQ(control("%\nO1\nG90 G94\nT0101\nG00 X1. Z.1\nM30\n%\n").g_system, ir::GSystem::b);
  EXPECT_EQ(control("%\nO1\nT0101\nG50 S2500\nG91 G00 X1.\nM30\n%\n").contradiction.size(), 2U);
}

TEST(Infer, ANameIsNoAxis) {
  const Dialect& own = *find_dialect("sinumerik-840d");
  const auto axes = [&](const std::string& text) { return own.infer_control(text::Source("x", text)).axes; };
  EXPECT_EQ(axes("DEF REAL V=1, A1\nV=5 A1=3\nG1 X=V Y=A1\nM30\n"), "XYZ");
  EXPECT_EQ(axes("PROC P(REAL B)\nB=2\nG1 X=B\nM17\n"), "XYZ");
  EXPECT_EQ(axes("DEF REAL W\nG1 X1 V5 A=3\nM30\n"), "XYZAV");
}

TEST(Controls, HaveTablesInOrder) {
  for (const Dialect& dialect : dialects()) {
    if (dialect.name.starts_with("sinumerik")) continue;  // named codes have no number
    for (const ir::MachineKind kind : {ir::MachineKind::mill, ir::MachineKind::lathe, ir::MachineKind::mill_turn}) {
      for (const ir::GSystem system : {ir::GSystem::a, ir::GSystem::b, ir::GSystem::c}) {
        const ir::Control c = dialect.control(kind, system);
        EXPECT_EQ(c.dialect, dialect.name);
        EXPECT_TRUE(std::ranges::is_sorted(c.g_codes, {}, &ir::CodeRow::number10)) << dialect.name;
        for (const ir::CodeRow& row : c.g_codes) EXPECT_FALSE(row.reference.empty()) << row.name;
        EXPECT_FALSE(c.alarms.empty());
      }
    }
  }
}

}  // namespace
}  // namespace dripfeed::compile::test
