// The shipped roll for a lathe whose control is slow, fast, or not known.
#include "server/app/checks/timed_rendering.h"

#include <fstream>
#include <sstream>

#include <gtest/gtest.h>

#include "dialects/compile/dialect/dialect.h"

namespace dripfeed::app {
namespace {

using compile::RenderMode;
using compile::RenderResult;

compile::RenderRequest roll(ir::Delivery delivery = ir::Delivery::memory, RenderMode mode = RenderMode::automatic) {
  std::ifstream file(DRIPFEED_SOURCE_DIR "/deploy/families/hyperbolic-roll.family");
  std::ostringstream text;
  text << file.rdbuf();
  return {.family = text::Source("hyperbolic-roll.family", text.str()),
          .values = {},
          .target = compile::find_dialect("fanuc")->control(ir::MachineKind::lathe, ir::GSystem::a),
          .mode = mode,
          .delivery = delivery,
          .program_name = {},
          .heading = {}};
}

// A block, and each thing that it computes, costs so much.
machine::Profile lathe(double cost_ms) {
  machine::Profile profile;
  profile.name = "lathe";
  profile.control.dialect = "fanuc";
  profile.machine.kind = ir::MachineKind::lathe;
  for (const ir::Axis axis : {ir::Axis::x, ir::Axis::z})
    profile.machine.axes.push_back({.axis = axis, .rapid_mm_min = 10'000, .acceleration_mm_s2 = 2000});
  profile.machine.timing.look_ahead_blocks = 5;
  ir::CostModel cost;
  cost.source = ir::CostSource::paper;
  for (const ir::CostTerm& term : ir::kCostTerms) cost.*term.ms = cost_ms;
  profile.machine.timing.cost = cost;
  return profile;
}

bool reports(const RenderResult& result, const char* what) { return result.because.find(what) != std::string::npos; }

TEST(TimedRendering, AControlThatComputesSlowlyGetsBlocks) {
  const machine::Profile slow = lathe(100.0);
  const RenderResult result = render_for(roll(), &slow);
  EXPECT_EQ(result.mode, RenderMode::explicit_blocks) << result.because;
  EXPECT_EQ(result.variables, 0U);
  EXPECT_TRUE(reports(result, "macro: ") && reports(result, "blocks: ") && reports(result, " stalls;"))
      << result.because;
  EXPECT_TRUE(reports(result, "cost model paper")) << result.because;
}

TEST(TimedRendering, OneThatComputesFastKeepsTheMacro) {
  const machine::Profile fast = lathe(1e-4);
  const RenderResult result = render_for(roll(), &fast);
  EXPECT_EQ(result.mode, RenderMode::macro) << result.because;
  EXPECT_TRUE(reports(result, "macro: ") && reports(result, "blocks: ") && reports(result, "no stall"))
      << result.because;
}

TEST(TimedRendering, WithoutAMachineTheControlAloneDecides) {
  const RenderResult result = render_for(roll(), nullptr);
  EXPECT_EQ(result.mode, RenderMode::macro);
  EXPECT_TRUE(reports(result, "not known without a machine")) << result.because;
  EXPECT_EQ(result.text, compile::render(roll()).text);
}

TEST(TimedRendering, WhatIsAskedForAndDripFeedingStayAsTheyAre) {
  const machine::Profile slow = lathe(100.0);
  EXPECT_EQ(render_for(roll(ir::Delivery::memory, RenderMode::macro), &slow).mode, RenderMode::macro);
  const machine::Profile fast = lathe(1e-4);
  EXPECT_EQ(render_for(roll(ir::Delivery::memory, RenderMode::explicit_blocks), &fast).mode,
            RenderMode::explicit_blocks);
  const RenderResult drip = render_for(roll(ir::Delivery::drip), &fast);
  EXPECT_EQ(drip.mode, RenderMode::explicit_blocks);
  EXPECT_TRUE(reports(drip, "jumps")) << drip.because;
}

// The shop's own program stays in the memory as the shop wrote it.
TEST(TimedRendering, ANativeProgramIsKept) {
  const machine::Profile slow = lathe(100.0);
  compile::RenderRequest request = roll();
  const std::string program =
      "G21G18G98G40\n#100=50.\n#1=0\nWHILE[#1LT300]DO1\nG1X[#100-#1*.1]F600\n#1=#1+1\nEND1\nM30\n";
  request.family = text::Source(
      "kept.family",
      "family kept\nmachine lathe, x is diameter\nparam d length 50 mm in 1..90 is #100\nnative fanuc\n" + program);
  const RenderResult result = render_for(request, &slow);
  EXPECT_EQ(result.mode, RenderMode::macro) << result.because;
  EXPECT_EQ(result.because, "the program is kept unchanged");
  EXPECT_EQ(result.text, program);
  request.delivery = ir::Delivery::drip;
  EXPECT_EQ(render_for(request, &slow).mode, RenderMode::explicit_blocks);
}

// What the control cannot hold is no choice, and a family with a fault is none at all.
TEST(TimedRendering, AMacroThatDoesNotGoIsNotTimed) {
  const machine::Profile slow = lathe(100.0);
  compile::RenderRequest request = roll();
  request.target.variables.clear();
  const RenderResult result = render_for(request, &slow);
  EXPECT_EQ(result.mode, RenderMode::explicit_blocks);
  EXPECT_TRUE(reports(result, "it cannot be a macro")) << result.because;
  request.values = {{.name = "nothing", .value = "1"}};
  EXPECT_TRUE(text::has_error(render_for(request, &slow).diagnostics));
}

}  // namespace
}  // namespace dripfeed::app
