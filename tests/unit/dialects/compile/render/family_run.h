// A family in every dialect and both modes: what is made of it, and that it moves alike.
#pragma once

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "dialects/compile/render/render.h"
#include "tests/unit/dialects/compile/harness.h"

namespace dripfeed::compile::test {

using Values = std::vector<family::Override>;

inline constexpr double kTolerance = 0.0006;  // explicit words are rounded as they are printed

inline ir::MachineKind kind_of(const text::Source& family) {
  return family.text().contains("\nmachine lathe") ? ir::MachineKind::lathe : ir::MachineKind::mill;
}

inline RenderResult rendered(const text::Source& family, const std::string& dialect, RenderMode mode,
                             const Values& values) {
  RenderRequest request;
  request.family = family;
  request.values = values;
  request.target = control(dialect, kind_of(family));
  request.mode = mode;
  request.program_name = dialect.starts_with("sinumerik") ? "FAMILY_TEST" : "O0100";
  return render(request);
}

// Motions without what controls do to the spindle for a tap, and its cuts as straight ones.
inline std::vector<ir::Motion> without_spindle(const std::vector<ir::Motion>& motions) {
  std::vector<ir::Motion> out = real_moves(motions);
  for (ir::Motion& one : out) {
    one.spindle = ir::SpindleState::stopped;
    if (one.kind != ir::MotionKind::thread) continue;
    one.kind = ir::MotionKind::linear;
    one.feed_mode = ir::FeedMode::per_rev;
  }
  return out;
}

// What every control does alike: holes are its own cycles.
inline std::vector<ir::Motion> comparable(const text::Source& family, const std::vector<ir::Motion>& motions) {
  if (family.text().contains("  tap from ")) return without_spindle(motions);
  return family.text().contains("    at ") ? real_moves(motions) : silent(motions);
}

// The moves of a family, equal in every dialect and mode.
inline std::vector<ir::Motion> one_trace(const text::Source& family, const Values& values = {}) {
  std::vector<ir::Motion> first;
  for (const std::string& dialect : dialect_names()) {
    for (const RenderMode mode : {RenderMode::macro, RenderMode::explicit_blocks}) {
      const std::string what = dialect + " " + std::string(name_of(mode));
      const RenderResult result = rendered(family, dialect, mode, values);
      EXPECT_TRUE(result.diagnostics.empty()) << what << "\n" << messages_of(result.diagnostics, family);
      if (text::has_error(result.diagnostics)) return {};
      const Played run = run_text(result.text, control(dialect, kind_of(family)));
      EXPECT_EQ(run.result.ended, interpreter::Ended::end) << what << "\n" << result.text;
      const std::vector<ir::Motion> motions = comparable(family, run.motions);
      EXPECT_FALSE(moves_of(motions).empty()) << what;
      if (first.empty()) first = motions;
      expect_same(first, motions, kTolerance, what);
    }
  }
  return moves_of(first);
}

// A family with these declarations and steps.
inline text::Source with(const std::string& declarations, const std::string& steps) {
  return {"test.family",
          "family test\nmachine mill\n" + declarations + "program test\n  feed 100 mm/min\n" + steps + "end\n"};
}

}  // namespace dripfeed::compile::test
