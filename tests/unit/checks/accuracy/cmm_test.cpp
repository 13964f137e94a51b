// The published table of paper measurements, faults with their place, and a fit that is known.
#include "checks/accuracy/cmm.h"

#include <cmath>
#include <numbers>
#include <string>

#include <gtest/gtest.h>

#include "dialects/curves/nurbs.h"

namespace dripfeed::accuracy {
namespace {

// Y theoretical, CAM and macro of the 13 rows that the paper prints (NURBS by macro against CAM, table 1).
constexpr double kRows[13][3] = {{50.000, 50.036, 50.037},    {44.342, 44.422, 44.412},    {40.888, 40.949, 40.970},
                                 {39.289, 39.354, 39.395},    {55.638, 55.796, 55.706},    {87.125, 87.369, 87.301},
                                 {119.045, 119.178, 119.102}, {126.823, 126.850, 126.739}, {114.152, 114.314, 114.185},
                                 {71.739, 71.957, 71.848},    {52.474, 52.545, 52.532},    {59.605, 59.720, 59.706},
                                 {150.000, 150.186, 150.095}};

CmmFigures of_column(int column) {
  std::string csv = "nominal,measured_mm\n";
  for (const auto& row : kRows) csv += std::to_string(row[0]) + "," + std::to_string(row[column]) + "\n";
  const auto table = read_cmm(csv, CmmKind::milling, false);
  EXPECT_TRUE(table);
  return measure_cmm(*table, {}, true).measured;
}

TEST(Cmm, TheTableOfThePaper) {
  const CmmFigures cam = of_column(1);
  EXPECT_EQ(cam.points, 13U);
  EXPECT_NEAR(cam.mean_mm, 0.120, 5e-4);
  EXPECT_NEAR(cam.rmse_mm, 0.137, 5e-4);
  EXPECT_NEAR(cam.max_mm, 0.244, 1e-9);
  EXPECT_EQ(cam.max_row, 7U);
  const CmmFigures macro = of_column(2);
  EXPECT_NEAR(macro.mean_mm, 0.070, 5e-4);
  EXPECT_NEAR(macro.rmse_mm, 0.090, 5e-4);
  EXPECT_NEAR(macro.min_mm, -0.084, 2e-3);
}

TEST(Cmm, FaultsNameRowAndColumn) {
  const auto fault = [](std::string_view csv) {
    const auto table = read_cmm(csv, CmmKind::milling, false);
    return table ? std::string() : table.error();
  };
  EXPECT_EQ(fault("x,y\n1,2\n\n3,abc\n"), "row 4, column 2: 'abc' is not a number");
  EXPECT_EQ(fault("n;X;Y_mm\n1;2\n"), "row 2, column 3: nothing is there");
  EXPECT_EQ(fault("x,y\n1,nan\n"), "row 2, column 2: 'nan' is not a number");
  EXPECT_EQ(fault("x,y\n1,1e400\n"), "row 2, column 2: '1e400' is not a number");
  EXPECT_NE(fault("a,b\n1,2\n").find("row 1: the header"), std::string::npos);
  EXPECT_NE(fault("").find("no rows"), std::string::npos);
  EXPECT_NE(fault("x,y\n").find("no rows"), std::string::npos);
  EXPECT_EQ(fault("x\ty\r\n1\t2\r\n"), "");
}

TEST(Cmm, PointsOfALatheAreDiameters) {
  const auto table = read_cmm("z,x\n1,100\n2,100.2\n", CmmKind::turning, true);
  ASSERT_TRUE(table);
  const curves::Profile bar{{{{{0, 10}, [](double) { return curves::ExplicitPoint{50, 0}; }, {}}, 0.01}}};
  const CmmReport report = measure_cmm(*table, nearest_on(bar), false);
  EXPECT_NEAR(report.measured.max_mm, 0.1, 1e-12);
  EXPECT_NEAR(report.measured.mean_mm, 0.05, 1e-12);
  EXPECT_FALSE(report.fitted);
}

TEST(Cmm, ABestFitTakesShiftAndTurnAway) {
  const curves::ParametricCurve curve = curves::curve_of(
      {4, {{25, 50}, {42.7, 24.4}, {70.7, 72.2}, {86.5, 165.4}, {112.5, 38.3}, {132.4, 35.2}, {175, 150}}, {}, {}});
  CmmTable table{true, {}};
  const double angle = 0.15 * std::numbers::pi / 180;
  for (std::uint32_t i = 0; i <= 60; ++i) {
    const curves::ParametricPoint on = curve.at(0.2 + 3.6 * i / 60);
    const double form = 0.004 * (i % 2 == 0 ? 1 : -1);  // what no fit can take away
    const curves::Point at = on.point + form * curves::unit({-on.derivative.x, on.derivative.z});
    table.rows.push_back({i + 2,
                          {0.3 + std::cos(angle) * at.z - std::sin(angle) * at.x,
                           -0.2 + std::sin(angle) * at.z + std::cos(angle) * at.x},
                          0});
  }
  const CmmReport report = measure_cmm(table, nearest_on(std::vector{curve}), true);
  EXPECT_GT(report.measured.rmse_mm, 0.05);
  ASSERT_TRUE(report.fitted);
  EXPECT_LT(report.fitted->rmse_mm, 0.0041);
  EXPECT_GT(report.fitted->rmse_mm, 0.0035);
  EXPECT_NEAR(report.fit.angle_deg, -0.15, 0.002);
}

TEST(Cmm, AFitToALineStaysWhereItIs) {
  const curves::ParametricCurve line = curves::curve_of({2, {{0, 0}, {100, 0}}, {}, {}});
  const CmmTable table{true, {{2, {10, 0.1}, 0}, {3, {50, 0.1}, 0}, {4, {90, 0.1}, 0}}};
  const CmmReport report = measure_cmm(table, nearest_on(std::vector{line}), true);
  EXPECT_NEAR(report.fitted->rmse_mm, 0, 1e-6);
  EXPECT_NEAR(report.fit.shift.z, 0, 1e-6);
  const CmmTable one{true, {{2, {10, 0.1}, 0}}};
  EXPECT_NEAR(measure_cmm(one, nearest_on(std::vector{line}), true).fitted->rmse_mm, 0, 1e-6);
}

}  // namespace
}  // namespace dripfeed::accuracy
