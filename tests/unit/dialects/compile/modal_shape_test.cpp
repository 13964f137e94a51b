// A modal call in effect while G70 finishes a shape: which blocks run must not depend on the program that is called.
#include <algorithm>

#include <gtest/gtest.h>

#include "tests/unit/dialects/compile/harness.h"

namespace dripfeed::compile::test {
namespace {

TEST(ModalShape, IsNotCalledAndReported) {
  std::string text =
      "%\nO0001\nG21 G18 G99 G97 G40\nS500 M03\nG00 X60. Z5.\nG66 P1001\nN10 G00 X10.\nG01 Z-5. F0.2\nN20 X30.\n"
      "G70 P10 Q20 F0.2\nG67\nM30\nO1001\n";
  for (int i = 0; i < 20; ++i) text += "G04 X1.\n";  // as many blocks as the shape's last one has before it
  text += "M99\n%\n";
  const ir::Control machine = control("fanuc", ir::MachineKind::lathe);
  const text::Source source("program", text);
  const ir::ReadResult read = find_dialect("fanuc")->read(source, machine);
  ASSERT_FALSE(text::has_error(read.diagnostics));
  Motions motions;
  const interpreter::RunResult result = execute(read.program, machine, nullptr, motions, {});
  EXPECT_EQ(result.ended, interpreter::Ended::end);
  const auto reported = [](const auto& name) { return name.name == "a modal call after moves of a shape"; };
  EXPECT_TRUE(std::ranges::any_of(result.not_interpreted, reported));
}

}  // namespace
}  // namespace dripfeed::compile::test
