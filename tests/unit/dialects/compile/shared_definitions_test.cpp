// Definition files are found by the names that the control gives them, macros before what may be sized by them, and a
// run takes what they mean.
#include "dialects/compile/dialect/shared_definitions.h"

#include <map>
#include <string>

#include <gtest/gtest.h>

#include "dialects/compile/dialect/dialect.h"

namespace dripfeed::compile {
namespace {

FindText files(std::map<std::string, std::string, std::less<>> texts) {
  return [texts = std::move(texts)](std::string_view name) -> std::optional<text::Source> {
    const auto found = texts.find(name);
    if (found == texts.end()) return std::nullopt;
    return text::Source(found->first + ".DEF", found->second);
  };
}

ir::Control control_of(std::string_view dialect) {
  return find_dialect(dialect)->control(ir::MachineKind::mill, ir::GSystem::a);
}

TEST(SharedDefinitions, MacrosComeBeforeTheDataThatTheySize) {
  const ir::Control c =
      with_definitions(control_of("sinumerik-840d"),
                       files({{"MGUD", "DEF NCK REAL LIST[SIZE]\nM30\n"}, {"UMAC", "DEFINE SIZE AS 12\nM30\n"}}));
  ASSERT_NE(c.shared, nullptr);
  EXPECT_EQ(c.shared->variables.at("LIST").dimensions[0], 12);
  EXPECT_TRUE(ir::is_shared(c.shared.get(), "SIZE"));
  EXPECT_FALSE(ir::is_shared(c.shared.get(), "OTHER"));
}

// A builder's file calls one for each option of the machine, where it exists.
TEST(SharedDefinitions, AFileThatAnotherOneCallsIsRead) {
  const ir::Control c = with_definitions(
      control_of("sinumerik-840d"),
      files({{"MGUD",
              "APR 7 APW 11\nIF ISFILE(\"/_N_DEF_DIR/_N_MGUD_PROBE_DEF\")\nCALL \"/_N_DEF_DIR/_N_MGUD_PROBE_DEF\"\n"
              "ENDIF\nIF ISFILE(\"/_N_DEF_DIR/_N_MGUD_OTHER_DEF\")\nCALL \"/_N_DEF_DIR/_N_MGUD_OTHER_DEF\"\nENDIF\n"
              "M30\n"},
             {"MGUD_PROBE", "DEF NCK REAL PROBE_RADIUS\nM30\n"}}));
  ASSERT_NE(c.shared, nullptr);
  EXPECT_TRUE(ir::is_shared(c.shared.get(), "PROBE_RADIUS"));
}

TEST(SharedDefinitions, WithoutFilesNothingIsKnown) {
  EXPECT_EQ(with_definitions(control_of("sinumerik-840d"), files({})).shared, nullptr);
  EXPECT_EQ(with_definitions(control_of("sinumerik-840d"), {}).shared, nullptr);
  EXPECT_EQ(with_definitions(control_of("fanuc"), files({{"MGUD", "DEF NCK REAL LIST\n"}})).shared, nullptr);
}

}  // namespace
}  // namespace dripfeed::compile
