// Steps of the translation that one program alone, or a text without faults, does not show.
#include <algorithm>
#include <string>

#include <gtest/gtest.h>

#include "tests/unit/dialects/compile/harness.h"

namespace dripfeed::compile::test {
namespace {

ConvertResult convert_on(const std::string& text, const std::string& from, const std::string& to,
                         ir::MachineKind kind) {
  ConvertRequest request;
  request.source = text::Source("program", text);
  request.from = control(from, kind);
  request.to = control(to, kind);
  return convert(request);
}

TEST(TranslateSteps, FaultsOfTheTextAreReportedByTheirOwnNames) {
  const ConvertResult made = translated("G17 G710 G90 G94 G54\nG0 X0 Y0 Z5\nR1 5\nM30\n", "sinumerik-840d", "fanuc");
  EXPECT_TRUE(std::ranges::any_of(
      made.diagnostics, [](const text::Diagnostic& d) { return d.id == text::DiagnosticId::missing_equals; }));
}

// G90 of a lathe is one cut there, and no distance mode.
TEST(TranslateSteps, EachProgramOfATextLosesItsTurningCycles) {
  const ConvertResult made = convert_on(
      "%\nO0001\nG21 G18 G99 G97 G40\nS500 M03\nG00 X60. Z5.\nG90 X50. Z-20. F0.2\nG00 X80.\nM30\nO0002\nG00 "
      "X1.\nM99\n%\n",
      "fanuc", "sinumerik-840d", ir::MachineKind::lathe);
  EXPECT_FALSE(text::has_error(made.diagnostics));
  EXPECT_NE(made.text.find("G0 X50. F0.2\nG1 Z-20.\nG1 X60.\nG0 Z5.\n"), std::string::npos) << made.text;
}

TEST(TranslateSteps, AFaceBeginsInItsPlaneAndFromAPositiveX) {
  const std::string head = "%\nO0001\nG21 G18 G99 G97 G40\nS500 M03\nG00 X";
  const std::string face = " Z5.\nC0.\nG98\nG12.1\nG01 X20. C9. F80.\nG13.1\nM30\n%\n";
  const ConvertResult made = convert_on(head + "50." + face, "fanuc", "sinumerik-840d", ir::MachineKind::mill_turn);
  EXPECT_FALSE(text::has_error(made.diagnostics));
  EXPECT_NE(made.text.find("TRANSMIT\nG17\nG1 X20. Y9. F80\n"), std::string::npos) << made.text;
  EXPECT_TRUE(text::has_error(
      convert_on(head + "-50." + face, "fanuc", "sinumerik-840d", ir::MachineKind::mill_turn).diagnostics));
}

}  // namespace
}  // namespace dripfeed::compile::test
