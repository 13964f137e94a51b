// R of a lathe's drilling cycles: a distance from the initial level on some controls, a level on others. And deep holes
// whose strokes no modal cycle makes: their moves in their place.
#include <string>

#include <gtest/gtest.h>

#include "tests/unit/dialects/compile/harness.h"

namespace dripfeed::compile::test {
namespace {

ConvertResult made_of(const std::string& text, const std::string& from, const std::string& to, ir::MachineKind kind) {
  ConvertRequest request;
  request.source = text::Source("program", text);
  request.from = control(from, kind);
  request.to = control(to, kind);
  return convert(request);
}

std::string tapped(const std::string& words, const std::string& second = "Z-15.") {
  return "O1\nG21 G18 G99 G97 G40\nS500 M03\nG00 X0. Z5.\nG84 Z-27. " + words + " F2.\n" + second +
         "\nG80\nG00 Z20.\nM30\n";
}

TEST(DrillLevels, ADistanceBecomesALevel) {
  for (const std::string from : {"fanuc", "mitsubishi-m80"}) {
    for (const auto& [words, level] :
         {std::pair("R-2.", "R3."), std::pair("R0", "R5."), std::pair("R1.", "R6."), std::pair("R-2. K0", "R3.")}) {
      const ConvertResult made = made_of(tapped(words), from, "haas", ir::MachineKind::lathe);
      EXPECT_NE(made.text.find(level), std::string::npos) << from << words << made.text;
      EXPECT_EQ(made.not_verified, "");
    }
  }
}

TEST(DrillLevels, ALevelBecomesADistance) {
  const ConvertResult made = made_of(tapped("R3."), "haas", "fanuc", ir::MachineKind::lathe);
  EXPECT_NE(made.text.find("R-2."), std::string::npos) << made.text;
}

TEST(DrillLevels, WhatIsNotKnownIsRefusedByItsWord) {
  const std::string unknown = "O1\nG21 G18 G99 G97 G40\nS500 M03\nG00 Z#1\nG84 Z-27. R-2. F2.\nG80\nM30\n";
  for (const std::string& text : {tapped("R#101"), tapped("R-2000"), tapped("R-2.", "Z-15. R-3."), unknown}) {
    const ConvertResult made = made_of(text, "fanuc", "haas", ir::MachineKind::lathe);
    EXPECT_EQ(made.text, "");
    const std::string messages = messages_of(made.diagnostics, text::Source("program", text));
    EXPECT_NE(messages.find("R of a drilling cycle, a distance from the initial level"), std::string::npos) << messages;
  }
}

TEST(DrillLevels, ControlsThatAgreeKeepIt) {
  EXPECT_NE(made_of(tapped("R-2."), "fanuc", "mitsubishi-m80", ir::MachineKind::lathe).text.find("R-2."),
            std::string::npos);
}

// --- deep holes

std::string drilled(const std::string& values, const std::string& unit = "G710") {
  return "G17 " + unit + " G90 G94 G40 G54\nT1 D1 M6\nS500 M3\nF100\nG0 X0 Y0 Z30\nCYCLE83(" + values +
         ")\nG0 Z50\nX10\nM30\n";
}

TEST(OwnPecks, TheyAreWrittenAsTheirMoves) {
  for (const std::string values : {
           "30,2,1,-20,,,5,0,,,1,1,,,,,1",     // from the surface, and not from the level above it
           "30,2,0,-20,,,5,0,,,1,1",           // back in to a distance that the cycle computes
           "30,2,0,-20,,,5,0,,,1,1,,,,,2",     // or states
           "30,2,0,-20,,,5,0,,,1,0,,,2",       // a retract of its own
           "30,2,0,-20,,,5,1,,,1,1,,,,,1",     // that grow less
           "30,2,0,-20,,,5,0,0.5,,1,1,,,,,1",  // a dwell at each
           "30,2,0,-20,,,5,0,,0.3,1,1,,,,,1",  // before each
           "30,2,0,-20,,,5,0,,,0.5,1,,,,,1",   // a slow first one
           "30,2,0,-20,,,5,-0.8,,,1,1,,2,,,1",
       }) {
    const std::string text = drilled(values);
    const auto here = real_moves(run_text(text, control("sinumerik-840d", ir::MachineKind::mill)).motions);
    for (const std::string to : {"fanuc", "mazak", "mitsubishi-m80", "haas"}) {
      const ConvertResult made = translated(text, "sinumerik-840d", to);
      const std::string messages = messages_of(made.diagnostics, text::Source("program", text));
      ASSERT_FALSE(text::has_error(made.diagnostics)) << values << messages;
      EXPECT_EQ(made.not_verified, "");
      EXPECT_EQ(made.text.find("G83"), std::string::npos) << made.text;
      EXPECT_NE(messages.find("it is written as its moves"), std::string::npos) << messages;
      expect_same(here, real_moves(run_text(made.text, control(to, ir::MachineKind::mill)).motions), 1.1e-3, made.text);
    }
  }
}

TEST(OwnPecks, ThoseOfAModalCallStandAtEachPosition) {
  for (const std::string holes : {"X10 Y5\nX20\n", "HOLES1(5,5,30,4,8,3)\n", "M8\nG91 X5\nG90\nHOLES2(0,0,20,0,0,4)\n",
                                  "X10\nCYCLE802(111111111,111111111,8,8,-6,4)\nF80\nY7\n"}) {
    const std::string text =
        "G17 G710 G90 G94 G40 G54\nT1 D1 M6\nS500 M3\nF100\nG0 X0 Y0 Z30\n"
        "MCALL CYCLE83(30,2,1,-20,,,5,1,,,1,1)\n" +
        holes + "MCALL\nG0 Z50\nX10\nG1 Y3\nM30\n";
    const auto here = real_moves(run_text(text, control("sinumerik-840d", ir::MachineKind::mill)).motions);
    for (const std::string to : {"fanuc", "haas"}) {
      const ConvertResult made = translated(text, "sinumerik-840d", to);
      const std::string messages = messages_of(made.diagnostics, text::Source("program", text));
      ASSERT_FALSE(text::has_error(made.diagnostics)) << holes << messages;
      EXPECT_EQ(made.not_verified, "");
      expect_same(here, real_moves(run_text(made.text, control(to, ir::MachineKind::mill)).motions), 1.1e-3, made.text);
    }
  }
}

TEST(OwnPecks, ThoseOfTheOtherControlStayACycle) {
  for (const auto& [values, code] :
       {std::pair("30,2,0,-20,,,5,0,,,1,1,,,,,1", "G83"), std::pair("30,2,0,-20,,,5,0,,,1,0", "G73"),
        std::pair("30,2,0,-20,,,5,0,,,1,0,,,1", "G73"), std::pair("30,2,1,-20,,,30,0,,,1,1", "G83"),
        std::pair("30,2,0,-20,,,5,-1,,,1,1,,,,,1", "G83")}) {
    const ConvertResult made = translated(drilled(values), "sinumerik-840d", "fanuc");
    EXPECT_NE(made.text.find(code), std::string::npos)
        << values << messages_of(made.diagnostics, text::Source("program", drilled(values)));
  }
  const ConvertResult inch =
      translated(drilled("1,0,0,-1,,,0.25,0,,,1,1,,,,,0.0394", "G700"), "sinumerik-840d", "fanuc");
  EXPECT_NE(inch.text.find("G83"), std::string::npos) << inch.text;
}

// Where no run decides, the cycle that comes nearest is written, as it was.
TEST(OwnPecks, WithoutARunTheNearestCycleIsWritten) {
  const std::string text = "IF $A_IN[1]==1 GOTOF ON\nON:\n" + drilled("30,2,0,-20,,,5,0,,,1,1");
  const ConvertResult made = translated(text, "sinumerik-840d", "fanuc");
  const std::string messages = messages_of(made.diagnostics, text::Source("program", text));
  EXPECT_EQ(messages.find("together with"), std::string::npos) << messages;
}

}  // namespace
}  // namespace dripfeed::compile::test
