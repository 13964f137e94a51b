// Nominal surfaces and curves of mills: read, bound, and what they come to; and what is wrong with them.
#include <cmath>
#include <memory>
#include <string>

#include <gtest/gtest.h>

#include "dialects/family/bind.h"
#include "dialects/family/formula.h"
#include "dialects/family/geometry.h"
#include "dialects/family/read.h"

namespace dripfeed::family {
namespace {

std::string whole(const std::string& declarations, const std::string& tool = "tool 1  diameter size  corner size/4") {
  return "family trial\nmachine mill\nparam size length 10 mm in 0..50\n" + declarations + "\nprogram p\n" + tool +
         "\nrapid x 0 mm\nend\n";
}

// The sentences of reading and binding.
std::string faults(const std::string& text) {
  ReadFamilyResult read = read_family(text::Source("trial", text));
  std::string out;
  for (const text::Diagnostic& one : read.diagnostics) out += text::message_of(one) + ";";
  if (!out.empty()) return out;
  const BindResult bound = bind_family(std::make_shared<const Family>(std::move(read.family)), {});
  for (const text::Diagnostic& one : bound.diagnostics) out += text::message_of(one) + ";";
  return out;
}

Geometry geometry_of(const std::string& text) {
  ReadFamilyResult read = read_family(text::Source("trial", text));
  EXPECT_EQ(faults(text), "");
  return geometry(bind_family(std::make_shared<const Family>(std::move(read.family)), {}).bound);
}

TEST(FamilyNominal, SurfacesAreHeights) {
  const Geometry g = geometry_of(
      whole("nominal z = 0 mm for x in -size .. size  y in -size .. size  tolerance 0.1 mm\n"
            "nominal z = -(x*x + y*y)/size for x in -5 mm .. 5 mm  y in -sqrt((5 mm)^2 - x^2) .. sqrt((5 mm)^2 - x^2)  "
            "tolerance 0.05 mm"));
  ASSERT_EQ(g.surfaces.size(), 2U);
  EXPECT_NEAR(curves::surface_at(g.surfaces, 3, 2)->z, -1.3, 1e-12);
  EXPECT_EQ(curves::surface_at(g.surfaces, 4.5, 4.5)->z, 0);
  EXPECT_FALSE(curves::surface_at(g.surfaces, 10.5, 0));
  ASSERT_EQ(g.tools.size(), 1U);
  EXPECT_EQ(g.tools[0].diameter_mm, 10);
  EXPECT_EQ(g.tools[0].corner_radius_mm, 2.5);
}

TEST(FamilyNominal, CurvesByFormulaHaveTheirDerivatives) {
  const Geometry g = geometry_of(
      whole("nominal curve for t in 0 deg .. 90 deg  x size*cos(t)  y 2*size*sin(t)  tolerance 0.02 mm  center"));
  ASSERT_EQ(g.curves.size(), 1U);
  EXPECT_TRUE(g.curves[0].of_center);
  const curves::ParametricCurve& curve = g.curves[0].curve;
  const double h = 1e-4;
  for (double t = 5; t < 90; t += 10) {
    const auto before = curve.at(t - h), here = curve.at(t), after = curve.at(t + h);
    EXPECT_LT(curves::distance(here.derivative, 0.5 / h * (after.point - before.point)), 1e-7);
    EXPECT_LT(curves::distance(here.second, 0.5 / h * (after.derivative - before.derivative)), 1e-7);
    const curves::Box box = curve.second_derivatives(t - 1, t + 1);
    EXPECT_TRUE(box.z.contains(here.second.z));
    EXPECT_TRUE(box.x.contains(here.second.x));
  }
}

TEST(FamilyNominal, CurvesByPoints) {
  const Geometry g = geometry_of(
      whole("nominal nurbs order 3 tolerance 0.1 mm\n  point x 0 mm y 0 mm\n  point x size y 0 mm weight 2\n"
            "  # the corner\n  point x size y size\n  point x 0 mm y 2*size\n  knots 0 0 0 1 2 2 2\nend\n"
            "nominal bezier tolerance 0.1 mm\n  point x 0 mm y 0 mm\n  point x 1 mm y 2 mm\nend"));
  ASSERT_EQ(g.curves.size(), 2U);
  EXPECT_EQ(g.curves[0].curve.t.high, 2);
  EXPECT_NEAR(g.curves[0].curve.at(2).point.x, 20, 1e-12);
  EXPECT_EQ(g.curves[0].curve.breaks, std::vector<double>{1});
  EXPECT_NEAR(g.curves[1].curve.at(0.5).point.x, 1, 1e-12);
}

// A plane that two rows of two points span, and a later surface that is carved into it.
const std::string kPlane =
    "list px = 0 mm, 0 mm, 2*size, 2*size\nlist py = 0 mm, size, 0 mm, size\nlist pz = -1 mm, -1 mm, -3 mm, -3 mm\n"
    "list pw of ratio 4\n";

TEST(FamilyNominal, SurfacesByPoints) {
  const Geometry g =
      geometry_of(whole(kPlane + "nominal surface order 2 tolerance 0.1 mm\n  points px py pz\n  row 2\nend\n"
                                 "nominal z = -7 mm for x in 0 mm .. size/2 y in 0 mm .. size tolerance 0.2 mm"));
  ASSERT_EQ(g.surfaces.size(), 2U);
  const auto plane = curves::surface_at(g.surfaces, 15, 5);
  ASSERT_TRUE(plane);
  EXPECT_NEAR(plane->z, -2.5, 1e-9);
  EXPECT_EQ(plane->tolerance, 0.1);
  EXPECT_EQ(curves::surface_at(g.surfaces, 2, 5)->z, -7);
}

TEST(FamilyNominal, FaultsOfSurfacesAreReported) {
  const auto expect_reported = [](const std::string& lines, std::string_view part) {
    const std::string messages = faults(whole(kPlane + "nominal surface order 2 tolerance 0.1 mm\n" + lines + "end"));
    EXPECT_NE(messages.find(part), std::string::npos) << messages;
  };
  expect_reported("  points px py pz\n  row 3\n", "whole rows");
  expect_reported("  points px py pz weights pw\n  row 2\n", "above 0");
  expect_reported("  points px py\n  row 2\n", "the name of a list");
  expect_reported("  points px py pz\n", "a line 'row'");
  expect_reported("  row 2\n", "a line 'points'");
  expect_reported("  point x 0 mm y 0 mm\n", "points, row, knots or end");
}

TEST(FamilyNominal, FaultsAreReported) {
  const auto expect_reported = [](const std::string& text, std::string_view part) {
    const std::string messages = faults(text);
    EXPECT_NE(messages.find(part), std::string::npos) << messages;
  };
  const std::string points = "  point x 0 mm y 0 mm\n  point x 1 mm y 2 mm\n";
  expect_reported(whole("nominal nurbs order 4 tolerance 0.1 mm\n" + points + "end"), "at least as many points");
  expect_reported(whole("nominal nurbs order 99 tolerance 0.1 mm\n" + points + "end"), "2 to 16");
  expect_reported(whole("nominal nurbs order 2 tolerance 0.1 mm\n" + points + "  knots 0 0 1\nend"), "as many knots");
  expect_reported(whole("nominal bezier tolerance 0.1 mm\n  point x 0 mm\nend"), "y");
  expect_reported(whole("nominal bezier tolerance 0.1 mm\n  point x 0 mm y 0 mm weight 0\n" + points + "end"),
                  "above 0");
  expect_reported(whole("nominal bezier tolerance 0.1 mm\n  point x 3 mm y 0 mm\n  point x 3 mm y 0 mm\nend"),
                  "the same");
  expect_reported(whole("nominal bezier tolerance 0.1 mm\n  point x 1 mm/0 y 0 mm\n" + points + "end"), "1 mm/0");
  expect_reported(whole("nominal curve for t in 1 .. 1  x t*size  y size  tolerance 0.1 mm"), "no range");
  expect_reported(whole("nominal x = size for z in 0 mm .. size tolerance 0.1 mm"), "nominals of a mill");
  expect_reported(whole("nominal z = q for x in 0 mm .. size y in 0 mm .. size tolerance 0.1 mm"), "q");
  expect_reported(whole("", "for d from 1 mm to 2 mm step 1 mm\n tool 1 diameter d\nend"), "parameters only");
  expect_reported(whole("", "tool 1 diameter -size"), "negative");
  expect_reported("family t\nmachine lathe, x is diameter\nnominal curve for t in 0 .. 1 x t y t\nprogram p\nend\n",
                  "lathe");
}

TEST(FamilyNominal, FormulasAreWhatEvaluateSays) {
  const std::string text = whole(
      "let leg = size/3\nrequire sin(30 deg + 2*asin(leg/size))*sqrt(leg*leg + size^2) > max(leg, 2 mm) - min(leg, "
      "size)");
  ASSERT_EQ(faults(text), "");
  const Family family = read_family(text::Source("trial", text)).family;
  std::vector<double> values(family.arena.symbols.size(), 0.0);
  const ir::SymbolId size = family.parameters[0].symbol, a = family.definitions[0].symbol;
  const ir::ExpressionId condition = family.requirements[0].condition;
  const Formula formula(family.arena, condition, values, size, a);
  for (const auto& [p, q] : {std::pair{10.0, 3.0}, {1.0, 7.0}, {2.0, -1.0}}) {
    values[static_cast<std::size_t>(size)] = p;
    values[static_cast<std::size_t>(a)] = q;
    const Dual wanted = evaluate(family.arena, condition, values, size);
    EXPECT_EQ(formula.at(p, q).value, wanted.value);
    EXPECT_EQ(formula.at(p, q).slope, wanted.slope);
  }
}

}  // namespace
}  // namespace dripfeed::family
