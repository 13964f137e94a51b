// What `dripfeed wrap` proposes: the numbers of a program's header with what they are for, and the program's own bytes.
#include "dialects/compile/propose/propose_family.h"

#include <string>

#include <gtest/gtest.h>

#include "dialects/compile/propose/proposed_names.h"
#include "dialects/family/read.h"
#include "tests/unit/dialects/compile/harness.h"

namespace dripfeed::compile::test {
namespace {

FamilyProposal proposed(const std::string& program, const std::string& dialect, ir::MachineKind kind,
                        const std::string& name = "part.nc") {
  const text::Source source(name, program);
  return propose_family(source, *find_dialect(dialect), control(dialect, kind), name);
}

std::string notes_of(const FamilyProposal& proposal) {
  std::string out;
  for (const ProposalNote& note : proposal.notes)
    out.append(std::to_string(note.line)).append(": ").append(note.text).append("\n");
  return out;
}

// The line of the proposal that binds the target.
std::string line_for(const FamilyProposal& proposal, const std::string& target) {
  const std::size_t at = proposal.text.find(" is " + target + " ");
  if (at == std::string::npos) return notes_of(proposal);
  const std::size_t begin = proposal.text.rfind('\n', at) + 1;
  return proposal.text.substr(begin, proposal.text.find('\n', begin) - begin);
}

const std::string kSlot =
    "%\nO1200 (SLOT, \"DEEP\")\nG21 G90 G17 G94 G40\n#100=50.(LENGTH OF THE SLOT)\n#101=-3.5 (DEPTH)\n#102=30(ANGLE)\n"
    "#103=250.(FEED)\n#104=1200(RPM)\n#105=0\n#106=3 (PASSES)\n#107=2.5\n#108=#100/2\n#109=1.5(NEVER USED)\n"
    "T1 M6\nS#104 M3\nG0 X[#100*COS[#102]] Y#107\nG43 H1 Z5.\nWHILE[#105LT#106]DO1\nG1 Z[#101*#105/3.] F#103\nX#108\n"
    "#105=#105+1\nEND1\nM30\n%\n";

TEST(ProposeFamily, NumbersOfTheHeaderBecomeParameters) {
  const FamilyProposal out = proposed(kSlot, "fanuc", ir::MachineKind::mill, "/parts/Slot 12.nc");
  EXPECT_TRUE(out.text.ends_with("\nnative fanuc\n" + kSlot)) << notes_of(out);
  EXPECT_NE(out.text.find("\nfamily slot-12 \"SLOT, 'DEEP'\"\nmachine mill\n"), std::string::npos) << out.text;
  EXPECT_EQ(line_for(out, "#100"),
            "param length_of_the length 50 mm in 25..100 \"LENGTH OF THE SLOT\" is #100  # proposed range");
  EXPECT_EQ(line_for(out, "#101"), "param depth length -3.5 mm in -7..-1.75 \"DEPTH\" is #101  # proposed range");
  EXPECT_EQ(line_for(out, "#102"), "param angle_value angle 30 deg in 15..60 \"ANGLE\" is #102  # proposed range");
  EXPECT_EQ(line_for(out, "#103"), "param feed_value feed 250 mm/min in 125..500 \"FEED\" is #103  # proposed range");
  EXPECT_EQ(line_for(out, "#104"), "param rpm_value speed 1200 rpm in 600..2400 \"RPM\" is #104  # proposed range");
  EXPECT_EQ(line_for(out, "#106"), "param passes count 3 in 1..6 \"PASSES\" is #106  # proposed range");
  EXPECT_EQ(line_for(out, "#107"), "param v107 length 2.5 mm in 1.25..5 is #107  # proposed range");
  EXPECT_EQ(line_for(out, "#109"), "param never_used ratio 1.5 in 0.75..3 \"NEVER USED\" is #109  # proposed range");
  EXPECT_EQ(out.parameters, 8U);
  EXPECT_EQ(notes_of(out),
            "9: #105 is not proposed: it is set in lines 9 and 21 of the native program, and which of "
            "them counts differs from place to place\n");
}

TEST(ProposeFamily, InchesAndTurnsAreTheProgramsOwn) {
  const FamilyProposal out =
      proposed("G20G99G40\n#1=2.\n#2=.01\n#3=600.\nG96S#3M3\nG0X#1\nG1Z-1.F#2\nM30\n", "fanuc", ir::MachineKind::lathe);
  EXPECT_NE(out.text.find("\nmachine lathe, x is diameter\n"), std::string::npos) << out.text;
  EXPECT_EQ(line_for(out, "#1"), "param v1 length 2 in in 1..4 is #1  # proposed range");
  EXPECT_EQ(line_for(out, "#2"), "param v2 feed 0.01 in/rev in 0.005..0.02 is #2  # proposed range");
  EXPECT_EQ(line_for(out, "#3"), "param v3 speed 600 ft/min in 300..1200 is #3  # proposed range");
}

TEST(ProposeFamily, UnknownUnitsStayPlainNumbers) {
  const FamilyProposal out = proposed("#1=2.\nG0X#1\nM30\n", "fanuc", ir::MachineKind::mill);
  EXPECT_EQ(line_for(out, "#1"), "param v1 ratio 2 in 1..4 is #1  # proposed range");
  EXPECT_NE(notes_of(out).find("1: #1 is proposed as a plain number: "), std::string::npos) << notes_of(out);
}

TEST(ProposeFamily, DefinitionsAndCallsAreFound) {
  const std::string program =
      "%_N_MAIN_MPF\nEXTERN TURN(REAL, INT, REAL)\nG71 G95 DIAMON\nDEF REAL DIA=100 ; bar\nDEF INT TIMES=4\nR5=-1\n"
      "G0 X=DIA Z=R5\nTURN(50.0, 4, 0.25)\nM30\n"
      "%_N_TURN_SPF\nPROC TURN(REAL DM, INT PASSES, REAL F_ROUGH)\nG95 G1 X=DM F=F_ROUGH\nM17\n";
  const FamilyProposal out = proposed(program, "sinumerik-840d", ir::MachineKind::lathe);
  EXPECT_TRUE(out.text.ends_with("\nnative sinumerik-840d\n" + program)) << notes_of(out);
  EXPECT_EQ(line_for(out, "DIA"), "param dia length 100 mm in 50..200 \"bar\" is DIA  # proposed range");
  EXPECT_EQ(line_for(out, "TIMES"), "param times count 4 in 2..8 is TIMES  # proposed range");
  EXPECT_EQ(line_for(out, "R5"), "param r5 length -1 mm in -2..-0.5 is R5  # proposed range");
  EXPECT_EQ(line_for(out, "TURN.DM"), "param dm length 50 mm in 25..100 is TURN.DM  # proposed range");
  EXPECT_EQ(line_for(out, "TURN.PASSES"), "param passes count 4 in 2..8 is TURN.PASSES  # proposed range");
  // G71 says nothing of feeds, and no one has looked at the machine.
  EXPECT_EQ(line_for(out, "TURN.F_ROUGH"), "param f_rough ratio 0.25 in 0.125..0.5 is TURN.F_ROUGH  # proposed range");
}

TEST(ProposeFamily, DwellsTakeTimes) {
  const FamilyProposal out = proposed("G21\n#109=1.5\n#110=500\n#111=2.\nG4X#109\nG4P#110\nG4X[#111*2]\nM30\n", "fanuc",
                                      ir::MachineKind::mill);
  EXPECT_EQ(line_for(out, "#109"), "param v109 time 1.5 s in 0.75..3 is #109  # proposed range");
  EXPECT_EQ(line_for(out, "#110"), "param v110 time 500 ms in 250..1000 is #110  # proposed range");
  EXPECT_EQ(line_for(out, "#111"), "param v111 time 2 s in 1..4 is #111  # proposed range");
  const FamilyProposal siemens =
      proposed("G71\nR1=1.5\nR2=3\nG4 F=R1\nG4 S=R2\nM30\n", "sinumerik-840d", ir::MachineKind::lathe);
  EXPECT_EQ(line_for(siemens, "R1"), "param r1 time 1.5 s in 0.75..3 is R1  # proposed range");
  EXPECT_EQ(line_for(siemens, "R2"), "param r2 ratio 3 in 1.5..6 is R2  # proposed range");
}

TEST(ProposeFamily, NumbersOfOtherFormsAreNamed) {
  const FamilyProposal out =
      proposed("G71\nR5=1EX2\nR6=-1EX2\nR7=3\nG0 X=R5 Z=R6+R7\nM30\n", "sinumerik-840d", ir::MachineKind::lathe);
  EXPECT_EQ(out.parameters, 1U);
  EXPECT_EQ(notes_of(out),
            "2: R5 is not proposed: line 2 of the native program does not set it to a plain decimal number\n"
            "3: R6 is not proposed: line 3 of the native program does not set it to a plain decimal number\n");
}

// A comment that comes after two numbers names neither.
TEST(ProposeFamily, ACommentNamesOneNumber) {
  const FamilyProposal out = proposed("G71\nR1=5 R2=7 ;feed\nR3=9 ;depth\nG0 X=R1 Z=R2\nG0 X=R3\nM30\n",
                                      "sinumerik-840d", ir::MachineKind::lathe);
  EXPECT_EQ(line_for(out, "R1"), "param r1 length 5 mm in 2.5..10 is R1  # proposed range");
  EXPECT_EQ(line_for(out, "R2"), "param r2 length 7 mm in 3.5..14 is R2  # proposed range");
  EXPECT_EQ(line_for(out, "R3"), "param depth length 9 mm in 4.5..18 \"depth\" is R3  # proposed range");
}

TEST(ProposeFamily, WhatOthersMaySetIsNamed) {
  const FamilyProposal out = proposed("G21\n#100=5.\nM98P7\nG0X#100\nM30\n", "fanuc", ir::MachineKind::mill);
  EXPECT_EQ(out.parameters, 1U);
  EXPECT_NE(notes_of(out).find("2: #100 may lose its value: programs that the native text does not hold"),
            std::string::npos)
      << notes_of(out);
}

TEST(ProposeFamily, UsesThatDisagreeSayNothing) {
  const FamilyProposal out = proposed("G21\n#1=2.\n#2=SIN[#1]\nG0X#1\nM30\n", "fanuc", ir::MachineKind::mill);
  EXPECT_EQ(line_for(out, "#1"), "param v1 ratio 2 in 1..4 is #1  # proposed range");
}

TEST(ProposeFamily, ProgramsWithoutNumbersAreWrappedAllTheSame) {
  const FamilyProposal out = proposed("\r\nG21\r\nM30", "fanuc", ir::MachineKind::mill);
  EXPECT_EQ(out.parameters, 0U);
  EXPECT_TRUE(out.text.ends_with("\nnative fanuc\n\r\nG21\r\nM30")) << out.text;
}

TEST(ProposedNames, AreWordsThatTheFamilyLanguageTakes) {
  ProposedNames names;
  EXPECT_EQ(names.name_for("DEPTH OF CUT, Q", "v1"), "depth_of_cut");
  EXPECT_EQ(names.name_for("depth of cut", "v2"), "depth_of_cut_2");
  EXPECT_EQ(names.name_for("2. PASS", "v3"), "v2_pass");
  EXPECT_EQ(names.name_for("---", "v4"), "v4");
  EXPECT_EQ(names.name_for("X", "v5"), "v5");
  EXPECT_EQ(names.name_for("DIAMETER", "v6"), "diameter_value");
  EXPECT_EQ(names.name_for("", "X_1"), "x_1");
  EXPECT_EQ(quoted_text("a\"b\tc\xFF\xC3\xA4"), "\"a'b c?\xC3\xA4\"");
  EXPECT_EQ(proposed_family_name("/a/b.c/O0100.NC"), "o0100");
  EXPECT_EQ(proposed_family_name("9010"), "program-9010");
  EXPECT_EQ(proposed_family_name("-"), "wrapped-program");
}

}  // namespace
}  // namespace dripfeed::compile::test
