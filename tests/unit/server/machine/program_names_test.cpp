// Which names are one program, and which are two.
#include "server/machine/program_names.h"

#include <algorithm>

#include <gtest/gtest.h>

namespace dripfeed::machine {
namespace {

TEST(ProgramNames, AControlsNameAndAPersonsAreOne) {
  for (const std::string_view name : {"ROLL_1", "roll_1", "ROLL_1.MPF", "ROLL_1_MPF", "_N_ROLL_1_MPF", "_n_roll_1_mpf"})
    EXPECT_EQ(plain_program_name(name), "ROLL_1") << name;
  for (const std::string_view name :
       {"O0042", "O42", "42", "0042", ":0042", "O00000042", "O0042.NC", "42.EIA", "o42.nc"})
    EXPECT_EQ(plain_program_name(name), "42") << name;
  EXPECT_EQ(plain_program_name("SHAFT.EIA"), "SHAFT");
  EXPECT_EQ(plain_program_name("O0"), "0");
}

TEST(ProgramNames, OtherProgramsKeepTheirNames) {
  EXPECT_EQ(plain_program_name("_N_ROLL_1_SPF"), "ROLL_1_SPF");  // a subprogram may have the name of a main program
  EXPECT_EQ(plain_program_name("ROLL_1.SPF"), "ROLL_1_SPF");
  EXPECT_FALSE(is_same_program_name("ROLL_1", "ROLL_1_SPF"));
  EXPECT_FALSE(is_same_program_name("ROLL_1", "ROLL_2"));
  EXPECT_FALSE(is_same_program_name("O0042", "O0420"));
  EXPECT_FALSE(is_same_program_name("O42A", "42"));
  for (const std::string_view name : {"", "O", ".NC", "_N_", "_MPF", "N_A", "OP10"}) {
    EXPECT_FALSE(is_same_program_name(name, "ROLL_1")) << name;
  }
  EXPECT_EQ(plain_program_name("OP10"), "OP10");
  EXPECT_EQ(plain_program_name("_MPF"), "_MPF");
}

TEST(ProgramNames, FormsAreOfOneProgramTheNameItselfFirst) {
  for (const std::string_view name :
       {"ROLL_1", "_N_ROLL_1_MPF", "roll_1.mpf", "O0042", "42", "O1234.NC", "ROLL_1_SPF", ""}) {
    const auto forms = forms_of_program_name(name);
    EXPECT_EQ(forms.front(), name);
    for (const std::string& form : forms) EXPECT_TRUE(is_same_program_name(form, name)) << form << " of " << name;
    EXPECT_LE(forms.size(), 40U);
  }
  const auto has = [](std::string_view name, std::string_view form) {
    return [&] {
      const auto all = forms_of_program_name(name);
      return std::ranges::find(all, form) != all.end();
    }();
  };
  EXPECT_TRUE(has("ROLL_1_MPF", "ROLL_1"));
  EXPECT_TRUE(has("ROLL_1", "_N_ROLL_1_MPF"));
  EXPECT_TRUE(has("O1234", "O1234.NC"));
  EXPECT_TRUE(has("O1234.NC", "O1234"));
  EXPECT_TRUE(has("42", "O0042"));
}

}  // namespace
}  // namespace dripfeed::machine
