// Binding: defaults, overrides, what lets and loops do with them; and the geometry that comes of it.
#include "dialects/family/bind.h"

#include <cmath>
#include <fstream>
#include <memory>
#include <sstream>
#include <string>

#include <gtest/gtest.h>

#include "dialects/family/geometry.h"
#include "dialects/family/read.h"

namespace dripfeed::family {
namespace {

std::shared_ptr<const Family> shipped(const std::string& name) {
  std::ifstream file(std::string(DRIPFEED_SOURCE_DIR) + "/deploy/families/" + name + ".family");
  std::ostringstream text;
  text << file.rdbuf();
  ReadFamilyResult read = read_family(text::Source(name, text.str()));
  EXPECT_TRUE(read.diagnostics.empty());
  return std::make_shared<const Family>(std::move(read.family));
}

std::vector<std::string> faults(const BindResult& bound) {
  std::vector<std::string> out;
  out.reserve(bound.diagnostics.size());
  for (const text::Diagnostic& d : bound.diagnostics) out.emplace_back(text::row_of(d.id).name);
  return out;
}

double value(const BoundFamily& bound, std::string_view name) {
  const auto& arena = bound.family->arena;
  for (std::size_t i = 0; i < arena.symbols.size(); ++i) {
    if (arena.strings.at(arena.symbols[i].name) == name) return bound.values[i];
  }
  ADD_FAILURE() << "no " << name;
  return 0.0;
}

TEST(FamilyBind, OverridesAreConverted) {
  const std::vector<Override> given = {{"half_axis_x", "4 in"}, {"roll_length", "120 mm"}};
  const BindResult bound = bind_family(shipped("hyperbolic-roll"), given);
  ASSERT_TRUE(bound.diagnostics.empty());
  EXPECT_DOUBLE_EQ(value(bound.bound, "half_axis_x"), 101.6);
  EXPECT_DOUBLE_EQ(value(bound.bound, "half_axis_z"), 202.4);
  EXPECT_NEAR(value(bound.bound, "half_angle"), std::atan(60.0 / 202.4) * 180.0 / M_PI, 1e-12);
}

TEST(FamilyBind, EveryFaultIsReported) {
  const std::vector<Override> given = {
      {"half_axis_x", "100"}, {"roll_length", "5 deg"}, {"angle_step", "6 deg"}, {"nothing", "1"}, {"clearance", "x"}};
  EXPECT_EQ(faults(bind_family(shipped("hyperbolic-roll"), given)),
            (std::vector<std::string>{"family-missing-unit", "family-wrong-unit", "family-value-out-of-range",
                                      "family-unknown-parameter", "family-syntax"}));
}

TEST(FamilyBind, RangeEndsAreIn) {
  EXPECT_TRUE(
      bind_family(shipped("hyperbolic-roll"), std::vector<Override>{{"half_axis_x", "10 mm"}}).diagnostics.empty());
  EXPECT_TRUE(
      bind_family(shipped("hyperbolic-roll"), std::vector<Override>{{"half_axis_x", "400 mm"}}).diagnostics.empty());
  EXPECT_EQ(
      bind_family(shipped("hyperbolic-roll"), std::vector<Override>{{"half_axis_x", "9.999999 mm"}}).diagnostics.size(),
      1U);
  EXPECT_EQ(bind_family(shipped("hyperbolic-roll"), std::vector<Override>{{"half_axis_x", "400.000001 mm"}})
                .diagnostics.size(),
            1U);
}

TEST(FamilyBind, ConstraintsAreTriedWithTheirText) {
  const BindResult bound =
      bind_family(shipped("stepped-shaft"), std::vector<Override>{{"journal_diameter", "99.5 mm"}});
  ASSERT_EQ(faults(bound), (std::vector<std::string>{"family-constraint-failed"}));
  EXPECT_NE(text::message_of(bound.diagnostics[0]).find("there must be something to turn off"), std::string::npos);
}

TEST(FamilyGeometry, NominalIsTheHyperbolaAsRadius) {
  const BindResult bound = bind_family(shipped("hyperbolic-roll"), {});
  const Geometry found = geometry(bound.bound);
  ASSERT_EQ(found.nominal.pieces.size(), 1U);
  const curves::ProfilePiece& piece = found.nominal.pieces[0];
  EXPECT_DOUBLE_EQ(piece.tolerance, 0.02);
  EXPECT_DOUBLE_EQ(piece.curve.z.low, -98.0);
  EXPECT_DOUBLE_EQ(piece.curve.z.high, 98.0);
  for (const double z : {-98.0, -40.0, 0.0, 1.0, 98.0}) {
    const double root = std::sqrt(1.0 + z * z / (202.4 * 202.4));
    EXPECT_NEAR(piece.curve.at(z).x, 100.0 * root, 1e-12);
    EXPECT_NEAR(piece.curve.at(z).slope, 100.0 * z / (202.4 * 202.4) / root, 1e-14);
    const double second = 100.0 / (202.4 * 202.4) / (root * root * root);
    const curves::Range tight = piece.curve.second_derivatives(z, z);
    EXPECT_NEAR(tight.low, second, 1e-12);
    EXPECT_NEAR(tight.high, second, 1e-12);
  }
  // The enclosure holds the values at every place of the range.
  const curves::Range wide = piece.curve.second_derivatives(-98.0, 98.0);
  EXPECT_LE(wide.low, 100.0 / (202.4 * 202.4) / std::pow(1.0 + 98.0 * 98.0 / (202.4 * 202.4), 1.5));
  EXPECT_GE(wide.high, 100.0 / (202.4 * 202.4));
  ASSERT_EQ(found.tools.size(), 1U);
  EXPECT_DOUBLE_EQ(found.tools[0].nose_radius_mm, 0.8);
  EXPECT_EQ(found.tools[0].tip, 3);
}

TEST(FamilyGeometry, StocksHaveTheirShape) {
  const Geometry shaft = geometry(bind_family(shipped("stepped-shaft"), {}).bound);
  const auto& cylinder = std::get<CylinderStock>(*shaft.stock);
  EXPECT_DOUBLE_EQ(cylinder.diameter_mm, 100.0);
  EXPECT_DOUBLE_EQ(cylinder.z_mm.low, -120.0);
  const Geometry pocket = geometry(bind_family(shipped("round-pocket"), {}).bound);
  EXPECT_DOUBLE_EQ(std::get<BoxStock>(*pocket.stock).x_mm.low, -60.0);
  EXPECT_TRUE(pocket.nominal.empty());
}

// Each rule of the interval arithmetic against sampled second differences.
TEST(FamilyGeometry, SecondDerivativesAreEnclosed) {
  for (const std::string text :
       {"10 mm*sin(z/1 mm*1 deg)", "10 mm*cos(z/1 mm*2 deg) + z", "2 mm*tan(z/1 mm*1 deg)", "0.1 mm*atan(z/5 mm)/1 deg",
        "3 mm*exp(z/30 mm)", "3 mm*ln(z/1 mm)", "z*z/40 mm - z^3/(4000 mm*1 mm)", "900 mm*1 mm/z",
        "(z + 1 mm)/(z + 3 mm)*1 mm", "sqrt(z^2 + 9 mm*z) - 4 mm"}) {
    ReadFamilyResult read = read_family(text::Source("t", "family f\nmachine lathe, x is radius\nnominal x = " + text +
                                                              " for z in 10 mm .. 40 mm tolerance 0.1 mm\n"
                                                              "program p\nend\n"));
    ASSERT_TRUE(read.diagnostics.empty()) << text << text::message_of(read.diagnostics[0]);
    const auto family = std::make_shared<const Family>(std::move(read.family));
    const curves::ExplicitCurve curve = geometry(bind_family(family, {}).bound).nominal.pieces[0].curve;
    for (double low = 10.0; low < 40.0; low += 3.0) {
      const curves::Range range = curve.second_derivatives(low, low + 3.0);
      EXPECT_LT(range.width(), 1.0) << text;
      for (double z = low + 0.1; z < low + 2.9; z += 0.1) {
        constexpr double kStep = 1e-4;
        const double second = (curve.at(z + kStep).slope - curve.at(z - kStep).slope) / (2.0 * kStep);
        EXPECT_GE(second, range.low - 1e-7) << text << " at " << z;
        EXPECT_LE(second, range.high + 1e-7) << text << " at " << z;
      }
    }
  }
}

}  // namespace
}  // namespace dripfeed::family
