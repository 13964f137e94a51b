// Lists from tables: which cells are taken, and which place a fault reports.
#include "dialects/compile/render/list_table.h"

#include <string>

#include <gtest/gtest.h>

#include "tests/unit/dialects/compile/harness.h"

namespace dripfeed::compile::test {
namespace {

const text::Source kFamily("t.family",
                           "family t\nmachine mill\nparam xs list of length 1 mm in 0..100 count 1..5\n"
                           "param ws list of ratio 1 in 0..9 count 1..5\nprogram p\n  rapid x xs[0]*ws[0]\nend\n");

TableColumn column(const std::string& table, const std::string& name, const std::string& parameter) {
  return list_of_column({"t.csv", table}, name, kFamily, parameter);
}

TEST(ListTable, CellsTakeTheUnitOfTheirColumn) {
  EXPECT_EQ(column("x mm,w\n1,2\n2.5 , 3\n", "x", "xs").value, "1 mm, 2.5 mm");
  EXPECT_EQ(column("x mm,w\n1,2\n2.5 , 3\n", "w", "ws").value, "2, 3");
  EXPECT_EQ(column("xs [in]; ws\r\n1; 2\r\n3 mm; 4\r\n", "", "xs").value, "1 in, 3 mm");
  EXPECT_EQ(column("# from the CAD\n\n1 mm\n\n2 mm\n", "", "xs").value, "1 mm, 2 mm");
  EXPECT_EQ(column("\xEF\xBB\xBFx\ty mm\n0\t7", "y", "xs").value, "7 mm");
  EXPECT_EQ(column("depth mm\n7\n", "", "xs").value, "7 mm");
}

TEST(ListTable, FaultsStandAtTheirCell) {
  struct Row {
    const char* table;
    const char* name;
    const char* parameter;
    const char* place;
    const char* sentence;
  };
  const Row rows[] = {{"x mm,y mm\n1,2\n3,4 deg\n", "y", "xs", ":3:3:", "an angle"},
                      {"x mm,y mm\n1,2\n3,four\n", "y", "xs", ":3:3:", "'four' is not a number"},
                      {"x,y\n1,2\n", "y", "xs", ":2:3:", "needs a unit"},
                      {"x mm\n1\n101\n", "x", "xs", ":3:1:", "outside"},
                      {"x mm,y mm\n1\n", "y", "xs", ":2:1:", "no number in column 2"},
                      {"x mm,y mm\n1,\n", "y", "xs", ":2:3:", "no number in column 2"},
                      {"x mm,y mm\n1,2\n", "z", "xs", ":1:1:", "no column is called z: there are x, y"},
                      {"x mm,y mm\n1,2\n", "", "xs", ":1:1:", "no column is called xs"},
                      {"x foot\n1\n", "x", "xs", ":1:1:", "'foot' is no unit"},
                      {"1 mm,2 mm\n", "x", "xs", ":1:1:", "names no columns"},
                      {"x mm\n", "x", "xs", ":1:1:", "no numbers"},
                      {"", "x", "xs", ":1:1:", "empty"},
                      {"w\n-1\n", "w", "ws", ":2:1:", "outside"},
                      {"x mm; y mm\n1,5; 2\n", "x", "xs", ":2:1:", "'1,5' is not a number"}};
  for (const Row& row : rows) {
    const text::Source table("t.csv", row.table);
    const TableColumn found = list_of_column(table, row.name, kFamily, row.parameter);
    const std::string all = messages_of(found.diagnostics, table);
    EXPECT_TRUE(all.contains(std::string("t.csv") + row.place)) << row.table << all;
    EXPECT_TRUE(all.contains(row.sentence)) << row.table << all;
    EXPECT_TRUE(text::has_error(found.diagnostics));
  }
}

// Who binds the family says that there is no such list.
TEST(ListTable, OtherParametersAreLeftToTheFamily) {
  EXPECT_TRUE(column("x mm\n1\n", "x", "none").diagnostics.empty());
  EXPECT_TRUE(column("x mm\n1\n", "x", "none").value.empty());
}

}  // namespace
}  // namespace dripfeed::compile::test
