// Units, dimensions and quantities.
#include "dialects/family/unit.h"

#include <gtest/gtest.h>

namespace dripfeed::family {
namespace {

TEST(FamilyUnit, QuantitiesComeInStoredUnits) {
  EXPECT_DOUBLE_EQ(parse_quantity("120 mm")->stored(), 120.0);
  EXPECT_DOUBLE_EQ(parse_quantity("4.7244 in")->stored(), 119.99976);
  EXPECT_DOUBLE_EQ(parse_quantity("-0.5rad")->stored(), -28.647889756541161);
  EXPECT_DOUBLE_EQ(parse_quantity(" 250 ms ")->stored(), 0.25);
  EXPECT_DOUBLE_EQ(parse_quantity("100 ft/min")->stored(), 30.48);
  EXPECT_DOUBLE_EQ(parse_quantity("3")->stored(), 3.0);
  EXPECT_EQ(parse_quantity("3")->unit, nullptr);
}

TEST(FamilyUnit, WhatIsNoQuantityIsRefused) {
  for (const char* text :
       {"", "mm", "12 parsec", "1,5 mm", "1 2 mm", "--1 mm", "1e3 mm", "nan mm", "0x10 mm", "12 mm 3"}) {
    EXPECT_FALSE(parse_quantity(text).has_value()) << text;
  }
}

TEST(FamilyUnit, DimensionsAreReported) {
  EXPECT_EQ(describe(kLength), "a length");
  EXPECT_EQ(describe(kLength + kLength), "mm^2");
  EXPECT_EQ(describe(kAngle - kLength), "mm^-1*deg");
  EXPECT_EQ(describe(kLength - kTime), describe(kFeedPerMin));
  EXPECT_EQ(stored_unit(kFeedPerRev), "mm/rev");
  EXPECT_EQ(stored_unit(kLength + kLength), "");
}

}  // namespace
}  // namespace dripfeed::family
