// What the tests of compile share: shipped families, texts run to motions, motions compared without their lines.
#pragma once

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "dialects/compile/dialect/dialect.h"
#include "dialects/compile/dialect/execute.h"
#include "dialects/compile/dialect/library.h"
#include "dialects/compile/render/render.h"
#include "dialects/compile/translate/convert.h"

namespace dripfeed::compile::test {

inline std::string file_text(const std::string& path) {
  std::ifstream file(std::string(DRIPFEED_SOURCE_DIR) + "/" + path, std::ios::binary);
  EXPECT_TRUE(file.good()) << path;
  std::ostringstream out;
  out << file.rdbuf();
  return out.str();
}

inline text::Source shipped(const std::string& name) {
  return {name + ".family", file_text("deploy/families/" + name + ".family")};
}

inline ir::Control control(const std::string& dialect, ir::MachineKind kind) {
  return find_dialect(dialect)->control(kind, ir::GSystem::a);
}

inline std::string messages_of(const std::vector<text::Diagnostic>& diagnostics, const text::Source& source) {
  std::string out;
  for (const text::Diagnostic& d : diagnostics) out += text::format_diagnostic(d, source, "");
  return out;
}

// A mill's program as a macro of another control.
inline ConvertResult translated(const std::string& text, const std::string& from, const std::string& to) {
  ConvertRequest request;
  request.source = text::Source("program", text);
  request.from = control(from, ir::MachineKind::mill);
  request.to = control(to, ir::MachineKind::mill);
  return convert(request);
}

class Motions final : public ir::MotionSink {
 public:
  void consume(std::span<const ir::Motion> motions) override { all.insert(all.end(), motions.begin(), motions.end()); }
  std::vector<ir::Motion> all;
};

struct Played {
  std::vector<ir::Motion> motions;
  interpreter::RunResult result;
};

// Reads and runs a text; every fault is a failure of the test.
inline Played run_text(const std::string& text, const ir::Control& control, ProgramLibrary* library = nullptr) {
  const text::Source source("program", text);
  const ir::ReadResult read = find_dialect(control.dialect)->read(source, control);
  EXPECT_FALSE(text::has_error(read.diagnostics)) << messages_of(read.diagnostics, source) << text;
  Motions motions;
  Played out;
  ProgramLibrary standard(control, [](std::string_view) { return std::nullopt; });  // the control's own cycles
  out.result = execute(read.program, control, library == nullptr ? &standard : library, motions, {});
  for (const interpreter::RunDiagnostic& d : out.result.diagnostics) {
    EXPECT_NE(d.diagnostic.severity, text::Severity::error) << d.line << ": " << text::message_of(d.diagnostic) << "\n"
                                                            << text;
  }
  out.motions = std::move(motions.all);
  return out;
}

inline std::vector<ir::Motion> moves_of(const std::vector<ir::Motion>& motions) {
  std::vector<ir::Motion> out;
  for (const ir::Motion& m : motions) {
    if (ir::is_move(m.kind)) out.push_back(m);
  }
  return out;
}

// Without moves of no length: controls differ in whether a cycle makes them.
inline std::vector<ir::Motion> real_moves(const std::vector<ir::Motion>& motions) {
  std::vector<ir::Motion> out = moves_of(motions);
  std::erase_if(out, [](const ir::Motion& m) { return m.start == m.end && (m.axes_unknown & m.axes_commanded) == 0; });
  return out;
}

// Without messages: not every control shows them while it runs.
inline std::vector<ir::Motion> silent(std::vector<ir::Motion> motions) {
  std::erase_if(motions, [](const ir::Motion& m) { return m.kind == ir::MotionKind::message; });
  return motions;
}

// Kinds, ends, centres, feeds and what is in effect; not lines, not the axes that one control has and the other has
// not.
inline void expect_same(const std::vector<ir::Motion>& a, const std::vector<ir::Motion>& b, double tolerance,
                        const std::string& what) {
  ASSERT_EQ(a.size(), b.size()) << what;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const std::string where = what + ", motion " + std::to_string(i);
    ASSERT_EQ(static_cast<int>(a[i].kind), static_cast<int>(b[i].kind)) << where;
    for (std::size_t axis = 0; axis < 6; ++axis) ASSERT_NEAR(a[i].end[axis], b[i].end[axis], tolerance) << where;
    for (std::size_t axis = 0; axis < 3; ++axis) ASSERT_NEAR(a[i].center[axis], b[i].center[axis], tolerance) << where;
    ASSERT_NEAR(a[i].feed, b[i].feed, 1e-9) << where;
    if (a[i].feed != 0.0) {
      ASSERT_EQ(static_cast<int>(a[i].feed_mode), static_cast<int>(b[i].feed_mode)) << where;
    }
    // What is in effect counts when something moves: one block's events may be several blocks' elsewhere.
    if (ir::is_move(a[i].kind)) {
      ASSERT_EQ(static_cast<int>(a[i].spindle), static_cast<int>(b[i].spindle)) << where;
      ASSERT_NEAR(a[i].spindle_rpm, b[i].spindle_rpm, 1e-9) << where;
      ASSERT_NEAR(a[i].surface_speed_m_min, b[i].surface_speed_m_min, 1e-9) << where;
      ASSERT_EQ(static_cast<int>(a[i].coolant), static_cast<int>(b[i].coolant)) << where;
      ASSERT_EQ(static_cast<int>(a[i].comp), static_cast<int>(b[i].comp)) << where;
      ASSERT_EQ(a[i].machine_coordinates, b[i].machine_coordinates) << where;
    }
    if (a[i].kind == ir::MotionKind::offset) {
      ASSERT_EQ(a[i].number, b[i].number) << where;
    }
    if (a[i].kind == ir::MotionKind::tool) {
      ASSERT_EQ(a[i].number, b[i].number) << where;
    }
  }
}

inline const std::vector<std::string>& dialect_names() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all;
    for (const Dialect& one : dialects()) all.emplace_back(one.name);
    return all;
  }();
  return names;
}

}  // namespace dripfeed::compile::test
