// The drawing of a family: its lines with these values, each dimension as long as its parameter, and what is wrong with
// a declaration. Of the shipped families every dimension is measured.
#include "dialects/family/drawing.h"

#include <cmath>
#include <filesystem>
#include <fstream>
#include <memory>
#include <numbers>
#include <set>
#include <sstream>
#include <string>

#include <gtest/gtest.h>

#include "dialects/family/evaluate.h"
#include "dialects/family/read.h"

namespace dripfeed::family {
namespace {

std::string mill(const std::string& declarations) {
  return "family trial\nmachine mill\nparam size length 10 mm in 1..50\nparam turn angle 30 deg in 1..90\n"
         "param n count 3 in 1..9\nparam kind choice a of a, b\nlist xs = 1 mm, 2 mm\n" +
         declarations + "\nprogram p\ntool 1\nrapid x 0 mm\nend\n";
}

std::string lathe(const std::string& declarations) {
  return "family trial\nmachine lathe, x is diameter\nparam size length 10 mm in 1..50\n" + declarations +
         "\nprogram p\ntool 1\nrapid x 0 mm\nend\n";
}

std::string faults_of_reading(const std::string& text) {
  std::string out;
  for (const text::Diagnostic& one : read_family(text::Source("trial", text)).diagnostics) out += text::message_of(one);
  return out;
}

BoundFamily bound_of(const std::string& text, const std::vector<Override>& values = {}) {
  ReadFamilyResult read = read_family(text::Source("trial", text));
  for (const text::Diagnostic& one : read.diagnostics) ADD_FAILURE() << text::message_of(one);
  BindResult bound = bind_family(std::make_shared<const Family>(std::move(read.family)), values);
  for (const text::Diagnostic& one : bound.diagnostics) ADD_FAILURE() << text::message_of(one);
  return std::move(bound.bound);
}

TEST(FamilyDrawing, DimensionsFollowTheValues) {
  const std::string text = mill("dimension size length from x 0 mm y 2 mm to x size y 2 mm");
  const auto views = drawing(bound_of(text, {{"size", "25 mm"}}));
  ASSERT_EQ(views.size(), 1U);
  EXPECT_EQ(views[0].axes, "xy");
  ASSERT_EQ(views[0].dimensions.size(), 1U);
  const DrawnDimension& one = views[0].dimensions[0];
  EXPECT_EQ(one.parameter, "size");
  EXPECT_EQ(one.value, "25 mm");
  EXPECT_EQ(one.to.across_mm, 25.0);
  EXPECT_EQ(one.to.up_mm, 2.0);
}

TEST(FamilyDrawing, ALathesXIsHalvedAndTheAxesMayStandInEitherOrder) {
  const auto views =
      drawing(bound_of(lathe("stock cylinder diameter 20 mm z -5 mm .. 0 mm\n"
                             "nominal x = size for z in -5 mm .. 0 mm tolerance 0.1 mm\n"
                             "dimension size diameter from x -size z 0 mm to z 0 mm x size")));
  ASSERT_EQ(views.size(), 1U);
  EXPECT_EQ(views[0].axes, "zx");
  EXPECT_EQ(views[0].dimensions[0].from.up_mm, -5.0);
  EXPECT_EQ(views[0].dimensions[0].to.up_mm, 5.0);
  ASSERT_EQ(views[0].lines.size(), 3U);  // stock, and the nominal on both sides of the axis
  EXPECT_EQ(views[0].lines[0].of, DrawnOf::stock);
  EXPECT_EQ(views[0].lines[0].points[0].up_mm, -10.0);
  EXPECT_EQ(views[0].lines[1].points.front().up_mm, 5.0);
  EXPECT_EQ(views[0].lines[2].points.front().up_mm, -5.0);
}

TEST(FamilyDrawing, OneFigureForEachNumberOfACounter) {
  const auto views =
      drawing(bound_of(mill("outline for hole in 0 .. n - 1 circle at x hole*size y 0 mm diameter size/2\n"
                            "outline for item in 0 .. count(xs) - 1 from x xs[item] y 0 mm to x xs[item] y size\n"
                            "outline from x 0 mm y 0 mm to x size y 0 mm to x size y size closed")));
  ASSERT_EQ(views.size(), 1U);
  ASSERT_EQ(views[0].circles.size(), 3U);
  EXPECT_EQ(views[0].circles[2].center.across_mm, 20.0);
  EXPECT_EQ(views[0].circles[2].diameter_mm, 5.0);
  ASSERT_EQ(views[0].lines.size(), 3U);
  EXPECT_EQ(views[0].lines[1].points[0].across_mm, 2.0);
  EXPECT_EQ(views[0].lines[2].points.size(), 4U);
}

TEST(FamilyDrawing, WhatCannotBeComputedIsLeftOut) {
  const auto views =
      drawing(bound_of(mill("outline from x size/(turn - turn)*turn y 0 mm to x size y 0 mm\n"
                            "outline for item in 0 .. 5 from x xs[item] y 0 mm to x xs[item] y size\n"
                            "dimension size length from x sqrt(-size*size) y 0 mm to x size y 0 mm")));
  ASSERT_EQ(views.size(), 1U);
  EXPECT_EQ(views[0].lines.size(), 2U);
  EXPECT_TRUE(views[0].dimensions.empty());
}

TEST(FamilyDrawing, ASectionHasTheWallsOfAPocket) {
  const auto views =
      drawing(bound_of(mill("stock box x -20 mm .. 20 mm  y -20 mm .. 20 mm  z -10 mm .. 0 mm\n"
                            "nominal z = 0 mm for x in -20 mm .. 20 mm y in -20 mm .. 20 mm tolerance 0.1 mm\n"
                            "nominal z = -4 mm for x in -size .. size y in -size .. size tolerance 0.1 mm\n"
                            "dimension size length from x 0 mm z -4 mm to x size z -4 mm")));
  ASSERT_EQ(views.size(), 1U);
  ASSERT_EQ(views[0].lines.size(), 2U);
  for (const DrawnPoint& at : views[0].lines[1].points) {
    const double wanted = std::abs(at.across_mm) < 10.0 ? -4.0 : 0.0;
    const bool at_wall = std::abs(std::abs(at.across_mm) - 10.0) < 1e-9;
    EXPECT_TRUE(at_wall || at.up_mm == wanted) << at.across_mm;
  }
}

TEST(FamilyDrawing, WrongDeclarationsAreErrors) {
  const auto has = [](const std::string& text, const std::string& words) {
    EXPECT_NE(faults_of_reading(text).find(words), std::string::npos) << text << faults_of_reading(text);
  };
  has(mill("dimension width length from x 0 mm y 0 mm to x size y 0 mm"), "the name of a parameter that is a number");
  has(mill("dimension kind length from x 0 mm y 0 mm to x size y 0 mm"), "the name of a parameter that is a number");
  has(mill("dimension turn length from x 0 mm y 0 mm to x size y 0 mm"), "and this is the dimension of a length");
  has(mill("dimension size angle at x 0 mm y 0 mm from x 0 mm y 0 mm to x size y 0 mm"), "the dimension of an angle");
  has(mill("dimension size length from x 0 mm x 0 mm to x size y 0 mm"), "two different axes");
  has(mill("dimension size length from x 0 mm y 0 mm to x size z 0 mm"), "the points before have x and y");
  has(mill("dimension size length from x 0 y 0 mm to x size y 0 mm"), "0");
  has(lathe("outline from x 0 mm y 0 mm to x size y 0 mm"), "has z and x");
  has(mill("outline from x 0 mm y 0 mm"), "'to'");
  has(mill("outline for size in 0 .. 2 circle at x 0 mm y 0 mm diameter size"), "size");
  EXPECT_EQ(
      faults_of_reading(mill("outline for item in 0 .. 2 circle at x 0 mm y 0 mm diameter size\nlet item = size")), "");
}

std::string file_text(const std::filesystem::path& path) {
  std::ostringstream out;
  out << std::ifstream(path, std::ios::binary).rdbuf();
  return out.str();
}

double measured(const DrawnDimension& one) {
  const auto direction = [&](DrawnPoint to) {
    return std::atan2(to.up_mm - one.at.up_mm, to.across_mm - one.at.across_mm);
  };
  if (one.kind != DimensionKind::angle)
    return std::hypot(one.to.across_mm - one.from.across_mm, one.to.up_mm - one.from.up_mm);
  return std::abs(direction(one.to) - direction(one.from)) * 180.0 / std::numbers::pi;
}

// As it stands, and with every number a little larger.
void measure(const std::string& text, const std::vector<Override>& values) {
  const BoundFamily bound = bound_of(text, values);
  std::size_t count = 0;
  std::set<std::string> seen;
  for (const DrawnView& view : drawing(bound)) {
    EXPECT_FALSE(view.lines.empty() && view.circles.empty()) << view.axes;
    for (const DrawnDimension& one : view.dimensions) {
      const Parameter* parameter = bound.family->find_parameter(one.parameter);
      const double value = bound.values[static_cast<std::size_t>(parameter->symbol)];
      EXPECT_NEAR(measured(one), std::abs(value), 1e-6 * std::max(1.0, std::abs(value))) << one.parameter;
      EXPECT_TRUE(seen.insert(one.parameter).second) << one.parameter << " is drawn twice";
      ++count;
    }
  }
  EXPECT_EQ(count, bound.family->dimensions.size());
}

TEST(FamilyDrawing, ShippedFamiliesHaveDimensionsThatAreAsLongAsTheirParameters) {
  std::size_t families = 0;
  for (const auto& entry : std::filesystem::directory_iterator(DRIPFEED_SOURCE_DIR "/deploy/families")) {
    SCOPED_TRACE(entry.path().string());
    const std::string text = file_text(entry.path());
    const Family family = read_family(text::Source(entry.path().string(), text)).family;
    EXPECT_FALSE(family.dimensions.empty());
    measure(text, {});
    const Parameter& first = family.parameters[family.dimensions.front().parameter];
    if (first.kind != ParameterKind::number || first.unit == nullptr) continue;
    if (family.name != "bolt-circle") measure(text, {{first.name, format_value(first, 1.05 * first.standard)}});
    ++families;
  }
  EXPECT_EQ(families, 17U);
}

}  // namespace
}  // namespace dripfeed::family
