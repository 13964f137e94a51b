// Definition files, initialization files, and what they change for programs next to them.
#include <memory>
#include <string>
#include <string_view>

#include <gtest/gtest.h>

#include "tests/unit/dialects/sinumerik/reading.h"

namespace dripfeed::sinumerik {
namespace {

ir::Control with_file(std::string_view name, std::string_view text, ir::Control c = control(ir::MachineKind::mill)) {
  ir::SharedDefinitions shared = c.shared != nullptr ? *c.shared : ir::SharedDefinitions{};
  add_definitions(text::Source(std::string(name), std::string(text)), c, shared);
  c.shared = std::make_shared<const ir::SharedDefinitions>(std::move(shared));
  return c;
}

std::string all_faults(std::string_view name, std::string_view text, const ir::Control& c) {
  std::string out;
  for (const text::Diagnostic& d : findings_of(name, text, c)) {
    if (!out.empty()) out += ' ';
    out += text::row_of(d.id).name;
  }
  return out;
}

constexpr std::string_view kHead = "G17 G710 G90 G94\n";

TEST(DefinitionFile, NamesAndSizesAreKnownAndSizesMayBeMacros) {
  const ir::Control macros = with_file("SMAC.DEF", "%_N_SMAC_DEF\nN10 DEFINE MAXT AS 20\nDEFINE CLAMP AS M80\n");
  const ir::Control c = with_file("MGUD.DEF",
                                  "DEF NCK REAL TOOLS[MAXT,3]=REP(1.5)\nDEF CHAN SYNR INT PHU 3 LLI 0 ULI 10 COUNT=5\n"
                                  "DEF NCK APW 7 STRING[32] NAMES[5]\nREDEF COUNT PHU 1\nM30\n",
                                  macros);
  ASSERT_TRUE(c.shared->variables.contains("TOOLS"));
  EXPECT_EQ(c.shared->variables.at("TOOLS").dimensions[0], 20);
  EXPECT_EQ(c.shared->variables.at("TOOLS").dimensions[1], 3);
  EXPECT_EQ(c.shared->variables.at("NAMES").type, ir::ValueType::string);
  EXPECT_EQ(c.shared->macros.at("CLAMP"), "M80");
  const std::string program = std::string(kHead) + "R1=TOOLS[1,2]+COUNT\nNAMES[0]=\"A\"\nR2=MAXT\nM30\n";
  EXPECT_EQ(all_faults("A.MPF", program, c), "");
  EXPECT_EQ(all_faults("A.MPF", program, control(ir::MachineKind::mill)),
            "unknown-name unknown-name unknown-name unknown-name");
}

TEST(DefinitionFile, AMacroOfCodesIsThoseCodes) {
  const ir::Control c = with_file("UMAC.DEF", "DEFINE OPEN_ALL AS M80 M8\nDEFINE G81 AS G64 SUPA\n");
  const ir::Program p = sinumerik::read(text::Source("A.MPF", "OPEN_ALL\nG81 G0 Z0\nM30\n"), c).program;
  ASSERT_GE(p.statements.size(), 2U);
  EXPECT_EQ(p.statements[0].kind, ir::StatementKind::block);
  EXPECT_EQ(p.codes_of(p.blocks[p.statements[0].payload]).size(), 2U);
  EXPECT_EQ(p.codes_of(p.blocks[p.statements[1].payload]).size(), 3U);
  EXPECT_EQ(all_faults("A.MPF", std::string(kHead) + "OPEN_ALL\nG81\nM30\n", c), "");
}

TEST(DefinitionFile, WhatAMacroHoldsElseIsNotKnown) {
  const ir::Control c = with_file("UMAC.DEF", "DEFINE RETRACT AS G0 Z100\nDEFINE PROBE AS $A_IN[9]\n");
  EXPECT_EQ(all_faults("A.MPF", std::string(kHead) + "RETRACT\nIF PROBE==1\nENDIF\nM30\n", c), "not-interpreted");
  const ir::Program p = sinumerik::read(text::Source("A.MPF", "RETRACT X5\nM30\n"), c).program;
  ASSERT_EQ(p.statements[0].kind, ir::StatementKind::native);
  EXPECT_TRUE(p.natives[p.statements[0].payload].moves);
}

TEST(DefinitionFile, AMacroOfTheProgramIsAValue) {
  const ir::Program p = good("DEFINE LAST AS 7\nDEF REAL LIST[LAST]\nR1=LAST\nM30");
  EXPECT_EQ(p.symbols.front().dimension1, 7);
  EXPECT_EQ(p.at(p.assigns.front().value).value, 7.0);
}

// G0 X=10 moves, whatever a file defines.
TEST(DefinitionFile, AnAxisIsNoVariable) {
  const ir::Control c = with_file("MGUD.DEF", "DEF NCK REAL X=1\nDEF NCK REAL WIDTH=2\nM30\n");
  EXPECT_FALSE(c.shared->variables.contains("X"));
  const ir::Program p = sinumerik::read(text::Source("A.MPF", "G0 X=10\nM30\n"), c).program;
  ASSERT_EQ(p.statements[0].kind, ir::StatementKind::block);
  ASSERT_EQ(p.words_of(p.blocks[p.statements[0].payload]).size(), 1U);
  EXPECT_EQ(p.words_of(p.blocks[p.statements[0].payload])[0].address, ir::Address::x);
}

// Which of the letters that are left are axes, a named machine knows.
TEST(DefinitionFile, AnAxisOfTheMachineIsNoVariable) {
  constexpr std::string_view kText = "DEF REAL A=1\nR1=A\nM30\n";
  ir::Control c = control(ir::MachineKind::mill);
  c.axes = "XYZA";
  EXPECT_EQ(all_faults("A.MPF", kText, c), "name-beginning");
  c.from_profile = true;
  EXPECT_TRUE(all_faults("A.MPF", kText, c).starts_with("name-defined-twice"));
  c.axes = "XYZB";
  EXPECT_EQ(all_faults("A.MPF", kText, c), "name-beginning");
}

TEST(DefinitionFile, DataFilesAreNoPrograms) {
  constexpr std::string_view kInit =
      "CHANDATA(1)\n$MN_SCALING_SYSTEM_IS_METRIC=1\nN20070 $MC_AXCONF_MACHAX_USED[0]=1 '2a3f\n"
      "$MA_REFP_SET_POS[0,AX1]=250.5\nMETRIC\n$TC_TP2[1]=\"CUTTER\"\n";
  const ir::Control c = control(ir::MachineKind::mill);
  EXPECT_EQ(all_faults("INITIAL.INI", kInit, c), "");
  EXPECT_EQ(all_faults("A.ARC", "%_N_INITIAL_INI\n" + std::string(kInit), c), "");
  EXPECT_NE(all_faults("INITIAL.MPF", kInit, c), "") << "the same in a program";
}

TEST(DefinitionFile, APartOfAnArchiveThatIsNoProgramIsNotRead) {
  const ir::Control c = control(ir::MachineKind::mill);
  EXPECT_EQ(
      all_faults("A.ARC", "%_N_ALARMS_COM\n;$PATH=/_N_CUS_DIR\n85000 0 0 \"text\"\n//END\n%_N_AB_SPF\nR1=1\nM17\n", c),
      "");
  EXPECT_NE(all_faults("A.ARC", "%_N_ALARMS_SPF\n85000 0 0 \"text\"\n", c), "");
}

TEST(DefinitionFile, OneFindingANameSaysWhatSettlesIt) {
  const ir::Control c = control(ir::MachineKind::mill);
  const ir::Program p = good(std::string(kHead) + "R1=GAUGE\nR2=GAUGE+WIDTH\nM30");
  const auto found = validate(p, c, ir::Delivery::memory);
  ASSERT_EQ(found.size(), 2U);
  for (const text::Diagnostic& d : found) {
    EXPECT_EQ(d.severity, text::Severity::warning);
    EXPECT_TRUE(d.is_open);
    ASSERT_FALSE(d.notes.empty());
    EXPECT_TRUE(d.notes.front().text.contains("decides this"));
  }
}

TEST(DefinitionFile, IsKnownByItsNameInAnyCase) {
  const auto is_data = [](std::string_view name) {
    return read(text::Source(std::string(name), "DEF CHAN REAL A1\n"), control(ir::MachineKind::mill)).program.is_data;
  };
  EXPECT_TRUE(is_data("/x/UGUD.DEF"));
  EXPECT_TRUE(is_data("more.def"));
  EXPECT_TRUE(is_data("INITIAL.INI"));
  EXPECT_FALSE(is_data("MORE.MPF"));
}

}  // namespace
}  // namespace dripfeed::sinumerik
