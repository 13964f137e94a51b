// Programs that call tools by name, on a machine whose profile has those names: each check finds the tool, as it does
// by number.
#include <algorithm>
#include <optional>
#include <string>

#include <gtest/gtest.h>

#include "server/app/checks/examine.h"

namespace dripfeed::app {
namespace {

using text::DiagnosticId;

machine::Profile named_profile() {
  machine::Profile made;
  made.control.dialect = "sinumerik-840d";
  made.machine.axes = {{.axis = ir::Axis::x, .min = -500, .max = 500, .rapid_mm_min = 20'000},
                       {.axis = ir::Axis::y, .min = -500, .max = 500, .rapid_mm_min = 20'000},
                       {.axis = ir::Axis::z, .min = -500, .max = 0, .rapid_mm_min = 20'000}};
  made.machine.tools = {{.number = 1, .name = "MILL_D10", .offset = 1, .diameter_mm = 10, .length_mm = 100},
                        {.number = 2, .name = "MILL_D20", .offset = 1, .diameter_mm = 20, .length_mm = 150}};
  made.machine.origin = {0.0, 0.0, -400.0};
  return made;
}

CheckReport check_on(const std::string& text, const machine::Profile& machine, bool with_part = false) {
  const compile::Dialect* dialect = compile::find_dialect(machine.control.dialect);
  std::optional<family::Geometry> part;
  if (with_part) {
    part.emplace();
    part->machine = ir::MachineKind::mill;
    part->stock = family::BoxStock{.x_mm = {-50, 50}, .y_mm = {-50, 50}, .z_mm = {-20, 0}};
  }
  return examine({.source = text::Source("x.mpf", text),
                  .dialect = dialect,
                  .control = machine::control_of(machine, dialect->control(ir::MachineKind::mill, ir::GSystem::a)),
                  .inferred = false,
                  .profile = &machine,
                  .delivery = ir::Delivery::memory,
                  .find_called = {},
                  .geometry = part,
                  .profile_lines = {}});
}

bool has_note(const CheckReport& report, std::string_view part) {
  return std::ranges::any_of(checks::not_checked_of(report.checks),
                             [&](const checks::NotChecked& one) { return one.text.contains(part); });
}

std::string cut_with(const std::string& tool) {
  return "G17 G90 G94 G71 G54 G40\n" + tool + " M6\nS1000 M3\nG0 X-70 Y0 Z50\nZ-3\nG1 X0 F200\nG0 Z50\nZ310\nM30\n";
}

std::uint64_t travel_findings(const CheckReport& report) {
  return report.checks.envelope.value().findings.count(DiagnosticId::travel_exceeded);
}

// Z310 in a zero at -400: 10 mm beyond with a tool of 100 mm, and the other is longer.
TEST(NamedTools, TheTravelCountsTheirLength) {
  EXPECT_EQ(travel_findings(check_on(cut_with("T=\"MILL_D10\" D1"), named_profile())), 1U);
  machine::Profile shorter = named_profile();
  shorter.machine.tools[0].length_mm = 80;
  EXPECT_EQ(travel_findings(check_on(cut_with("T=\"MILL_D10\" D1"), shorter)), 0U);
  EXPECT_TRUE(has_note(check_on(cut_with("T=\"MILL_D10\""), shorter), "tool \"MILL_D10\" is called without D"));
  const CheckReport other = check_on(cut_with("T=\"MILL_D12\" D1"), named_profile());
  EXPECT_TRUE(has_note(other, "the length of a tool that is called by its name"));
  ASSERT_EQ(other.checks.diagnostics.size(), 1U);
  EXPECT_EQ(other.checks.diagnostics[0].id, DiagnosticId::tool_missing);
  EXPECT_EQ(text::message_of(other.checks.diagnostics[0]), "the tool \"MILL_D12\" is not in the machine's list");
}

TEST(NamedTools, WithoutNamesTheReportStatesWhatSettlesIt) {
  machine::Profile nameless = named_profile();
  for (checks::Tool& tool : nameless.machine.tools) tool.name.clear();
  const CheckReport report = check_on(cut_with("T=\"MILL_D10\" D1"), nameless);
  EXPECT_TRUE(
      has_note(report,
               "T=\"MILL_D10\": which tool this is is not known; \"name\" of the tools in the machine's profile "
               "decides this"));
  EXPECT_TRUE(report.checks.diagnostics.empty());
  nameless.machine.tools.clear();
  EXPECT_FALSE(has_note(check_on(cut_with("T=\"MILL_D10\" D1"), nameless), "which tool"));
}

// A rapid 12 mm before the block: a radius of 5 mm passes, one of 20 does not.
TEST(NamedTools, GougesAreThoseOfTheTool) {
  const std::string text =
      "G17 G90 G94 G71 G54 G40\nT=\"MILL_D10\" D1 M6\nS1000 M3\nG0 X-70 Y0 Z50\nX-58 Z-3\nG0 Z50\n"
      "T=\"MILL_D20\" D1 M6\nG0 X-70 Y0 Z50\nZ-3\nX-58\nG0 Z50\nM30\n";
  const CheckReport report = check_on(text, named_profile(), true);
  const auto& found = report.checks.gouge.value().findings;
  ASSERT_EQ(found.count(DiagnosticId::rapid_into_stock), 2U) << "to it and away from it";
  EXPECT_EQ(found.kept()[0].place.line, 10U);
  const CheckReport open = check_on(cut_with("T=\"MILL_D12\" D1"), named_profile(), true);
  EXPECT_TRUE(
      has_note(open, "the diameter of a tool that is called by a name is not known: its moves were not checked"));
}

// Compensation takes what the program wrote; what cuts is the tool of the profile.
TEST(NamedTools, AWrittenRadiusLeavesCompensationOpen) {
  const std::string head = "G17 G90 G94 G71 G54 G40\nT1 D1 M6\nS1000 M3\n";
  const std::string cut = "G0 X-70 Y-70 Z50\nZ-3\nG41 G1 X-40 Y-60 F200\nY60\nG40 X-70 Y70\nG0 Z50\nM30\n";
  EXPECT_FALSE(check_on(head + cut, named_profile(), true).checks.gouge->has_unjudged_cuts);
  EXPECT_FALSE(check_on(head + "$TC_DP6[1,1]=5\n" + cut, named_profile(), true).checks.gouge->has_unjudged_cuts);
  const CheckReport open = check_on(head + "$TC_DP6[1,1]=4\n" + cut, named_profile(), true);
  EXPECT_TRUE(open.checks.gouge->has_unjudged_cuts);
  EXPECT_TRUE(has_note(open, "$TC_DP6: the program changes the control's tool data, and they stay so after its end"));
  EXPECT_FALSE(has_note(check_on(head + "$TC_DP6[1,1]=5\n" + cut, named_profile(), true), "$TC_DP6"));
  EXPECT_TRUE(has_note(open, "the program changes the radius of a tool"));
}

// G10 L12 writes the register of D on a control with numbers.
TEST(NamedTools, AWrittenRegisterLeavesCompensationOpen) {
  machine::Profile fanuc = named_profile();
  fanuc.control.dialect = "fanuc";
  const std::string head = "%\nO1\nG21 G17 G90 G94 G40 G49 G80 G54\nT1 M6\nG43 H1\nS1000 M3\n";
  const std::string cut =
      "G0 X-70. Y-70. Z50.\nZ-3.\nG41 D1 G1 X-40. Y-60. F200.\nY60.\nG40 X-70. Y70.\nG0 Z50.\nM30\n%\n";
  const auto is_open = [&](const std::string& written) {
    return check_on(head + written + cut, fanuc, true).checks.gouge->has_unjudged_cuts;
  };
  EXPECT_FALSE(is_open(""));
  EXPECT_TRUE(is_open("G10 L12 P1 R4.\n"));
  EXPECT_TRUE(is_open("#13001=4.\n"));
  EXPECT_FALSE(is_open("G10 L10 P1 R120.\n")) << "a length";
}

}  // namespace
}  // namespace dripfeed::app
