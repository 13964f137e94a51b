// The table of cycles: the places of values are those of the cycles' own heads.
#include "dialects/sinumerik/tables/called_cycles.h"

#include <gtest/gtest.h>

#include "dialects/sinumerik/sinumerik.h"

namespace dripfeed::sinumerik {
namespace {

using ir::CycleValue;
using ir::DrillCycle;

std::size_t place(std::string_view cycle, CycleValue value) { return ir::place_of(*find_called_cycle(cycle), value); }

TEST(CalledCycles, ValuesStandWhereTheManualHasThem) {
  EXPECT_EQ(place("CYCLE81", CycleValue::return_level), 0U);
  EXPECT_EQ(place("CYCLE82", CycleValue::dwell), 5U);
  EXPECT_EQ(place("CYCLE83", CycleValue::less_each_peck), 7U);
  EXPECT_EQ(place("CYCLE83", CycleValue::last_dwell), 15U);
  EXPECT_EQ(place("CYCLE84", CycleValue::lead), 8U);
  EXPECT_EQ(place("CYCLE84", CycleValue::speed_back), 11U);
  EXPECT_EQ(place("CYCLE840", CycleValue::encoder), 8U);
  EXPECT_EQ(place("CYCLE840", CycleValue::axis), 11U);
  EXPECT_EQ(place("CYCLE86", CycleValue::lift), 9U);
  EXPECT_EQ(place("CYCLE87", CycleValue::spindle), 5U);
  EXPECT_EQ(place("CYCLE87", CycleValue::dwell), ir::kNoPlace);
  EXPECT_EQ(place("HOLES1", CycleValue::pattern_start), 3U);
  EXPECT_EQ(place("HOLES2", CycleValue::pattern_radius), 2U);
  EXPECT_EQ(place("CYCLE95", CycleValue::contour), 0U);
}

TEST(CalledCycles, EachHasALevelToGoBackToAndADepth) {
  for (const ir::CalledCycle& cycle : called_cycles()) {
    if (cycle.sort != ir::CalledSort::hole) continue;
    EXPECT_EQ(ir::place_of(cycle, CycleValue::return_level), 0U) << cycle.name;
    EXPECT_EQ(ir::place_of(cycle, CycleValue::depth), 3U) << cycle.name;
    EXPECT_FALSE(standard_cycle(cycle.name).empty()) << cycle.name;
  }
}

TEST(CalledCycles, AreFoundByWhatTheyMake) {
  EXPECT_EQ(cycle_for(DrillCycle::chip_break), find_called_cycle("CYCLE83"));
  EXPECT_EQ(cycle_for(DrillCycle::tap_left), find_called_cycle("CYCLE84"));
  EXPECT_EQ(cycle_for(DrillCycle::back_bore), nullptr);
}

TEST(CalledCycles, AProgramOfSomebodysOwnIsNone) {
  EXPECT_EQ(find_called_cycle("CYCLE999"), nullptr);
  EXPECT_EQ(find_called_cycle("CYCLE_CLEAN"), nullptr);
  EXPECT_EQ(find_called_cycle("HOLES_FLANGE"), nullptr);
}

}  // namespace
}  // namespace dripfeed::sinumerik
