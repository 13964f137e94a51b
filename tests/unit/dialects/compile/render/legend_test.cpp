// The legend of a macro: its numbers are those of the text, its meanings the family's.
#include "dialects/compile/render/legend.h"

#include <algorithm>
#include <string>

#include <gtest/gtest.h>

#include "dialects/compile/render/optimized_render.h"
#include "tests/unit/dialects/compile/render/family_run.h"

namespace dripfeed::compile::test {
namespace {

const LegendEntry* find(const std::vector<LegendEntry>& legend, std::string_view name) {
  const auto found = std::ranges::find(legend, name, &LegendEntry::name);
  return found == legend.end() ? nullptr : &*found;
}

// Where the text gives a single variable its value, that is the legend's.
TEST(Legend, IsOfTheText) {
  for (const std::string& dialect : dialect_names()) {
    const RenderResult made =
        rendered(shipped("hyperbolic-roll"), dialect, RenderMode::macro, {{"half_axis_x", "4 in"}});
    const LegendEntry* half_axis = find(made.legend, "half_axis_x");
    ASSERT_NE(half_axis, nullptr) << dialect;
    EXPECT_EQ(half_axis->kind, LegendKind::parameter);
    EXPECT_EQ(half_axis->meaning, "radius at the waist");
    EXPECT_EQ(half_axis->unit, "mm");
    EXPECT_DOUBLE_EQ(half_axis->value.value_or(0.0), 101.6);
    EXPECT_TRUE(made.text.contains("\n" + half_axis->variable + "=101.6")) << dialect << "\n" << made.text;
    const LegendEntry* rim = find(made.legend, "rim");
    ASSERT_NE(rim, nullptr) << dialect;
    EXPECT_EQ(rim->kind, LegendKind::derived);
    EXPECT_TRUE(made.text.contains("\n" + rim->variable + "=2")) << dialect << "\n" << made.text;
    const LegendEntry* t = find(made.legend, "t");
    ASSERT_NE(t, nullptr) << dialect;
    EXPECT_EQ(t->kind, LegendKind::computed);
    EXPECT_FALSE(t->value.has_value());
  }
}

TEST(Legend, AListIsItsFirstVariableAndACount) {
  const RenderResult made = rendered(shipped("nurbs-profile"), "mitsubishi-m80", RenderMode::macro, {});
  const LegendEntry* points = find(made.legend, "point_x");
  ASSERT_NE(points, nullptr);
  EXPECT_EQ(points->count, 7U);
  EXPECT_FALSE(points->value.has_value());
  EXPECT_TRUE(made.text.contains("\n" + points->variable + "=25")) << made.text;
}

TEST(Legend, PlainBlocksHaveNone) {
  EXPECT_TRUE(rendered(shipped("slot"), "fanuc", RenderMode::explicit_blocks, {}).legend.empty());
}

TEST(Legend, ANativeProgramHasItsBindings) {
  const text::Source family("slot.family",
                            "family slot \"Slot\"\nmachine mill\n"
                            "param depth length 4 mm in 0.5..20 \"below the face\" is #101\n"
                            "native fanuc\n%\nO1200\nG21 G90 G17 G94 G40\n#101=4.\nT1 M6\nG54 G0 X0 Y0\nS2000 M3\n"
                            "G43 H1 Z5.\nG1 Z[-#101] F100\nG0 Z50.\nM30\n%\n");
  const RenderResult made = rendered(family, "fanuc", RenderMode::macro, {{"depth", "5 mm"}});
  ASSERT_EQ(made.legend.size(), 1U) << messages_of(made.diagnostics, family);
  EXPECT_EQ(made.legend[0].variable, "#101");
  EXPECT_EQ(made.legend[0].name, "depth");
  EXPECT_EQ(made.legend[0].kind, LegendKind::parameter);
  EXPECT_FALSE(made.legend[0].value.has_value()) << "it stands in the text";
}

// A number that the optimizer freed may hold another value then.
TEST(Legend, AfterOptimizingItHasTheParameters) {
  for (const std::string& dialect : dialect_names()) {
    RenderResult made = rendered(shipped("round-pocket"), dialect, RenderMode::macro, {});
    const auto parameters = std::ranges::count(made.legend, LegendKind::parameter, &LegendEntry::kind);
    ASSERT_LT(parameters, std::ssize(made.legend)) << dialect;
    const OptimizeResult result = optimize_rendered(made, control(dialect, ir::MachineKind::mill), ir::CostModel{});
    ASSERT_FALSE(result.changes.empty()) << dialect;
    EXPECT_EQ(std::ssize(made.legend), parameters) << dialect;
    for (const LegendEntry& one : made.legend) {
      EXPECT_EQ(one.kind, LegendKind::parameter) << dialect << " " << one.name;
      EXPECT_TRUE(made.text.contains(one.variable + "=")) << dialect << " " << one.variable << "\n" << made.text;
    }
  }
}

}  // namespace
}  // namespace dripfeed::compile::test
