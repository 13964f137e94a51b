// CSV for a spreadsheet: quotes, formulas, ends of lines.
#include "server/json/csv.h"

#include <gtest/gtest.h>

namespace dripfeed::json {
namespace {

TEST(Csv, QuotesWhatNeedsItAndLeavesNoFormula) {
  Csv csv;
  csv.cell("plain").cell("a,b").cell("say \"no\"").cell("two\r\nlines").cell("a;b").end_row();
  csv.cell("=1+1").cell("-1").cell("@x").cell("").cell("+\"").end_row();
  EXPECT_EQ(csv.take(),
            "\xEF\xBB\xBFplain,\"a,b\",\"say \"\"no\"\"\",\"two\r\nlines\",\"a;b\"\r\n"
            "'=1+1,'-1,'@x,,\"'+\"\"\"\r\n");
}

TEST(Csv, NumbersAreWrittenInTheirShortestForm) {
  Csv csv;
  csv.cell(std::uint64_t{12}).cell(0.1).cell(-2.5).cell(std::optional<double>()).cell(std::optional(3.0)).end_row();
  EXPECT_EQ(csv.take(),
            "\xEF\xBB\xBF"
            "12,0.1,-2.5,,3\r\n");
}

}  // namespace
}  // namespace dripfeed::json
