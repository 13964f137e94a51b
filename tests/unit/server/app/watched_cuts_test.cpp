// Which likely faults of tools and spindles a run of a mill's program reports, and what it leaves open.
#include <algorithm>

#include <gtest/gtest.h>

#include "server/app/checks/examine.h"

namespace dripfeed::app {
namespace {

using text::DiagnosticId;

const std::string kStart = "%\nO1\nG21 G17 G90 G94 G40 G49 G80 G54\n";
const std::string kEnd = "M30\n%\n";

CheckReport check_mill(const std::string& blocks, std::string_view name = "fanuc",
                       ir::MachineKind kind = ir::MachineKind::mill) {
  const compile::Dialect* dialect = compile::find_dialect(name);
  return examine({.source = text::Source("x.nc", kStart + blocks + kEnd),
                  .dialect = dialect,
                  .control = dialect->control(kind, ir::GSystem::a),
                  .inferred = false,
                  .profile = nullptr,
                  .delivery = ir::Delivery::memory,
                  .find_called = {},
                  .geometry = {},
                  .profile_lines = {}});
}

std::int64_t count(const CheckReport& report, DiagnosticId id) {
  return std::ranges::count(report.checks.diagnostics, id, &text::Diagnostic::id);
}

bool leaves_open(const CheckReport& report, std::string_view part) {
  return std::ranges::any_of(checks::not_checked_of(report.checks),
                             [&](const checks::NotChecked& one) { return one.text.contains(part); });
}

TEST(WatchedCuts, ACutWithASpindleThatStandsIsReportedOnceATool) {
  const std::string cuts = "G43 H1 G00 Z5.\nG01 Z-1. F100.\nX5.\nX0.\n";
  const CheckReport report = check_mill("T1 M6\n" + cuts);
  EXPECT_EQ(count(report, DiagnosticId::spindle_not_turning), 1);
  EXPECT_EQ(report.verdict, checks::Verdict::warn);
  EXPECT_EQ(count(check_mill("T1 M6\nS500 M3\n" + cuts), DiagnosticId::spindle_not_turning), 0);
  EXPECT_EQ(check_mill("T1 M6\nS500 M3\n" + cuts).verdict, checks::Verdict::pass);
  EXPECT_EQ(count(check_mill("T1 M6\nS500 M3\n" + cuts + "M5\nT2 M6\nG43 H2 G00 Z5.\nG01 X5.\n"),
                  DiagnosticId::spindle_not_turning),
            1);
}

TEST(WatchedCuts, WhatMayStartTheSpindleUnseenIsNotReported) {
  const std::string cuts = "G43 H1 G00 Z5.\nG01 Z-1. F100.\nX5.\n";
  EXPECT_EQ(count(check_mill("T1 M6\nS500 M13\n" + cuts), DiagnosticId::spindle_not_turning), 0);
  EXPECT_EQ(count(check_mill("T1 M6\nG65 P9000 S500\n" + cuts), DiagnosticId::spindle_not_turning), 0);
  EXPECT_EQ(count(check_mill("T1 M6\nG43 H1 G00 Z5.\nG01 Z1. F100.\n"), DiagnosticId::spindle_not_turning), 0)
      << "straight down it positions";
}

// Later on it stands while a bar is pulled.
TEST(WatchedCuts, OnALatheTheSpindleMustHaveTurned) {
  const auto is_reported = [](const std::string& blocks) {
    const CheckReport report = check_mill(blocks, "fanuc", ir::MachineKind::lathe);
    return count(report, DiagnosticId::spindle_not_turning) != 0;
  };
  EXPECT_TRUE(is_reported("T0101\nG00 X50. Z5.\nG01 Z-5. F100.\n"));
  EXPECT_FALSE(is_reported("T0101\nG97 S500 M3\nG00 X50. Z5.\nG01 Z-5. F100.\nM5\nG01 Z-20. F500.\n"));
  EXPECT_FALSE(is_reported("T0101\nM45\nG00 X50. Z5.\nG01 Z-5. F100.\n")) << "which may turn a driven tool";
}

TEST(WatchedCuts, ASpindleWithoutItsSpeedIsNotKnown) {
  const std::string cuts = "G43 H1 G00 Z5.\nG01 Z-1. F100.\nX5.\n";
  const CheckReport report = check_mill("T1 M6\nM3\n" + cuts);
  EXPECT_EQ(report.verdict, checks::Verdict::unknown);
  EXPECT_TRUE(leaves_open(report, "the speed of the spindle (S)"));
  EXPECT_FALSE(leaves_open(check_mill("S500\nT1 M6\nM3\n" + cuts), "the speed of the spindle (S)"));
}

TEST(WatchedCuts, AToolThatIsOnlySelectedDoesNotCut) {
  const auto is_reported = [](const std::string& first, const char* dialect = "haas") {
    const std::string cuts = "G43 H1 G00 Z5.\nS500 M3\nG01 X5. F100.\nX0.\n";
    return count(check_mill(first + cuts, dialect), DiagnosticId::tool_not_called) != 0;
  };
  EXPECT_TRUE(is_reported("T1\n"));
  EXPECT_FALSE(is_reported("T1 M6\n"));
  EXPECT_FALSE(is_reported("T1 M6\nT2\n")) << "ready for the next change";
  EXPECT_FALSE(is_reported(""));
  EXPECT_FALSE(is_reported("T1\n", "fanuc")) << "machines change tools by T alone";
}

TEST(WatchedCuts, HaasToolsTakeTheirLengthByG43) {
  const auto id_of = [](const std::string& blocks, const char* dialect = "haas") {
    const CheckReport report = check_mill(blocks, dialect);
    if (count(report, DiagnosticId::length_offset_missing) != 0) return std::string("missing");
    if (count(report, DiagnosticId::length_offset_of_other_tool) != 0) return std::string("other");
    return std::string("none");
  };
  EXPECT_EQ(id_of("T1 M6\nG00 Z5.\n"), "missing");
  EXPECT_EQ(id_of("T1 M6\nG43 H5 Z5.\n"), "other");
  EXPECT_EQ(id_of("T1 M6\nG43 H1 Z5.\n"), "none");
  EXPECT_EQ(id_of("T1 M6\nG00 Z5.\n", "mazak"), "none") << "a parameter lets the length act by M6";
  EXPECT_EQ(id_of("T1 M6\nG43 H5 Z5.\n", "mazak"), "other");
}

// #2 is an argument: that the text sets it later does not give it a value where it is read first.
TEST(WatchedCuts, AnArgumentThatIsChangedLaterIsOneNevertheless) {
  const CheckReport report = check_mill("IF[#2 EQ #0]GOTO10\n#2=#2*2\nM30\nN10 #3000=1(NO B)\n");
  EXPECT_FALSE(text::has_error(report.checks.diagnostics));
  EXPECT_EQ(report.verdict, checks::Verdict::unknown);
}

// Files of the disc of a Mazak.
TEST(WatchedCuts, AFileWithTheControlsEndingIsCalledByItsName) {
  const compile::Dialect* dialect = compile::find_dialect("mazak");
  const auto count_in = [&](const char* name) {
    const text::Source source(name, "#1=5.\nM99\n");
    const ir::Control control = dialect->control(ir::MachineKind::mill, ir::GSystem::a);
    const ir::ReadResult read = dialect->read(source, control);
    return dialect->validate(read.program, control, ir::Delivery::memory).size();
  };
  EXPECT_EQ(count_in("SWAP.EIA"), 0U);
  EXPECT_EQ(count_in("swap.eia"), 0U);
  EXPECT_GT(count_in("swap.nc"), 0U);
}

}  // namespace
}  // namespace dripfeed::app
