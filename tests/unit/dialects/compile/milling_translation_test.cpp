// Milling cycles on controls that have none: their moves in their place, in both modes. Oracle: the run of the source.
#include <string>

#include <gtest/gtest.h>

#include "tests/unit/dialects/compile/harness.h"

namespace dripfeed::compile::test {
namespace {

const std::string kMilledPart =
    "G17 G90 G71 G94 G40 G54\nT1 D1 M6\nS1000 M3\nG0 X0 Y0 Z50\n"
    "POCKET3(20,0,2,-5,30,20,8,50,40,30,2,0.2,0.1,300,100,0,21,0,0,0,0,3,1)\n"
    "POCKET3(20,0,2,-5,30,20,8,50,40,30,0,0.2,0.1,300,100,0,12)\n"
    "SLOT1(20,0,2,-4,,2,30,12,-50,0,20,45,90,100,320,3,2,0.2,0,0,200)\n"
    "SLOT2(20,0,2,-4,,2,70,12,-50,0,30,45,0,100,320,3,0,0.2,0,0,200)\n"
    "LONGHOLE(20,0,2,-4,,2,30,-50,80,20,45,90,100,320,3)\n"
    "CYCLE77(20,0,3,-6,,20,60,-70,3,0,0,900,800,1,1,30)\n"
    "G0 X0 Y0\nZ50\nG1 X10 F500\nM30\n";

ConvertResult milled_on(const std::string& to, ConvertMode mode, bool has_tool = true) {
  ConvertRequest request;
  request.source = text::Source("program", kMilledPart);
  request.from = control("sinumerik-840d", ir::MachineKind::mill);
  if (has_tool) request.from.tool_radii = {{.tool = 1, .offset = 1, .radius_mm = 5.0}};
  request.to = control(to, ir::MachineKind::mill);
  request.mode = mode;
  return convert(request);
}

TEST(MillingTranslation, TheMovesOfACycleStandInItsPlace) {
  ir::Control source = control("sinumerik-840d", ir::MachineKind::mill);
  source.tool_radii = {{.tool = 1, .offset = 1, .radius_mm = 5.0}};
  const auto here = real_moves(run_text(kMilledPart, source).motions);
  EXPECT_GT(here.size(), 150U);
  for (const std::string to : {"fanuc", "mazak", "mitsubishi-m80", "haas"}) {
    for (const ConvertMode mode : {ConvertMode::macro, ConvertMode::explicit_blocks}) {
      SCOPED_TRACE(to + " " + std::string(name_of(mode)));
      const ConvertResult made = milled_on(to, mode);
      const std::string messages = messages_of(made.diagnostics, text::Source("program", kMilledPart));
      ASSERT_FALSE(text::has_error(made.diagnostics)) << messages;
      EXPECT_EQ(made.not_verified, "");
      const auto there = real_moves(run_text(made.text, control(to, ir::MachineKind::mill)).motions);
      expect_same(here, there, 1.1e-3, made.text);
    }
  }
}

TEST(MillingTranslation, WithoutTheToolItIsRefused) {
  for (const ConvertMode mode : {ConvertMode::macro, ConvertMode::explicit_blocks}) {
    const ConvertResult made = milled_on("fanuc", mode, false);
    EXPECT_TRUE(text::has_error(made.diagnostics));
    EXPECT_EQ(made.text, "");
  }
}

}  // namespace
}  // namespace dripfeed::compile::test
