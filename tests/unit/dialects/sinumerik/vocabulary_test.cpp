// The words of the control: each once, with what it may do.
#include "dialects/sinumerik/tables/vocabulary.h"

#include <set>
#include <string_view>

#include <gtest/gtest.h>

#include "tests/unit/dialects/sinumerik/reading.h"

namespace dripfeed::sinumerik {
namespace {

TEST(Vocabulary, EachWordStandsOnce) {
  std::set<std::string_view> seen;
  for (const Keyword& word : keywords()) EXPECT_TRUE(seen.insert(word.name).second) << word.name;
}

TEST(Vocabulary, DistinguishesWordsFromNames) {
  for (const std::string_view word :
       {"FNORM", "flin", "FCUB", "BRISKA", "SOFTA", "FPR", "FPRAON", "OSCILL", "OSP1", "STRINGIS", "MEAFRAME",
        "GROUP_BEGIN", "CYCLE81", "TRAORI", "GFRAME100", "SIN", "CHANDATA", "REDEF", "CPLNUM"})
    EXPECT_TRUE(is_word_of_control(word)) << word;
  for (const std::string_view name : {"PREC", "RFP", "WIDTH", "_X", "GFRAME101", "E_COMMON", "G1"})
    EXPECT_FALSE(is_word_of_control(name)) << name;
}

TEST(Vocabulary, OnlyWhatIsQuietLeavesAVerdictAsItIs) {
  const auto native = [](std::string_view line) {
    const ir::Program p = good(line);
    EXPECT_EQ(p.statements[0].kind, ir::StatementKind::native) << line;
    return p.natives[p.statements[0].payload];
  };
  for (const std::string_view line : {"GROUP_BEGIN(0,\"A\",0,0)", "BRISKA(X)", "REDEF $MC_X PHU 1", "TMON(1)"}) {
    EXPECT_TRUE(native(line).effects_known) << line;
    EXPECT_FALSE(native(line).moves) << line;
  }
  for (const std::string_view line : {"FPRAON(X)", "NEWCONF", "READ(R1,\"A\",1,80,R2)"}) {
    EXPECT_FALSE(native(line).effects_known) << line;
    EXPECT_FALSE(native(line).moves) << line;
  }
  for (const std::string_view line : {"CYCLE93(1)", "TRAORI(1)", "PRESETON(X,10)", "TRAILON(X,Y,1)", "TOFFON(Z)",
                                      "X[R1]=5", "OSCILL[Z]=(X,Y)", "S[2]=100 G0 X10"}) {
    EXPECT_FALSE(native(line).effects_known) << line;
    EXPECT_TRUE(native(line).moves) << line;
  }
}

}  // namespace
}  // namespace dripfeed::sinumerik
