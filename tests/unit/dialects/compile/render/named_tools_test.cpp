// Tools that SINUMERIK programs call by name, and tool data that they write. The name means a tool of the machine's
// profile; case counts in it and nowhere else (SINUMERIK NC programming, "Structure and contents of an NC program").
#include <algorithm>
#include <cmath>
#include <string>

#include "tests/unit/dialects/compile/render/family_run.h"
#include "tests/unit/dialects/compile/sinumerik_run.h"

namespace dripfeed::compile::test {
namespace {

ir::Control machine() {
  ir::Control control = test::control("sinumerik-840d", ir::MachineKind::mill);
  control.semantics.power_on_known = true;
  control.from_profile = true;
  control.tool_names = {{"DRILL 8.5", 9}, {"MILL_D10", 4}};
  control.tool_radii = {{.tool = 4, .offset = 1, .radius_mm = 5.0}, {.tool = 4, .offset = 2, .radius_mm = 4.0}};
  control.tool_lengths = {{.tool = 4, .offset = 1, .length_mm = 100.0}};
  return control;
}

// "4 MILL_D10 D1" of each tool that comes in.
std::string tools_of(const Result& ran) {
  std::string out;
  for (const ir::Motion& m : ran.motions) {
    if (m.kind != ir::MotionKind::tool) continue;
    out += std::to_string(m.number) + " ";
    out += m.text < ran.result.strings.size() ? ran.result.strings[m.text] : std::string("-");
    out += " D" + std::to_string(m.tool_offset) + "\n";
  }
  return out;
}

const std::string kModes = "G17 G90 G94 G54 G71\n";

TEST(NamedTools, TheNameIsATheProfilesTool) {
  const Result ran = run_on(machine(), kModes +
                                           "T=\"MILL_D10\" D2 M6\nG0 X0\nt=\"DRILL \"<<8.5\nD1 M6\nT=\"MILL_D10\"\nM6\n"
                                           "T3 M6\nM30\n");
  EXPECT_EQ(tools_of(ran), "4 MILL_D10 D2\n9 DRILL 8.5 D1\n4 MILL_D10 D0\n3 - D0\n");
  EXPECT_TRUE(ran.result.diagnostics.empty());
  EXPECT_TRUE(ran.result.not_interpreted.empty());
}

TEST(NamedTools, ANameThatTheProfileDoesNotHaveIsReported) {
  const Result ran = run_on(machine(), kModes + "T=\"Mill_D10\" M6\nT=\"MILL_D12\" M6\nM30\n");
  EXPECT_EQ(tools_of(ran), "0 Mill_D10 D0\n0 MILL_D12 D0\n");
  ASSERT_EQ(ran.result.diagnostics.size(), 2U);
  const text::Diagnostic& first = ran.result.diagnostics[0].diagnostic;
  EXPECT_EQ(first.id, text::DiagnosticId::tool_missing);
  EXPECT_EQ(first.severity, text::Severity::warning);
  EXPECT_EQ(first.arguments, (std::vector<std::string>{"\"Mill_D10\""}));
  ASSERT_EQ(first.notes.size(), 1U);
  EXPECT_TRUE(first.notes[0].text.contains("\"name\" of the tools")) << first.notes[0].text;
  EXPECT_EQ(ran.result.diagnostics[1].line, 3U);
}

// A profile without names leaves open which of its tools is meant; without a profile there is nothing to settle.
TEST(NamedTools, AProfileWithoutNamesLeavesThemOpen) {
  ir::Control control = machine();
  control.tool_names.clear();
  const std::string text = kModes + "T=\"MILL_D10\" M6\nM30\n";
  const Result open = run_on(control, text);
  EXPECT_TRUE(open.result.diagnostics.empty());
  ASSERT_TRUE(open.names("T=\"MILL_D10\""));
  EXPECT_TRUE(open.result.not_interpreted[0].effects_known);
  control.from_profile = false;
  EXPECT_TRUE(run_on(control, text).result.not_interpreted.empty());
  const Result computed = run_on(machine(), kModes + "T=\"MILL_\"<<R5 M6\nM30\n");
  EXPECT_TRUE(computed.names("T by a name that is not known"));
  EXPECT_TRUE(tools_of(computed).starts_with("0 "));
}

// The internal number of a tool by name is the control's own: $P_TOOLNO is not the number of the profile.
TEST(NamedTools, TheControlsOwnNumberIsNotKnown) {
  const Result ran = run_on(machine(), kModes + "T=\"MILL_D10\" D1 M6\nR1=$P_TOOLNO\nR2=$P_TOOL\nM30\n");
  EXPECT_TRUE(ran.names("$P_TOOLNO"));
  EXPECT_EQ(ran.value("R2"), 1.0);
}

std::string pocket(const std::string& before) {
  return kModes + before + "S1000 M3\nG0 X0 Y0 Z50\nPOCKET4(20,0,2,-3,20,0,0,3,0,0,300,100,0,11)\nM30\n";
}

// How far from its centre the wall of the pocket is cut: its radius less that of the tool.
double reach(const Result& ran) {
  double most = 0.0;
  for (const ir::Motion& m : ran.motions)
    if (ir::is_move(m.kind) && m.end[2] < 0.0) most = std::max(most, std::hypot(m.end[0], m.end[1]));
  return most;
}

TEST(NamedTools, MillingCyclesTakeTheirRadius) {
  EXPECT_NEAR(reach(run_on(machine(), pocket("T=\"MILL_D10\" D1 M6\n"))), 15.0, 1e-6);
  EXPECT_NEAR(reach(run_on(machine(), pocket("T=\"MILL_D10\" D2 M6\n"))), 16.0, 1e-6);
  EXPECT_TRUE(run_on(machine(), pocket("T=\"MILL_D12\" D1 M6\n")).names("POCKET4 by a tool whose radius is not known"));
}

std::uint8_t gaps_of(const Result& ran) {
  std::uint8_t all = 0;
  for (const ir::Motion& m : ran.motions)
    if (ir::is_move(m.kind)) all |= m.gaps;
  return all;
}

// $TC_DP6 is the radius of tool and edge from then on (LIS1).
TEST(WrittenToolData, ARadiusIsThatOfTheToolFromThenOn) {
  EXPECT_NEAR(reach(run_on(machine(), pocket("$TC_DP6[4,1]=3\nT4 D1 M6\n"))), 17.0, 1e-6);
  EXPECT_NEAR(reach(run_on(machine(), pocket("T4 D1 M6\n$TC_DP6[4,1]=3\n"))), 17.0, 1e-6);
  EXPECT_NEAR(reach(run_on(machine(), pocket("T7 D1 M6\n$TC_DP6[7,1]=3.5\n"))), 16.5, 1e-6) << "not in the profile";
  const auto is_open = [](const std::string& before) {
    return run_on(machine(), pocket(before)).names("POCKET4 by a tool whose radius is not known");
  };
  EXPECT_TRUE(is_open("T4 D1 M6\n$TC_DP6[4,1]=R5\n")) << "by a value that is not known";
  EXPECT_TRUE(is_open("T4 D1 M6\n$TC_DP6[R5,1]=3\n")) << "it may be any tool";
  EXPECT_TRUE(is_open("T4 D1 M6\n$TC_DP1[4,0]=0\n")) << "its edges are deleted";
  EXPECT_TRUE(is_open("T=\"MILL_D10\" D1 M6\n$TC_DP6[4,1]=3\n")) << "the control numbers named tools itself";
}

TEST(WrittenToolData, WhatTheProfileHasIsNoChange) {
  const auto gaps = [](const std::string& written) {
    return gaps_of(run_on(machine(), kModes + "T4 D1 M6\n" + written + "\nG0 X0 Y0 Z50\nM30\n"));
  };
  EXPECT_EQ(gaps("$TC_DP1[4,1]=120 $TC_DP3[4,1]=100 $TC_DP6[4,1]=5"), 0);
  EXPECT_EQ(gaps("$TC_DP6[4,1]=5.1"), ir::kRadiiChanged);
  EXPECT_EQ(gaps("$TC_DP3[4,1]=100.1"), ir::kLengthsChanged);
  EXPECT_EQ(gaps("$TC_DP3[4,2]=100"), ir::kLengthsChanged) << "of an edge that the profile does not have";
  EXPECT_EQ(gaps("$TC_DP1[4,1]=0"), ir::kLengthsChanged | ir::kRadiiChanged);
  const Result ran = run_on(machine(), kModes + "$TC_DP6[4,1]=5\n$TC_DP15[4,1]=0.1\nR1=$TC_DP6[4,1]\nM30\n");
  EXPECT_FALSE(ran.names("$TC_DP6"));
  EXPECT_TRUE(ran.names("$TC_DP15")) << "wear stays what it was: not interpreted";
  EXPECT_EQ(ran.value("R1"), 5.0);
}

// LIS1: of the tool in the spindle. Where its data are not given the value is not known.
TEST(ActiveTool, RadiusAndLengthAreThoseOfTheEdgeInEffect) {
  const auto values = [](const std::string& before) {
    return run_on(machine(), kModes + before + "R1=$P_TOOLR\nR2=$P_TOOLL[1]\nM30\n");
  };
  const auto expect = [&](const std::string& before, double radius, double length) {
    const Result ran = values(before);
    EXPECT_EQ(ran.value("R1"), radius) << before;
    EXPECT_EQ(ran.value("R2"), length) << before;
    EXPECT_FALSE(ran.names("$P_TOOLR") || ran.names("$P_TOOLL[1]")) << before;
  };
  expect("T4 D1 M6\n", 5.0, 100.0);
  expect("T=\"MILL_D10\" D1 M6\n", 5.0, 100.0);
  expect("T4 D1 M6\nD0\n", 0.0, 0.0);
  expect("T7 D1 M6\n$TC_DP6[7,1]=3.5 $TC_DP3[7,1]=80\n", 3.5, 80.0);
  const Result other_edge = values("T4 D2 M6\n");
  EXPECT_EQ(other_edge.value("R1"), 4.0);
  EXPECT_TRUE(other_edge.names("$P_TOOLL[1]"));
  for (const std::string before :
       {"", "T9 D1 M6\n", "T4 D1 M6\nG70\n", "T4 D1 M6\n$TC_DP6[4,1]=R9 $TC_DP3[4,1]=R9\n"}) {
    EXPECT_TRUE(values(before).names("$P_TOOLR")) << before;
    EXPECT_TRUE(values(before).names("$P_TOOLL[1]")) << before;
  }
  EXPECT_TRUE(run_on(machine(), kModes + "T4 D1 M6\nR1=$P_TOOLL[2]\nM30\n").names("$P_TOOLL[2]"));
}

// --- families

RenderResult with_named_tool(const std::string& dialect, const std::string& name, RenderMode mode,
                             bool has_profile = true) {
  RenderRequest request;
  request.family = {"test.family", "family test\nmachine mill\nprogram test\n  feed 100 mm/min\n  tool \"" + name +
                                       "\"  diameter 10 mm\n  rapid x 1 mm\n  tool 9\n  cut x 2 mm\nend\n"};
  request.target = test::control(dialect, ir::MachineKind::mill);
  request.target.from_profile = has_profile;
  if (has_profile) request.target.tool_names = machine().tool_names;
  request.mode = mode;
  request.program_name = dialect.starts_with("sinumerik") ? "FAMILY_TEST" : "O0100";
  return render(request);
}

TEST(NamedTools, AFamilyCallsAToolByItsName) {
  for (const std::string& dialect : dialect_names()) {
    for (const RenderMode mode : {RenderMode::macro, RenderMode::explicit_blocks}) {
      const RenderResult made = with_named_tool(dialect, "MILL_D10", mode);
      ASSERT_TRUE(made.diagnostics.empty()) << dialect;
      EXPECT_EQ(made.text.contains("T=\"MILL_D10\""), dialect.starts_with("sinumerik")) << made.text;
      ASSERT_EQ(made.geometry.tools.size(), 2U);
      EXPECT_EQ(made.geometry.tools[0].number, 4);
      ir::Control control = test::control(dialect, ir::MachineKind::mill);
      control.from_profile = true;
      control.tool_names = machine().tool_names;
      std::vector<std::int32_t> numbers;
      for (const ir::Motion& one : run_text(made.text, control).motions)
        if (one.kind == ir::MotionKind::tool) numbers.push_back(one.number);
      EXPECT_EQ(numbers, (std::vector<std::int32_t>{4, 9})) << made.text;
    }
  }
}

TEST(NamedTools, AFamilysToolThatTheMachineDoesNotHaveIsAnError) {
  const auto fault = [](const RenderResult& made) {
    EXPECT_TRUE(made.text.empty());
    EXPECT_EQ(made.diagnostics.size(), 1U);
    EXPECT_EQ(made.diagnostics.front().id, text::DiagnosticId::tool_missing);
    EXPECT_EQ(made.diagnostics.front().severity, text::Severity::error);
    return made.diagnostics.front().notes.front().text;
  };
  EXPECT_EQ(fault(with_named_tool("fanuc", "MILL_D12", RenderMode::macro)), "did you mean \"MILL_D10\"?");
  EXPECT_EQ(fault(with_named_tool("sinumerik-840d", "mill_d10", RenderMode::macro)),
            "of the names in the machine's profile \"MILL_D10\" is the nearest; case counts");
  EXPECT_TRUE(fault(with_named_tool("fanuc", "MILL_D10", RenderMode::macro, false)).contains("state the machine"));
  EXPECT_EQ(with_named_tool("fanuc", "", RenderMode::macro).diagnostics.front().id, text::DiagnosticId::family_syntax);
  EXPECT_EQ(with_named_tool("fanuc", "MILL D10", RenderMode::macro).diagnostics.front().id,
            text::DiagnosticId::family_syntax);
}

}  // namespace
}  // namespace dripfeed::compile::test
