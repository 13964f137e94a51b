// Modes that a person names for a subprogram without its caller.
#include "dialects/compile/translate/caller_modes.h"

#include <gtest/gtest.h>

#include "tests/unit/dialects/compile/harness.h"

namespace dripfeed::compile::test {
namespace {

ir::Control lathe_with(std::string_view modes) {
  ir::Control machine = control("fanuc", ir::MachineKind::lathe);
  if (modes.empty()) return machine;
  auto read = read_caller_modes(*find_dialect("fanuc"), machine, modes);
  EXPECT_TRUE(read.has_value()) << (read ? "" : read.error());
  if (read) machine.caller_modes = std::move(*read);
  return machine;
}

TEST(CallerModes, AreInEffectWhereARunStarts) {
  const std::string text = "%\nO0010\nX20. Z-5. F0.2\nM99\n%\n";
  const auto moves = moves_of(run_text(text, lathe_with("G01 G99 G97")).motions);
  ASSERT_EQ(moves.size(), 1U);
  EXPECT_EQ(moves[0].kind, ir::MotionKind::linear);
  EXPECT_EQ(moves[0].feed_mode, ir::FeedMode::per_rev);
  const auto others = moves_of(run_text(text, lathe_with("G01 G98")).motions);
  EXPECT_EQ(others[0].feed_mode, ir::FeedMode::per_min);
}

// G98 in a subprogram says nothing of surface speed, which belongs to the same group elsewhere.
TEST(CallerModes, MakeATranslationPossible) {
  ConvertRequest request;
  request.source = text::Source("program", "%\nO0010\nG98\nG01 X20. Z-5. F100.\nM99\n%\n");
  request.to = control("sinumerik-840d", ir::MachineKind::lathe);
  request.from = lathe_with("");
  const ConvertResult refused = convert(request);
  EXPECT_TRUE(text::has_error(refused.diagnostics));
  request.from = lathe_with("G97 G18 G99");
  const ConvertResult made = convert(request);
  EXPECT_FALSE(text::has_error(made.diagnostics)) << messages_of(made.diagnostics, request.source);
  EXPECT_NE(made.text.find("G94"), std::string::npos) << made.text;
}

TEST(CallerModes, WhatIsNoModeIsRefused) {
  const ir::Control machine = control("fanuc", ir::MachineKind::lathe);
  for (const std::string_view wrong : {"", "G97 X10.", "G28", "G777", "M30", "#1=2", "M98 P1"}) {
    const auto read = read_caller_modes(*find_dialect("fanuc"), machine, wrong);
    EXPECT_FALSE(read.has_value()) << wrong;
  }
}

}  // namespace
}  // namespace dripfeed::compile::test
