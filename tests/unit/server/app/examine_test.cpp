// What an examination says of a text besides what its dialect says: the characters of the machine's line, and the
// bytes that its lines take there.
#include "server/app/checks/examine.h"

#include <functional>
#include <map>

#include <gtest/gtest.h>

namespace dripfeed::app {
namespace {

machine::Profile profile_of(const std::string& url, const char* set) {
  machine::Profile profile;
  profile.name = "m";
  profile.control.dialect = "fanuc";
  profile.line.link = machine::parse_link_url(url).value();
  profile.line.character_set = set;
  return profile;
}

CheckReport report_of(const std::string& text, const machine::Profile* profile) {
  const compile::Dialect* dialect = compile::find_dialect("fanuc");
  return examine({.source = text::Source("x.nc", text),
                  .dialect = dialect,
                  .control = dialect->control(ir::MachineKind::mill, ir::GSystem::a),
                  .inferred = false,
                  .profile = profile,
                  .delivery = ir::Delivery::memory,
                  .find_called = {},
                  .geometry = {},
                  .profile_lines = {}});
}

// "LINE:COLUMN ARGUMENT" of what is reported of characters.
std::vector<std::string> characters_in(const CheckReport& report) {
  std::vector<std::string> all;
  for (const text::Diagnostic& one : report.checks.diagnostics) {
    if (one.id != text::DiagnosticId::invalid_character) continue;
    const text::Position at = report.source.position(one.span.begin);
    all.push_back(std::to_string(at.line) + ":" + std::to_string(at.column) + " " + one.arguments.at(0));
  }
  return all;
}

TEST(Examine, ACharacterThatTheLineCannotCarryIsSeenBeforeAJob) {
  const std::string text = "%\r\nO1(Shaft)\r\nG21G90G94G17\r\nG0X1.\r\nM30\r\n%\r\n";
  const machine::Profile upper = profile_of("serial:/dev/ttyS0", "fanuc-iso");
  const CheckReport report = report_of(text, &upper);
  EXPECT_EQ(characters_in(report), (std::vector<std::string>{"2:5 h"})) << "those of comments together";
  EXPECT_EQ(report.verdict, checks::Verdict::warn);
  EXPECT_EQ(report_of("%\nO1\nG21G90G94G17\nG0x1.\nM30\n%\n", &upper).verdict, checks::Verdict::fail);
  const machine::Profile lower = profile_of("serial:/dev/ttyS0", "ascii");
  EXPECT_TRUE(characters_in(report_of(text, &lower)).empty());
  EXPECT_TRUE(characters_in(report_of(text, nullptr)).empty()) << "no machine, no line";
}

TEST(Examine, TheCodeOfTheUrlCounts) {
  const std::string text = "%\nO1\nG21G90G94G17\nG0X1.\nM30\n%\n";
  const machine::Profile eia = profile_of("serial:/dev/ttyS0?framing=8N2&code=eia", "fanuc-iso");
  EXPECT_TRUE(characters_in(report_of(text, &eia)).empty());
  EXPECT_EQ(characters_in(report_of("%\nO1\nG21G90G94G17\n#1=2.\nM30\n%\n", &eia)),
            (std::vector<std::string>{"4:1 #", "4:3 ="}));
}

TEST(Examine, WhatTheReaderReportedIsNotReportedAgain) {
  const machine::Profile profile = profile_of("serial:/dev/ttyS0", "fanuc-iso");
  EXPECT_EQ(characters_in(report_of("%\nO1\nG0X1.\n\xC3\xA4\nM30\n%\n", &profile)).size(), 1U);
}

TEST(Examine, WhatReadingAndRunningBothSeeIsReportedOnce) {
  const CheckReport report = report_of("%\nO1\nG21 G90 G94 G17\nG0 X1.\n\n%\n", nullptr);
  std::vector<std::uint32_t> lines;
  for (const text::Diagnostic& one : report.checks.diagnostics)
    if (one.id == text::DiagnosticId::missing_program_end) lines.push_back(report.source.position(one.span.begin).line);
  EXPECT_EQ(lines, (std::vector<std::uint32_t>{4}));
}

// What the envelope says of a text on a machine whose Z travels from -500 to 0, with its zero at -400.
CheckReport on_short_z(const std::string& text, const std::string& name) {
  machine::Profile profile = profile_of("serial:/dev/ttyS0", "ascii");
  profile.control.dialect = name;
  profile.machine.axes = {{.axis = ir::Axis::z, .min = -500, .max = 0}};
  profile.machine.tools = {{.number = 7, .offset = 1, .length_mm = 100}};
  profile.machine.origin[2] = -400;
  const compile::Dialect* dialect = compile::find_dialect(name);
  return examine({.source = text::Source("x.nc", text),
                  .dialect = dialect,
                  .control = dialect->control(ir::MachineKind::mill, ir::GSystem::a),
                  .inferred = false,
                  .profile = &profile,
                  .delivery = ir::Delivery::memory,
                  .find_called = {},
                  .geometry = {},
                  .profile_lines = {}});
}

// Lines at which the travel of Z is exceeded.
std::vector<std::uint32_t> lines_exceeded(const std::string& text, const std::string& name) {
  const CheckReport report = on_short_z(text, name);
  std::vector<std::uint32_t> lines;
  for (const checks::Finding& one : report.checks.envelope.value().findings.kept())
    if (one.id == text::DiagnosticId::travel_exceeded) lines.push_back(one.place.line);
  return lines;
}

// By the codes of each control: H of an offset, D of an edge of the tool in the spindle.
TEST(Examine, TheTravelCountsTheToolsLength) {
  using Lines = std::vector<std::uint32_t>;
  const std::string head = "%\nO1\nG21G17G90G94G54T7M6\n";
  const std::string tail = "G0Z300.\nZ300.01\nZ400.\nZ400.01\nM30\n";
  EXPECT_EQ(lines_exceeded(head + "G43H1\n" + tail + "%\n", "fanuc"), (Lines{6, 7, 8}));
  EXPECT_EQ(lines_exceeded(head + "G49\n" + tail + "%\n", "fanuc"), (Lines{8}));
  EXPECT_EQ(lines_exceeded("G71 G17 G90 G94 G54 T7 M6\nD1\n" + tail, "sinumerik-840d"), (Lines{4, 5, 6}));
  EXPECT_EQ(lines_exceeded("G71 G17 G90 G94 G54 T7 M6\n\n" + tail, "sinumerik-840d"), (Lines{4, 5, 6}));
  EXPECT_EQ(lines_exceeded("G71 G17 G90 G94 G54 T7 M6\nD0\n" + tail, "sinumerik-840d"), (Lines{6}));
}

// "LINE ALARM" of each finding.
std::vector<std::string> alarms_in(const std::string& text, const std::string& name) {
  const CheckReport report = on_short_z(text, name);
  std::vector<std::string> all;
  for (const checks::Finding& one : report.checks.envelope.value().findings.kept())
    all.push_back(std::to_string(one.place.line) + " " + (one.alarm.empty() ? "-" : one.alarm));
  return all;
}

// Z0 of the machine is Z400 here, Z-500 is Z-100.
TEST(Examine, ASoftLimitHasTheAlarmOfItsSide) {
  using Alarms = std::vector<std::string>;
  const std::string head = "G21G17G90G94G40G49G54\n";
  EXPECT_EQ(alarms_in("%\nO1\n" + head + "G0Z400.\nZ-100.\nM30\n%\n", "fanuc"), Alarms{}) << "just at its limits";
  EXPECT_EQ(alarms_in("%\nO1\n" + head + "G0Z400.01\nM30\n%\n", "fanuc"), Alarms{"4 OT0500"});
  EXPECT_EQ(alarms_in("%\nO1\n" + head + "G0Z-100.01\nM30\n%\n", "fanuc"), Alarms{"4 OT0501"});
  EXPECT_EQ(alarms_in("G71 G17 G90 G94 G54\nG0 Z400.01\nZ-100.01\nM30\n", "sinumerik-840d"),
            (Alarms{"2 10720", "3 10720"}));
  EXPECT_EQ(alarms_in("%\nO1\n" + head + "G0Z400.01\nM30\n%\n", "mitsubishi-m80"), Alarms{"4 -"});
}

TEST(Examine, LinesTakeTheirEobAndTheBlankOfATvCheck) {
  tape_code::WireFormat format;
  EXPECT_EQ(bytes_of_lines("%\r\nG0X1\r\nG0X10\r\n", format), (std::vector<std::uint32_t>{2, 5, 6}));
  format.eob = tape_code::Eob::lf_cr_cr;
  format.leader_chars = 100;
  EXPECT_EQ(bytes_of_lines("%\nG0X1\nG0X10", format), (std::vector<std::uint32_t>{4, 7, 8}));
  format.pad_tv = true;
  EXPECT_EQ(bytes_of_lines("%\nG0X1\nG0X10\n", format), (std::vector<std::uint32_t>{4, 8, 8}));
  format.eia = tape_code::EiaSpecials{};
  EXPECT_EQ(bytes_of_lines("%\nG0X1\nG0X10\n", format), (std::vector<std::uint32_t>{2, 6, 6}));
}

// A SINUMERIK program, with others next to it by name.
CheckReport sinumerik_report(const std::string& text, std::map<std::string, std::string, std::less<>> next_to_it = {}) {
  const compile::Dialect* dialect = compile::find_dialect("sinumerik-840d");
  return examine(
      {.source = text::Source("MAIN.MPF", text),
       .dialect = dialect,
       .control = dialect->control(ir::MachineKind::mill, ir::GSystem::a),
       .inferred = false,
       .profile = nullptr,
       .delivery = ir::Delivery::memory,
       .find_called = [next_to_it = std::move(next_to_it)](std::string_view name) -> std::optional<text::Source> {
         const auto found = next_to_it.find(name);
         if (found == next_to_it.end()) return std::nullopt;
         return text::Source("/nc/" + found->first + ".SPF", found->second);
       },
       .geometry = {},
       .profile_lines = {}});
}

constexpr const char* kHead = "G17 G710 G90 G94 M3 S1000 F100\n";

TEST(Examine, AnAlarmInACalledProgramIsAtItsOwnPlace) {
  const CheckReport report =
      sinumerik_report(std::string(kHead) + "PART\nM30\n", {{"PART", ";a\nR1=0\nG1 X=1/R1\nM17\n"}});
  ASSERT_EQ(report.checks.diagnostics.size(), 1U);
  const text::Diagnostic& one = report.checks.diagnostics.front();
  EXPECT_EQ(one.id, text::DiagnosticId::division_by_zero);
  ASSERT_NE(one.elsewhere, nullptr);
  EXPECT_EQ(one.elsewhere->name(), "/nc/PART.SPF");
  EXPECT_EQ(one.elsewhere->position(one.span.begin).line, 3U);
  EXPECT_TRUE(text::format_diagnostic(one, report.source, "").starts_with("/nc/PART.SPF:3:"));
}

TEST(Examine, AProgramThatIsNotThereIsNoFaultAndNothingPasses) {
  const CheckReport report = sinumerik_report(std::string(kHead) + "OTHER\nG0 X1\nM30\n");
  ASSERT_EQ(report.checks.diagnostics.size(), 1U);
  EXPECT_EQ(report.checks.diagnostics.front().severity, text::Severity::warning);
  EXPECT_EQ(report.verdict, checks::Verdict::unknown);
  EXPECT_EQ(sinumerik_report(std::string(kHead) + "OTHER\nG0 X1\nM30\n", {{"OTHER", "G0 Z5\nM17\n"}}).verdict,
            checks::Verdict::pass);
}

TEST(Examine, ANameThatNothingDefinesLetsNothingPass) {
  const std::string text = std::string(kHead) + "GAUGE=10\nM30\n";
  EXPECT_EQ(sinumerik_report(text).verdict, checks::Verdict::unknown) << "it may be an axis";
  EXPECT_EQ(sinumerik_report(text, {{"MGUD", "DEF NCK REAL GAUGE\nM30\n"}}).verdict, checks::Verdict::pass);
}

TEST(Examine, WhatTheControlAnswersIsNeverZero) {
  for (const char* condition : {"GETT(\"X\",1)==0", "ISFILE(\"A\")==0", "$AC_TIMER[1]==0", "$A_IN[1]==0",
                                "STRINGIS(\"A\")==0", "$AC_MEA[1]==0"}) {
    const std::string text =
        std::string(kHead) + "IF " + condition + "\nSETAL(65000)\nELSE\nSETAL(65001)\nENDIF\nM30\n";
    const CheckReport report = sinumerik_report(text);
    EXPECT_NE(report.verdict, checks::Verdict::pass) << condition;
    EXPECT_NE(report.verdict, checks::Verdict::fail) << condition << ": neither branch is certain";
  }
}

}  // namespace
// A family for lathes says nothing of what a mill does: the text fails, and its nominal is not dropped without a word.
TEST(Examine, AFamilyForAnotherKindOfMachineFails) {
  const compile::Dialect* dialect = compile::find_dialect("fanuc");
  family::Geometry geometry;
  geometry.machine = ir::MachineKind::lathe;
  const auto verdict = [&](ir::MachineKind kind) {
    return examine({.source = text::Source("x.nc", "%\nO1\nG21G90G40\nM30\n%\n"),
                    .dialect = dialect,
                    .control = dialect->control(kind, ir::GSystem::a),
                    .inferred = false,
                    .profile = nullptr,
                    .delivery = ir::Delivery::memory,
                    .find_called = {},
                    .geometry = geometry,
                    .profile_lines = {}});
  };
  const CheckReport mill = verdict(ir::MachineKind::mill);
  EXPECT_EQ(mill.verdict, checks::Verdict::fail);
  ASSERT_FALSE(mill.checks.diagnostics.empty());
  EXPECT_EQ(mill.checks.diagnostics.back().id, text::DiagnosticId::family_other_machine);
  EXPECT_NE(verdict(ir::MachineKind::lathe).verdict, checks::Verdict::fail);
  EXPECT_NE(verdict(ir::MachineKind::mill_turn).verdict, checks::Verdict::fail);
}

// A family's checks are those of the machine's tool: where that has another shape, nothing passes.
TEST(Examine, AToolOfAnotherShapeThanTheFamilysIsReported) {
  machine::Profile profile;
  profile.machine.tools = {{.number = 1, .diameter_mm = 10}};
  const compile::Dialect* dialect = compile::find_dialect("fanuc");
  const auto reported_for = [&](std::int32_t number, double diameter_mm) {
    family::Geometry geometry;
    geometry.tools = {{.number = number, .diameter_mm = diameter_mm}};
    std::vector<std::string> out;
    const CheckReport report = examine({.source = text::Source("x.nc", "%\nO1\nG21G90G40\nM30\n%\n"),
                                        .dialect = dialect,
                                        .control = dialect->control(ir::MachineKind::mill, ir::GSystem::a),
                                        .inferred = false,
                                        .profile = &profile,
                                        .delivery = ir::Delivery::memory,
                                        .find_called = {},
                                        .geometry = geometry,
                                        .profile_lines = {}});
    for (const checks::NotChecked& one : checks::not_checked_of(report.checks))
      if (one.text.starts_with("tool ")) out.push_back(one.text);
    return out;
  };
  EXPECT_EQ(reported_for(1, 8),
            (std::vector<std::string>{"tool 1: the family has the diameter 8 mm, the machine 10 mm, which counts"}));
  EXPECT_TRUE(reported_for(1, 10).empty());
  EXPECT_TRUE(reported_for(1, 0).empty());
  EXPECT_TRUE(reported_for(2, 8).empty());
}

}  // namespace dripfeed::app
