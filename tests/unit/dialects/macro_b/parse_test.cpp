// Statements that blocks become, and blocks that stay text.
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "reading.h"

namespace dripfeed::macro_b {
namespace {

using ir::StatementKind;
using ::testing::ElementsAre;
using enum ir::StatementKind;

std::vector<StatementKind> kinds(const std::string& text) {
  std::vector<StatementKind> out;
  for (const ir::Statement& statement : read_text(text).program.statements) out.push_back(statement.kind);
  return out;
}
std::string native_of(const std::string& text) {
  const ir::ReadResult read = read_text(text);
  EXPECT_TRUE(read.diagnostics.empty()) << text;
  return read.program.natives.empty() ? "" : std::string(read.program.strings.at(read.program.natives.front().name));
}

TEST(Parse, MakesStatementsOfBlocks) {
  EXPECT_THAT(kinds("G00 X1.\n"), ElementsAre(block));
  EXPECT_THAT(kinds("#1=2\n"), ElementsAre(assign));
  EXPECT_THAT(kinds("#1=2,#3=4\n"), ElementsAre(assign, assign));
  EXPECT_THAT(kinds("IF[#1EQ2]GOTO5\n"), ElementsAre(go_to));
  EXPECT_THAT(kinds("IF[#1EQ2]THEN #3=4\n"), ElementsAre(if_begin, assign, if_end));
  EXPECT_THAT(kinds("WHILE[#1LT2]DO1\nEND1\n"), ElementsAre(while_begin, while_end));
  EXPECT_THAT(kinds("DO2\nEND2\n"), ElementsAre(loop_begin, loop_end));
  EXPECT_THAT(kinds("G00 X1. M98 P100\n"), ElementsAre(block, call));
  EXPECT_THAT(kinds("G67 G00 X1.\n"), ElementsAre(modal_call_end, block));
  EXPECT_THAT(kinds("G00 X1. G67 M98 P100\n"), ElementsAre(modal_call_end, block, call));
  EXPECT_THAT(kinds("M03 M30\n"), ElementsAre(block, program_end));
  EXPECT_THAT(kinds("M99 P10 L2\n"), ElementsAre(native, return_to));
  EXPECT_THAT(kinds("M99\n"), ElementsAre(subprogram_return));
  EXPECT_THAT(kinds("#3000=1(STOP)\n"), ElementsAre(alarm));
  EXPECT_THAT(kinds("#3006=1(LOOK)\n"), ElementsAre(message, block));
  EXPECT_THAT(kinds("%\nO1\n(C)\n\n"), ElementsAre(empty, empty, empty, empty));
}

TEST(Parse, KeepsNamesLabelsAndSkips) {
  const ir::ReadResult read = read_text("%\nO12(TITLE)\n/3N100 G00X1.\n");
  EXPECT_EQ(read.program.name, "O0012");
  ASSERT_EQ(read.program.labels.size(), 1U);
  EXPECT_EQ(read.program.labels[0].number, 100U);
  EXPECT_TRUE(read.program.statements[2].is_label);
  EXPECT_EQ(read.program.statements[2].skip_level, 3);
  EXPECT_EQ(read.program.statements[2].line, 3U);
  EXPECT_EQ(read_text("<ROLL-1>\n").program.name, "ROLL-1");
}

TEST(Parse, CountsLinesAsTheSourceDoes) {
  const ir::ReadResult read = read_text("G00X1.\r\nG00X2.\n\r\rG00X3.;G00X4.\rG00X5.");
  std::vector<std::uint32_t> lines;
  for (const ir::Statement& statement : read.program.statements) lines.push_back(statement.line);
  EXPECT_THAT(lines, ElementsAre(1, 2, 3, 3, 4));
}

TEST(Parse, ReadsCalls) {
  const ir::ReadResult read = read_text("M98 P51234\nM98 P12 L3\nG54 G65 P9010 L2 A1. I2. I3.\nM98 P#1\nM98 <SUB>\n");
  const ir::Program& p = read.program;
  ASSERT_TRUE(read.diagnostics.empty());
  ASSERT_EQ(p.calls.size(), 5U);
  EXPECT_EQ(p.strings.at(p.calls[0].name), "O1234");
  EXPECT_EQ(p.at(p.calls[0].repeats).value, 5.0);
  EXPECT_EQ(p.strings.at(p.calls[1].name), "O0012");
  EXPECT_EQ(p.at(p.calls[1].repeats).value, 3.0);
  EXPECT_EQ(p.calls[2].kind, ir::CallKind::macro);
  ASSERT_EQ(p.arguments_of(p.calls[2]).size(), 3U);
  EXPECT_EQ(p.arguments_of(p.calls[2])[1].letter, 'I');
  EXPECT_NE(p.calls[3].number, ir::ExpressionId::none);
  EXPECT_EQ(p.strings.at(p.calls[4].name), "SUB");
}

TEST(Parse, KeepsWhatItDoesNotModelByName) {
  EXPECT_EQ(native_of("BPRNT[X#100[3]]\n"), "BPRNT");
  EXPECT_EQ(native_of("DPRNT[X#[#1]]\n"), "DPRNT");
  EXPECT_EQ(native_of("SETVN101[A,B]\n"), "SETVN");
  EXPECT_EQ(native_of("#1=[#_CLOCK1]\n"), "a variable with a name");
  EXPECT_EQ(native_of("[#NAME]=5.\n"), "a variable with a name");
  EXPECT_EQ(native_of("G10 L50\n"), "G10 L50");
  EXPECT_EQ(native_of("&F=/USER/\n"), "&");
}

TEST(Parse, KnowsWhereTheCallerGoesOn) {
  const ir::Program plain = read_text("M99\n").program;
  EXPECT_EQ(plain.statements.front().payload, ir::kNoIndex);
  const ir::Program written = read_text("M99 P100\n").program;
  ASSERT_EQ(written.statements.front().kind, ir::StatementKind::return_to);
  EXPECT_EQ(written.jumps.at(written.statements.front().payload).number, 100U);
  const ir::Program computed = read_text("M99 P#4\n").program;
  EXPECT_NE(computed.jumps.at(computed.statements.front().payload).computed, ir::ExpressionId::none);
}

TEST(Parse, ReportsCallsOfOtherDevicesAndModalCalls) {
  const ir::Program external = read_text("M198 P100 L2\n").program;
  ASSERT_EQ(external.calls.size(), 1U);
  EXPECT_EQ(external.calls[0].kind, ir::CallKind::external);
  const ir::Program modal = read_text("G66 P9100 A1.\nX1.\nG67\n").program;
  EXPECT_EQ(modal.statements[0].kind, ir::StatementKind::modal_call);
  EXPECT_EQ(modal.statements[2].kind, ir::StatementKind::modal_call_end);
  const ir::Program start = read_text("M98 P2 Q30\n").program;
  ASSERT_EQ(start.calls.size(), 1U);
  EXPECT_EQ(start.at(start.calls[0].start).value, 30.0);
}

TEST(Parse, ReadsTheFieldsOfOutput) {
  const ir::Program program = read_text("DPRNT[X#100[53]*Y]\n").program;
  ASSERT_EQ(program.output_parts.size(), 2U);
  EXPECT_EQ(program.strings.at(program.output_parts[0].text), "X");
  EXPECT_EQ(program.output_parts[0].whole_digits, 5);
  EXPECT_EQ(program.output_parts[0].decimals, 3);
  EXPECT_EQ(program.strings.at(program.output_parts[1].text), " Y");
}

TEST(Parse, KnowsTheProgramsOfAText) {
  const ir::Program program = read_text("%\nO1\nM98 P2\nM30\nO2\nM99\n%\n").program;
  ASSERT_EQ(program.sections.size(), 2U);
  EXPECT_EQ(program.strings.at(program.sections[0].name), "O0001");
  EXPECT_EQ(program.sections[0].first, 0U);
  EXPECT_EQ(program.strings.at(program.sections[1].name), "O0002");
  EXPECT_EQ(program.sections[0].last, program.sections[1].first);
  EXPECT_EQ(program.sections[1].last, program.statements.size());
}

TEST(Parse, TakesNoMovesFromParameterData) {
  const ir::ReadResult read = read_text("G10 L52\nN7810 R0\nX1.\nG11\nX2.\n");
  EXPECT_EQ(read.program.blocks.size(), 2U);  // G11, X2.
}

TEST(Parse, NumbersExtendedWorkOffsets) {
  const ir::ReadResult read = read_text("G54.1 P48 X1.\n");
  ASSERT_EQ(read.program.codes.size(), 1U);
  EXPECT_EQ(read.program.codes[0].function, ir::Function::work_offset);
  EXPECT_EQ(read.program.codes[0].argument, kExtendedOffset + 48);
  ASSERT_EQ(read.program.words.size(), 1U);
}

TEST(Parse, NotUnderstoodBlocksHaveUnknownEffects) {
  const ir::ReadResult read = read_text("G00 X1. Y\nG00 X2.\n");
  ASSERT_EQ(read.program.natives.size(), 1U);
  EXPECT_FALSE(read.program.natives[0].effects_known);
  EXPECT_EQ(read.diagnostics.size(), 1U);
  EXPECT_EQ(read.program.statements[1].kind, block);
}

TEST(Parse, FaultInWhileLeavesItsEndAlone) {
  const ir::ReadResult read = read_text("WHILE[#1LT]DO1\nEND1\n");
  EXPECT_EQ(read.diagnostics.size(), 1U);
  EXPECT_THAT(read.program.statements[0].kind, loop_begin);
  EXPECT_NE(read.program.structures[0].partner, ir::kNoIndex);
}

TEST(Parse, RoundInAnAddressIsToItsIncrement) {
  const ir::ReadResult read = read_text("G00 X[ROUND[#1]]\n#2=ROUND[#1]\n");
  const ir::Program& p = read.program;
  EXPECT_EQ(p.at(p.words[0].value).op, ir::Operator::divide);
  EXPECT_EQ(p.at(p.assigns[0].value).op, ir::Operator::round);
}

TEST(Parse, OffersFixes) {
  const ir::ReadResult read = read_text(
      "G00 X#106+50.\n\xD0\x9C"
      "30\n");
  ASSERT_EQ(read.diagnostics.size(), 2U);
  ASSERT_TRUE(read.diagnostics[0].fix);
  EXPECT_EQ(read.diagnostics[0].fix->text, "[#106+50.]");
  ASSERT_TRUE(read.diagnostics[1].fix);
  EXPECT_EQ(read.diagnostics[1].fix->text, "M");
}

TEST(Parse, TextOfNothingButFaultsEnds) {
  std::string text;
  for (int i = 0; i < 10'000; ++i) text += "X Y\n";
  EXPECT_EQ(read_text(text).diagnostics.size(), Faults::kMostFaults);
}

}  // namespace
}  // namespace dripfeed::macro_b
