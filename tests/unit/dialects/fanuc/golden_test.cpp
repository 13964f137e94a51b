// The golden programs of Fanuc: every rule with its alarm.
#include "tests/support/golden.h"

#include <gtest/gtest.h>

#include "dialects/fanuc/fanuc.h"

namespace dripfeed::fanuc {
namespace {

test::Golden golden() {
  return {{".expected.diagnostics", control, Stages::infer_control, Stages::read, Stages::validate}, "fanuc"};
}

TEST(Golden, DiagnosticsAreAsExpected) {
  ASSERT_GT(golden().programs().size(), 90U);
  golden().expect_files();
}
TEST(Golden, TriggersTriggerAndNearMissesDoNot) { golden().expect_triggers(); }
TEST(Golden, EachNamesItsOracle) { golden().expect_oracles("hyperbola_as_printed.nc"); }

}  // namespace
}  // namespace dripfeed::fanuc
