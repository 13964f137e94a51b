// Axes that the source's machine has and the target may not have.
#include <gtest/gtest.h>

#include "tests/unit/dialects/compile/harness.h"

namespace dripfeed::compile::test {
namespace {

constexpr const char* kTurned = "%\nO1\nG21 G18 G99\nG00 X20. Z5. C0.\nH-30.5\nM30\n%\n";

ConvertResult converted(const ir::Control& to, ConvertMode mode) {
  ConvertRequest request;
  request.source = text::Source("axes.nc", kTurned);
  request.from = find_dialect("fanuc")->infer_control(request.source);
  request.to = to;
  request.mode = mode;
  EXPECT_EQ(request.from.axes, "XZC");
  return convert(request);
}

// H without its point would be read as the number of an offset.
TEST(TargetAxes, AControlWithoutDescriptionGetsThemAll) {
  const ir::Control mazak = control("mazak", ir::MachineKind::lathe);
  const ConvertResult macro = converted(mazak, ConvertMode::macro);
  EXPECT_FALSE(text::has_error(macro.diagnostics));
  EXPECT_NE(macro.text.find("H-30.5\n"), std::string::npos) << macro.text;
  const ConvertResult plain = converted(mazak, ConvertMode::explicit_blocks);
  EXPECT_NE(plain.text.find("C-30.5\n"), std::string::npos) << plain.text;
  const ConvertResult sinumerik = converted(control("sinumerik-840d", ir::MachineKind::lathe), ConvertMode::macro);
  EXPECT_NE(sinumerik.text.find("C=IC(-30.5)"), std::string::npos) << sinumerik.text;
}

TEST(TargetAxes, AMachineWithoutOneIsRefused) {
  ir::Control machine = control("mazak", ir::MachineKind::lathe);
  machine.axes = "XZ";
  machine.from_profile = true;
  for (const ConvertMode mode : {ConvertMode::macro, ConvertMode::explicit_blocks}) {
    const ConvertResult made = converted(machine, mode);
    EXPECT_EQ(made.text, "");
    ASSERT_TRUE(text::has_error(made.diagnostics));
    EXPECT_TRUE(text::message_of(made.diagnostics.front()).starts_with("the axis C has no counterpart"));
  }
  machine.axes = "XZC";
  EXPECT_FALSE(text::has_error(converted(machine, ConvertMode::macro).diagnostics));
}

}  // namespace
}  // namespace dripfeed::compile::test
