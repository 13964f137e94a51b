// G37 and its like: where the tool goes, and what is known afterwards. Oracle: the moves of the manuals ("Automatic
// tool length measurement", "Automatic tool offset"), with numbers worked out by hand.
#include <algorithm>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/unit/dialects/compile/harness.h"

namespace dripfeed::compile::test {
namespace {

constexpr std::string_view kNote = "the end of measuring a tool (G37) and the length that comes of it";
const std::vector<std::string> kControls = {"fanuc", "mazak", "mitsubishi-m80"};
const std::vector<std::string> kWithWords = {"mazak", "mitsubishi-m80"};  // R D F next to the axis

struct Result {
  interpreter::RunResult result;
  std::string trace;
  std::vector<ir::Motion> motions;

  [[nodiscard]] bool names(std::string_view what) const {
    return std::ranges::any_of(result.not_interpreted, [&](const auto& one) { return one.name == what; });
  }
  // None where it is not known.
  [[nodiscard]] std::optional<double> value(std::string_view name) const {
    for (const interpreter::VariableValue& v : result.variables)
      if (v.name == name) return v.value;
    return std::nullopt;
  }
  [[nodiscard]] std::vector<ir::Motion> of(std::uint32_t line) const {
    std::vector<ir::Motion> out;
    std::ranges::copy_if(motions, std::back_inserter(out),
                         [&](const ir::Motion& m) { return m.place.line == line && ir::is_move(m.kind); });
    return out;
  }
};

Result run(const std::string& text, const std::string& dialect, ir::MachineKind kind = ir::MachineKind::mill,
           std::vector<interpreter::InitialValue> values = {}) {
  const ir::Control machine = control(dialect, kind);
  const text::Source source("program", text);
  const ir::ReadResult read = find_dialect(dialect)->read(source, machine);
  EXPECT_FALSE(text::has_error(read.diagnostics)) << messages_of(read.diagnostics, source);
  interpreter::RunNames names;
  interpreter::TraceWriter writer(machine, names);
  Motions motions;
  FanOut both({&writer, &motions});
  interpreter::RunOptions options;
  options.want_variables = true;
  options.initial_values = std::move(values);
  options.names = &names;
  Result out;
  out.result = execute(read.program, machine, nullptr, both, options);
  out.trace = writer.text();
  out.motions = motions.all;
  return out;
}
std::vector<interpreter::InitialValue> touch_at(double z) { return {{ir::Bank::hash, 5063, {}, z}}; }

// Line 4 moves to Z100, line 5 measures.
std::string mill(const std::string& measures, const std::string& then = "") {
  return "%\nO1\nG21 G17 G90 G94 G40 G43 H01\nG00 X0. Y0. Z100. F300.\n" + measures + "\n" + then + "M30\n%\n";
}

// R 20 before -400 the rapid ends: at -380.
TEST(ToolMeasuring, ByRapidAndThenSlower) {
  for (const std::string& dialect : kWithWords) {
    const Result ran = run(mill("G37 Z-400. R20. F100."), dialect);
    EXPECT_TRUE(
        ran.trace.contains("5 rapid X0.0000 Y0.0000 Z-380.0000\n"
                           "5 linear X0.0000 Y0.0000 Z-400.0000 F100.0000/min\n"))
        << dialect << ran.trace;
    EXPECT_TRUE(ran.names(kNote)) << dialect;
    EXPECT_TRUE(run(mill("G37 Z400. R20. F100."), dialect).trace.contains("5 rapid X0.0000 Y0.0000 Z380.0000\n"));
  }
}

// A parameter says how much is slow, or R is more than the travel.
TEST(ToolMeasuring, ByRapidWhereNothingSaysMore) {
  for (const std::string measures :
       {"G37 Z-400.", "G37 Z-400. F100.", "G37 Z-400. R500. F100.", "G37 Z-400. R0 F100."}) {
    const auto moves = run(mill(measures), "mitsubishi-m80").of(5);
    ASSERT_EQ(moves.size(), 1U) << measures;
    EXPECT_EQ(moves[0].kind, ir::MotionKind::rapid);
    EXPECT_EQ(moves[0].end[2], -400.0);
  }
  // The speed is a parameter's: no cut without a feed.
  const Result ran = run(mill("G37 Z-400. R20."), "mitsubishi-m80");
  ASSERT_EQ(ran.of(5).size(), 2U);
  EXPECT_EQ(ran.of(5)[1].feed, 0.0);
  EXPECT_TRUE(ran.result.diagnostics.empty());
}

// The same input as of a skip move.
TEST(ToolMeasuring, EndsWhereTheTouchIsKnown) {
  for (const std::string& dialect : kWithWords) {
    const Result ran = run(mill("G37 Z-400. R20. F100."), dialect, ir::MachineKind::mill, touch_at(-392.5));
    ASSERT_EQ(ran.of(5).size(), 2U) << dialect;
    EXPECT_EQ(ran.of(5)[0].end[2], -380.0);
    EXPECT_EQ(ran.of(5)[1].end[2], -392.5);
    const Result early = run(mill("G37 Z-400. R20. F100."), dialect, ir::MachineKind::mill, touch_at(-300.0));
    ASSERT_EQ(early.of(5).size(), 1U) << dialect;
    EXPECT_EQ(early.of(5)[0].end[2], -300.0);
    // The touch counts in the coordinates of a length that is another now.
    for (const Result& one : {ran, early}) EXPECT_NE(one.motions.back().axes_unknown & 4U, 0U);
  }
  const auto moves = run(mill("G37 Z-400."), "fanuc", ir::MachineKind::mill, touch_at(-392.5)).of(5);
  ASSERT_EQ(moves.size(), 1U);
  EXPECT_EQ(moves[0].end[2], -392.5);
}

TEST(ToolMeasuring, TheAxisIsSomewhereAfterwards) {
  for (const std::string& dialect : kControls) {
    const Result ran = run(mill("G37 Z-400.", "X5.\nG91 G00 Z10.\nG90 Z50.\nG91 Z1.\n#101=#5063\n"), dialect);
    EXPECT_NE(ran.of(6).back().axes_unknown & 4U, 0U);
    EXPECT_EQ(ran.of(6).back().axes_unknown & 1U, 0U);
    EXPECT_EQ(ran.of(7).back().gaps & ir::kEndUnknown, ir::kEndUnknown) << dialect;
    EXPECT_TRUE(ran.names("increments from a position that is not known"));
    EXPECT_EQ(ran.of(9).back().end[2], 51.0);
    EXPECT_EQ(ran.of(9).back().gaps & ir::kEndUnknown, 0) << dialect;
    EXPECT_EQ(ran.value("#101"), std::nullopt);
  }
}

// Lengths in the machine's profile count no longer, from the next move on.
TEST(ToolMeasuring, LengthsAreOthersAfterwards) {
  for (const std::string& dialect : kControls) {
    const Result ran = run(mill("G37 Z-400.", "Z100.\n"), dialect);
    for (const ir::Motion& m : ran.of(5)) EXPECT_EQ(m.gaps & ir::kLengthsChanged, 0) << dialect;
    EXPECT_EQ(ran.of(6).back().gaps, ir::kLengthsChanged) << dialect;
  }
}

// What was written of a length is another value; a work offset is what it was.
TEST(ToolMeasuring, WrittenLengthsAreForgotten) {
  const std::string text =
      mill("#102=#2001\nG10 L2 P1 Z5.\n#2001=7.\n#103=#2001\nG37 Z-400.", "#101=#2001\n#104=#5223\n");
  for (const std::string& dialect : kControls) {
    const Result ran = run(text, dialect, ir::MachineKind::mill, {{ir::Bank::hash, 2001, {}, 3.0}});
    EXPECT_EQ(ran.value("#102"), 3.0) << dialect;
    EXPECT_EQ(ran.value("#103"), 7.0) << dialect;
    EXPECT_EQ(ran.value("#101"), std::nullopt) << dialect;
    EXPECT_EQ(ran.value("#104"), 5.0) << dialect;
    EXPECT_TRUE(ran.names("#2001")) << dialect;
  }
}

// D is a range there and F a speed: neither is what it is elsewhere.
TEST(ToolMeasuring, ItsWordsAreItsOwn) {
  const Result ran =
      run(mill("D5\nG37 Z-400. R20. D2. F100.", "#101=#4107\nG01 Z-10.\nZ-20. F50.\n"), "mitsubishi-m80");
  EXPECT_EQ(ran.value("#101"), 5.0);
  EXPECT_EQ(ran.of(8).back().feed, 0.0);
  EXPECT_EQ(ran.of(9).back().feed, 50.0);
  EXPECT_TRUE(ran.result.diagnostics.empty());
  // Without F the feed of the program stays.
  EXPECT_EQ(run(mill("G37 Z-400.", "G01 Z-10.\n"), "fanuc").of(6).back().feed, 300.0);
}

// G36 along X and G37 along Z; whether R of a diameter is one, the manuals do not say.
TEST(ToolMeasuring, OnLathes) {
  for (const std::string& dialect : kWithWords) {
    const Result ran = run(
        "%\nO1\nG21 G98 G40 T0101\nG00 X100. Z50.\nG36 X40. R5. F20.\nG00 X100.\nG37 Z-10. R5. F20.\nZ50.\nM30\n%\n",
        dialect, ir::MachineKind::lathe);
    EXPECT_TRUE(ran.names(kNote)) << dialect;
    ASSERT_EQ(ran.of(5).size(), 1U) << dialect << ran.trace;
    EXPECT_EQ(ran.of(5)[0].end[0], 40.0);
    EXPECT_EQ(ran.of(5)[0].kind, ir::MotionKind::rapid);
    EXPECT_EQ(ran.of(6)[0].axes_unknown & 5U, 1U);
    ASSERT_EQ(ran.of(7).size(), 2U) << dialect;
    EXPECT_EQ(ran.of(7)[0].end[2], -5.0);
    EXPECT_EQ(ran.of(7)[0].axes_unknown & 5U, 0U) << "X100. is known again";
    EXPECT_EQ(ran.of(7)[1].end[2], -10.0);
    EXPECT_EQ(ran.of(7)[1].feed, 20.0);
    EXPECT_EQ(ran.of(8)[0].gaps, ir::kLengthsChanged);
  }
  for (const std::string code : {"G36 X40.", "G37 Z-10.", "G37.1 X40.", "G37.2 Z-10."}) {
    const Result ran =
        run("%\nO1\nG21 G98 G40 T0101\nG00 X100. Z50.\n" + code + "\nM30\n%\n", "fanuc", ir::MachineKind::lathe);
    EXPECT_TRUE(ran.names(kNote)) << code;
    ASSERT_EQ(ran.of(5).size(), 1U) << code;
    EXPECT_EQ(ran.of(5)[0].end[0], code.contains('X') ? 40.0 : 100.0);
    EXPECT_EQ(ran.of(5)[0].end[2], code.contains('Z') ? -10.0 : 50.0);
  }
}

// Each control measures by its own rules: no other's.
TEST(ToolMeasuring, IsRefusedWhereItStands) {
  const std::string text = mill("G37 Z-400. F100.");
  const std::vector<std::string> all = {"fanuc", "mazak", "mitsubishi-m80", "sinumerik-840d"};
  for (const std::string& from : kControls) {
    for (const std::string& to : all) {
      const ConvertResult made = translated(text, from, to);
      if (from == to) {
        EXPECT_EQ(made.text, text);
        continue;
      }
      const text::Source source("program", text);
      const bool placed = std::ranges::any_of(made.diagnostics, [&](const text::Diagnostic& d) {
        return d.severity == text::Severity::error && source.position(d.span.begin).line == 5;
      });
      EXPECT_TRUE(placed) << from << " " << to << messages_of(made.diagnostics, source);
    }
  }
}

}  // namespace
}  // namespace dripfeed::compile::test
