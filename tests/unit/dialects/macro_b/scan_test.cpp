// The scanner of plain blocks leaves to the reader what the reader makes a call or data of.
#include "dialects/macro_b/reader/scan.h"

#include <gtest/gtest.h>

#include "dialects/macro_b/tables/codes.h"
#include "reading.h"

namespace dripfeed::macro_b {
namespace {

ir::Control whole_control() {
  static const std::vector<ir::CodeRow> kG = join_codes({shared_g_codes(), mill_g_codes()});
  ir::Control control = test_control();
  control.g_codes = kG;
  control.m_codes = m_codes();
  return control;
}

std::size_t plain_bytes(std::string text, const ir::Control& control) {
  const std::size_t size = text.size();
  text += '\n';
  ir::PlainBatch batch;
  return make_scanner(control, test_grammar())->scan(std::string_view(text).substr(0, size), batch).taken;
}

TEST(Scan, TakesMovesAndLeavesCallsAndData) {
  const ir::Control control = whole_control();
  EXPECT_EQ(plain_bytes("G01X1.F100.\n", control), 12U);
  EXPECT_EQ(plain_bytes("M123\n", control), 5U);
  for (const char* block :
       {"G65P1\n", "G66P1\n", "G66.1P1\n", "G67\n", "M98P1\n", "M198P1\n", "G10L2P1X1.\n", "G11\n", "M96P1\n"}) {
    EXPECT_EQ(plain_bytes(block, control), 0U) << block;
  }
}

TEST(Scan, LeavesCodesThatTheMachineMakesCallsOf) {
  ir::Control control = whole_control();
  control.code_calls = {{'M', 60, 9001, false}, {'M', 1230, 9002, true}, {'G', 10, 9010, true}};
  for (const char* block : {"M06\n", "M123\n", "G01X1.F100.\n"}) EXPECT_EQ(plain_bytes(block, control), 0U) << block;
  EXPECT_EQ(plain_bytes("M08\n", control), 4U);
}

}  // namespace
}  // namespace dripfeed::macro_b
