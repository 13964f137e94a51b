// One family in every dialect and both forms is one trace, and that trace is the closed form.
#include "dialects/compile/render/render.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "dialects/text/number.h"
#include "tests/unit/dialects/compile/harness.h"

namespace dripfeed::compile::test {
namespace {

using Values = std::vector<family::Override>;

RenderResult rendered(const std::string& family, const std::string& dialect, ir::MachineKind kind, RenderMode mode,
                      const Values& values = {}, ir::Delivery delivery = ir::Delivery::memory) {
  RenderRequest request;
  request.family = shipped(family);
  request.values = values;
  request.target = control(dialect, kind);
  request.mode = mode;
  request.delivery = delivery;
  request.program_name = dialect == "fanuc" ? "O0100" : "FAMILY_TEST";
  RenderResult out = render(request);
  EXPECT_FALSE(text::has_error(out.diagnostics)) << messages_of(out.diagnostics, request.family);
  return out;
}

struct Roll {
  double a = 100.0;
  double b = 202.4;
  double length = 196.0;
  double step = 0.2;
};

Values values_of(const Roll& roll) {
  const auto mm = [](double v) { return text::format_shortest(v) + " mm"; };
  return {{"half_axis_x", mm(roll.a)},
          {"half_axis_z", mm(roll.b)},
          {"roll_length", mm(roll.length)},
          {"angle_step", text::format_shortest(roll.step) + " deg"}};
}

// The points of the profile by the definition of the loop, computed here.
std::vector<std::pair<double, double>> closed_form(const Roll& roll) {
  const double degree = std::numbers::pi / 180.0;
  const double from = std::atan(roll.length / 2.0 / roll.b) / degree;
  std::vector<std::pair<double, double>> out;
  const auto last = static_cast<int>(std::ceil(2.0 * from / roll.step - 1e-6));
  for (int k = 0; k <= last; ++k) {
    const double t = (k == last ? -from : from - k * roll.step) * degree;
    out.emplace_back(2.0 * roll.a / std::cos(t), roll.b * std::tan(t));
  }
  return out;
}

void expect_closed_form(const RenderResult& result, const Played& run, const Roll& roll, double tolerance,
                        const std::string& what) {
  std::vector<ir::Motion> profile;
  for (const ir::Motion& m : run.motions) {
    const bool inside = std::ranges::any_of(result.profile_lines, [&](const family::LineRange& r) {
      return r.first <= m.place.line && m.place.line <= r.last;
    });
    if (ir::is_move(m.kind) && inside) profile.push_back(m);
  }
  const auto expected = closed_form(roll);
  ASSERT_EQ(profile.size(), expected.size()) << what;
  for (std::size_t i = 0; i < expected.size(); ++i) {
    ASSERT_EQ(static_cast<int>(profile[i].kind), static_cast<int>(ir::MotionKind::linear)) << what;
    ASSERT_NEAR(profile[i].end[0], expected[i].first, tolerance) << what << ", point " << i;
    ASSERT_NEAR(profile[i].end[2], expected[i].second, tolerance) << what << ", point " << i;
  }
}

// Macros carry their numbers in full; explicit words are rounded as they are printed.
constexpr double kMacroTolerance = 1e-6;
constexpr double kExplicitTolerance = 0.0006;

void expect_one_trace(const Roll& roll) {
  std::vector<ir::Motion> first;
  for (const std::string& dialect : dialect_names()) {
    for (const RenderMode mode : {RenderMode::macro, RenderMode::explicit_blocks}) {
      const std::string what = dialect + " " + std::string(name_of(mode));
      const RenderResult result = rendered("hyperbolic-roll", dialect, ir::MachineKind::lathe, mode, values_of(roll));
      ASSERT_EQ(result.mode, mode);
      const Played run = run_text(result.text, control(dialect, ir::MachineKind::lathe));
      EXPECT_EQ(run.result.ended, interpreter::Ended::end) << what;
      const double tolerance = mode == RenderMode::macro ? kMacroTolerance : kExplicitTolerance;
      expect_closed_form(result, run, roll, tolerance, what);
      if (first.empty()) first = run.motions;
      expect_same(first, run.motions, tolerance, what);
    }
  }
}

TEST(Render, RollIsOneTraceInEveryDialectAndMode) { expect_one_trace({}); }

TEST(Render, RollIsOneTraceOverItsParameters) {
  for (const Roll& roll : {Roll{10.0, 202.4, 10.0, 0.2}, Roll{400.0, 800.0, 1000.0, 1.0}, Roll{100.0, 10.0, 40.0, 1.0},
                           Roll{55.5, 123.456, 77.7, 0.37}, Roll{100.0, 202.4, 196.0, 0.01},
                           Roll{100.0, 98.0, 196.0, 0.5}, Roll{100.0, 800.0, 10.0, 1.5}}) {
    SCOPED_TRACE(text::format_shortest(roll.length) + " step " + text::format_shortest(roll.step));
    expect_one_trace(roll);
  }
}

void expect_all_alike(const std::string& family, ir::MachineKind kind, const Values& values) {
  std::vector<ir::Motion> first;
  for (const std::string& dialect : dialect_names()) {
    for (const RenderMode mode : {RenderMode::macro, RenderMode::explicit_blocks}) {
      const std::string what = family + " " + dialect + " " + std::string(name_of(mode));
      const RenderResult result = rendered(family, dialect, kind, mode, values);
      const Played run = run_text(result.text, control(dialect, kind));
      const std::vector<ir::Motion> motions = silent(run.motions);
      if (first.empty()) first = motions;
      ASSERT_FALSE(moves_of(motions).empty()) << what;
      expect_same(first, motions, kExplicitTolerance, what);
    }
  }
}

TEST(Render, ShaftIsOneTraceInEveryDialectAndMode) {
  expect_all_alike("stepped-shaft", ir::MachineKind::lathe, {});
  expect_all_alike("stepped-shaft", ir::MachineKind::lathe, {{"depth_of_cut", "10 mm"}, {"journal_diameter", "95 mm"}});
}

TEST(Render, PocketIsOneTraceInEveryDialectAndMode) {
  expect_all_alike("round-pocket", ir::MachineKind::mill, {});
  expect_all_alike("round-pocket", ir::MachineKind::mill, {{"cutter_diameter", "59 mm"}, {"layer_depth", "20 mm"}});
}

TEST(Render, IslandPocketIsOneTraceInEveryDialectAndMode) {
  expect_all_alike("island-pocket", ir::MachineKind::mill, {});
  expect_all_alike("island-pocket", ir::MachineKind::mill, {{"pocket_corner", "30 mm"}, {"island_corner", "0 mm"}});
}

TEST(Render, EngravingIsOneTraceInEveryDialectAndMode) {
  expect_all_alike("engrave-text", ir::MachineKind::mill, {});
  expect_all_alike("engrave-text", ir::MachineKind::mill, {{"part", "0-9 +,./ xyz"}, {"height", "3 mm"}});
}

// The rings of the pocket end at the wall exactly, and no arc leaves it.
TEST(Render, PocketMeetsItsWall) {
  const RenderResult result = rendered("round-pocket", "fanuc", ir::MachineKind::mill, RenderMode::macro);
  double largest = 0.0;
  double deepest = 0.0;
  int arcs = 0;
  for (const ir::Motion& m : run_text(result.text, control("fanuc", ir::MachineKind::mill)).motions) {
    if (!ir::is_move(m.kind)) continue;
    largest = std::max(largest, std::abs(m.end[0]));
    deepest = std::min(deepest, m.end[2]);
    arcs += m.kind == ir::MotionKind::arc_ccw ? 1 : 0;
  }
  EXPECT_NEAR(largest, 22.0, 1e-9);
  EXPECT_NEAR(deepest, -12.0, 1e-9);
  EXPECT_EQ(arcs, 3 * 4);  // layers 4, 8, 12; rings 9.6, 19.2, 22, and the wall once more
}

TEST(Render, AutomaticChoosesByDelivery) {
  const auto render_auto = [](ir::Delivery delivery) {
    return rendered("hyperbolic-roll", "fanuc", ir::MachineKind::lathe, RenderMode::automatic, {}, delivery);
  };
  const RenderResult drip = render_auto(ir::Delivery::drip);
  EXPECT_EQ(drip.mode, RenderMode::explicit_blocks);
  EXPECT_NE(drip.because.find("jumps"), std::string::npos);
  EXPECT_EQ(drip.variables, 0U);
  const RenderResult memory = render_auto(ir::Delivery::memory);
  EXPECT_EQ(memory.mode, RenderMode::macro);
  EXPECT_GT(memory.variables, 0U);
  EXPECT_LT(memory.blocks, drip.blocks / 5);
  EXPECT_EQ(memory.bytes, memory.text.size());
}

TEST(Render, MacroForDripIsRefused) {
  RenderRequest request;
  request.family = shipped("hyperbolic-roll");
  request.target = control("fanuc", ir::MachineKind::lathe);
  request.mode = RenderMode::macro;
  request.delivery = ir::Delivery::drip;
  const RenderResult result = render(request);
  ASSERT_TRUE(text::has_error(result.diagnostics));
  EXPECT_EQ(result.diagnostics.back().id, text::DiagnosticId::not_in_drip_mode);
  EXPECT_TRUE(result.text.empty());
}

// A control without variables gets plain blocks, and the reason says so.
TEST(Render, AutomaticFallsBackWhereVariablesDoNotSuffice) {
  RenderRequest request;
  request.family = shipped("hyperbolic-roll");
  request.target = control("fanuc", ir::MachineKind::lathe);
  request.target.variables = {{ir::Bank::hash, 100, 102, ir::VariableUse::common, true}};
  const RenderResult result = render(request);
  EXPECT_EQ(result.mode, RenderMode::explicit_blocks) << result.because;
  EXPECT_NE(result.because.find("variables"), std::string::npos) << result.because;
  request.mode = RenderMode::macro;
  EXPECT_TRUE(text::has_error(render(request).diagnostics));
}

TEST(Render, SafeStateIsStatedFirst) {
  const RenderResult fanuc = rendered("round-pocket", "fanuc", ir::MachineKind::mill, RenderMode::explicit_blocks);
  for (const char* code : {"G21", "G17", "G90", "G94", "G40"}) {
    const std::size_t at = fanuc.text.find(code);
    ASSERT_NE(at, std::string::npos) << code << "\n" << fanuc.text.substr(0, 200);
    EXPECT_LT(at, fanuc.text.find("X0")) << code;
  }
}

TEST(Render, WrongValuesGiveNoText) {
  RenderRequest request;
  request.family = shipped("hyperbolic-roll");
  request.values = {{"half_axis_x", "100"}};
  request.target = control("fanuc", ir::MachineKind::lathe);
  const RenderResult result = render(request);
  EXPECT_TRUE(result.text.empty());
  ASSERT_EQ(result.diagnostics.size(), 1U);
  EXPECT_EQ(result.diagnostics[0].id, text::DiagnosticId::family_missing_unit);
  request.values = {};
  request.target.dialect = "klartext";
  EXPECT_TRUE(text::has_error(render(request).diagnostics));
}

TEST(Render, FamiliesAreDescribed) {
  const FamilyDescription description = describe_family(shipped("hyperbolic-roll"));
  EXPECT_EQ(description.name, "hyperbolic-roll");
  EXPECT_EQ(description.machine, ir::MachineKind::lathe);
  ASSERT_EQ(description.parameters.size(), 9U);
  EXPECT_EQ(description.parameters[1].standard, "202.4 mm");
  EXPECT_EQ(description.parameters[1].unit, "mm");
  EXPECT_DOUBLE_EQ(description.parameters[1].high, 800.0);
  EXPECT_EQ(description.parameters[4].unit, "deg");
}

// --- place index ------------------------------------------------------------------------------------------------

TEST(PlaceIndex, OffsetsAreBlockStartsAndValuesAreTheirs) {
  for (const std::string& dialect : dialect_names()) {
    const RenderResult result =
        rendered("hyperbolic-roll", dialect, ir::MachineKind::lathe, RenderMode::explicit_blocks);
    const PlaceIndex& places = result.places;
    ASSERT_EQ(places.entries.size(), result.blocks) << dialect;
    ASSERT_EQ(places.values.size(), places.entries.size() * places.names.size());
    const auto column = std::ranges::find(places.names, "t");
    ASSERT_NE(column, places.names.end()) << dialect;
    const auto t = static_cast<std::size_t>(column - places.names.begin());

    const double from = std::atan(98.0 / 202.4) * 180.0 / std::numbers::pi;
    int k = 0;
    for (std::size_t i = 0; i < places.entries.size(); ++i) {
      const PlaceEntry& entry = places.entries[i];
      ASSERT_TRUE(entry.offset == 0 || result.text[entry.offset - 1] == '\n');
      ASSERT_NE(result.text[entry.offset], '\n');
      EXPECT_EQ(places.at(entry.offset), i);
      const std::size_t end = result.text.find('\n', entry.offset);
      EXPECT_EQ(places.at(static_cast<std::uint32_t>(end)), i);
      const bool in_profile = std::ranges::any_of(result.profile_lines, [&](const family::LineRange& r) {
        return r.first <= entry.line && entry.line <= r.last;
      });
      if (!in_profile) continue;
      EXPECT_EQ(shipped("hyperbolic-roll").line(entry.origin).find("        cut x"), 0U);
      EXPECT_NEAR(places.values_of(i)[t], std::max(from - 0.2 * k, -from), 1e-9) << dialect << " " << i;
      ++k;
    }
    EXPECT_EQ(k, static_cast<int>(closed_form({}).size()));
    // Parameters do not change, so they are reported once.
    const auto constant = std::ranges::find(places.constants, "half_axis_z", &std::pair<std::string, double>::first);
    ASSERT_NE(constant, places.constants.end());
    EXPECT_DOUBLE_EQ(constant->second, 202.4);
    EXPECT_EQ(std::ranges::find(places.names, "t_index"), places.names.end());
  }
}

TEST(PlaceIndex, OffsetsOutsideFindTheNearestBlock) {
  PlaceIndex places;
  places.entries = {{.offset = 10, .line = 2, .origin = 1}, {.offset = 20, .line = 3, .origin = 2}};
  EXPECT_EQ(places.at(0), 0U);
  EXPECT_EQ(places.at(19), 0U);
  EXPECT_EQ(places.at(20), 1U);
  EXPECT_EQ(places.at(4'000'000), 1U);
}

// Its control counts 0.001 mm: every position is a multiple of it, in both forms, and no further from the curve.
TEST(Render, ForANamedMachineByItsIncrement) {
  for (const std::string& dialect : dialect_names()) {
    RenderRequest request;
    request.family = shipped("hyperbolic-roll");
    request.target = control(dialect, ir::MachineKind::lathe);
    request.target.from_profile = true;
    request.mode = RenderMode::explicit_blocks;
    request.program_name = dialect == "sinumerik-840d" ? "FAMILY_TEST" : "O0100";
    const RenderResult made = render(request);
    ASSERT_FALSE(text::has_error(made.diagnostics)) << messages_of(made.diagnostics, request.family);
    std::size_t positions = 0;
    for (const ir::Motion& m : moves_of(run_text(made.text, request.target).motions)) {
      for (const std::size_t axis : {0U, 2U}) {
        EXPECT_NEAR(m.end[axis] * 1000.0, std::nearbyint(m.end[axis] * 1000.0), 1e-6) << dialect;
        ++positions;
      }
    }
    EXPECT_GT(positions, 100U);
  }
}

TEST(Render, AFamilyForAnotherKindOfMachineIsRefused) {
  const auto is_refused = [](const char* family, ir::MachineKind kind, bool expected) {
    for (const std::string& dialect : dialect_names()) {
      RenderRequest request;
      request.family = shipped(family);
      request.target = control(dialect, kind);
      const RenderResult result = render(request);
      const bool refused =
          !result.diagnostics.empty() && result.diagnostics.front().id == text::DiagnosticId::family_other_machine;
      EXPECT_EQ(refused, result.text.empty()) << dialect;
      EXPECT_EQ(refused, expected) << family << " for " << dialect;
    }
  };
  using enum ir::MachineKind;
  is_refused("hyperbolic-roll", mill, true);
  is_refused("hyperbolic-roll", lathe, false);
  is_refused("hyperbolic-roll", mill_turn, false);
  is_refused("round-pocket", lathe, true);
  is_refused("round-pocket", mill, false);
  is_refused("round-pocket", mill_turn, true);
}

// A word of an axis that the machine does not have is no word of its program.
TEST(Render, AnAxisThatTheMachineLacksIsRefused) {
  const text::Source family(
      "cam.family",
      "family cam\nmachine lathe, x is diameter\nprogram cam\n  feed 100 mm/min\n  rapid x 10 mm  c 0 deg\n"
      "  cut c 90 deg\nend\n");
  for (const RenderMode mode : {RenderMode::macro, RenderMode::explicit_blocks}) {
    RenderRequest request;
    request.family = family;
    request.target = control("fanuc", ir::MachineKind::lathe);
    request.target.from_profile = true;
    request.mode = mode;
    EXPECT_TRUE(text::has_error(render(request).diagnostics)) << name_of(mode);
    request.target.axes = "XZC";
    EXPECT_FALSE(text::has_error(render(request).diagnostics)) << name_of(mode);
  }
}

// G43 H1 of a mill-turn center is a length, and T1 M06 its tool 1.
TEST(Render, AMillTurnCenterOfMazakHasToolsOfAMill) {
  const Played run = run_text("%\nO1\nG21 G90 G17 G94\nG0 C0.\nT1 M06\nG43 H1 Z50.\nG0 X10. Z5.\nM30\n%\n",
                              control("mazak", ir::MachineKind::mill_turn));
  const auto tool = std::ranges::find(run.motions, ir::MotionKind::tool, &ir::Motion::kind);
  ASSERT_NE(tool, run.motions.end());
  EXPECT_EQ(tool->number, 1);
  for (const ir::Motion& one : run.motions) EXPECT_EQ(one.end[static_cast<std::size_t>(ir::Axis::c)], 0.0);
}

}  // namespace
}  // namespace dripfeed::compile::test
