// Values that the control changes by itself, and values of the control that a program changes: neither a branch nor a
// travel is certain by them.
#include <string>
#include <string_view>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "server/app/checks/examine.h"

namespace dripfeed::app {
namespace {

using checks::Verdict;

// A mill that travels 0 to 100 in each axis, with its zeros at 0.
machine::Profile small_mill(const std::string& dialect) {
  machine::Profile profile;
  profile.name = "m";
  profile.control.dialect = dialect;
  for (const ir::Axis axis : {ir::Axis::x, ir::Axis::y, ir::Axis::z}) {
    profile.machine.axes.push_back(
        {.axis = axis, .min = 0.0, .max = 100.0, .rapid_mm_min = 10'000.0, .acceleration_mm_s2 = 1000.0});
    profile.machine.origin[static_cast<std::size_t>(axis)] = 0.0;
  }
  profile.machine.spindle_max_rpm = 8000.0;
  return profile;
}

CheckReport check(const std::string& dialect_name, const std::string& text) {
  const machine::Profile profile = small_mill(dialect_name);
  const compile::Dialect* dialect = compile::find_dialect(dialect_name);
  return examine({.source = text::Source("MAIN.MPF", text),
                  .dialect = dialect,
                  .control = dialect->control(ir::MachineKind::mill, ir::GSystem::a),
                  .inferred = false,
                  .profile = &profile,
                  .delivery = ir::Delivery::memory,
                  .find_called = {},
                  .geometry = {},
                  .profile_lines = {}});
}

std::string reasons_of(const CheckReport& report) {
  std::string all;
  for (const text::Diagnostic& one : report.checks.diagnostics)
    all += text::format_diagnostic(one, report.source, "") + "\n";
  for (const checks::NotChecked& one : checks::not_checked_of(report.checks)) all += one.text + "\n";
  return all;
}

const std::string kHash = "%\nO1\nG21 G17 G90 G94 G40 G49 G80 G54\nG00 X10. Y10. Z10. S500 M03\n";
const std::string kSinumerik = "G17 G710 G90 G94 G54 G40\nT1 D0\nS500 M3 F100\nG0 X10 Y10 Z10\n";

CheckReport check_hash(const std::string& blocks, const std::string& dialect = "fanuc") {
  return check(dialect, kHash + blocks + "G00 X20.\nM30\n%\n");
}
CheckReport check_sinumerik(const std::string& blocks) {
  return check("sinumerik-840d", kSinumerik + blocks + "G0 X20\nM30\n");
}

TEST(ControlValues, AProgramWithoutAnyPasses) {
  for (const char* dialect : {"fanuc", "mazak", "mitsubishi-m80"}) {
    const CheckReport report = check_hash("", dialect);
    EXPECT_EQ(report.verdict, Verdict::pass) << dialect << reasons_of(report);
  }
  const CheckReport report = check_sinumerik("");
  EXPECT_EQ(report.verdict, Verdict::pass) << reasons_of(report);
}

// --- clocks and counters

void expect_no_branch_is_certain(const CheckReport& report, const std::string& what) {
  EXPECT_EQ(report.verdict, Verdict::unknown) << what << reasons_of(report);
}

TEST(ControlValues, WhatATimerSaysAfterAMoveIsNotKnown) {
  for (const char* timer :
       {"$AC_TIMER[1]", "$AC_OPERATING_TIME", "$AC_CYCLE_TIME", "$AC_CUTTING_TIME", "$AN_SETUP_TIME",
        "$AN_POWERON_TIME", "$AC_TOTAL_PARTS", "$AC_ACTUAL_PARTS", "$AC_SPECIAL_PARTS"})
    for (const char* condition : {">5", "==0", "<=5"}) {
      const std::string blocks = fmt::format("{0}=0\nG1 X90\nIF {0}{1}\nSETAL(65000)\nENDIF\n", timer, condition);
      expect_no_branch_is_certain(check_sinumerik(blocks), blocks);
    }
  for (const char* clock : {"$AC_TIME", "$A_SECOND"})
    expect_no_branch_is_certain(check_sinumerik(fmt::format("IF {}>5\nSETAL(65000)\nENDIF\n", clock)), clock);
}

// A clock that is set, what follows, and a branch by it.
std::string branch_by(std::string_view clock, std::string_view between) {
  return fmt::format("{0}=0\n{1}IF[{0}LT5000]GOTO10\n#3000=1(LATE)\nN10\n", clock, between);
}

TEST(ControlValues, WhatAClockSaysAfterAMoveIsNotKnown) {
  for (const char* dialect : {"fanuc", "haas", "mazak", "mitsubishi-m80"})
    for (const char* between : {"G01 X90. F10.\n", "G00 X90.\n", "M05\n", "T2 M06\n", "M50\n"})
      for (const char* clock : {"#3001", "#3002", "#3901"})
        expect_no_branch_is_certain(check_hash(branch_by(clock, between), dialect),
                                    fmt::format("{} {}", dialect, clock));
  for (const char* clock : {"#3001", "#3002", "#3011", "#3012"})
    expect_no_branch_is_certain(check_hash(fmt::format("IF[{}LT5000]GOTO10\n#3000=1(LATE)\nN10\n", clock)), clock);
  for (const char* timer : {"#3020", "#3022", "#3024"})
    expect_no_branch_is_certain(check_hash(branch_by(timer, ""), "haas"), timer);
}

// What a dwell and the blocks take is counted: a program that waits for its clock ends.
TEST(ControlValues, AClockCountsWhileNothingMoves) {
  for (const std::string dialect : {"fanuc", "mazak", "mitsubishi-m80"}) {
    const CheckReport report = check_hash("#3001=0\nG04 P1500\nWHILE[#3001LT2000]DO1\nEND1\n", dialect);
    EXPECT_EQ(report.verdict, Verdict::pass) << dialect << reasons_of(report);
  }
}

// --- the control's memory

TEST(ControlValues, NoTravelPassesAfterAnOffsetThatAProgramWrites) {
  struct Row {
    std::string dialect;
    std::string block;
  };
  const Row rows[] = {
      {"fanuc", "#5221=50."},
      {"fanuc", "#5201=50."},
      {"fanuc", "#7001=50."},
      {"fanuc", "#14001=50."},
      {"fanuc", "#2501=50."},
      {"fanuc", "#2600=50."},
      {"fanuc", "#5502=50."},
      {"fanuc", "#3005=32"},
      {"fanuc", "#[5220+1]=50."},
      {"fanuc", "[#_WZG54[1]]=50."},
      {"fanuc", "G10 L2 P1 X50."},
      {"haas", "#5221=50."},
      {"haas", "#14001=50."},
      {"haas", "#50001=50."},
      {"mazak", "#5221=50."},
      {"mazak", "#70001=50."},
      {"mazak", "#5510=50."},
      {"mitsubishi-m80", "#5221=50."},
      {"mitsubishi-m80", "#101001=50."},
      {"mitsubishi-m80", "#100002=50."},
  };
  for (const Row& row : rows) {
    const CheckReport report = check_hash(row.block + "\n", row.dialect);
    EXPECT_EQ(report.verdict, Verdict::unknown) << row.dialect << ' ' << row.block << '\n' << reasons_of(report);
  }
  for (const std::string block :
       {"$P_UIFR[1,X,TR]=50", "$P_UIFR[1]=CTRANS(X,50)", "$P_UIFR[R1,X,TR]=50", "$P_IFRAME=CTRANS(X,50)",
        "$P_BFRAME=CTRANS(X,50)", "$P_UBFR=CTRANS(X,50)", "$P_CHBFR[0]=CTRANS(X,50)", "$P_NCBFR[0]=CTRANS(X,50)",
        "$P_SETFRAME=CTRANS(X,50)", "$P_PFRAME=$P_UIFR[2]", "$P_PFRAME[X,TR]=$A_INA[1]"}) {
    const CheckReport report = check_sinumerik(block + "\n");
    EXPECT_EQ(report.verdict, Verdict::unknown) << block << '\n' << reasons_of(report);
  }
}

// The programmable frame is followed, and with it the travel.
TEST(ControlValues, AProgrammableFrameThatIsKnownIsFollowed) {
  const CheckReport inside = check_sinumerik("$P_PFRAME=CTRANS(X,50)\n");
  EXPECT_EQ(inside.verdict, Verdict::pass) << reasons_of(inside);
  const CheckReport outside = check_sinumerik("$P_PFRAME=CTRANS(X,90)\n");
  EXPECT_EQ(outside.verdict, Verdict::fail) << reasons_of(outside);
}

TEST(ControlValues, WhatMovesNothingMayBeWritten) {
  for (const std::string block : {"#3003=1", "#3004=2", "#3901=0", "#500=1.", "#150=1."})
    for (const std::string dialect : {"fanuc", "mazak", "mitsubishi-m80"}) {
      const CheckReport report = check_hash(block + "\n", dialect);
      EXPECT_EQ(report.verdict, Verdict::pass) << dialect << ' ' << block << '\n' << reasons_of(report);
    }
  for (const std::string block : {"$AC_TIMER[1]=0", "$AC_MARKER[1]=2", "R1=5"}) {
    const CheckReport report = check_sinumerik(block + "\n");
    EXPECT_EQ(report.verdict, Verdict::pass) << block << '\n' << reasons_of(report);
  }
}

// What an output switches, and what the PLC makes of a value, only the machine says.
TEST(ControlValues, WhatAnOutputSwitchesIsNotKnown) {
  for (const std::string block : {"#1100=1", "#1132=5"})
    for (const std::string dialect : {"fanuc", "mazak", "mitsubishi-m80", "haas"})
      EXPECT_EQ(check_hash(block + "\n", dialect).verdict, Verdict::unknown) << dialect << ' ' << block;
  for (const std::string block : {"$A_OUT[1]=1", "$A_DBB[4]=2", "H3=1"})
    EXPECT_EQ(check_sinumerik(block + "\n").verdict, Verdict::unknown) << block;
}

}  // namespace
}  // namespace dripfeed::app
