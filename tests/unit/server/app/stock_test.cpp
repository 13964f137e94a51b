// The stock of a program along its path, and blanks that a person states.
#include "server/app/checks/stock.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "server/app/checks/tool_path.h"
#include "tests/unit/server/app/whole_shop.h"

namespace dripfeed::app {
namespace {

constexpr const char* kSlotText =
    "%\nO1\nG21 G17 G90 G94 G54\nT1 M6\nS1000 M3\nG0 X10. Y10. Z5.\nG1 Z-2. F100.\nX30. F500.\nG0 Z5.\nM30\n%\n";

constexpr const char* kPlate = R"(family plate "Plate"
machine mill
param depth length 3 mm in 1..10
nominal z = -depth for x in 5 mm .. 35 mm  y in 5 mm .. 15 mm  tolerance 0.1 mm
stock box x 0 mm .. 40 mm  y 0 mm .. 20 mm  z -10 mm .. 0 mm
program slot
  work offset 1
  tool 1  diameter 10 mm
  spindle 1000 rpm cw
  feed 500 mm/min
  rapid x 10 mm  y 10 mm
  rapid z 5 mm
  cut z -depth
  cut x 30 mm
  rapid z 5 mm
end
)";

DiagnoseOrder plate_order(const std::string& text) {
  DiagnoseOrder order{.dialect = "fanuc", .text = text};
  order.nominal = NominalCase{.family = "plate", .revision = 1, .text = kPlate, .values = {}};
  return order;
}

TEST(Stock, IsCutAlongThePath) {
  const auto stock = test::must(follow_stock(plate_order(kSlotText), test::PlainDocuments(), {}));
  EXPECT_FALSE(stock.turns);
  EXPECT_TRUE(stock.ran);
  ASSERT_EQ(stock.start.size(), stock.columns * stock.rows);
  ASSERT_EQ(stock.nominal.size(), stock.start.size());
  ASSERT_FALSE(stock.places.empty());
  EXPECT_TRUE(std::ranges::is_sorted(stock.moments));
  // Points: begin, plunge, cut, retract. The plunge cuts on the segment to point 1, the slot on that to point 2.
  EXPECT_GT(stock.moments.front(), 0.0F);
  EXPECT_LE(stock.moments.back(), 2.0F);
  std::vector<float> heights = stock.start;
  for (std::size_t i = 0; i < stock.places.size(); ++i) heights[stock.places[i]] = stock.heights[i];
  const auto at = [&](double x, double y) {
    const auto column = static_cast<std::size_t>((x - stock.low_mm) / stock.step_mm);
    const auto row = static_cast<std::size_t>((y - stock.y_low_mm) / stock.step_mm);
    return row * stock.columns + column;
  };
  EXPECT_FLOAT_EQ(heights[at(20, 10)], -2.0F);
  EXPECT_FLOAT_EQ(heights[at(38, 18)], 0.0F);
  EXPECT_FLOAT_EQ(stock.nominal[at(20, 10)], -3.0F);
  EXPECT_TRUE(std::isnan(stock.nominal[at(38, 18)]));
}

TEST(Stock, AStatedBlankCountsAndWithoutOneThereIsNone) {
  DiagnoseOrder order{.dialect = "fanuc", .text = kSlotText};
  EXPECT_NE(test::refusal(follow_stock(order, test::PlainDocuments(), {})).text.find("no stock"), std::string::npos);
  order.stock = "box 0 40 0 20 -10 0";
  const auto stock = test::must(follow_stock(order, test::PlainDocuments(), {}));
  EXPECT_TRUE(stock.places.empty()) << "the tool is in no profile";
  const bool reported = std::ranges::any_of(stock.notes, [](const checks::NotChecked& one) {
    return one.text.find("diameter of tool 1") != std::string::npos;
  });
  EXPECT_TRUE(reported) << "and that is stated";
  EXPECT_TRUE(stock.nominal.empty());
  order.stock = "box 0 40";
  EXPECT_NE(test::refusal(follow_stock(order, test::PlainDocuments(), {})).text.find("stock must be"),
            std::string::npos);
}

TEST(Stock, BlanksAreReadOrRefused) {
  const auto box = read_stock("box 0 40 -10.5 20 -10 0");
  ASSERT_TRUE(box && std::holds_alternative<family::BoxStock>(*box));
  EXPECT_EQ(std::get<family::BoxStock>(*box).y_mm.low, -10.5);
  const auto bar = read_stock("cylinder 80 -100 2");
  ASSERT_TRUE(bar && std::holds_alternative<family::CylinderStock>(*bar));
  EXPECT_EQ(std::get<family::CylinderStock>(*bar).diameter_mm, 80.0);
  for (const char* text :
       {"", "box", "box 0 0 0 1 0 1", "box 1 0 0 1 0 1", "box 0 1 0 1 0 1 2", "cylinder 0 0 1", "cylinder -1 0 1",
        "cylinder 1 0", "ball 1 2 3", "box 0 1 0 1 0 x", "box 0 1 0 1 0 1e300", "cylinder  80 0 1"})
    EXPECT_FALSE(read_stock(text)) << text;
}

TEST(Stock, DeviationsOfBlocksGoWithTheirPoints) {
  const auto path = test::must(follow_path(plate_order(kSlotText), test::PlainDocuments(), {}));
  EXPECT_FALSE(path.times);
  EXPECT_NE(path.why_no_times.find("machine"), std::string::npos);
  ASSERT_EQ(path.tools.size(), 2U);
  ASSERT_TRUE(path.tools[1].shape);
  EXPECT_EQ(path.tools[1].shape->diameter_mm, 10.0);
  ASSERT_FALSE(path.tool_changes.empty());
  EXPECT_EQ(path.tool_changes.back().tool, 1U);
  EXPECT_FALSE(path.deviations) << "the family has no curve";
}

}  // namespace
}  // namespace dripfeed::app
