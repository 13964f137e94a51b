// The golden programs of Fanuc as this control sees them, with its own alarms, and those of rules that it has
// otherwise.
#include "tests/support/golden.h"

#include <gtest/gtest.h>

#include "dialects/mitsubishi/mitsubishi.h"

namespace dripfeed::mitsubishi {
namespace {

// Rules that differ: loops to 27 deep by numbers to 127, IF blocks, and what else has a program of its own.
// … and G83 without Q drills in one.
const std::vector<std::string> kOtherwise = {"peck-without-depth",         "rigid-tap-invalid", "loop-number-invalid",
                                             "nesting-too-deep",           "missing-end",       "unknown-code",
                                             "expression-without-brackets"};

test::GoldenDialect dialect() {
  return {".expected.mitsubishi", control, Stages::infer_control, Stages::read, Stages::validate};
}

TEST(Golden, ProgramsOfAllHashControls) {
  const test::Golden golden(dialect(), "fanuc");
  golden.expect_files();
  golden.expect_triggers(kOtherwise);
}
TEST(Golden, ProgramsOfItsOwn) {
  const test::Golden golden(dialect(), "mitsubishi");
  ASSERT_GE(golden.programs().size(), 2 * kOtherwise.size());
  golden.expect_files();
  golden.expect_triggers();
  golden.expect_oracles();
}

}  // namespace
}  // namespace dripfeed::mitsubishi
