// Numbers of a list that the program sets: read only after that.
#include <string>

#include <gtest/gtest.h>

#include "tests/unit/dialects/compile/family_run.h"

namespace dripfeed::compile::test {
namespace {

std::string faults_of(const std::string& steps, RenderMode mode) {
  const text::Source family = with("list kept of length 4\n", steps);
  const RenderResult result = rendered(family, "fanuc", mode, {});
  EXPECT_EQ(result.text.empty(), text::has_error(result.diagnostics));
  return said(result.diagnostics, family);
}

TEST(FamilyLists, ANumberThatIsReadBeforeItIsSetIsAnError) {
  for (const RenderMode mode : {RenderMode::macro, RenderMode::explicit_blocks}) {
    for (const char* steps :
         {"  cut x kept[2]\n", "  set kept[1] = 3 mm\n  cut x 1 mm\n  cut x kept[2]\n",
          "  for n from 0 to 2 step 1\n    set kept[n] = n*1 mm\n  end\n  for q from 0 to 3 step 1\n"
          "    cut x kept[q]\n  end\n",
          "  for one in kept\n    cut x one\n  end\n"}) {
      const std::string found = faults_of(steps, mode);
      EXPECT_TRUE(found.contains("a list that the program has not set")) << steps << found;
      EXPECT_FALSE(found.contains(":1:1:")) << found;
    }
    EXPECT_EQ(faults_of("  for n from 0 to 3 step 1\n    set kept[n] = n*1 mm\n  end\n  for q from 0 to 3 step 1\n"
                        "    cut x kept[q]\n  end\n",
                        mode),
              "");
    EXPECT_EQ(faults_of("  set kept[3] = 3 mm\n  cut x kept[3]\n", mode), "");
    // What is not come to is not read.
    EXPECT_EQ(faults_of("  let n = 1\n  cut x 1 mm\n  if n > 2\n    cut x kept[3]\n  end\n", mode), "");
  }
}

}  // namespace
}  // namespace dripfeed::compile::test
