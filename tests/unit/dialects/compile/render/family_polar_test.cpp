// Polar and cylindrical interpolation of families. Oracle: the path in the plane that the family writes. What each text
// moves, as its control carries it out, is brought back to that plane and lies on the path, and the path on it.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include "tests/unit/dialects/compile/render/family_run.h"

namespace dripfeed::compile::test {
namespace {

constexpr double kDegreesOfTurn = 180.0 / std::numbers::pi;
// Pieces of a control keep within 0.001 mm, and so do the straight ones between the places that are compared here.
constexpr double kAside_mm = 2e-3;

struct FacePlace {
  double x = 0.0;
  double y = 0.0;
  double z = 0.0;
};
using FacePath = std::vector<FacePlace>;

ir::Control lathe_with_c(const std::string& dialect) {
  ir::Control out = control(dialect, ir::MachineKind::lathe);
  if (!out.axes.contains('C')) out.axes += 'C';
  return out;
}

RenderResult rendered_on(const text::Source& family, const ir::Control& target, RenderMode mode,
                         const Values& values = {}) {
  RenderRequest request;
  request.family = family;
  request.values = values;
  request.target = target;
  request.mode = mode;
  return render(request);
}

double aside_of_piece(const FacePlace& p, const FacePlace& from, const FacePlace& to) {
  const FacePlace d{to.x - from.x, to.y - from.y, to.z - from.z};
  const double length = d.x * d.x + d.y * d.y + d.z * d.z;
  const double along = (p.x - from.x) * d.x + (p.y - from.y) * d.y + (p.z - from.z) * d.z;
  const double t = length > 0.0 ? std::clamp(along / length, 0.0, 1.0) : 0.0;
  return std::hypot(p.x - from.x - t * d.x, p.y - from.y - t * d.y, p.z - from.z - t * d.z);
}

// The greatest distance of places of one path from the other.
double farthest_aside(const FacePath& of, const FacePath& from) {
  double most = 0.0;
  for (std::size_t i = 1; i < of.size(); ++i) {
    for (const double t : {0.0, 0.5}) {
      const auto between = [t](double a, double b) { return a + t * (b - a); };
      const FacePlace p{between(of[i - 1].x, of[i].x), between(of[i - 1].y, of[i].y), between(of[i - 1].z, of[i].z)};
      double least = 1e9;
      for (std::size_t k = 1; k < from.size(); ++k) least = std::min(least, aside_of_piece(p, from[k - 1], from[k]));
      most = std::max(most, least);
    }
  }
  return most;
}

// The cuts on the face, or with `radius` on the circumference: those before or after C comes back to 0.
FacePath face_cuts(const std::vector<ir::Motion>& motions, double radius) {
  std::vector<FacePath> parts;
  bool cuts = false;
  for (const ir::Motion& m : motions) {
    if (!ir::is_move(m.kind)) continue;
    const bool now = m.kind != ir::MotionKind::rapid;
    const auto place = [&](const std::array<double, ir::kAxisCount>& at) {
      const double c = at[5] / kDegreesOfTurn;
      return radius == 0.0 ? FacePlace{at[0] / 2.0 * std::cos(c), at[0] / 2.0 * std::sin(c), at[2]}
                           : FacePlace{at[0] / 2.0, c * radius, at[2]};
    };
    if (now && !cuts) parts.push_back({place(m.start)});
    if (now) {
      for (int step = 1; step <= 8; ++step) {
        const double t = step / 8.0;
        std::array<double, ir::kAxisCount> at{};
        for (std::size_t i = 0; i < at.size(); ++i) at[i] = m.start[i] + t * (m.end[i] - m.start[i]);
        parts.back().push_back(place(at));
      }
    }
    cuts = now;
  }
  EXPECT_EQ(parts.size(), 2U);
  return parts.size() == 2 ? parts[radius == 0.0 ? 0 : 1] : FacePath{};
}

text::Source polar_example() {
  const std::string document = file_text("docs/families.md");
  const std::size_t at = document.find("family milled-hexagon");
  EXPECT_NE(at, std::string::npos);
  return {"example.family", document.substr(at, document.find("```", at) - at)};
}

// With these values: 24 mm across flats, a shank of 40 mm, 2 mm deep.
FacePath face_path() {
  const double corner = 12.0 / std::cos(30.0 / kDegreesOfTurn);
  FacePath out = {{30, 0, 2}, {25, 0, 2}, {25, 0, -2}};
  for (int n = 0; n <= 6; ++n)
    out.push_back({corner * std::cos(n * 60 / kDegreesOfTurn), corner * std::sin(n * 60 / kDegreesOfTurn), -2});
  for (int n = 1; n <= 720; ++n)
    out.push_back({corner * std::cos(n * 0.5 / kDegreesOfTurn), corner * std::sin(n * 0.5 / kDegreesOfTurn), -2});
  out.push_back({25, 0, -2});
  return out;
}
FacePath cylinder_path() { return {{30, 0, -10}, {18, 0, -10}, {18, 15, -20}, {21, 15, -20}}; }

TEST(FamilyPolar, EveryControlMakesThePathOfTheFamily) {
  for (const std::string& dialect : dialect_names()) {
    const ir::Control target = lathe_with_c(dialect);
    for (const RenderMode mode : {RenderMode::macro, RenderMode::explicit_blocks}) {
      SCOPED_TRACE(dialect + " " + std::string(name_of(mode)));
      const RenderResult made = rendered_on(polar_example(), target, mode);
      ASSERT_TRUE(made.diagnostics.empty()) << messages_of(made.diagnostics, polar_example());
      const Played run = run_text(made.text, target);
      ASSERT_EQ(run.result.ended, interpreter::Ended::end) << made.text;
      EXPECT_TRUE(run.result.not_interpreted.empty()) << made.text;
      const FacePath face = face_cuts(run.motions, 0.0);
      EXPECT_LT(farthest_aside(face, face_path()), kAside_mm) << made.text;
      EXPECT_LT(farthest_aside(face_path(), face), kAside_mm) << made.text;
      const FacePath cylinder = face_cuts(run.motions, 20.0);
      EXPECT_LT(farthest_aside(cylinder, cylinder_path()), kAside_mm) << made.text;
      EXPECT_LT(farthest_aside(cylinder_path(), cylinder), kAside_mm) << made.text;
      const bool by_y = dialect.starts_with("sinumerik");
      for (const char* word : {by_y ? "TRANSMIT" : "G12.1", by_y ? "TRACYL(40)" : "G07.1 C20.",
                               by_y ? "TRAFOOF" : "G13.1", by_y ? "TRAFOOF" : "G07.1 C0."})
        EXPECT_TRUE(made.text.contains(word)) << word << "\n" << made.text;
    }
  }
}

// As macros the controls make the same moves.
TEST(FamilyPolar, MacrosAreOneTrace) {
  std::vector<ir::Motion> first;
  for (const std::string& dialect : dialect_names()) {
    const RenderResult made = rendered_on(polar_example(), lathe_with_c(dialect), RenderMode::macro);
    const std::vector<ir::Motion> moves = moves_of(run_text(made.text, lathe_with_c(dialect)).motions);
    if (first.empty()) first = moves;
    ASSERT_EQ(first.size(), moves.size()) << dialect;
    for (std::size_t i = 0; i < moves.size(); ++i)
      for (const std::size_t axis : {0U, 2U, 5U}) ASSERT_NEAR(first[i].end[axis], moves[i].end[axis], 1e-4) << dialect;
  }
}

// Twice the same: each begins at C 0, and a block of the text leads to the family's line.
TEST(FamilyPolar, FacesInALoop) {
  const text::Source family{"test.family",
                            "family test\nmachine lathe, x is diameter\nprogram test\n  feed 100 mm/min\n"
                            "  for layer from 1 to 3 step 1\n    rapid x 30 mm  z 2 mm\n    polar\n"
                            "      cut x 20 mm  y 0 mm\n      cut z -1 mm*layer\n      cut x 10 mm  y 5 mm\n"
                            "      if layer > 2\n        cut y 7 mm\n      end\n    end\n  end\nend\n"};
  for (const std::string& dialect : dialect_names()) {
    const RenderResult macro = rendered_on(family, lathe_with_c(dialect), RenderMode::macro);
    const RenderResult blocks = rendered_on(family, lathe_with_c(dialect), RenderMode::explicit_blocks);
    ASSERT_TRUE(macro.diagnostics.empty() && blocks.diagnostics.empty())
        << dialect << messages_of(macro.diagnostics, family) << messages_of(blocks.diagnostics, family);
    const std::vector<ir::Motion> a = moves_of(run_text(macro.text, lathe_with_c(dialect)).motions);
    const std::vector<ir::Motion> b = moves_of(run_text(blocks.text, lathe_with_c(dialect)).motions);
    ASSERT_FALSE(a.empty());
    EXPECT_NEAR(a.back().end[0], 2.0 * std::hypot(5.0, 7.0), 1e-6) << dialect;
    EXPECT_NEAR(a.back().end[5], std::atan2(7.0, 5.0) * kDegreesOfTurn, 1e-6) << dialect;
    EXPECT_NEAR(b.back().end[0], a.back().end[0], 1e-3) << dialect << blocks.text;
    EXPECT_NEAR(b.back().end[5], a.back().end[5], 1e-3) << dialect << blocks.text;
    const auto begun = [](const std::string& text, std::string_view word) {
      std::size_t count = 0;
      for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) ++count;
      return count;
    };
    EXPECT_EQ(begun(blocks.text, dialect.starts_with("sinumerik") ? "TRANSMIT" : "G12.1"), 3U) << blocks.text;
    for (const PlaceEntry& one : blocks.places.entries) EXPECT_LT(one.origin, 20U);
  }
}

std::string polar_fault(const std::string& steps, const std::string& machine = "lathe, x is diameter",
                        const std::string& before = "") {
  const text::Source family{"test.family", "family test\nmachine " + machine + "\n" + before +
                                               "program test\n  feed 100 mm/min\n  rapid x 30 mm  z 2 mm\n" + steps +
                                               "end\n"};
  const ir::MachineKind kind = machine == "mill" ? ir::MachineKind::mill : ir::MachineKind::lathe;
  const RenderResult made = rendered_on(family, control("fanuc", kind), RenderMode::macro);
  EXPECT_TRUE(made.text.empty()) << made.text;
  return messages_of(made.diagnostics, family);
}

TEST(FamilyPolar, WhatControlsDoNotMakeIsRefused) {
  const std::string entry = "    cut x 20 mm  y 0 mm\n";
  const auto polar = [&](const std::string& steps) { return "  polar\n" + entry + steps + "  end\n"; };
  EXPECT_TRUE(polar_fault("  polar\n  end\n", "mill").contains("only a lathe"));
  EXPECT_TRUE(polar_fault("  polar\n  end\n").contains("the first cut"));
  EXPECT_TRUE(polar_fault("  polar\n    cut x 20 mm\n  end\n").contains("the first cut"));
  EXPECT_TRUE(
      polar_fault("  polar\n    for n from 1 to 2 step 1\n  " + entry + "    end\n  end\n").contains("the first cut"));
  EXPECT_TRUE(polar_fault(polar("    rapid x 30 mm\n")).contains("no rapid move"));
  EXPECT_TRUE(polar_fault(polar("    cut c 30 deg\n")).contains("y stands for"));
  EXPECT_TRUE(polar_fault(polar("    tool 3\n")).contains("stand cuts"));
  EXPECT_TRUE(polar_fault(polar("    polar\n" + entry + "    end\n")).contains("inside of another"));
  EXPECT_TRUE(polar_fault(polar("    compensate left\n    cut x 10 mm\n")).contains("before its end"));
  EXPECT_TRUE(polar_fault(polar("") + "  rapid x by 5 mm\n").contains("name their places"));
  EXPECT_TRUE(polar_fault("  cut y 5 mm\n").contains("a lathe has no y axis"));
  const std::string cylinder = "  cylinder diameter 40 mm\n" + entry;
  EXPECT_TRUE(polar_fault(cylinder + "    arc cw z 5 mm  y 5 mm  radius 9 mm\n  end\n").contains("cut along"));
  EXPECT_TRUE(
      polar_fault("  cylinder diameter 0 mm\n" + entry + "  end\n").contains("the diameter of a cylinder is 0"));
  EXPECT_TRUE(
      polar_fault("  let d = 4 mm\n  cylinder diameter d\n" + entry + "  end\n").contains("on parameters only"));
  EXPECT_TRUE(polar_fault("", "lathe, x is diameter", "sub part\n  polar\n  end\nend\n")
                  .contains("a subprogram holds no face"));
}

// Y of the face is no axis of the machine: C turns for it.
TEST(FamilyPolar, AMachineWithoutYTakesTheText) {
  for (const std::string& dialect : dialect_names()) {
    ir::Control target = control(dialect, ir::MachineKind::lathe);
    target.from_profile = true;
    target.axes = "XZC";
    for (const RenderMode mode : {RenderMode::macro, RenderMode::explicit_blocks}) {
      const RenderResult made = rendered_on(polar_example(), target, mode);
      const text::Source text("program", made.text);
      const Dialect* language = find_dialect(dialect);
      const auto found = language->validate(language->read(text, target).program, target, ir::Delivery::memory);
      EXPECT_TRUE(found.empty()) << dialect << messages_of(found, text) << made.text;
    }
  }
}

TEST(FamilyPolar, AMachineWithoutCIsRefused) {
  for (const std::string& dialect : dialect_names()) {
    ir::Control target = control(dialect, ir::MachineKind::lathe);
    target.from_profile = true;
    target.axes = "XZ";
    const RenderResult made = rendered_on(polar_example(), target, RenderMode::macro);
    EXPECT_TRUE(made.text.empty());
    EXPECT_TRUE(messages_of(made.diagnostics, polar_example()).contains("axis C")) << dialect;
  }
}

}  // namespace
}  // namespace dripfeed::compile::test
